#include "rbpa/base/run/input.h"

#include <array>
#include <charconv>

#include "rbpa/base/error.h"

namespace rbpa {

std::string text(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

void check_number(std::size_t points) {
  if (points > max_points)
    throw InvalidInput(std::to_string(points) + " points, expected at most " + std::to_string(max_points) +
                       ", whose halfedges can be numbered in int");
}

void check(std::span<const Point> points, double alpha) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  check_number(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InvalidInput("point " + std::to_string(i) + " is (" + text(points[i].x) + ", " + text(points[i].y) +
                         "), expected finite coordinates");
}

}  // namespace rbpa
