// What: the tetrahedra that tiles have not found: those all of whose corners are unsettled.
// How:  each of them is Delaunay among the unsettled points too. What else there is in the triangulation of these is left out by
//       going from the faces that have a tetrahedron on one side only to the other side, and on from there to neighbors, never
//       across such a face.
// Cost: that of inserting the unsettled points.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid_rows.h"
#include "rbpa/space/tiles/border_faces.h"
#include "rbpa/space/tiles/leaves.h"

namespace rbpa::space {

/// Tetrahedra with places as corners, each once.
struct FoundRows {
  SolidRows rows;
  meshops::FreshVector<std::uint8_t> is_within;  ///< of each, whether its circumradius is at most alpha
  meshops::FreshVector<BorderFace> border;       ///< faces whose neighbor was not known when they were found
};

/// Appends them. Requires: all that have a settled corner, linked; the spread of the leaves' points.
void add_remainder(const Leaves& leaves, const Spread& spread, double alpha, const std::vector<Place>& unsettled,
                   FoundRows& found);

}  // namespace rbpa::space
