#include "rbpa/space/predicate/sphere.h"

#include <cmath>
#include <cstddef>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/fixed_width_vectors.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

/// Returns whether p is before q in lexicographic order. Requires: no NaN.
bool is_less(const Point3& p, const Point3& q) {
  return (p.x < q.x) | ((p.x == q.x) & ((p.y < q.y) | ((p.y == q.y) & (p.z < q.z))));
}

/// The minor a.x b.y − a.y b.x, and the sum of the absolute values of both products.
struct Minor {
  Minor(const Vector3<double>& a, const Vector3<double>& b)
      : value(a.x * b.y - a.y * b.x), size(std::abs(a.x * b.y) + std::abs(a.y * b.x)) {}
  double value, size;
};

/// Returns pulled_into_sphere() by products without rounding. Requires: the bound of the in-sphere determinant's error
/// is so small that the determinant has no error (docs/explanation/exact_decisions.md, section 7).
bool pulled_without_rounding(const Point3& pa, const Point3& pb, const Point3& pc, const Point3& pd, const Point3& pq) {
  const auto a = from<double>(pd, pa), b = from<double>(pd, pb), c = from<double>(pd, pc), q = from<double>(pd, pq);
  // Signed volumes with q in place of each corner; the last one is −volume. The volume of the corners is below 0.
  const auto ab = cross(a, b), cq = cross(c, q);
  const double volume = dot(ab, c), at_a = dot(b, cq), at_b = -dot(a, cq), at_c = dot(ab, q);
  const std::array<double, 5> at = {at_a, at_b, at_c, volume - at_a - at_b - at_c, -volume};
  const std::array<const Point3*, 5> points = {&pa, &pb, &pc, &pd, &pq};
  std::size_t largest = 4;  // among the points that are not at 0
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_larger = is_less(*points[largest], *points[i]), is_at_0 = at[i] == 0;
    largest = (is_larger & !is_at_0) ? i : largest;  // no branches, which would be mispredicted
  }
  return at[largest] < 0;
}

}  // namespace

bool pulled_into_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q) {
  // Let q = Σ λ corner with Σ λ = 1. The perturbed height of q above the corners is ε(q) − Σ λ ε(corner). The largest ε
  // whose coefficient is not 0 decides. λ has the sign of the tetrahedron with q in place of the corner.
  std::array<const Point3*, 4> corners = {&a, &b, &c, &d};
  std::array<std::size_t, 4> left = {0, 1, 2, 3};  // corners not tried yet, not sorted: usually one decides
  for (std::size_t count = 4; count > 0; --count) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < count; ++i)
      if (is_less(*corners[left[largest]], *corners[left[i]])) largest = i;
    const std::size_t k = left[largest];
    if (is_less(*corners[k], q)) return false;
    std::array<const Point3*, 4> replaced = corners;
    replaced[k] = &q;
    if (const int side = orientation(*replaced[0], *replaced[1], *replaced[2], *replaced[3]); side != 0)
      return side > 0;
    left[largest] = left[count - 1];
  }
  return false;  // not reached: some λ is not 0
}

double in_sphere_by_double_double(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                                  const FiveRadii* radii) {
  struct Row {
    DoubleDouble x, y, z, square;
    Row(const Point3& p, const Point3& from)
        : x(DoubleDouble::difference(p.x, from.x)),
          y(DoubleDouble::difference(p.y, from.y)),
          z(DoubleDouble::difference(p.z, from.z)),
          square(x * x + y * y + z * z) {}
  };
  Row r(a, d), s(b, d), t(c, d), w(q, d);
  if (radii) {
    const auto subtract_weight = [&](Row& row, std::size_t i) {
      const double own = (*radii)[i], last = (*radii)[3];
      row.square = row.square - DoubleDouble::difference(own, last) * DoubleDouble::difference(own, -last);
    };
    subtract_weight(r, 0);
    subtract_weight(s, 1);
    subtract_weight(t, 2);
    subtract_weight(w, 4);
  }
  const DoubleDouble xy = s.x * t.y - s.y * t.x, yz = s.y * t.z - s.z * t.y, xz = s.x * t.z - s.z * t.x,
                     xs = s.x * t.square - s.square * t.x, ys = s.y * t.square - s.square * t.y,
                     zs = s.z * t.square - s.square * t.z;
  const DoubleDouble along_x = r.z * ys - r.y * zs - r.square * yz, along_y = r.x * zs - r.z * xs + r.square * xz,
                     along_z = r.y * xs - r.x * ys - r.square * xy, volume = r.x * yz - r.y * xz + r.z * xy;
  return (along_x * w.x + along_y * w.y + along_z * w.z + volume * w.square).high;
}

