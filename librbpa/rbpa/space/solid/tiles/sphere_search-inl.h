// What: finds the apex of a face at a point of a tile, the fourth corner of the tetrahedron outside of the face.
// Law:  for a Delaunay face, an apex that is found is exact: no other point is in its sphere. No apex is found if no
//       candidate is outside of the face, as at the hull; if the sphere may contain points outside of the tile; or if
//       rounding leaves the sphere uncertain (is_certain()).
// How:  chooses the most probable candidate. If a point may be in the sphere of this candidate, an exact search
//       continues from it. docs/explanation/space.md, sections 11 to 15.
#if defined(RBPA_SPACE_TILES_SPHERE_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_TILES_SPHERE_SEARCH_INL_H_
#undef RBPA_SPACE_TILES_SPHERE_SEARCH_INL_H_
#else
#define RBPA_SPACE_TILES_SPHERE_SEARCH_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/sphere.h"
#include "rbpa/space/solid/tiles/candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

class SphereSearch {
 protected:
  SphereSearch(const Spread& spread, double alpha) : beyond_filter_(spread), alpha_(alpha) {}

  /// Prepares a search in a tile. Requires: tile_ has the points in and around `leaf`.
  void start_tile(const Leaf& leaf) {
    const std::size_t size = tile_.size();
    inverse_ = leaf.grid.inverse;
    inverse_2_ = inverse_ * inverse_;
    inverse_5_ = inverse_2_ * inverse_2_ * inverse_;
    reach_ = (Block::cells - 0x1p-8) * leaf.grid.size;
    pad_ = 0x1p-10 * leaf.grid.size;
    candidates_.start_tile(size);
    open_bits_.assign(size / 8 + 2, 0xff);
    exact_ = 0;
  }
  /// Prepares a search at the faces of point v. Requires: block_ has the unfinished points around v.
  void start_at(Local v) {
    at_ = v;
    v_ = point(v);
    candidates_.see(block_, v_, reach_, inverse_);
  }

  Point3 point(Local i) const { return {tile_.x(i), tile_.y(i), tile_.z(i)}; }
  HWY_INLINE Spoke spoke(Local i) const {
    const double x = tile_.x(i) - v_.x, y = tile_.y(i) - v_.y, z = tile_.z(i) - v_.z;
    return {x, y, z, x * x + y * y + z * z, 0};  // the length is not computed
  }

  /// Calls visit(first, end) for the points first … end − 1 in each row of `cells`.
  template <typename Visit>
  HWY_INLINE void for_each_row(const std::array<Tile::Range, 3>& cells, Visit visit) const {
    for (int x = cells[0].low; x <= cells[0].high; ++x)
      for (int y = cells[1].low; y <= cells[1].high; ++y)
        visit(tile_.first_in(tile_.cell(x, y, cells[2].low)), tile_.first_in(tile_.cell(x, y, cells[2].high) + 1));
  }
  /// The terms that all spheres through the face (v, p, q) share.
  struct Face {
    HWY_INLINE Face(const Spoke& p, const Spoke& q)
        : normal(cross<double>({p.x, p.y, p.z}, {q.x, q.y, q.z})),
          turned{p.square * q.x - q.square * p.x, p.square * q.y - q.square * p.y, p.square * q.z - q.square * p.z},
          sum(p.square + q.square),
          product(p.square * q.square) {}

    Vector3<double> normal, turned;  ///< p × q, and p² q − q² p
    double sum, product;             ///< p² + q², and p² q²
  };

