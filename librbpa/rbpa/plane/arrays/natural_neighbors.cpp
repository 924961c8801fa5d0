#include "rbpa/plane/arrays/natural_neighbors.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::cpp_bin_float_50;  // exponents to 2^31

/// Returns (a − b) · 2^exponent in the precision of Number; for Rational, exactly a − b.
template <typename Number>
Number difference(double a, double b, int exponent);
template <>
double difference(double a, double b, int exponent) {
  return std::ldexp(a - b, exponent);
}
template <>
DoubleDouble difference(double a, double b, int exponent) {
  const DoubleDouble exact = DoubleDouble::difference(a, b);
  return {std::ldexp(exact.high, exponent), std::ldexp(exact.low, exponent)};
}
template <>
Rational difference(double a, double b, int /*exponent*/) {
  return Rational(a) - Rational(b);
}

double rounded(double value) { return value; }
double rounded(const DoubleDouble& value) { return value.high; }

template <typename Number>
struct Vector {
  Number x, y;
  friend Vector operator+(const Vector& u, const Vector& v) { return {Number(u.x + v.x), Number(u.y + v.y)}; }
  friend Vector operator-(const Vector& u, const Vector& v) { return {Number(u.x - v.x), Number(u.y - v.y)}; }
};
template <typename Number>
Number cross(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.y - u.y * v.x;
}

/// Returns the vector from one point to another.
template <typename Number>
Vector<Number> from(const Point& a, const Point& b, int exponent) {
  return {difference<Number>(b.x, a.x, exponent), difference<Number>(b.y, a.y, exponent)};
}

/// Returns the vector from a corner of a triangle to its circumcenter, given the vectors to the two other corners.
template <typename Number>
Vector<Number> to_circumcenter(const Vector<Number>& u, const Vector<Number>& v) {
  const Number uu = u.x * u.x + u.y * u.y, vv = v.x * v.x + v.y * v.y, area = cross(u, v);
  const Number twice = area + area;
  return {Number((v.y * uu - u.y * vv) / twice), Number((u.x * vv - v.x * uu) / twice)};
}

/// The maximum distance of the neighbors' weighted mean from the query, divided by that of the nearest neighbor.
constexpr double tolerance = 1e-9;

/// Returns whether products of six numbers of the size of `way` stay within the exponents of double.
bool stays(double way) { return way == 0 || (std::abs(way) > 0x1p-120 && std::abs(way) < 0x1p120); }

}  // namespace

/// Returns whether the circumcircle of the triangle across a side contains the query strictly inside; false if no
/// triangle is there.
bool NaturalNeighbors::goes_on_beyond(const Side& s, const Point& query) const {
  const std::uint32_t other = of_.neighbors[s.triangle][s.across];
  if (other == no_index) return false;
  const auto& [a, b, c] = of_.triangles[other];
  return Predicates<long double>::in_circle(points_[a], points_[b], points_[c], query) > 0;
}

/// Returns the side `s` as a side of the triangle across it.
NaturalNeighbors::Side NaturalNeighbors::beyond(const Side& s) const {
  const std::uint32_t other = of_.neighbors[s.triangle][s.across];
  const auto& back = of_.neighbors[other];
  return {other, static_cast<std::size_t>(std::find(back.begin(), back.end(), s.triangle) - back.begin())};
}

