#include "rbpa/space/predicate/orientation.h"

#include <cmath>

#include "rbpa/base/exact/expansion.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/fixed_width_vectors.h"

namespace rbpa::space {
namespace {

using Difference = Expansion<2>;

struct Differences {
  Difference x, y, z;
  Differences(const Point3& a, const Point3& b)
      : x(difference(b.x, a.x)), y(difference(b.y, a.y)), z(difference(b.z, a.z)) {}

  /// Returns whether products of three components, and their last bits, are within the range of double.
  bool fit() const { return fits(x) && fits(y) && fits(z); }

 private:
  static bool fits(const Difference& d) {
    for (int i = 0; i < d.size; ++i) {
      const double size = std::abs(d.component[static_cast<unsigned>(i)]);
      if (!(size > 0x1p-200 && size < 0x1p200)) return false;
    }
    return true;
  }
};

/// Returns the component of u × v along an axis.
auto product_along(const Differences& u, const Differences& v, int axis) {
  if (axis == 0) return u.y * v.z - u.z * v.y;
  if (axis == 1) return u.z * v.x - u.x * v.z;
  return u.x * v.y - u.y * v.x;
}

}  // namespace

int orientation_exactly(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const FixedVectors<3> fixed(a, {&b, &c, &d});
  if (fixed.are_exact()) return volume_sign(fixed[0], fixed[1], fixed[2]);
  const Differences u(a, b), v(a, c), w(a, d);
  if (!u.fit() || !v.fit() || !w.fit()) return exact::orientation(a, b, c, d);
  return (product_along(u, v, 0) * w.x + product_along(u, v, 1) * w.y + product_along(u, v, 2) * w.z).sign();
}

int orientation_along_exactly(const Point3& a, const Point3& b, const Point3& c, int axis) {
  const Differences u(a, b), v(a, c);
  if (!u.fit() || !v.fit())
    return exact::normal_sign(a, b, c, {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
  return product_along(u, v, axis).sign();
}

}  // namespace rbpa::space
