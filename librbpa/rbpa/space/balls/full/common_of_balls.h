// What: volume and surface area of the intersection of one, two and three balls of radius 1, and sums of such terms.
// How:  docs/explanation/space.md, section 21, has the formula and a drawing.
#pragma once

#include <cmath>
#include <numbers>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

using Vector = Vector3<double>;

inline Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
/// Returns the length of a vector, also of a very short or long one whose square a double does not hold.
inline double norm(const Vector& v) { return std::hypot(v.x, v.y, v.z); }
Vector unit(const Vector& v);

/// Returns the solid angle at a corner with edges along three unit vectors, as a fraction of the sphere.
/// Source: Van Oosterom, Strackee (1983).
double solid_angle(const Vector& a, const Vector& b, const Vector& c);

/// Returns the angle at an edge between the two faces that contain it and the directions a and b, as a fraction of a
/// full turn. All three are unit vectors from one end of the edge.
double dihedral_angle(const Vector& edge, const Vector& a, const Vector& b);

/// The volume of an intersection of balls, and the area of its surface.
struct Measure {
  double volume, area;
};

inline constexpr Measure one_ball = {4 * std::numbers::pi / 3, 4 * std::numbers::pi};

/// Measures the intersection of two balls whose centers are `distance` apart, at most 2.
Measure two_balls(double distance);

/// Measures the intersection of three balls around 0, u and v, whose circumradius is at most 1.
Measure three_balls(const Vector& u, const Vector& v);

/// Sums of measures that do not depend on the order.
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
