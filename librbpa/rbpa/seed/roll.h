// What:   rolls the ball around a point, from one contact to the next.
// Law:    starting where the ball rests on v and `from`, on the left of v→from, with no point inside it, contacts() are
//         the points q at which the ball, turning counter-clockwise around v, comes to rest after having rested on v
//         alone, up to and including `until`. Every Delaunay
//         triangle at v with circumradius ≤ alpha in that turn is in a fan that begins with one of the edges v–q.
//         docs/seeding.md has the proof.
// Cost:   one search of the part of the plane that the ball sweeps, and m log m for m points in it.
// Source: Restricted BPA, section 4, asks for ideal seeds and leaves the way open.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/predicate/radius.h"
#include "rbpa/search/point_grid.h"

namespace rbpa {

template <typename Real>
class Roll {
 public:
  using Site = std::uint32_t;
  using P = Predicates<Real>;
  using Vector = typename P::Vector;

  /// Requires a finite radius and |v–from|, |v–until| ≤ 2 alpha; no point inside the ball at the start nor at the end.
  /// With until = from the ball goes all the way round; from is then no contact.
  Roll(const PointGrid<Real>& grid, double alpha, Site v, Site from, Site until)
      : grid_(grid), points_(grid.points()), alpha_(alpha), v_(v), from_(from), until_(until) {}

  std::vector<Site> contacts() const {
    std::vector<Site> met = gather();
    std::sort(met.begin(), met.end(), [&](Site q, Site p) { return met_before(q, p); });
    std::vector<Site> result;
    Site cover = from_;  // of those met so far, the one that the ball leaves last
    for (const Site q : met) {
      // Where the ball still touches the one it leaves, the contact goes on: their triangle has circumradius alpha.
      if (cover == from_ || !touches_arriving_ball(q, cover)) {
        result.push_back(q);
        cover = q;
      } else if (!in_leaving_ball(q, cover)) {
        cover = q;
      }
      if (q == until_) break;
    }
    return result;
  }

  /// Of two points on which the ball can come to rest, both other than `from`: is q met before p?
  bool met_before(Site q, Site p) const {
    if (q == p) return false;
    // If one lies inside the ball that arrives at the other, it was met before.
    if (in_arriving_ball(p, q)) return true;
    if (in_arriving_ball(q, p)) return false;
    // Else they are met apart, or at once and then in the order in which they lie on the ball: by direction either way.
    const int turn_q = half_turn(q), turn_p = half_turn(p);
    if (turn_q != turn_p) return turn_q < turn_p;
    return P::orientation(at(v_), at(q), at(p)) > 0;
  }

  /// q is inside the ball that touches v and p and whose centre is right of v→p: where a counter-clockwise roll comes
  /// to rest on p. An angle at q decides, and if that is not enough the circumradius: no square root is needed.
  bool in_arriving_ball(Site p, Site q) const { return in_ball(p, q, -1, false); }
  /// The same, or q is on that ball.
  bool touches_arriving_ball(Site p, Site q) const { return in_ball(p, q, -1, true); }
  /// q is inside the ball that touches v and p and whose centre is left of v→p: where the roll leaves p.
  bool in_leaving_ball(Site p, Site q) const { return in_ball(p, q, 1, false); }

 private:
  const Point& at(Site s) const { return points_[s]; }

  bool in_ball(Site p, Site q, int centre_side, bool or_on) const {
    const int side = P::orientation(at(v_), at(p), at(q));
    const int cosine = P::dot_sign(at(q), at(v_), at(p));  // of the angle at q
    if (side == 0) return cosine < 0;                      // between v and p
    const auto circumradius = [&] { return P::compare_circumradius(at(v_), at(p), at(q), alpha_); };
    // On the side of the centre the ball's arc is at least half a circle, on the other at most half.
    if (side == centre_side) return cosine < 0 || circumradius() < (or_on ? 1 : 0);
    return cosine < (or_on ? 1 : 0) && circumradius() > (or_on ? -1 : 0);
  }

  /// 0, 1, 2 as the direction from v to q is less than, exactly, or more than half a turn after that to `from`.
  int half_turn(Site q) const {
    const int side = P::orientation(at(v_), at(from_), at(q));
    return side > 0 ? 0 : side == 0 ? 1 : 2;
  }

