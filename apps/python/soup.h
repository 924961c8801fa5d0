// What: polygon soups from Python's arrays: the corners of all faces, and the begin of each face.
#pragma once

#include "meshops/topology/polygon_soup.h"
#include "python/arrays.h"

namespace rbpa::python {

/// Returns the faces. Throws ContractViolation if `begin` does not ascend from 0 to the number of corners.
meshops::PolygonSoup soup_of(const Indices& corners, const Begins& begin, std::size_t points);

}  // namespace rbpa::python
