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

/// Returns the corners of all pixels, and the centers of solid pixels. A pixel is 2 × 2: corners are on even integers,
/// centers on odd ones. A center and two corners have circumradius 1, so that a solid pixel is filled. Three corners
/// have √2, so that an empty pixel is not.
Points points_of(const Picture& picture);
inline constexpr double picture_alpha = 1;

Picture random_picture(std::size_t rows, std::size_t columns, double solid, Random& random);

/// Exact measures of a polygon.
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
