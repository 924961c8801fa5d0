#include "rbpa/space/balls/full/ball_wedges.h"

#include <numbers>
#include <utility>

namespace rbpa::space {
namespace {

/// Ratios of squares: below `lossy`, a rounded difference has lost too many digits; `thin` limits flat triangles.
constexpr double lossy = 0x1p-10, thin = 0x1p-6;

/// A third ball seen along an edge, at the distance y from the edge. The line of points of equal power to all three
/// balls is at the distance `offset` / y from the edge, and moves by `rate` / y when all radii grow.
template <typename Real>
struct Side {
  Real square, offset, rate, ratio;  // square: y²; ratio: offset / square
  bool is_thin;                      // the triangle is too flat, or values are too rough for another reason

  /// The third ball is at the end of the spoke: `along` times the edge along it, and √`apart` away from it.
  Side(const BallEdge<Real>& edge, const BallEdge<Real>& spoke, const Real& along, const Real& apart)
      : square(apart),
        offset(spoke.lift - along * edge.lift),
        rate(spoke.shrink - along * edge.shrink),
        ratio(offset / square),
        is_thin(!(rounded(square) >= thin * rounded(spoke.square))) {}
};

Side<double> side_of(const EdgeOfBalls& edge, const EdgeOfBalls& spoke, double product) {
  const double along = product * edge.inverse;
  Side<double> side(edge, spoke, along, spoke.square - along * product);
  side.is_thin |= edge.is_uneven || spoke.is_uneven;
  return side;
}

/// A side, computed from vectors. Both ends of the edge give equal results; the end nearer to the third ball is chosen,
/// from which short distances are exact.
struct PreciseSide {
  using Edge = BallEdge<DoubleDouble>;
  PreciseSide(const Ball& i, const Ball& j, const Ball& k)
      : edge(i, j),
        base(distance(j.center, k.center) < distance(i.center, k.center) ? Edge(j, i) : edge),
        spoke(*base.a, k),
        along(dot(spoke.to, base.to) / base.square),
        away(minus(spoke.to, times(along, base.to))),
        side(base, spoke, along, dot(away, away)) {}
  Edge edge, base, spoke;
  DoubleDouble along;
  Vector3<DoubleDouble> away;
  Side<DoubleDouble> side;
};

/// A result in double, and whether it must be computed again in double-double.
template <typename Result>
struct Tried {
  Result result;
  bool is_rough;
};

/// Returns the part in a tetrahedron between two sides. Cosine and sine of the angle are multiplied by both distances.
template <typename Real>
Tried<WedgePart> between(const Side<Real>& a, const Side<Real>& b, const Real& cosine, double sine, double radius,
                         bool with_angle) {
  if (!(sine > 0)) return {{}, true};
  const Real oo = a.offset * b.offset, aa = a.offset * a.ratio, bb = b.offset * b.ratio, sum = aa + bb;
  WedgePart part;
  part.area = rounded(oo + oo - sum * cosine) / (2 * sine);
  part.growth = rounded(a.rate * b.offset + a.offset * b.rate - (a.rate * a.ratio + b.rate * b.ratio) * cosine) / sine;
  if (with_angle) part.angle = std::atan2(sine, rounded(cosine));
  const double terms = 2 * std::abs(rounded(oo)) + rounded(sum) * std::abs(rounded(cosine));
  return {part, a.is_thin || b.is_thin || lossy * terms > sine * radius * radius};
}

template <typename Real>
Tried<WedgePart> beside(const BallEdge<Real>& edge, const Side<Real>& side) {
  const Real radius = exactly<Real>(edge.a->radius), ii = radius * radius;
  // The square of half the chord in which the line of equal power meets the balls.
  const double square = rounded(ii - edge.lift * edge.lift / edge.square - side.offset * side.ratio);
  const double half = std::sqrt(std::max(square, 0.0)), y = std::sqrt(rounded(side.square));
  if (!(y > 0)) return {{}, true};
  const double away = rounded(side.offset) / y;
  return {{std::atan2(half, away), half * away / 2, half * rounded(side.rate) / y},
          side.is_thin || square < lossy * rounded(ii)};
}

template <typename Real>
Tried<double> angle_at_corner(const BallEdge<Real>& u, const BallEdge<Real>& v) {
  const Vector3<Real> normal = cross(u.to, v.to), w = minus(times(u.lift, v.to), times(v.lift, u.to));
  const Real nn = dot(normal, normal), radius = exactly<Real>(u.a->radius), ii = radius * radius;
  const double square = rounded(nn) > 0 ? std::min(rounded(ii - dot(w, w) / nn), rounded(ii)) : 0;
  const double y = u.a->radius * std::sqrt(std::max(square, 0.0) * rounded(nn)),
               x = rounded(ii * dot(u.to, v.to) - u.lift * v.lift);
  return {std::atan2(y, x),
          rounded(nn) < lossy * rounded(u.square) * rounded(v.square) || square < lossy * rounded(ii)};
}

/// Returns the square of the radius of the circle in which the spheres of an edge meet; negative if they do not meet.
double square_of_circle(const EdgeOfBalls& edge) {
  const bool is_smaller = edge.a->radius <= edge.b->radius;
  const BallEdge<DoubleDouble> from_smaller(is_smaller ? *edge.a : *edge.b, is_smaller ? *edge.b : *edge.a);
  const DoubleDouble radius = exactly<DoubleDouble>(from_smaller.a->radius);
  return rounded(radius * radius - from_smaller.lift * from_smaller.lift / from_smaller.square);
}

WedgePart precise_in_tetrahedron(const Ball& i, const Ball& j, const Ball& k, const Ball& l, bool with_angle) {
  const PreciseSide a(i, j, k), b(i, j, l);
  const double sine = std::abs(rounded(dot(a.edge.to, cross(a.away, b.away)))) / std::sqrt(rounded(a.edge.square));
  return between(a.side, b.side, dot(a.away, b.away), sine, i.radius, with_angle).result;
}

/// Returns the corner angle at a sphere where it meets that of a very small ball, at the end of `edge`, and a third
/// one. The cotangent formula gives it from the angle beside the triangle, which is accurate only if computed from the
/// small ball.
double angle_near_small_ball(const EdgeOfBalls& edge, const EdgeOfBalls& other) {
  const CircleOfBalls circle(edge);
  const double angle = beside_triangle(edge, other).angle;
  const Vector3<double> normal = cross(edge.to, other.to);
  const double sine = std::sqrt(dot(normal, normal)), cosine = dot(edge.to, other.to);
  return std::atan2(edge.a->radius * std::sin(angle) * sine,
                    std::sqrt(circle.square) * cosine - circle.height_i * std::cos(angle) * sine);
}

}  // namespace

bool EdgeOfBalls::are_tangent() const { return square_of_circle(*this) <= 0x1p-90 * a->radius * b->radius; }

EdgesAtCorner::EdgesAtCorner(const std::array<const EdgeOfBalls*, 3>& edges) : edge(edges) {
  const auto& [a, b, c] = edges;
  product = {dot(b->to, c->to), dot(c->to, a->to), dot(a->to, b->to)};
  volume = std::abs(dot(a->to, cross(b->to, c->to)));
}

WedgePart in_tetrahedron(const EdgesAtCorner& at, std::size_t k, bool with_angle) {
  const std::size_t first = (k + 1) % 3, second = (k + 2) % 3;
  const EdgeOfBalls &edge = *at.edge[k], &a = *at.edge[first], &b = *at.edge[second];
  const double to_a = at.product[second], to_b = at.product[first], radius = edge.a->radius;
  const Tried<WedgePart> tried =
      between(side_of(edge, a, to_a), side_of(edge, b, to_b), at.product[k] - to_a * edge.inverse * to_b,
              at.volume * edge.inverse_length, radius, with_angle);
  return tried.is_rough ? precise_in_tetrahedron(*edge.a, *edge.b, *a.b, *b.b, with_angle) : tried.result;
}

WedgePart beside_triangle(const EdgeOfBalls& edge, const EdgeOfBalls& other) {
  if (edge.is_tangent) return {};
  const Tried<WedgePart> tried = beside<double>(edge, side_of(edge, other, dot(edge.to, other.to)));
  if (!tried.is_rough) return tried.result;
  const bool from_b = edge.is_uneven && edge.b->radius < edge.a->radius;
  const PreciseSide precise(from_b ? *edge.b : *edge.a, from_b ? *edge.a : *edge.b, *other.b);
  return beside(precise.edge, precise.side).result;
}

CircleOfBalls::CircleOfBalls(const EdgeOfBalls& edge) : distance(std::sqrt(edge.square) / edge.scale) {
  const double r = edge.a->radius, s = edge.b->radius, shift = (r - s) / distance * (r + s) / 2;
  height_i = distance / 2 + shift;
  height_j = distance / 2 - shift;
  square = std::max((r - height_i) * (r + height_i), 0.0);
  if (!edge.is_uneven) return;
  const auto height = [](const BallEdge<DoubleDouble>& from) {
    return rounded(from.lift) / std::sqrt(rounded(from.square));
  };
  height_i = height({*edge.a, *edge.b});
  height_j = height({*edge.b, *edge.a});
  square = std::max(square_of_circle(edge), 0.0);
}

double corner_angle(const EdgeOfBalls& j, const EdgeOfBalls& k) {
  // If spheres touch, the angle is the limit for a small circle, around which the angle beside the triangle is 0.
  for (const EdgeOfBalls* edge : {&j, &k})
    if (edge->is_tangent) return edge->lift > 0 ? std::numbers::pi : 0;
  for (const auto& [edge, other] : {std::pair{&j, &k}, std::pair{&k, &j}})
    if (edge->b->radius < 0x1p-24 * edge->a->radius) return angle_near_small_ball(*edge, *other);
  const Tried<double> tried = angle_at_corner<double>(j, k);
  if (!tried.is_rough && !j.is_uneven && !k.is_uneven) return tried.result;
  return angle_at_corner<DoubleDouble>({*j.a, *j.b}, {*k.a, *k.b}).result;
}

}  // namespace rbpa::space
