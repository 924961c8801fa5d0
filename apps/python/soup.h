// What: makes polygon soups of NumPy arrays: the corners of all faces, and the index at which each face begins.
#pragma once

#include "meshops/topology/polygon_soup.h"
#include "python/arrays.h"

namespace rbpa::python {

/// Returns a copy of the faces: face f has corners[begin[f]] to corners[begin[f + 1] − 1]. `points` is the number of
/// points. `begin` has one entry more than there are faces. Corners need not be below `points`, as in any PolygonSoup.
/// Throws: ContractViolation unless `begin` starts with 0, never decreases, and ends with the number of corners.
meshops::PolygonSoup soup_of(const Indices& corners, const Begins& begin, std::size_t points);

}  // namespace rbpa::python
