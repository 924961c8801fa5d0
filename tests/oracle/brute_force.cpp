#include "oracle/brute_force.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "oracle/rational.h"

namespace rbpa_test {
namespace {

template <typename Number>
struct Lifted {
  Number x, y, lift;        ///< lift = x² + y²
  std::uint32_t index = 0;  ///< index of the input point
  std::size_t epsilon = 0;  ///< rank by coordinates: the point of the larger rank has the infinitely larger ε
};

template <typename Number>
int sign(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Returns (b − a) × (c − a).
template <typename Number>
Number area(const Lifted<Number>& a, const Lifted<Number>& b, const Lifted<Number>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns the sign of the determinant with rows (x, y, lift + ε) of a − d, b − d, c − d: positive when d is inside the
/// circle of the counter-clockwise triangle (a, b, c). It is linear in the lifts, with these cofactors:
///   for a: [d b c]   for b: −[d a c]   for c: [d a b]   for d: −[a b c],   [p q r] = area(p, q, r).
template <typename Number>
int perturbed_in_circle(const Lifted<Number>& a, const Lifted<Number>& b, const Lifted<Number>& c,
                        const Lifted<Number>& d) {
  struct Term {
    const Lifted<Number>* point;
    Number cofactor;
  };
  Term terms[] = {{&a, area(d, b, c)}, {&b, -area(d, a, c)}, {&c, area(d, a, b)}, {&d, -area(a, b, c)}};
  Number determinant = 0;
  for (const Term& term : terms) determinant += term.cofactor * term.point->lift;
  if (const int s = sign(determinant); s != 0) return s;
  std::sort(std::begin(terms), std::end(terms),
            [](const Term& s, const Term& t) { return s.point->epsilon > t.point->epsilon; });
  for (const Term& term : terms)
    if (const int s = sign(term.cofactor); s != 0) return s;
  return 0;  // only when a, b, c are on a line
}

template <typename Number>
bool circumradius_fits(const Lifted<Number>& a, const Lifted<Number>& b, const Lifted<Number>& c, double alpha) {
  if (std::isinf(alpha)) return true;
  const auto square_distance = [](const Lifted<Number>& p, const Lifted<Number>& q) {
    const Number x = q.x - p.x, y = q.y - p.y;
    return Rational(x * x + y * y);
  };
  const Rational cross(area(a, b, c)), radius = rational(alpha);
  return square_distance(a, b) * square_distance(b, c) * square_distance(c, a) <= 4 * radius * radius * cross * cross;
}

template <typename Number, typename Convert>
std::vector<Triangle> all_triples(std::span<const rbpa::Point> points, double alpha, const Convert& convert) {
  std::vector<rbpa::Point> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());

  std::vector<Lifted<Number>> lifted;
  for (std::size_t rank = 0; rank < sorted.size(); ++rank) {
    const Number x = convert(sorted[rank].x), y = convert(sorted[rank].y);
    const auto first = std::find(points.begin(), points.end(), sorted[rank]);
    lifted.push_back({x, y, Number(x * x + y * y), static_cast<std::uint32_t>(first - points.begin()), rank});
  }

  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < lifted.size(); ++i)
    for (std::size_t j = i + 1; j < lifted.size(); ++j)
      for (std::size_t k = j + 1; k < lifted.size(); ++k) {
        const Lifted<Number>&a = lifted[i], *b = &lifted[j], *c = &lifted[k];
        const int turn = sign(area(a, *b, *c));
        if (turn == 0) continue;
        if (turn < 0) std::swap(b, c);
        const bool empty = std::none_of(lifted.begin(), lifted.end(), [&](const Lifted<Number>& d) {
          return &d != &a && &d != b && &d != c && perturbed_in_circle(a, *b, *c, d) > 0;
        });
        if (empty && circumradius_fits(a, *b, *c, alpha)) triangles.push_back({a.index, b->index, c->index});
      }
  return canonical(std::move(triangles));
}

}  // namespace

std::vector<Triangle> brute_force_in_rationals(std::span<const rbpa::Point> points, double alpha) {
  return all_triples<Rational>(points, alpha, [](double value) { return rational(value); });
}

std::vector<Triangle> brute_force(std::span<const rbpa::Point> points, double alpha) {
  // The determinant is of degree four: below 2²⁴ it stays below 2¹⁰⁴.
  const auto small_integer = [](double value) { return std::abs(value) < 0x1p24 && value == std::trunc(value); };
  const bool small = std::all_of(points.begin(), points.end(),
                                 [&](const rbpa::Point& p) { return small_integer(p.x) && small_integer(p.y); });
  if (!small) return brute_force_in_rationals(points, alpha);
  using Integer = boost::multiprecision::int128_t;
  return all_triples<Integer>(points, alpha, [](double value) { return Integer(static_cast<std::int64_t>(value)); });
}

}  // namespace rbpa_test
