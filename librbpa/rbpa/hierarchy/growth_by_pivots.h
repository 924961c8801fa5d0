// What:   the complex from level to level by pivots and seeds, where exponents are extreme and there are no tiles.
// Law:    after grow() the mesh is the complex of the level's radius, if it was that of the level before; every boundary
//         halfedge is frozen.
// Source: Restricted BPA, section 6; docs/hrbpa.md.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "meshops/front/engine.h"
#include "rbpa/hierarchy/policy.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/report.h"

namespace rbpa {

class GrowthByPivots {
 public:
  using Real = LevelSeeds::Real;

  /// Keeps references.
  GrowthByPivots(const PointGrid<Real>& grid, const Ladder<Real>& ladder, Real grid_unit, Report& report)
      : report_(report),
        pivot_(grid, Radius(), grid_unit),
        apexes_(pivot_),
        seeds_(grid, ladder, pivot_, apexes_, report),
        policy_(grid, ladder, apexes_, seeds_),
        carried_(grid.points().size()) {
    std::iota(carried_.begin(), carried_.end(), 0);
  }
  GrowthByPivots(const GrowthByPivots&) = delete;
  GrowthByPivots& operator=(const GrowthByPivots&) = delete;

  /// A front without triangles.
  meshops::Front begin(Assembly<Real>& assembly) { return assembly.front(); }

  /// Attaches the triangles of a level to a front that was carried on to it.
  /// Returns: how many sites were looked at.
  std::size_t grow(int level, meshops::Front& front) {
    std::size_t awake = 0;
    std::vector<meshops::Site> free;
    for (const meshops::Site s : carried_) {
      if (seeds_.wake(s) > level) continue;
      ++awake;
      if (front.is_free(s)) free.push_back(s);
    }
    policy_.begin(level);
    seeds_.begin(level, std::move(free));
    meshops::advance(front, policy_, report_);
    return awake;
  }

  /// The first level after this one on which something can happen, given the sites that are carried on to it.
  int next(int, std::vector<meshops::Site> carried) {
    carried_ = std::move(carried);
    int next = policy_.next();
    for (const meshops::Site s : carried_) next = std::min(next, seeds_.wake(s));
    return next;
  }

 private:
  Report& report_;
  Pivot<Real> pivot_;
  Apexes apexes_;
  LevelSeeds seeds_;
  LevelPivoting policy_;
  std::vector<meshops::Site> carried_;
};

}  // namespace rbpa
