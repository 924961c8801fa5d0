// What: the Delaunay tetrahedra at the points of a tile, star by star.
// Law:  exact: a tetrahedron is found only if no other point is in its sphere, rounding considered and ties perturbed; a point is
//       settled if all tetrahedra at it are found. Where a ball is too large for the tile, and at the hull, points stay unsettled.
// How:  points are completed in their order. A face that has a tetrahedron on one side waits at the first of its corners that is not
//       completed; there the tetrahedron on the other side is found, and its faces are closed with those that wait, or wait themselves.
//       docs/solid_tiles.md.
// Cost: about a tenth of a microsecond a tetrahedron.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/tiles/border_faces.h"
#include "rbpa/space/tiles/tile.h"

namespace rbpa::space {

struct Stars {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<Row> tetrahedra;  ///< positively oriented places, the least corner being a settled one of the leaf
  std::vector<std::uint8_t> is_within;  ///< of each, whether its circumradius is at most alpha
  std::vector<Row> neighbors;           ///< numbers among them, or none
  std::vector<BorderFace> border;       ///< those that have none
  std::vector<Place> unsettled;         ///< of the leaf's points
  /// Further ones with a corner in the leaf, which has to give them if its corner is the first that is settled.
  std::vector<Row> shared;
  std::vector<std::uint8_t> shared_is_within;
  std::size_t exact = 0;  ///< how often a filter did not decide
};

/// Finds them, one leaf after the other. One at a time may be used by a thread.
class StarFinder {
 public:
  virtual ~StarFinder() = default;
  /// Replaces `found` by the tetrahedra of the leaf.
  virtual void find(std::size_t leaf, Stars& found) = 0;
};

/// Keeps the reference. Requires: leaves of scaled points, their spread being exact; alpha in the same scale, which may be infinite.
std::unique_ptr<StarFinder> star_finder(const Leaves& leaves, const Spread& spread, double alpha);

}  // namespace rbpa::space
