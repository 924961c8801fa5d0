// What: finds the tetrahedra whose corners are all unsettled: tiles have not found these.
// How:  each tetrahedron is also in the Delaunay triangulation of the unsettled points. To exclude the other tetrahedra
//       of this triangulation, the search starts across the faces that have a known tetrahedron on one side only,
//       continues to neighbors, and never crosses a face of this kind.
// Cost: that of inserting the unsettled points.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/rows/solid_rows.h"
#include "rbpa/space/solid/tiles/border_faces.h"
#include "rbpa/space/solid/tiles/leaves.h"

namespace rbpa::space {

/// The tetrahedra found, each once. Corners are places.
struct FoundRows {
  SolidRows rows;
  meshops::FreshVector<std::uint8_t> is_within;  ///< for each tetrahedron, whether its circumradius is at most alpha
  meshops::FreshVector<BorderFace> border;       ///< faces whose neighbor was unknown when they were found
};

/// Appends the tetrahedra whose corners are all in `unsettled` to `found`, with neighbors. Requires: `unsettled` has
/// all unsettled places, ascending; `found` has all tetrahedra with a settled corner, linked; the points of `leaves`
/// and `alpha` are scaled by `spread`. Throws InvalidInput for too many tetrahedra.
void add_remainder(const Leaves& leaves, const Spread& spread, double alpha, const std::vector<Place>& unsettled,
                   FoundRows& found);

}  // namespace rbpa::space
