// What:   seeds of one level after another: triangles that the front of a level does not reach by itself.
// Law:    when next() returns nothing, no triangle within the level's radius is missing from the mesh, provided the
//         front ran dry between calls, and everything up to the level before was there when it began.
// How:    a site sleeps until the first level at which a triangle can have a corner there that no frozen edge leads to.
//         docs/hrbpa.md has the proof.
// Cost:   a short search per free site that wakes; a few pivots, once, per gap between fans that is wider than the
//         triangles at its two frozen edges.
// Source: Restricted BPA, section 4 (ideal seeds) and section 6 (levels).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/hierarchy/apexes.h"
#include "rbpa/hierarchy/ladder.h"
#include "rbpa/run/report.h"

namespace rbpa {

class LevelSeeds {
 public:
  using Real = long double;  ///< where exponents are not extreme, tiles tell all triangles
  using Site = meshops::Site;

  /// Keeps references.
  LevelSeeds(const PointGrid<Real>& grid, const Ladder<Real>& ladder, const Pivot<Real>& pivot, Apexes& apexes,
             Report& report);

  /// The level at which a site must be looked at next: before, there is no triangle at it but beyond frozen edges.
  int wake(meshops::Site s) const { return wake_[s]; }

  /// Begins a level, at which these sites are looked at as long as they are free.
  void begin(int level, std::vector<meshops::Site> free);

  /// A triangle of the level that is not in the mesh, counter-clockwise.
  std::optional<std::array<meshops::Site, 3>> next(const meshops::Front& front);

 private:
  struct Near {
    Real distance;  // squared
    Site site;
  };
  /// A fan with boundary: the apexes at the frozen edges before and after it, counter-clockwise, and where it begins.
  struct Fan {
    std::optional<Site> before, after;
    Site first;
    bool reached = false;  // by the walk from the fan before
  };

  void turn_to_boundary(const meshops::Front& front);
  void look_near(Site v);
  bool is_triangle(Site v, Site p, Site q) const;
  void gather(Site v, Real reach);
  void look_all_around(Site v);
  void look_into_gaps(const meshops::Front& front, Site v);
  template <typename EndsAt>
  bool walk_counter_clockwise(Site v, Site q, EndsAt ends_at, Real& least, Site hint);
  void walk_clockwise(Site v, Site q, Real& least);
  void consider(Site v, Site p, Site q, Real& least);
  void sleep(Site v, Real least);

  const PointGrid<Real>& grid_;
  std::span<const Point> points_;
  const Ladder<Real>& ladder_;
  const Pivot<Real>& pivot_;
  Apexes& apexes_;
  Report& report_;
  std::vector<std::uint16_t> wake_;
  std::vector<bool> reached_;  // looked at when two others were near enough for a triangle
  int level_ = 0;
  Radius radius_;
  std::vector<meshops::Site> due_;
  std::size_t next_ = 0;
  bool on_free_sites_ = true;  // else on the boundary
  std::vector<std::array<meshops::Site, 3>> pending_;
  std::vector<Near> near_;
  std::vector<Fan> fans_;
};

}  // namespace rbpa
