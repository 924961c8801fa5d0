// What: finds the Delaunay tetrahedra of circumradius at most alpha, tile by tile. Tetrahedra without a corner that a
//       tile has settled (stars.h) come from one triangulation of all unsettled points.
// Law:  exact and complete; each tetrahedron is found once (docs/explanation/space.md, sections 11 to 15).
// Cost: about a microsecond a point if points fill a volume.
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
  SolidRows rows;                             ///< the tetrahedra; corners are places (leaves.h)
  meshops::FreshVector<std::uint32_t> index;  ///< input index of each place
  std::vector<Duplicate> duplicates;
  std::size_t distinct = 0;
};

/// The size of a leaf, and the limits beyond which find_by_tiles() returns false. Tests set other values.
struct TileLimits {
  std::size_t points_in_leaf = 8192;  ///< maximum, roughly
  double most_crowding = 5;           ///< greatest Leaves::crowding(); beyond it, points are spread too unevenly
  // Greatest fraction of unsettled points among the points of finished tiles: in the first quarter of the tiles, which
  // may be at the hull, most_unsettled_at_first; then most_unsettled.
  double most_unsettled = 0.25, most_unsettled_at_first = 0.5;
  double most_exact = 8;  ///< greatest number of exact decisions a point in finished tiles
};

/// Fills in `solid`. Calls step(done, all) with numbers of points after each tile, one call at a time, from any thread;
/// `step` may throw, or be empty. Returns false, with `solid` unchanged, if points are spread too unevenly, too many
/// points are unsettled (at the hull, or at balls larger than tiles), or too many decisions are exact.
/// Requires: `points` and `alpha` are scaled by `spread`; spread.is_exact; alpha may be infinite.
/// Throws:   InvalidInput for more than 2^30 tetrahedra; what step() throws.
bool find_by_tiles(std::span<const Point3> points, const Spread& spread, double alpha, Threads& threads,
                   const std::function<void(std::size_t, std::size_t)>& step, TiledSolid& solid,
                   const TileLimits& limits = {});

}  // namespace rbpa::space
