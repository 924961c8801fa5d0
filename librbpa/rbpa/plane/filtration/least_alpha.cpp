#include "rbpa/plane/filtration/least_alpha.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/base/exact/least_reaching.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

using Exact = Predicates<long double>;  // more digits than double, and exponents that hold degree six in doubles

/// Returns the least double x > 0 from `low` to `high` for which enough(x) is true. Requires: enough(high) is true, and
/// with enough(x) also enough(y) for every y > x.
template <typename Enough>
double least(double low, double high, const Enough& enough) {
  return least_reaching_between(std::max(std::nextafter(low, 0.0), 0.0), high, enough);
}

}  // namespace

double least_alpha(const Point& a, const Point& b, const Point& c) {
  const Exact::Vector ab = Exact::from(a, b), bc = Exact::from(b, c), ca = Exact::from(c, a);
  const long double sides = std::sqrt(Exact::dot(ab, ab) * Exact::dot(bc, bc) * Exact::dot(ca, ca));
  const long double area = 2 * std::abs(Exact::cross(ab, ca)),
                    error = 10 * Exact::unit_roundoff * Exact::cross_magnitude(ab, ca);
  const double low = rounded_up(sides / (area + error) * (1 - 16 * Exact::unit_roundoff));
  const double high = area > error ? rounded_up(sides / (area - error) * (1 + 16 * Exact::unit_roundoff))
                                   : std::numeric_limits<double>::infinity();
  if (low == high) return low;
  return least(low, high, [&](double alpha) { return Exact::compare_to_close_alpha(a, b, c, alpha) <= 0; });
}

double least_alpha(const Point& a, const Point& b) {
  const Exact::Vector ab = Exact::from(a, b);
  const long double half = std::sqrt(Exact::dot(ab, ab)) / 2;
  const double low = rounded_up(half * (1 - 8 * Exact::unit_roundoff)),
               high = rounded_up(half * (1 + 8 * Exact::unit_roundoff));
  if (low == high) return low;
  return least(low, high, [&](double alpha) { return Exact::compare_to_diameter(a, b, alpha) <= 0; });
}

}  // namespace rbpa
