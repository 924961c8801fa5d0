// What: volume, area and box of what closed triangles enclose.
// Law:  sums are exact and rounded once, so that no order matters; solid_boundary.h has the bounds.
// How:  the volume is a sum of determinants of corners. Where these are whole multiples of 2⁻⁶⁰ of the greatest coordinate, as they mostly
//       are, it is one of integers; else a product of two is two doubles, and a product of three four terms of an ExactSum.
// Cost: linear; an integer sum takes a tenth of the time.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"

namespace rbpa::space {

struct ClosedMeasures {
  double volume = 0;  ///< negative where the triangles face what they enclose
  double area = 0;
  Point3 low, high;               ///< opposite corners of the box
  std::array<Point3, 3> least{};  ///< triangle, from its least corner on: by coordinates, so that no numbering matters
};

/// Multiplies by a power of two, in two steps: one factor alone may be beyond the range of double.
class PowerOfTwo {
 public:
  /// Brings `size` to between 2^(exponent − 1) and 2^exponent.
  PowerOfTwo(double size, int exponent);

  double operator()(double x) const { return x * first_ * second_; }
  int exponent() const { return exponent_; }

 private:
  int exponent_ = 0;
  double first_ = 1, second_ = 1;
};

class Measures {
 public:
  /// Keeps the span.
  explicit Measures(std::span<const Point3> points);

  /// Of some of the triangles, by number. Requires: at least one; together they are closed, and on these points.
  ClosedMeasures of(std::span<const Triangle> triangles, std::span<const std::uint32_t> which) const;

 private:
  class Sums;
  Measures(std::span<const Point3> points, const Point3& size);

  std::span<const Point3> points_;
  std::array<PowerOfTwo, 3> to_integers_, to_doubles_;  // by axis
  PowerOfTwo to_unit_;
};

}  // namespace rbpa::space
