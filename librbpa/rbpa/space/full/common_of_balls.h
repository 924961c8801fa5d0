// What: volume, and area of the surface, of what one, two and three balls of radius 1 have in common, and sums of such
//       terms.
// How:  docs/solid.md, section 11, has the formula and a drawing.
#pragma once

#include <cmath>
#include <numbers>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

using Vector = Vector3<double>;

inline Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
inline double length(const Vector& v) { return std::hypot(v.x, v.y, v.z); }  // of points that nearly coincide too
Vector unit(const Vector& v);

/// The solid angle of a corner whose edges lead along three unit vectors, as a share of all directions.
/// Source: Van Oosterom, Strackee (1983).
double solid_angle(const Vector& a, const Vector& b, const Vector& c);

/// The angle at an edge between the faces towards a and b, which begin at its origin, as a share of a whole turn: all
/// three unit vectors.
double dihedral_angle(const Vector& edge, const Vector& a, const Vector& b);

/// Volume of what balls have in common, and area of its surface.
struct Measure {
  double volume, area;
};

inline constexpr Measure one_ball = {4 * std::numbers::pi / 3, 4 * std::numbers::pi};

/// Measures two balls whose centers are so far apart, at most 2.
Measure two_balls(double distance);

/// Measures three balls around 0, u and v, whose circumradius is at most 1.
Measure three_balls(const Vector& u, const Vector& v);

/// Sums that do not depend on the order.
class MeasureSum {
 public:
  void add(double times, const Measure& of) {
    volume_.add(times * of.volume);
    area_.add(times * of.area);
  }
  MeasureSum& operator+=(const MeasureSum& other) {
    volume_ += other.volume_;
    area_ += other.area_;
    return *this;
  }
  Measure rounded() const { return {volume_.rounded(), area_.rounded()}; }

 private:
  ExactSum volume_, area_;
};

}  // namespace rbpa::space
