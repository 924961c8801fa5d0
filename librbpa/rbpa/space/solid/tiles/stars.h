// What: finds the Delaunay tetrahedra at the points of a tile, star by star.
// Law:  exact: a tetrahedron is found only if no other point is in its sphere, with rounding considered and ties
//       perturbed. A point is settled if all tetrahedra at it are found. Where a ball is too large for the tile, and at
//       the hull, points stay unsettled.
// How:  points are completed in their order. A face with a tetrahedron on one side waits at the first of its corners
//       that is not completed. When this corner is completed, the tetrahedron on the other side is found; each of its
//       faces closes a waiting face or waits itself. docs/explanation/space.md, sections 11 to 15.
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

  std::vector<Row> tetrahedra;  ///< positively oriented; corners are places, the least one a settled place of the leaf
  std::vector<std::uint8_t> is_within;  ///< for each tetrahedron, whether its circumradius is at most alpha
  std::vector<Row> neighbors;           ///< for each tetrahedron, its neighbors in `tetrahedra`, or none
  std::vector<BorderFace> border;       ///< faces of `tetrahedra` without a neighbor
  std::vector<Place> unsettled;         ///< the unsettled places of the leaf
  /// Other tetrahedra found with a corner in the leaf: their least corner is not a settled place of the leaf. If a
  /// corner is unsettled, the leaf of the least settled corner contributes the tetrahedron to the result.
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

/// Returns a finder, which keeps a reference to `leaves`. Requires: the points of `leaves` and `alpha` are scaled by
/// `spread`; spread.is_exact; alpha may be infinite.
std::unique_ptr<StarFinder> star_finder(const Leaves& leaves, const Spread& spread, double alpha);

}  // namespace rbpa::space
