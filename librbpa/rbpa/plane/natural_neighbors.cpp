#include "rbpa/plane/natural_neighbors.h"

#include <algorithm>
#include <cmath>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

double difference_of(double a, double b, int exponent, double /*as*/) { return std::ldexp(a - b, exponent); }
DoubleDouble difference_of(double a, double b, int exponent, DoubleDouble /*as*/) {
  const DoubleDouble exact = DoubleDouble::difference(a, b);
  return {std::ldexp(exact.high, exponent), std::ldexp(exact.low, exponent)};
}
double rounded(double value) { return value; }
double rounded(const DoubleDouble& value) { return value.high; }

template <typename Number>
struct Vector {
  Number x, y;
  friend Vector operator+(const Vector& u, const Vector& v) { return {u.x + v.x, u.y + v.y}; }
  friend Vector operator-(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y}; }
};
template <typename Number>
Number cross(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

/// From one point to another, times 2^exponent.
template <typename Number>
Vector<Number> from(const Point& a, const Point& b, int exponent) {
  return {difference_of(b.x, a.x, exponent, Number()), difference_of(b.y, a.y, exponent, Number())};
}

/// From a corner of a triangle to its circumcentre, by the ways to the two others.
template <typename Number>
Vector<Number> to_circumcentre(const Vector<Number>& u, const Vector<Number>& v) {
  const Number uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y, area = cross(u, v);
  const Number twice = area + area;
  return {(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
}

/// Of the size of the polygon, by which the mean of the neighbours may miss the point.
constexpr double tolerance = 1e-9;

}  // namespace

/// Beyond a side there is a triangle whose circle contains the query.
bool NaturalNeighbors::goes_on_beyond(const Side& s, const Point& query) const {
  const std::uint32_t other = of_.neighbors[s.triangle][s.across];
  if (other == no_index) return false;
  const auto& [a, b, c] = of_.triangles[other];
  return Predicates<long double>::in_circle(points_[a], points_[b], points_[c], query) > 0;
}

/// The same side of the triangle beyond.
NaturalNeighbors::Side NaturalNeighbors::beyond(const Side& s) const {
  const std::uint32_t other = of_.neighbors[s.triangle][s.across];
  const auto& back = of_.neighbors[other];
  return {other, static_cast<std::size_t>(std::find(back.begin(), back.end(), s.triangle) - back.begin())};
}

/// Goes once around the polygon from a side of it on; the lengths of its numbers are about 1 times 2^-exponent.
/// Returns: whether Sibson's identity holds but for rounding.
template <typename Number>
bool NaturalNeighbors::measure(const Point& query, const Side& first, int exponent) {
  using V = Vector<Number>;
  const auto of_side = [&](const Side& s) {
    return to_circumcentre(from<Number>(query, points_[begin(s)], exponent),
                           from<Number>(query, points_[end(s)], exponent));
  };
  const auto of_triangle = [&](std::uint32_t t) {
    const auto& [a, b, c] = of_.triangles[t];
    return from<Number>(query, points_[a], exponent) + to_circumcentre(from<Number>(points_[a], points_[b], exponent),
                                                                       from<Number>(points_[a], points_[c], exponent));
  };
  shares_.clear();
  double sum = 0, size = 0, least = 0;
  double mean_x = 0, mean_y = 0;
  Side side = first;
  V centre = of_side(side);
  do {
    const std::uint32_t corner = end(side);
    V last = of_triangle(side.triangle) - centre;
    Number area{};
    for (side = next(side); goes_on_beyond(side, query); side = next(beyond(side))) {
      const V here = of_triangle(of_.neighbors[side.triangle][side.across]) - centre;
      area = area + cross(here, last);
      last = here;
    }
    const V centre_of_next = of_side(side);
    area = area + cross(centre_of_next - centre, last);
    centre = centre_of_next;
    const double share = rounded(area);
    const V to_corner = from<Number>(query, points_[corner], exponent);
    const double x = rounded(to_corner.x), y = rounded(to_corner.y);
    sum += share;
    least = std::min(least, share);
    size += std::abs(share) * std::hypot(x, y);
    mean_x += share * x;
    mean_y += share * y;
    shares_.push_back({corner, std::max(0.0, share)});
  } while (!(side == first));
  double whole = 0;  // without the sizes of negative ones, which are rounding
  for (const PointShare& s : shares_) whole += s.share;
  for (PointShare& s : shares_) s.share /= whole;
  // A comparison with what is no number is false.
  return sum > 0 && std::isfinite(sum) && std::hypot(mean_x, mean_y) <= tolerance * size && least >= -tolerance * sum;
}

std::span<const PointShare> NaturalNeighbors::find(const Point& query, std::uint32_t t) {
  Side side{t, 0};
  while (goes_on_beyond(side, query)) side = next(beyond(side));
  double largest = 0;
  for (const std::uint32_t corner : of_.triangles[t])
    largest = std::max({largest, std::abs(points_[corner].x - query.x), std::abs(points_[corner].y - query.y)});
  const int exponent = std::isfinite(largest) ? -std::ilogb(largest) : 0;
  if (!measure<double>(query, side, exponent) && !measure<DoubleDouble>(query, side, exponent)) return {};
  return shares_;
}

}  // namespace rbpa