  /// Returns the sphere through a face (v, p, q) and r, with the minors that sphere_minors(q, p, r) returns.
  HWY_INLINE static Sphere sphere_of(const Face& face, const Spoke& r) {
    const auto &n = face.normal, &m = face.turned;
    // The error bound of docs/explanation/exact_decisions.md, section 7, for spokes p, q, r of lengths α, β, γ, with
    // (α + β + γ)² ≤ 3 (α² + β² + γ²).
    const double weight = in_sphere_filter * std::sqrt(face.product * r.square);
    return {{n.x * r.square + (m.y * r.z - m.z * r.y), n.y * r.square + (m.z * r.x - m.x * r.z),
             n.z * r.square + (m.x * r.y - m.y * r.x), -(n.x * r.x + n.y * r.y + n.z * r.z)},
            1.5 * weight * (face.sum + r.square),
            1.5 * weight};
  }

  /// Returns whether the error of the center is below 1 % of the radius (docs/explanation/space.md, sections 11 to 15).
  HWY_INLINE static bool is_certain(const Sphere& sphere) { return -sphere.minor[3] > 0x1p10 * sphere.slope; }

  /// Returns a box that contains the ball of `sphere`. Requires: is_certain(sphere).
  Box box_of(const Sphere& sphere) const {
    const auto& m = sphere.minor;
    const double half = -0.5 / m[3], x = m[0] * half, y = m[1] * half, z = m[2] * half;
    const double radius = std::sqrt(x * x + y * y + z * z) * (1 + 0x1p-5) + pad_;
    const double cx = v_.x + x, cy = v_.y + y, cz = v_.z + z;
    return {{cx - radius, cy - radius, cz - radius}, {cx + radius, cy + radius, cz + radius}};
  }

  /// Returns whether the ball of `sphere` is so small that all unfinished points in it are candidates.
  HWY_INLINE bool is_within_reach(const Sphere& sphere) const {
    const auto& m = sphere.minor;
    return (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) * (1 + 0x1p-5) < m[3] * m[3] * (reach_ * reach_);
  }

  /// Sets apex_ and sphere_ to the apex and the sphere of the tetrahedron outside of the face (v, first, second): on
  /// the side from which v, first, second are counter-clockwise. Returns false if no apex is found; apex_ and sphere_
  /// are then unspecified.
  HWY_INLINE bool find_apex(Local first, Local second) {
    const std::size_t first_at = candidates_.position(first), second_at = candidates_.position(second);
    const Face face(first_at != Candidates::none ? candidates_.spoke(first_at) : spoke(first),
                    second_at != Candidates::none ? candidates_.spoke(second_at) : spoke(second));
    const std::size_t apex_at = choose(face);
    if (apex_at == Candidates::none) [[unlikely]]
      return false;  // no candidate: mostly at the hull
    sphere_ = sphere_of(face, candidates_.spoke(apex_at));
    apex_ = candidates_.id(apex_at);
    if (is_certain(sphere_) && candidates_.are_outside(sphere_, {first_at, second_at, apex_at})) [[likely]] {
      if (is_within_reach(sphere_)) [[likely]]
        return true;
    }
    return find_apex_exactly(first, second);
  }

  /// Returns the position of the most probable candidate outside of the face, or Candidates::none.
  HWY_INLINE std::size_t choose(const Face& face) const {
    const auto& n = face.normal;
    const Vector3<double> x = cross(face.turned, n);
    const auto single = [](double value) { return static_cast<float>(value); };
    return candidates_.least({single(x.x * inverse_5_), single(x.y * inverse_5_), single(x.z * inverse_5_)},
                             {single(n.x * inverse_2_), single(n.y * inverse_2_), single(n.z * inverse_2_)},
                             single(dot(n, n) * (inverse_2_ * inverse_2_)));
  }

