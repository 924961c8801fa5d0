#include "rbpa/plane/collinear.h"

#include <algorithm>

#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

bool are_collinear(std::span<const Point> points, const GoOn& go_on) {
  Steps step(go_on);
  const auto other = std::find_if(points.begin(), points.end(), [&](const Point& p) { return !(p == points[0]); });
  return std::all_of(other, points.end(), [&](const Point& p) {
    step();
    return Predicates<long double>::orientation(points[0], *other, p) == 0;
  });
}

std::string why_no_triangle(std::size_t distinct, bool collinear, double alpha) {
  if (distinct < 3) return "fewer than three distinct points (" + std::to_string(distinct) + ")";
  return collinear ? "all points are collinear" : "no triangle has circumradius <= " + text(alpha);
}

}  // namespace rbpa
