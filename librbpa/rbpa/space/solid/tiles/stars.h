// What: finds the Delaunay tetrahedra at the points of a tile, star by star.
// Law:  exact: a tetrahedron is found only if provably no other point is in its sphere; ties are perturbed. A point is
//       settled if all its tetrahedra are found. Points stay unsettled at the hull, and where a ball is too large for
//       the tile.
// How:  points are completed in their order. A face with a tetrahedron on one side waits at the first of its corners
//       that is not completed. When this corner is completed, the tetrahedron on the other side is found, each further
//       face of which closes a waiting face or waits itself. docs/explanation/space.md, sections 11 to 15.
// Cost: about a tenth of a microsecond for each tetrahedron.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/tiles/border_faces.h"
#include "rbpa/space/solid/tiles/leaf_points.h"

namespace rbpa::space {

struct Stars {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<Row> tetrahedra;  ///< positively oriented; corners are places; the least one is settled and in the leaf
  std::vector<std::uint8_t> is_within;  ///< for each tetrahedron, whether its circumradius is at most alpha
  std::vector<Row> neighbors;           ///< for each tetrahedron, its neighbors in `tetrahedra`, or none
  std::vector<BorderFace> border;       ///< faces of `tetrahedra` without a neighbor
  std::vector<Place> unsettled;         ///< the unsettled places of the leaf
  /// Other tetrahedra found with a corner in the leaf: the least corner is not a settled place of the leaf. If a corner
  /// is unsettled, the leaf of the least settled corner contributes the tetrahedron to the result.
  std::vector<Row> shared;
  std::vector<std::uint8_t> shared_is_within;  ///< is_within for `shared`
  std::size_t exact = 0;                       ///< number of decisions that needed more than a filter
};

/// A search for the tetrahedra of leaves, one leaf after the other, in one thread at a time.
class StarFinder {
 public:
  virtual ~StarFinder() = default;
  /// Replaces `found` by the tetrahedra of leaf number `leaf`.
  virtual void find(std::size_t leaf, Stars& found) = 0;
};

/// Returns a finder that keeps a reference to `leaves`. Requires: the points of `leaves` and `alpha` are scaled by
/// `spread`; spread.is_exact. An infinite alpha is allowed.
std::unique_ptr<StarFinder> star_finder(const Leaves& leaves, const Spread& spread, double alpha);

}  // namespace rbpa::space
