// What:   one level of hierarchical ball pivoting as a policy of the advancing-front engine.
// Law:    proposes exactly the triangles of the level's complex that are not in the mesh.
// Source: Restricted BPA, section 6.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

#include "meshops/front/policy.h"
#include "rbpa/hierarchy/circumradius.h"
#include "rbpa/hierarchy/level_seeds.h"

namespace rbpa {

class LevelPivoting {
 public:
  using Real = LevelSeeds::Real;
  using Site = LevelSeeds::Site;

  /// Keeps references.
  LevelPivoting(const PointGrid<Real>& grid, const Ladder<Real>& ladder, Apexes& apexes, LevelSeeds& seeds)
      : points_(grid.points()), ladder_(ladder), apexes_(apexes), seeds_(seeds) {}

  void begin(int level) {
    radius_ = ladder_.radius(level);
    least_frozen_ = std::numeric_limits<Real>::infinity();
  }

  /// The first level at which a frozen edge may advance.
  int next() const { return ladder_.first_reaching(least_frozen_); }

  std::optional<std::array<meshops::Site, 3>> seed(const meshops::Front& front) { return seeds_.next(front); }

  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) {
    const bool is_kept = apexes_.is_kept(h);
    const auto apex = apexes_(front, h);
    if (apex) {
      const Point &a = points_[front.from_site(h)], &b = points_[front.to_site(h)];
      if (radius_.admits<Real>(a, b, points_[*apex])) return apex;
      least_frozen_ = std::min(least_frozen_, circumradius<Real>(a, b, points_[*apex]));
    }
    if (!is_kept) apexes_.keep(front, h, apex);
    return std::nullopt;
  }

 private:
  std::span<const Point> points_;
  const Ladder<Real>& ladder_;
  Apexes& apexes_;
  LevelSeeds& seeds_;
  Radius radius_;
  Real least_frozen_ = 0;
};

}  // namespace rbpa
