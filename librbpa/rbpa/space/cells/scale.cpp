#include "rbpa/space/cells/scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/base/exact/magnitude.h"

namespace rbpa::space {

std::optional<int> scale_to_double(std::span<const Point3> points, double radius) {
  constexpr int bits = std::numeric_limits<double>::digits, least_bit = -1074;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const Point3& p : points)
    for (const double coordinate : {p.x, p.y, p.z}) {
      const double size = std::abs(coordinate);
      if (size == 0) continue;
      least = std::min(least, size);
      greatest = std::max(greatest, size);
    }
  // Every coordinate is assumed to use all its bits. For the radius, which is in no difference, one bit suffices.
  int lowest = std::ilogb(radius), highest = lowest + 1;
  if (greatest > 0) {
    lowest = std::min(lowest, std::max(std::ilogb(least) - (bits - 1), least_bit));
    highest = std::max(highest, std::ilogb(greatest) + 1);
  }
  if (fits_double({lowest, highest})) return 0;
  if (highest - lowest > largest_in_double - least_in_double) return std::nullopt;
  return least_in_double - lowest;
}

}  // namespace rbpa::space
