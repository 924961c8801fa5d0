#include "rbpa/plane/region.h"

#include <cmath>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/partial/region_complex.h"

namespace rbpa {

void check_finite(double alpha) {
  if (std::isinf(alpha) && alpha > 0)
    throw InvalidInput(
        "alpha is infinite, expected a radius: without one a circle may be as large as the whole set, and no halo "
        "around a region is enough (rbpa alpha --help says how to choose one; or triangulate all points in memory)");
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a finite radius above 0");
}

void check(const Region& region) {
  if (!(region.x0 <= region.x1) || !(region.y0 <= region.y1))
    throw InvalidInput("region: found " + text(region) + ", expected bounds in ascending order");
}

std::string text(const Region& region) {
  std::string all = "x from ";
  all += text(region.x0) + " to " + text(region.x1) + ", y from ";
  return all + text(region.y0) + " to " + text(region.y1);
}

Region halo(const Region& region, double alpha) {
  check_finite(alpha);
  check(region);
  // The next double below a rounded difference is below the real one. The box is half-open, so the next double above
  // the rounded sum includes points on the border.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double reach = 2 * alpha;
  const auto below = [&](double bound) { return std::nextafter(bound - reach, -infinity); };
  const auto above = [&](double bound) { return std::nextafter(bound + reach, infinity); };
  Region wide{below(region.x0), below(region.y0), above(region.x1), above(region.y1)};
  // With an infinite reach, an infinite bound would become NaN.
  if (std::isinf(reach)) wide = Region{};
  return wide;
}

}  // namespace rbpa
