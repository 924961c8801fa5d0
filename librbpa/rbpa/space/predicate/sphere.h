// What: tests whether a fifth point is inside the sphere through four points; a perturbation breaks ties. With radii,
//       the five points are balls, whose weights are their squared radii. The sphere is then orthogonal to the first
//       four balls, and the fifth ball is inside if its power to the sphere is negative.
// Law:  exact for every finite input. All results are consistent with one perturbed set of lifted points
//       (docs/explanation/exact_decisions.md, section 2), without ties.
// Cost: some ten nanoseconds if the filter decides; else a tenth of a microsecond for points on grids, and microseconds
//       for other points.
#pragma once

#include <array>
#include <optional>

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/spread.h"

namespace rbpa::space {

/// Radii of the balls a, b, c, d, q. A null pointer in place of FiveRadii stands for points, with radii of 0.
using FiveRadii = std::array<double, 5>;

/// Returns whether the perturbation moves q into the sphere through a, b, c, d. Requires: q is on the sphere.
/// Requires: five distinct points; orientation(a, b, c, d) > 0.
bool pulled_into_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q);

/// Returns the in-sphere determinant, positive inside, in double-double (base/exact/double_double.h). Its error is at
/// most 72 · 2^−106 times the sum of the absolute values of all terms (docs/explanation/exact_decisions.md, section 7).
/// Requires: points that fit double (base/exact/magnitude.h).
double in_sphere_by_double_double(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                                  const FiveRadii* radii = nullptr);

/// Returns whether q is inside the perturbed sphere through a, b, c, d; nothing if differences of the points are not
/// integers of fixed width (fixed_width_vectors.h). Requires: five distinct points; orientation(a, b, c, d) > 0.
std::optional<bool> in_sphere_on_grid(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                      const Point3& q, const FiveRadii* radii = nullptr);

/// Returns whether q is inside the perturbed sphere, for any points. Requires: what in_sphere_on_grid() requires.
bool in_sphere_exactly(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                       const FiveRadii* radii = nullptr);

/// Returns in_sphere_exactly(), after trying a floating-point filter (docs/explanation/space.md, sections 8 to 10).
bool in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q);

/// A decision of tests that the filter of sphere_minors.h leaves open: by the computed determinant if it has no error,
/// else by integers of fixed width, by double-double, or by integers of any length.
class BeyondFilter {
 public:
  explicit BeyondFilter(const Spread& spread) : exact_below_(spread.exact_below(5)), is_exact_(spread.is_exact) {}

  /// Returns whether q is inside the perturbed sphere. `value` and `error` are the computed determinant and the bound
  /// of its error.
  /// Requires: five distinct points of the spread and their radii, scaled by it where it is exact; orientation(a, b, c,
  ///           d) > 0.
  bool is_inside(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q, double value,
                 double error, const FiveRadii* radii = nullptr) const;

 private:
  double exact_below_;  // a determinant with an error bound below this has no error
  bool is_exact_;
};

}  // namespace rbpa::space
