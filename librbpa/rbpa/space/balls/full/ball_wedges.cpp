#include "rbpa/space/balls/full/ball_wedges.h"

namespace rbpa::space {
namespace {

/// A result, and whether it needs double-double.
template <typename Result>
struct Tried {
  Result result;
  bool is_rough;
};

template <typename Real>
Tried<WedgePart> in_tetrahedron(const BallEdge<Real>& edge, const BallBeside<Real>& a, const BallBeside<Real>& b,
                                double radius, bool with_angle) {
  const Real cosine = dot(a.away, b.away);  // times both distances, as is the sine
  const double sine = std::abs(rounded(dot(edge.to, cross(a.away, b.away)))) / std::sqrt(rounded(edge.square));
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
Tried<WedgePart> beside_triangle(const BallEdge<Real>& edge, const BallBeside<Real>& side, double radius) {
  const Real exact = exactly<Real>(radius), ii = exact * exact;
  // Half of the chord in which the line of same power meets the balls, squared.
  const double square = rounded(ii - edge.lift * edge.lift / edge.square - side.offset * side.ratio);
  const double half = std::sqrt(std::max(square, 0.0)), y = std::sqrt(rounded(side.square));
  if (!(y > 0)) return {{}, true};
  const double away = rounded(side.offset) / y;
  return {{std::atan2(half, away), half * away / 2, half * rounded(side.rate) / y},
          side.is_thin || square < lossy * rounded(ii)};
}

template <typename Real>
Tried<double> corner_angle(const Ball& i, const Ball& j, const Ball& k) {
  const BallEdge<Real> u(i, j), v(i, k);
  const Vector3<Real> normal = cross(u.to, v.to), w = minus(times(u.lift, v.to), times(v.lift, u.to));
  const Real nn = dot(normal, normal), radius = exactly<Real>(i.radius), ii = radius * radius;
  const double square = rounded(nn) > 0 ? std::min(rounded(ii - dot(w, w) / nn), rounded(ii)) : 0;
  const double y = i.radius * std::sqrt(std::max(square, 0.0) * rounded(nn)),
               x = rounded(ii * dot(u.to, v.to) - u.lift * v.lift);
  return {std::atan2(y, x),
          rounded(nn) < lossy * rounded(u.square) * rounded(v.square) || square < lossy * rounded(ii)};
}

}  // namespace

BallCircle::BallCircle(const Ball& i, const Ball& j) : i_(i), j_(j), edge_(i, j) {
  distance = std::sqrt(edge_.square) / edge_.scale;
  const double shift = (i.radius - j.radius) / distance * (i.radius + j.radius) / 2;
  height_i = distance / 2 + shift;
  height_j = distance / 2 - shift;
  square = std::max((i.radius - height_i) * (i.radius + height_i), 0.0);
}

WedgePart BallCircle::in_tetrahedron(const Side& k, const Side& l, bool with_angle) const {
  const Tried<WedgePart> tried = space::in_tetrahedron(edge_, k, l, i_.radius, with_angle);
  if (!tried.is_rough) return tried.result;
  const BallEdge<DoubleDouble> edge(i_, j_);
  return space::in_tetrahedron(edge, {edge, i_, j_, *k.ball}, {edge, i_, j_, *l.ball}, i_.radius, with_angle).result;
}

WedgePart BallCircle::beside_triangle(const Side& k) const {
  const Tried<WedgePart> tried = space::beside_triangle(edge_, k, i_.radius);
  if (!tried.is_rough) return tried.result;
  const BallEdge<DoubleDouble> edge(i_, j_);
  return space::beside_triangle(edge, {edge, i_, j_, *k.ball}, i_.radius).result;
}

double corner_angle(const Ball& i, const Ball& j, const Ball& k) {
  const Tried<double> tried = corner_angle<double>(i, j, k);
  return tried.is_rough ? corner_angle<DoubleDouble>(i, j, k).result : tried.result;
}

}  // namespace rbpa::space
