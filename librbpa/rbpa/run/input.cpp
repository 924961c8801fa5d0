#include "rbpa/run/input.h"

#include <array>
#include <charconv>

#include "rbpa/core/error.h"

namespace rbpa {

std::string text(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

void check(std::span<const Point> points, double alpha) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  if (points.size() >= (std::size_t{1} << 30))
    throw InvalidInput(std::to_string(points.size()) + " points, expected fewer than 2^30");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InvalidInput("point " + std::to_string(i) + " is (" + text(points[i].x) + ", " + text(points[i].y) +
                         "), expected finite coordinates");
}

}  // namespace rbpa
