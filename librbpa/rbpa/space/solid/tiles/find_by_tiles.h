// What: finds the Delaunay tetrahedra of circumradius at most alpha, tile by tile. Tetrahedra whose corners no tile
//       settles come from a triangulation of these points.
// Law:  exact and complete; each tetrahedron once (docs/explanation/space.md, sections 11 to 15).
// Cost: about a microsecond a point, for points that fill a volume.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/rows/solid_rows.h"

namespace rbpa::space {

struct TiledSolid {
  SolidRows rows;                             ///< the tetrahedra; corners are places
  meshops::FreshVector<std::uint32_t> index;  ///< input index of each place
  std::vector<Duplicate> duplicates;
  std::size_t distinct = 0;
};

/// Limits beyond which find_by_tiles() gives up; tests set others.
struct TileLimits {
  std::size_t points_in_leaf = 8192;
  double most_crowding = 5;  ///< greatest Leaves::crowding(); beyond it, points are spread too unevenly
  // Limits of the fraction of unsettled points; the second for the first quarter of leaves, which may be at the hull.
  double most_unsettled = 0.25, most_unsettled_at_first = 0.5;
  double most_exact = 8;  ///< maximum number of exact decisions a point
};

/// Fills in `solid`. `alpha` and points are scaled by the spread, which is exact. `step(done, all)` is called for each
/// tile, from any thread; it may throw. Returns false if it gave up: too many points are at the hull, have balls larger
/// than tiles, or need exact decisions.
bool find_by_tiles(std::span<const Point3> points, const Spread& spread, double alpha, Threads& threads,
                   const std::function<void(std::size_t, std::size_t)>& step, TiledSolid& solid,
                   const TileLimits& limits = {});

}  // namespace rbpa::space
