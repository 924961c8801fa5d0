#include "rbpa/space/predicate/circumradius.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/space/predicate/circumradius.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h: the code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/base/exact/least_reaching.h"
#include "rbpa/base/lanes/double_double-inl.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/vector3.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <typename D>
class Circumradii {
 public:
  using V = hn::Vec<D>;
  using Number = rbpa::HWY_NAMESPACE::DoubleDoubleLanes<D>;
  struct Vector {
    Number x, y, z;
  };

  /// Returns the rounded-up radius of the simplex in each lane; 0 where double-double does not decide. `coordinates`
  /// has 12 rows of lanes: x, y, z of each of the four corners.
  static HWY_INLINE V rounded_up(const double* coordinates) {
    const D d;
    const auto edge = [&](std::size_t corner) HWY_ATTR {
      const auto along = [&](std::size_t axis) HWY_ATTR {
        return Number::difference(hn::Load(d, coordinates + (3 * corner + axis) * hn::Lanes(d)),
                                  hn::Load(d, coordinates + axis * hn::Lanes(d)));
      };
      return Vector{along(0), along(1), along(2)};
    };
    Vector u = edge(1), v = edge(2), w = edge(3);
    const V greatest = hn::Max(hn::Max(greatest_of(u), greatest_of(v)), greatest_of(w));
    // Whether the greatest difference, and the power of two that scales it to about 1, are far from limits of double.
    const auto are_fit = hn::And(hn::Gt(greatest, hn::Set(d, 0x1p-800)), hn::Lt(greatest, hn::Set(d, 0x1p+900)));
    const hn::RebindToUnsigned<D> du;
    const auto exponent = hn::And(hn::BitCast(du, greatest), hn::Set(du, 0x7ff0000000000000U));
    const V size = hn::BitCast(d, exponent),
            power = hn::BitCast(d, hn::Sub(hn::Set(du, 0x7fe0000000000000U), exponent));
    scale(u, power);
    scale(v, power);
    scale(w, power);

    const Vector vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const Number uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), volume = dot(u, vw);
    const Vector center = {uu * vw.x + vv * wu.x + ww * uv.x, uu * vw.y + vv * wu.y + ww * uv.y,
                           uu * vw.z + vv * wu.z + ww * uv.z};  // times 2 volume
    const Number squares = dot(center, center), diameter = volume + volume, denominator = diameter * diameter;

    // docs/explanation/exact_decisions.md, section 7.
    constexpr double volume_error = 0x1p-93, center_error = 0x1p-91, relative = 0x1p-98;
    const V length = hn::Sqrt(squares.high), half = hn::Abs(diameter.high);
    const V squares_error = hn::MulAdd(hn::Set(d, 4 * center_error), length,
                                       hn::MulAdd(hn::Set(d, 2 * relative), squares.high, hn::Set(d, 0x1p-180)));
    const V denominator_error = hn::MulAdd(hn::Set(d, 8 * volume_error), half,
                                           hn::MulAdd(hn::Set(d, relative), denominator.high, hn::Set(d, 0x1p-180)));
    // (r² − R²) · denominator, with R the exact radius.
    const auto difference = [&](V r) HWY_ATTR { return Number::product_of(r, r) * denominator - squares; };
    const auto error = [&](V r) HWY_ATTR {
      return hn::MulAdd(hn::Mul(hn::Set(d, 2), hn::Mul(r, r)), denominator_error, squares_error);
    };
    const V quotient = hn::Div(length, half);
    const V r = hn::Sub(
        quotient, hn::Div(difference(quotient).high, hn::Mul(hn::Mul(hn::Set(d, 2), quotient), denominator.high)));
    const V of_r = difference(r).high, error_of_r = error(r);
    const auto is_above = hn::Gt(of_r, error_of_r), is_below = hn::Lt(of_r, hn::Neg(error_of_r));
    // Positive doubles are ordered like their bits.
    const auto bits = hn::BitCast(du, r), one = hn::Set(du, 1);
    const V next = hn::BitCast(d, hn::IfThenElse(hn::RebindMask(du, is_above), hn::Sub(bits, one), hn::Add(bits, one)));
    const V of_next = difference(next).high, error_of_next = error(next);
    const auto are_apart = hn::Or(hn::And(is_above, hn::Lt(of_next, hn::Neg(error_of_next))),
                                  hn::And(is_below, hn::Gt(of_next, error_of_next)));
    const V radius = hn::Mul(hn::Max(r, next), size);
    const auto is_decided =
        hn::And(hn::And(are_fit, hn::And(are_apart, hn::Gt(half, hn::Set(d, 0x1p-40)))),
                hn::And(hn::Gt(radius, hn::Set(d, 0x1p-1000)), hn::Lt(radius, hn::Set(d, 0x1p+1000))));
    return hn::IfThenElseZero(is_decided, radius);
  }

 private:
  static HWY_INLINE V greatest_of(const Vector& v) {
    return hn::Max(hn::Max(hn::Abs(v.x.high), hn::Abs(v.y.high)), hn::Abs(v.z.high));
  }
  static HWY_INLINE void scale(Vector& v, V power) {
    for (Number* x : {&v.x, &v.y, &v.z}) *x = {hn::Mul(power, x->high), hn::Mul(power, x->low)};
  }
  static HWY_INLINE Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

void round_up(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
              std::span<double> radii) {
  using D = hn::CappedTag<double, 8>;
  const std::size_t lanes = hn::Lanes(D());
  alignas(64) double coordinates[12 * 8], rounded[8] = {};
  for (std::size_t first = 0; first < simplices.size(); first += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto& corners = simplices[std::min(first + lane, simplices.size() - 1)];
      for (std::size_t k = 0; k < 4; ++k) {
        const Point3& p = points[corners[k]];
        coordinates[(3 * k + 0) * lanes + lane] = p.x;
        coordinates[(3 * k + 1) * lanes + lane] = p.y;
        coordinates[(3 * k + 2) * lanes + lane] = p.z;
      }
    }
    hn::Store(Circumradii<D>::rounded_up(coordinates), D(), rounded);
    for (std::size_t t = first; t < std::min(first + lanes, simplices.size()); ++t) {
      const auto& [a, b, c, e] = simplices[t];
      const double radius = rounded[t - first];
      radii[t] = radius > 0 ? radius : circumradius_rounded_up(points[a], points[b], points[c], points[e]);
    }
  }
}

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa::space {

HWY_EXPORT(round_up);

void circumradii_rounded_up(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
                            std::span<double> radii) {
  HWY_DYNAMIC_DISPATCH(round_up)(points, simplices, radii);
}

double circumradius_rounded_up(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  // The estimate is precise enough for a search over neighboring doubles, unless a value overflows or cancels.
  using Vector = Vector3<long double>;
  const Vector u = from<long double>(a, b), v = from<long double>(a, c), w = from<long double>(a, d);
  const Vector vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const long double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const Vector center = {uu * vw.x + vv * wu.x + ww * uv.x, uu * vw.y + vv * wu.y + ww * uv.y,
                         uu * vw.z + vv * wu.z + ww * uv.z};
  const auto estimate = static_cast<double>(std::sqrt(dot(center, center)) / (2 * std::abs(dot(u, vw))));
  return least_reaching(estimate, [&](double r) { return exact::compare_circumradius(a, b, c, d, r) <= 0; });
}

}  // namespace rbpa::space
#endif