std::optional<bool> in_sphere_on_grid(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                      const Point3& q, const FiveRadii* radii) {
  int power;
  if (radii) {
    const FixedVectors<4, true> to(a, {&b, &c, &d, &q}, radii);
    if (!to.are_exact()) return std::nullopt;
    power = power_sign(to[0], to[1], to[2], to[3], to.weights());
  } else {
    const FixedVectors<4> to(a, {&b, &c, &d, &q});
    if (!to.are_exact()) return std::nullopt;
    power = power_sign(to[0], to[1], to[2], to[3]);
  }
  return power == 0 ? pulled_into_sphere(a, b, c, d, q) : power < 0;
}

bool in_sphere_exactly(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                       const FiveRadii* radii) {
  if (const std::optional<bool> in = in_sphere_on_grid(a, b, c, d, q, radii)) return *in;
  const int side = exact::side_of_sphere(a, b, c, d, q, radii);
  return side == 0 ? pulled_into_sphere(a, b, c, d, q) : side > 0;
}

bool in_sphere(const Point3& pa, const Point3& pb, const Point3& pc, const Point3& pd, const Point3& pq) {
  const auto a = from<double>(pq, pa), b = from<double>(pq, pb), c = from<double>(pq, pc), d = from<double>(pq, pd);
  const Minor ab(a, b), bc(b, c), cd(c, d), da(d, a), ac(a, c), bd(b, d);
  const auto volume = [](double x, const Minor& yz, double y, const Minor& xz, double z, const Minor& xy) {
    return std::array{x * yz.value - y * xz.value + z * xy.value,
                      std::abs(x) * yz.size + std::abs(y) * xz.size + std::abs(z) * xy.size};
  };
  const auto abc = volume(a.z, bc, b.z, ac, c.z, ab), bcd = volume(b.z, cd, c.z, bd, d.z, bc);
  const auto cda = volume(c.z, da, d.z, Minor(c, a), a.z, cd), dab = volume(d.z, ab, a.z, Minor(d, b), b.z, da);
  const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), dd = dot(d, d);
  const double value = (aa * bcd[0] - bb * cda[0]) + (cc * dab[0] - dd * abc[0]);
  const double size = (dd * abc[1] + cc * dab[1]) + (bb * cda[1] + aa * bcd[1]);
  const double bound = 0x1p-48 * size;
  if (bound > least_filtered) {  // also false for NaN
    if (value > bound) return true;
    if (value < -bound) return false;
  }
  return in_sphere_exactly(pa, pb, pc, pd, pq);
}

bool BeyondFilter::is_inside(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                             double value, double error, const FiveRadii* radii) const {
  if (error < exact_below_) return value != 0 ? value > 0 : pulled_without_rounding(a, b, c, d, q);
  if (const auto in = in_sphere_on_grid(a, b, c, d, q, radii)) return *in;
  if (is_exact_) {
    // The bound of the double-double error has 72 u² in place of 20 u for each term.
    const double finer = in_sphere_by_double_double(a, b, c, d, q, radii);
    if (std::abs(finer) > 0x1p-51 * error) return finer > 0;
  }
  return in_sphere_exactly(a, b, c, d, q, radii);
}

}  // namespace rbpa::space
