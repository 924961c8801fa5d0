// What: faces as Python has them: all corners in one array, and where each face begins.
#pragma once

#include "meshops/topology/polygon_soup.h"
#include "python/arrays.h"

namespace rbpa::python {

/// Throws ContractViolation when the beginnings are not those of faces.
meshops::PolygonSoup soup_of(const Indices& corners, const Begins& begin, std::size_t points);

}  // namespace rbpa::python
