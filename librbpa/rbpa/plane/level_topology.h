// What: counts the simplices, components and holes of the complex after each level of a hierarchy.
// Law:  level_topology(h)[i] is count(rbpa(points, h.levels[i].alpha)).
// Cost: near-linear in the triangles and levels together: each triangle is added once.
#pragma once

#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/plane/topology.h"

namespace rbpa {

struct Hierarchy;  // rbpa/hrbpa.h

/// Returns the counts of the complex after each level, in the order of hierarchy.levels.
/// Requires: `hierarchy` is the result of hrbpa(), of which only the number of triangles is checked.
/// Throws:   ContractViolation when the number of faces of the mesh is not Level::triangles of the last level.
RBPA_API std::vector<ComplexCounts> level_topology(const Hierarchy& hierarchy);

}  // namespace rbpa
