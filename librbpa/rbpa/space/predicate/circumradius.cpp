#include "rbpa/space/predicate/circumradius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "rbpa/base/exact/double_double.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/least_reaching.h"

namespace rbpa::space {
namespace {

using Vector = std::array<DoubleDouble, 3>;

DoubleDouble dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The differences to the first of four points, times a power of two that makes the greatest coordinate one between 1 and 2.
struct Edges {
  std::array<Vector, 3> edge;
  int exponent;  ///< of that power
  bool are_fit;  ///< neither that power nor the differences are near the ends of the range of double
};

Edges edges(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  Edges edges{};
  double greatest = 0;
  const std::array<const Point3*, 3> to = {&b, &c, &d};
  for (std::size_t i = 0; i < 3; ++i) {
    edges.edge[i] = {DoubleDouble::difference(to[i]->x, a.x), DoubleDouble::difference(to[i]->y, a.y),
                     DoubleDouble::difference(to[i]->z, a.z)};
    for (const DoubleDouble& x : edges.edge[i]) greatest = std::max(greatest, std::abs(x.high));
  }
  edges.are_fit = greatest > 0x1p-800 && greatest < 0x1p+900;
  if (!edges.are_fit) return edges;
  edges.exponent = -std::ilogb(greatest);
  const double power = std::ldexp(1, edges.exponent);
  for (Vector& v : edges.edge)
    for (DoubleDouble& x : v) x = {power * x.high, power * x.low};
  return edges;
}

/// Where double-double decides it.
std::optional<double> by_double_double(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Edges scaled_edges = edges(a, b, c, d);
  if (!scaled_edges.are_fit) return std::nullopt;
  const auto& [u, v, w] = scaled_edges.edge;
  const Vector vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const DoubleDouble uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), volume = dot(u, vw);
  Vector centre;  // times 2 volume
  for (std::size_t i = 0; i < 3; ++i) centre[i] = uu * vw[i] + vv * wu[i] + ww * uv[i];
  const DoubleDouble squares = dot(centre, centre), diameter = volume + volume, denominator = diameter * diameter;

  // docs/predicates.md, section 7.
  constexpr double volume_error = 0x1p-93, centre_error = 0x1p-91, relative = 0x1p-98;
  const double size = std::sqrt(squares.high), half = std::abs(diameter.high);
  if (!(half > 0x1p-40)) return std::nullopt;
  const double squares_error = 4 * size * centre_error + 0x1p-180 + relative * squares.high;
  const double denominator_error = 8 * half * volume_error + 0x1p-180 + relative * denominator.high;
  /// Of r² − R², times the denominator; nothing where it is within its error.
  const auto sign = [&](double r) -> int {
    const DoubleDouble square = DoubleDouble{r, 0} * DoubleDouble{r, 0}, difference = square * denominator - squares;
    const double error = squares_error + 2 * square.high * denominator_error + relative * squares.high;
    return difference.high > error ? 1 : difference.high < -error ? -1 : 0;
  };
  double r = size / half;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  int of_r = sign(r);
  for (int steps = 0; of_r != 0 && steps < 8; ++steps) {
    const double next = std::nextafter(r, of_r > 0 ? 0 : infinity);
    const int of_next = sign(next);
    if (of_next == -of_r) {
      const double least = std::ldexp(std::max(r, next), -scaled_edges.exponent);
      return least > 0x1p-1000 && least < 0x1p+1000 ? std::optional(least) : std::nullopt;
    }
    r = next;
    of_r = of_next;
  }
  return std::nullopt;
}

/// By integers of any length.
double exactly(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  double estimate = 0;
  const Edges scaled_edges = edges(a, b, c, d);
  if (scaled_edges.are_fit) {
    const auto& [u, v, w] = scaled_edges.edge;
    const Vector vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = (dot(u, u) * vw[i] + dot(v, v) * wu[i] + dot(w, w) * uv[i]).high;
      square += x * x;
    }
    estimate = std::ldexp(std::sqrt(square) / (2 * std::abs(dot(u, vw).high)), -scaled_edges.exponent);
  }
  return least_reaching(estimate, [&](double r) { return exact::compare_circumradius(a, b, c, d, r) <= 0; });
}

}  // namespace

double circumradius_rounded_up(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const std::optional<double> radius = by_double_double(a, b, c, d);
  return radius ? *radius : exactly(a, b, c, d);
}

}  // namespace rbpa::space