  /// Finds the apex exactly, starting from the candidate apex_. Outside of the face (v, first, second), the balls
  /// through its corners are ordered by inclusion: a point inside the current ball is the next apex, and a point
  /// outside of the ball remains outside. Points on the inner side of a Delaunay face are in none of these balls.
  HWY_NOINLINE bool find_apex_exactly(Local first, Local second) {
    if (!is_certain(sphere_)) return false;  // the candidate may be on either side of the face
    const Face face(spoke(first), spoke(second));
    const auto look = [&](Local i) {
      if (i == first || i == second || i == apex_ || i == at_) return;
      const Spoke s = spoke(i);
      const double value = value_of(sphere_, s), error = sphere_.constant + sphere_.slope * s.square;
      if (value < -error) return;
      if (value <= error) {
        ++exact_;
        if (!beyond_filter_.is_inside(point(second), point(first), point(apex_), v_, point(i), value, error)) return;
      }
      apex_ = i;
      sphere_ = sphere_of(face, s);
    };
    candidates_.for_each_not_outside(sphere_, look);
    if (!is_certain(sphere_)) return false;
    if (!is_within_reach(sphere_)) {
      std::array<Tile::Range, 3> ranges;
      if (!tile_.ranges(box_of(sphere_), ranges)) return false;
      if (is_in_block(ranges))
        block_.for_each_not_outside(sphere_, v_, look);
      else
        for_each_not_outside(sphere_, ranges, look);
    }
    return is_certain(sphere_);
  }

  bool is_in_block(const std::array<Tile::Range, 3>& ranges) const {
    const auto& block = block_.ranges();
    bool is_in = true;
    for (std::size_t k = 0; k < 3; ++k) is_in &= block[k].low <= ranges[k].low && ranges[k].high <= block[k].high;
    return is_in;
  }

  /// Calls visit(i) for each unfinished point i in the cells `ranges` that is not certainly outside of `sphere`.
  template <typename Visit>
  void for_each_not_outside(const Sphere& sphere, const std::array<Tile::Range, 3>& ranges, Visit visit) const {
    const Doubles d;
    const SphereLanes of(sphere);
    const auto vx = hn::Set(d, v_.x), vy = hn::Set(d, v_.y), vz = hn::Set(d, v_.z);
    for_each_row(ranges, [&](Local first, Local end) HWY_ATTR {
      for (Local i = first; i < end; i += double_lanes) {
        std::uint64_t open = lane_bits(open_bits_.data(), i);
        if (end - i < double_lanes) open &= (1U << (end - i)) - 1;
        if (open == 0) continue;
        const auto px = hn::Sub(hn::LoadU(d, tile_.x() + i), vx), py = hn::Sub(hn::LoadU(d, tile_.y() + i), vy),
                   pz = hn::Sub(hn::LoadU(d, tile_.z() + i), vz);
        const auto square = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
        for (std::uint64_t left = open & ~of.outside(px, py, pz, square); left != 0; left &= left - 1)
          visit(i + static_cast<Local>(std::countr_zero(left)));
      }
    });
  }
  static double value_of(const Sphere& sphere, const Spoke& s) {
    return sphere.minor[0] * s.x + sphere.minor[1] * s.y + sphere.minor[2] * s.z + sphere.minor[3] * s.square;
  }

  /// Returns whether the circumradius of (second, first, apex_, v_) is at most alpha_, exactly.
  HWY_INLINE bool is_within(Local first, Local second) const {
    if (std::isinf(alpha_)) return true;
    const RadiusSide side = radius_side(sphere_.minor, ErrorBound(sphere_.constant, sphere_.slope), alpha_);
    if (side != RadiusSide::unknown) return side == RadiusSide::within;
    return exact::compare_circumradius(point(second), point(first), point(apex_), v_, alpha_) <= 0;
  }

  BeyondFilter beyond_filter_;
  double alpha_, inverse_ = 1, inverse_2_ = 1, inverse_5_ = 1, reach_ = 0, pad_ = 0;

  Tile tile_;
  Block block_;
  Candidates candidates_;
  std::vector<std::uint8_t> open_bits_;  // a bit for each point, set until the point is finished
  std::size_t exact_ = 0;

  // The current point.
  Local at_ = 0;
  Point3 v_{};
  // The apex found.
  Local apex_ = 0;
  Sphere sphere_{};
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
