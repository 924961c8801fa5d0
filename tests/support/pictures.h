// What: pictures of square pixels as point sets whose alpha solid is exactly the pixels, and the polygons that must
//       result, by flood fill. Pixels that touch in a corner make pinches of every kind.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/random.h"
#include "support/triangle.h"

namespace rbpa_test {

/// Picture as rows from the top; '#' is solid. All rows have the same length.
using Picture = std::vector<std::string>;

/// A pixel is 2 × 2, with its corners on even integers and its center on odd ones. The center makes four triangles of
/// circumradius 1; three corners without it have √2.
Points points_of(const Picture& picture);
inline constexpr double picture_alpha = 1;

Picture random_picture(std::size_t rows, std::size_t columns, double solid, Random& random);

/// Polygon by numbers that are exact.
struct Part {
  double area;
  double perimeter;
  std::size_t holes;
  friend auto operator<=>(const Part&, const Part&) = default;
};

/// Returns, sorted, the parts that remain after holes of less than `min_hole` are filled and then parts of less than
/// `min_part` are dropped.
std::vector<Part> parts_of(const Picture& picture, double min_hole = 0, double min_part = 0);

}  // namespace rbpa_test