  /// While the ball touches q, `from` is inside it or on it: q was left before the roll began, or is met behind `from`
  /// when the ball is back there.
  bool already_left(Site q) const {
    const int side = P::orientation(at(v_), at(from_), at(q));
    if (side < 0) return in_arriving_ball(q, from_);
    if (P::dot_sign(at(v_), at(from_), at(q)) <= 0) return false;
    return side == 0 || in_leaving_ball(q, from_);
  }

  /// The points the ball may come to rest on before `until`, and `until` itself unless it is `from`.
  std::vector<Site> gather() const {
    std::vector<Site> found;
    const auto look = [&](Site first, Site last) {
      for (Site q = first; q < last; ++q)
        if (q != v_ && q != from_ && q != until_ && P::compare_to_diameter(at(v_), at(q), alpha_) <= 0 &&
            !already_left(q))
          found.push_back(q);
    };
    const Real diameter = 2 * Real(alpha_) * (1 + 64 * P::unit);
    const Vector centre{Real(at(v_).x), Real(at(v_).y)};
    const Ball start = ball(from_, 1), end = ball(until_, -1);
    const Real turn = P::cross(start.direction, end.direction);
    const Real size =
        std::sqrt(P::dot(start.direction, start.direction)) * std::sqrt(P::dot(end.direction, end.direction));
    const Real error = 4 * (start.error + end.error) / Real(alpha_);
    if (from_ == until_ || !(size > 0) ||
        !(std::abs(turn) > size * error || P::dot(start.direction, end.direction) < 0)) {
      // All the way round, or so nearly nothing or everything that rounded numbers cannot tell.
      grid_.scan(Region<Real>::disc(centre, diameter), look);
    } else {
      for (const Ball& b : {start, end})
        grid_.scan(Region<Real>::disc({centre.x + b.direction.x, centre.y + b.direction.y}, Real(alpha_) + b.error),
                   look);
      if (turn > 0) {
        scan_sector(diameter, start.direction, end.direction, error, look);
      } else {
        const Vector back{-start.direction.x, -start.direction.y};
        scan_sector(diameter, start.direction, back, error, look);
        scan_sector(diameter, back, end.direction, error, look);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    if (until_ != from_) found.push_back(until_);
    return found;
  }

  /// The disc around v between two directions at most half a turn apart, counter-clockwise. Near half a turn the tilted
  /// cuts may cross beyond v and take a sliver away there, which the balls at the two ends cover.
  template <typename Look>
  void scan_sector(Real radius, const Vector& low, const Vector& high, Real error, Look& look) const {
    auto region = Region<Real>::disc({Real(at(v_).x), Real(at(v_).y)}, radius);
    region.keep_left(at(v_), tilted(low, -error));
    region.keep_left(at(v_), tilted({-high.x, -high.y}, error));
    grid_.scan(region, look);
  }

  struct Ball {
    Vector direction;  ///< from v to its centre, approximate
    Real error;        ///< the centre is off by less
  };

  /// The ball that touches v and p, its centre on the given side of v→p.
  Ball ball(Site p, int side) const {
    const Vector d = P::from(at(v_), at(p));
    const Real length = std::sqrt(P::dot(d, d));
    const Real ratio = Real(alpha_) / length;
    const Real half = std::sqrt(std::max(Real(0), ratio * ratio - Real(0.25))) * Real(side);
    // Where the ball is hardly larger than the chord, the root of a difference of nearly equal numbers loses half of
    // the digits; else a few roundings are all.
    return {{d.x / 2 - half * d.y, d.y / 2 + half * d.x}, half_the_digits * length + 256 * P::unit * Real(alpha_)};
  }

  static Vector tilted(const Vector& d, Real by) { return {d.x - by * d.y, d.y + by * d.x}; }

  static constexpr Real half_the_digits = std::is_same_v<Real, double> ? Real(1e-7) : Real(1e-8);

  const PointGrid<Real>& grid_;
  std::span<const Point> points_;
  double alpha_;
  Site v_, from_, until_;
};

}  // namespace rbpa
