#include "rbpa/space/solid/boundary/measures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/exact/expansion.h"
#include "rbpa/base/exact/integer128.h"
#include "rbpa/base/exact/integer_sum.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/crossing.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using Integers = std::array<std::int64_t, 3>;

/// Exponents of the bounds of scaled coordinates: below 2^60 as integers, below 2^500 as doubles. Products of the
/// scaled doubles fit double with their last bits.
constexpr int integer_bits = 60, double_bits = 500;

/// Returns the greatest absolute value of each coordinate.
Point3 size_of(std::span<const Point3> points) {
  Point3 size{0, 0, 0};
  for (const Point3& p : points)
    size = {std::max(size.x, std::abs(p.x)), std::max(size.y, std::abs(p.y)), std::max(size.z, std::abs(p.z))};
  return size;
}

/// Sets `result` to the integer part of scale(x). Returns whether `result` is exact.
bool to_integer(const PowerOfTwo& scale, double x, std::int64_t& result) {
  const double scaled = scale(x);
  result = static_cast<std::int64_t>(scaled);
  return static_cast<double>(result) == scaled && (result != 0 || x == 0);
}

/// Adds a (b c − d e) to `sum`, exactly.
void add_terms(ExactSum& sum, double a, double b, double c, double d, double e) {
  const auto plus = detail::two_product(b, c), minus = detail::two_product(d, e);
  for (const double term : {plus.high, plus.low, -minus.high, -minus.low})
    if (term != 0) sum.add_product(a, term);
}

}  // namespace

PowerOfTwo::PowerOfTwo(double size, int exponent) {
  if (size == 0) return;
  int of_size = 0;
  std::frexp(size, &of_size);
  exponent_ = exponent - of_size;
  first_ = std::ldexp(1.0, exponent_ / 2);
  second_ = std::ldexp(1.0, exponent_ - exponent_ / 2);
}

Measures::Measures(std::span<const Point3> points) : Measures(points, size_of(points)) {}

Measures::Measures(std::span<const Point3> points, const Point3& size)
    : points_(points),
      to_integers_{PowerOfTwo(size.x, integer_bits), PowerOfTwo(size.y, integer_bits),
                   PowerOfTwo(size.z, integer_bits)},
      to_doubles_{PowerOfTwo(size.x, double_bits), PowerOfTwo(size.y, double_bits), PowerOfTwo(size.z, double_bits)},
      to_unit_(std::max({size.x, size.y, size.z}), 0) {}

class Measures::Sums {
 public:
  explicit Sums(const Measures& by) : by_(by) {}

  void add(const Corners& t) {
    if (const auto integers = integers_of(t))
      add_integers(*integers);
    else
      add_doubles(t);
    add_area(t);
  }

  double volume() {
    integers_.add_to(doubles_, 3 * (double_bits - integer_bits));
    integers_ = {};
    const auto& [x, y, z] = by_.to_doubles_;
    return doubles_.rounded(-(x.exponent() + y.exponent() + z.exponent())) / 6;
  }
  double area() const { return areas_.rounded(-2 * by_.to_unit_.exponent() - 1); }

 private:
  std::optional<std::array<Integers, 3>> integers_of(const Corners& t) const {
    std::array<Integers, 3> result{};
    const auto& [x, y, z] = by_.to_integers_;
    bool fit = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool at_x = to_integer(x, t[i].x, result[i][0]), at_y = to_integer(y, t[i].y, result[i][1]),
                 at_z = to_integer(z, t[i].z, result[i][2]);
      fit = fit && at_x && at_y && at_z;
    }
    if (!fit) return std::nullopt;
    return result;
  }
  void add_integers(const std::array<Integers, 3>& t) {
    const auto& [a, b, c] = t;
    integers_.add_product(Integer128{b[1]} * c[2] - Integer128{b[2]} * c[1], a[0]);
    integers_.add_product(Integer128{b[2]} * c[0] - Integer128{b[0]} * c[2], a[1]);
    integers_.add_product(Integer128{b[0]} * c[1] - Integer128{b[1]} * c[0], a[2]);
  }

  void add_doubles(const Corners& t) {
    const auto scaled = [&](const Point3& p) {
      return Point3{by_.to_doubles_[0](p.x), by_.to_doubles_[1](p.y), by_.to_doubles_[2](p.z)};
    };
    const Point3 a = scaled(t[0]), b = scaled(t[1]), c = scaled(t[2]);
    add_terms(doubles_, a.x, b.y, c.z, b.z, c.y);
    add_terms(doubles_, a.y, b.z, c.x, b.x, c.z);
    add_terms(doubles_, a.z, b.x, c.y, b.y, c.x);
  }

  void add_area(const Corners& t) {
    const auto scaled = [&](const Point3& p) {
      return Point3{by_.to_unit_(p.x), by_.to_unit_(p.y), by_.to_unit_(p.z)};
    };
    const Point3 a = scaled(t[0]);
    const Vector3<double> normal = cross(from<double>(a, scaled(t[1])), from<double>(a, scaled(t[2])));
    const double square = dot(normal, normal);
    constexpr double least_square = 0x1p-900;  // below, the terms of the square may underflow
    areas_.add(square > least_square ? std::sqrt(square) : std::hypot(normal.x, normal.y, normal.z));
  }

  const Measures& by_;
  IntegerSum integers_;
  ExactSum doubles_, areas_;
};

ClosedMeasures Measures::of(std::span<const Triangle> triangles, std::span<const std::uint32_t> which) const {
  ClosedMeasures result;
  Box box;
  result.least = {box.low, box.low, box.low};
  Sums sums(*this);
  for (const std::uint32_t t : which) {
    const Corners corners = corners_of(points_, triangles[t]);
    if (corners < result.least) result.least = corners;
    for (const Point3& p : corners) box.include(p);
    sums.add(corners);
  }
  result.low = box.low;
  result.high = box.high;
  // If other points are much farther out, the scale is too coarse, and the triangles get a scale of their own.
  const Point3 size = size_of(std::array{result.low, result.high});
  constexpr int too_small = -200;  // an exponent of 2
  const auto is_small = [&](double of_triangles, const PowerOfTwo& scale) {
    return of_triangles != 0 && std::ilogb(of_triangles) + scale.exponent() < double_bits + too_small;
  };
  if (is_small(size.x, to_doubles_[0]) || is_small(size.y, to_doubles_[1]) || is_small(size.z, to_doubles_[2]))
    return Measures(points_, size).of(triangles, which);
  result.volume = sums.volume();
  result.area = sums.area();
  return result;
}

}  // namespace rbpa::space
