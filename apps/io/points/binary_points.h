// What: points that lie in memory as numbers at regular distances.
#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <vector>

#include "io/scalar.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

/// Where the coordinates are: point i has x at first_x + i · stride, y at first_y + i · stride.
struct PointArray {
  std::size_t count;
  const char* first_x;
  const char* first_y;
  std::size_t stride;
  Scalar x_type;
  Scalar y_type;
  std::endian order;
  std::size_t first_index = 0;  ///< of point 0 in its file, for messages
};

/// Requires every byte named to be there. Throws BadInput when a coordinate is not finite; points count from 0.
std::vector<Point> load_points(const PointArray& array, const std::string& name);

/// Throws BadInput when `p`, point `index` of the file, is not finite.
void require_finite(const Point& p, std::size_t index, const std::string& name);

/// Little-endian float64 pairs x, y and nothing else.
std::vector<Point> read_raw_points(std::string_view bytes, const std::string& name);

}  // namespace rbpa::app