/// Walks once around the polygon of the natural neighbors, from its side `first` on. Calls visit(corner, area) for each
/// corner, with twice the area of the corner's part of the new cell; lengths are multiplied by 2^exponent.
template <typename Number, typename Visit>
void NaturalNeighbors::measure(const Point& query, const Side& first, int exponent, Visit visit) const {
  const auto way = [&](const Point& a, const Point& b) { return from<Number>(a, b, exponent); };
  const auto of_side = [&](const Side& s) {
    return to_circumcenter(way(query, points_[begin(s)]), way(query, points_[end(s)]));
  };
  const auto of_triangle = [&](std::uint32_t t) {
    const Triangle corners = least_first(points_, of_.triangles[t]);
    const Point &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]];
    return way(query, a) + to_circumcenter(way(a, b), way(a, c));
  };
  Side side = first;
  Vector<Number> center = of_side(side);
  do {
    const std::uint32_t corner = end(side);
    Vector<Number> last = of_triangle(side.triangle) - center;
    Number area{};
    for (side = next(side); goes_on_beyond(side, query); side = next(beyond(side))) {
      const Vector<Number> here = of_triangle(of_.neighbors[side.triangle][side.across]) - center;
      area = area + cross(here, last);
      last = here;
    }
    const Vector<Number> center_of_next = of_side(side);
    area = area + cross(Vector<Number>(center_of_next - center), last);
    center = center_of_next;
    visit(corner, area);
  } while (!(side == first));
}

template <typename Number, typename Visit>
void NaturalNeighbors::measure_in_order(const Point& query, const Side& first, int exponent, Visit visit) const {
  std::vector<std::pair<std::uint32_t, Number>> areas;
  measure<Number>(query, first, exponent, [&](std::uint32_t corner, Number area) { areas.emplace_back(corner, area); });
  const auto is_before = [&](const auto& a, const auto& b) { return points_[a.first] < points_[b.first]; };
  std::rotate(areas.begin(), std::min_element(areas.begin(), areas.end(), is_before), areas.end());
  for (const auto& [corner, area] : areas) visit(corner, area);
}

/// Computes shares_ in rounded numbers. Returns whether the shares satisfy Sibson's identity up to `tolerance`.
template <typename Number>
bool NaturalNeighbors::find_rounded(const Point& query, const Side& first, int exponent) {
  shares_.clear();
  double sum = 0, least = 0, nearest = std::numeric_limits<double>::infinity();
  Point mean = {0, 0};
  bool stay = true;
  measure_in_order<Number>(query, first, exponent, [&](std::uint32_t corner, const Number& measured) {
    const double area = rounded(measured);
    const Vector<double> way = from<double>(query, points_[corner], exponent);
    shares_.push_back({corner, std::max(0.0, area)});
    sum += shares_.back().share;
    least = std::min(least, area);
    nearest = std::min(nearest, std::hypot(way.x, way.y));
    stay = stay && stays(way.x) && stays(way.y);
    mean = {mean.x + area * way.x, mean.y + area * way.y};
  });
  for (PointShare& s : shares_) s.share /= sum;
  // A comparison with NaN is false.
  return stay && std::hypot(mean.x, mean.y) <= tolerance * sum * nearest && least >= -tolerance * sum;
}

void NaturalNeighbors::find_exactly(const Point& query, const Side& first) {
  shares_.clear();
  std::vector<Wide> areas;
  Wide sum = 0;
  measure_in_order<Rational>(query, first, 0, [&](std::uint32_t corner, const Rational& area) {
    shares_.push_back({corner, 0});
    sum += areas.emplace_back(area);
  });
  for (std::size_t i = 0; i < areas.size(); ++i) shares_[i].share = static_cast<double>(Wide(areas[i] / sum));
}

std::span<const PointShare> NaturalNeighbors::find(const Point& query, std::uint32_t t) {
  Side side{t, 0};
  while (goes_on_beyond(side, query)) side = next(beyond(side));
  double largest = 0;
  for (const std::uint32_t corner : of_.triangles[t])
    largest = std::max({largest, std::abs(points_[corner].x - query.x), std::abs(points_[corner].y - query.y)});
  const int exponent = std::isfinite(largest) ? -std::ilogb(largest) : 0;
  if (!find_rounded<double>(query, side, exponent) && !find_rounded<DoubleDouble>(query, side, exponent))
    find_exactly(query, side);
  return shares_;
}

}  // namespace rbpa
