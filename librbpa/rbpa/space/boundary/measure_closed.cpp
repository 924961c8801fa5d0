#include "rbpa/space/boundary/measure_closed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/exact_sum.h"

namespace rbpa::space {
namespace {

using Corners = std::array<Point3, 3>;

/// Multiplies by a power of two, in two steps: one factor alone may be beyond the range of double.
class PowerOfTwo {
 public:
  PowerOfTwo() = default;
  /// Brings `size` to between 2^(exponent − 1) and 2^exponent.
  PowerOfTwo(double size, int exponent) {
    if (size == 0) return;
    int of_size = 0;
    std::frexp(size, &of_size);
    exponent_ = exponent - of_size;
    first_ = std::ldexp(1.0, exponent_ / 2);
    second_ = std::ldexp(1.0, exponent_ - exponent_ / 2);
  }

  double operator()(double x) const { return x * first_ * second_; }
  int exponent() const { return exponent_; }

 private:
  int exponent_ = 0;
  double first_ = 1, second_ = 1;
};

double size_of(double low, double high) { return std::max(std::abs(low), std::abs(high)); }

/// Adds a (b c − d e).
void add_terms(ExactSum& sum, double a, double b, double c, double d, double e) {
  const auto plus = detail::two_product(b, c), minus = detail::two_product(d, e);
  for (const double term : {plus.high, plus.low, -minus.high, -minus.low})
    if (term != 0) sum.add_product(a, term);
}

/// Sum of the determinants of the corners: six times the volume. Coordinates are scaled axis by axis so that products of two fit double with
/// their last bits.
class Volume {
 public:
  Volume(const Point3& low, const Point3& high)
      : x_(size_of(low.x, high.x), 500), y_(size_of(low.y, high.y), 500), z_(size_of(low.z, high.z), 500) {}

  void add(const Corners& t) {
    const Point3 a = scaled(t[0]), b = scaled(t[1]), c = scaled(t[2]);
    add_terms(sum_, a.x, b.y, c.z, b.z, c.y);
    add_terms(sum_, a.y, b.z, c.x, b.x, c.z);
    add_terms(sum_, a.z, b.x, c.y, b.y, c.x);
  }
  double rounded() const { return sum_.rounded(-(x_.exponent() + y_.exponent() + z_.exponent())) / 6; }

 private:
  Point3 scaled(const Point3& p) const { return {x_(p.x), y_(p.y), z_(p.z)}; }

  PowerOfTwo x_, y_, z_;
  ExactSum sum_;
};

/// All coordinates are scaled alike, to at most 1.
class Area {
 public:
  Area(const Point3& low, const Point3& high)
      : scale_(std::max({size_of(low.x, high.x), size_of(low.y, high.y), size_of(low.z, high.z)}), 0) {}

  void add(const Corners& t) {
    const Difference u(scaled(t[0]), scaled(t[1])), v(scaled(t[0]), scaled(t[2]));
    const DoubleDouble x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
    sum_.add(std::hypot(x.high, y.high, z.high));
  }
  double rounded() const { return sum_.rounded(-2 * scale_.exponent() - 1); }

 private:
  struct Difference {
    Difference(const Point3& a, const Point3& b)
        : x(DoubleDouble::difference(b.x, a.x)),
          y(DoubleDouble::difference(b.y, a.y)),
          z(DoubleDouble::difference(b.z, a.z)) {}
    DoubleDouble x, y, z;
  };
  Point3 scaled(const Point3& p) const { return {scale_(p.x), scale_(p.y), scale_(p.z)}; }

  PowerOfTwo scale_;
  ExactSum sum_;
};

/// The corners from the least on.
Corners corners_of(std::span<const Point3> points, const Triangle& triangle) {
  Corners corners = {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

ClosedMeasures measure_closed(std::span<const Point3> points, std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> which) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ClosedMeasures result;
  result.low = {infinity, infinity, infinity};
  result.high = {-infinity, -infinity, -infinity};
  result.least = corners_of(points, triangles[which.front()]);
  for (const std::uint32_t t : which) {
    const Corners corners = corners_of(points, triangles[t]);
    result.least = std::min(result.least, corners);
    for (const Point3& p : corners) {
      result.low = {std::min(result.low.x, p.x), std::min(result.low.y, p.y), std::min(result.low.z, p.z)};
      result.high = {std::max(result.high.x, p.x), std::max(result.high.y, p.y), std::max(result.high.z, p.z)};
    }
  }
  Volume volume(result.low, result.high);
  Area area(result.low, result.high);
  for (const std::uint32_t t : which) {
    // From the least corner on, as the area of a triangle is rounded.
    const Corners corners = corners_of(points, triangles[t]);
    volume.add(corners);
    area.add(corners);
  }
  result.volume = volume.rounded();
  result.area = area.rounded();
  return result;
}

}  // namespace rbpa::space
