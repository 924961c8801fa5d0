#include "oracle/circumradius.h"

#include <CGAL/Interval_nt.h>

#include <cmath>

#include "oracle/rational.h"

namespace rbpa_test {
namespace {

/// Returns |ab|²|bc|²|ca|² − 4 alpha² (ab × ac)².
template <typename Number>
Number excess(const Number& ax, const Number& ay, const Number& bx, const Number& by, const Number& cx,
              const Number& cy, const Number& alpha) {
  const auto square_length = [](const Number& x, const Number& y) { return Number(x * x + y * y); };
  const Number ux = bx - ax, uy = by - ay, vx = cx - ax, vy = cy - ay;
  const Number cross = ux * vy - uy * vx;
  const Number sides = square_length(ux, uy) * square_length(vx, vy) * square_length(cx - bx, cy - by);
  return sides - 4 * alpha * alpha * cross * cross;
}

}  // namespace

bool circumradius_at_most_exactly(const rbpa::Point& a, const rbpa::Point& b, const rbpa::Point& c, double alpha) {
  if (std::isinf(alpha)) return true;
  return excess(rational(a.x), rational(a.y), rational(b.x), rational(b.y), rational(c.x), rational(c.y),
                rational(alpha))
             .sign() <= 0;
}

bool circumradius_at_most(const rbpa::Point& a, const rbpa::Point& b, const rbpa::Point& c, double alpha) {
  if (std::isinf(alpha)) return true;
  {
    using Interval = CGAL::Interval_nt_advanced;
    const Interval::Protector round_upward;
    const Interval difference = excess<Interval>(a.x, a.y, b.x, b.y, c.x, c.y, alpha);
    // Overflow leaves no finite bound; the comparisons are false for NaN.
    if (std::isfinite(difference.inf()) && std::isfinite(difference.sup())) {
      if (difference.inf() > 0) return false;
      if (difference.sup() < 0) return true;
    }
  }
  return circumradius_at_most_exactly(a, b, c, alpha);
}

}  // namespace rbpa_test
