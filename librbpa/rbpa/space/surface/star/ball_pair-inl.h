// What: computes the two balls of the radius that touch v, p and q, for one pair (p, q) or for as many pairs as a
//       vector has lanes. The two centers are where the circles of p and q cross, on the sphere of centers of balls
//       that touch v.
// Law:  a bound of the error of the centers is known. docs/explanation/surfaces.md, sections 14 and 15.
// How:  relative to v, with n = p × q and D = 4r²n² − p²q²(p − q)², the centers are
//
//           (p² (q × n) + q² (n × p) ± √D n) / 2n²
//
//               n
//               ↑     · left: on (v, p, q)
//               │     │ √D / 2|n|
//           v ──┼─────m─────  plane of v, p and q; m is the circumcenter of the triangle
//                     │
//                     · right: on (v, q, p)
//
//       Compiled once for each kind of vector unit: Highway's toggle is the include guard.
#if defined(RBPA_SPACE_STAR_BALL_PAIR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_BALL_PAIR_INL_H_
#undef RBPA_SPACE_STAR_BALL_PAIR_INL_H_
#else
#define RBPA_SPACE_STAR_BALL_PAIR_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using rbpa::HWY_NAMESPACE::Vector3Lanes;

template <typename D>
class BallPair {
 public:
  using V = hn::Vec<D>;
  using Vector = Vector3Lanes<V>;
  /// A point relative to v. The power is half the square of its distance from v.
  struct Point {
    Vector at;
    V power;
  };
  struct Centers {
    Vector left, right;
  };

  HWY_INLINE BallPair(D d, const Point& p, const Point& q, double radius)
      : d_(d), radius_(radius), p_(p), q_(q), n_(cross(p.at, q.at)), nn_(dot(n_, n_)) {
    const Vector w = {hn::Sub(p.at.x, q.at.x), hn::Sub(p.at.y, q.at.y), hn::Sub(p.at.z, q.at.z)};
    product_ = hn::Mul(hn::Set(d, 4), hn::Mul(p.power, q.power));
    whole_ = hn::Mul(hn::Set(d, 4 * radius * radius), nn_);
    clearance_ = hn::NegMulAdd(product_, dot(w, w), whole_);
  }

  /// Returns the lanes in which certainly no ball touches all three points.
  HWY_INLINE hn::Mask<D> are_apart() const {
    return clearance_ < hn::Mul(hn::Set(d_, -limits::flatness * radius_ * radius_), product_);
  }
  /// Returns the lanes in which certainly both balls exist. The error of their centers may still be too large.
  HWY_INLINE hn::Mask<D> exist() const { return clearance_ > hn::Mul(hn::Set(d_, limits::flatness), whole_); }

  /// Returns a bound for the error of c · x − x²/2, for either center c, as a fraction of Σ|xᵢ|. Requires: exist().
  HWY_INLINE V error() const {
    const V terms = hn::MulAdd(hn::Mul(hn::Set(d_, 384), product_), inverse(),
                               hn::MulAdd(hn::Set(d_, 32), hn::Div(whole_, clearance_), hn::Set(d_, 32)));
    return hn::Mul(hn::Set(d_, limits::unit_roundoff * radius_), terms);
  }
  HWY_INLINE hn::Mask<D> is_accurate(V error) const { return error < hn::Set(d_, limits::error * radius_); }

  /// Returns the centers of the balls on (v, p, q) and on (v, q, p). Requires: exist().
  HWY_INLINE Centers centers() const {
    const V rise = hn::Mul(hn::Sqrt(clearance_), inverse());
    const Vector to_p = cross(q_.at, n_), to_q = cross(n_, p_.at);
    const V p_share = hn::Mul(hn::Add(p_.power, p_.power), inverse()),
            q_share = hn::Mul(hn::Add(q_.power, q_.power), inverse());
    const auto middle = [&](V p, V q) { return hn::MulAdd(p_share, p, hn::Mul(q_share, q)); };
    const Vector m = {middle(to_p.x, to_q.x), middle(to_p.y, to_q.y), middle(to_p.z, to_q.z)};
    return {{hn::MulAdd(n_.x, rise, m.x), hn::MulAdd(n_.y, rise, m.y), hn::MulAdd(n_.z, rise, m.z)},
            {hn::NegMulAdd(n_.x, rise, m.x), hn::NegMulAdd(n_.y, rise, m.y), hn::NegMulAdd(n_.z, rise, m.z)}};
  }

 private:
  HWY_INLINE V inverse() const { return hn::Div(hn::Set(d_, 0.5), nn_); }

  D d_;
  double radius_;
  Point p_, q_;
  Vector n_;
  V nn_, product_, whole_, clearance_;  // n², p²q², 4r²n² and D
};

/// The centers of the two balls that rest on v, p and q: there the circles of p and q cross.
struct Crossing {
  Vector3<double> left{}, right{};  // centers of the balls on (v, p, q) and (v, q, p)
  double error = 0;                 // BallPair::error()
  // is_certain: both balls exist, with accurate centers; is_impossible: certainly none exists. Both are integers
  // instead of bool, so that a copy is of whole registers: this avoids a store-forwarding stall.
  std::uint32_t is_certain = 0, is_impossible = 0;
};
inline Crossing crossing_of(const Neighbor& p, const Neighbor& q, double radius) {
  const hn::CappedTag<double, 1> d;
  using Pair = BallPair<decltype(d)>;
  const auto lane = [&](const Neighbor& x) {
    return typename Pair::Point{{hn::Set(d, x.at.x), hn::Set(d, x.at.y), hn::Set(d, x.at.z)}, hn::Set(d, x.power)};
  };
  const auto vector = [&](const typename Pair::Vector& x) {
    return Vector3<double>{hn::GetLane(x.x), hn::GetLane(x.y), hn::GetLane(x.z)};
  };
  const Pair pair(d, lane(p), lane(q), radius);
  Crossing both;
  both.is_certain = !hn::AllFalse(d, pair.exist());
  both.is_impossible = !hn::AllFalse(d, pair.are_apart());
  if (!both.is_certain) return both;
  const auto error = pair.error();
  const auto centers = pair.centers();
  both.left = vector(centers.left);
  both.right = vector(centers.right);
  both.error = hn::GetLane(error);
  both.is_certain = !hn::AllFalse(d, pair.is_accurate(error));
  return both;
}

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
