// What: computes volume, area and bounding box of the region that closed triangles enclose.
// Law:  sums are exact and rounded once, so that results do not depend on the order of triangles. solid_boundary.h
//       states the bounds of errors.
// How:  the volume is a sum of determinants of corners. Determinants are summed as integers if the coordinates along
//       each axis, divided by the power of two above the greatest one, are multiples of 2⁻⁶⁰. Otherwise a product of
//       two numbers is two doubles, and each of the six products of three is added to an ExactSum.
// Cost: linear; integers take a tenth of the time of an ExactSum.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"

namespace rbpa::space {

struct ClosedMeasures {
  double volume = 0;  ///< in cubed units of the points; negative if the triangles face the enclosed region
  double area = 0;
  Point3 low, high;  ///< opposite corners of the box
  /// The least triangle by coordinates, rotated so that its least corner is first; does not depend on indices.
  std::array<Point3, 3> least{};
};

/// A multiplication by a power of two in two steps, because the power may be beyond the range of double.
class PowerOfTwo {
 public:
  /// Chooses the factor that scales `size` to at least 2^(exponent − 1) and below 2^exponent; 1 if `size` is 0.
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

  /// Returns the measures of the triangles with the indices `which`. Requires: at least one index; the triangles with
  /// these indices form closed surfaces, and their corners are indices of the points.
  ClosedMeasures of(std::span<const Triangle> triangles, std::span<const std::uint32_t> which) const;

 private:
  class Sums;
  Measures(std::span<const Point3> points, const Point3& size);

  std::span<const Point3> points_;
  std::array<PowerOfTwo, 3> to_integers_, to_doubles_;  // factors by axis
  PowerOfTwo to_unit_;
};

/// Returns the indices of `pieces` of a boundary, sorted by descending absolute volume. Among pieces of equal volume,
/// the piece with the lexicographically least triangle is first. There are no ties, because no two closed pieces share
/// a triangle.
inline std::vector<std::uint32_t> by_volume(const std::vector<ClosedMeasures>& pieces) {
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const double volume = std::abs(pieces[i].volume), other = std::abs(pieces[j].volume);
    return volume != other ? volume > other : pieces[i].least < pieces[j].least;
  });
  return order;
}

}  // namespace rbpa::space
