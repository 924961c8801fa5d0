// What: makes polygon soups from two NumPy arrays: the corners of all faces, and the position of each face's first.
#pragma once

#include "meshops/topology/polygon_soup.h"
#include "python/arrays.h"

namespace rbpa::python {

/// Returns a copy of the faces. Face f has the corners corners[begin[f]] to corners[begin[f + 1] − 1]; `begin` has one
/// entry more than there are faces. `points` is the number of points; corners are not compared with `points`.
/// Throws: ContractViolation unless `begin` starts with 0, never decreases, and ends with the number of corners.
meshops::PolygonSoup soup_of(const Indices& corners, const Begins& begin, std::size_t points);

}  // namespace rbpa::python
