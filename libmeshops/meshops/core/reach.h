// What: whether two halfedges lie on one boundary curve, or two faces in one component.
// Cost: that of the smaller of the two, because both are searched in turns: a sequence of operators that only splits or
//       only joins pays O(n log n) for it in all.
#pragma once

#include <optional>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Requires: boundary halfedges. Throws ContractViolation.
/// Cost:     the shorter of the two ways from one to the other; the shorter curve when they are on two.
MESHOPS_API bool on_same_curve(const Connectivity& mesh, Halfedge a, Halfedge b);

/// Whether a path across edges other than `without` leads from one face to the other.
/// Requires: live faces. Throws ContractViolation.
/// Cost:     linear in the smaller component when there are two; otherwise in what is searched before both searches
///           meet. Memory likewise.
MESHOPS_API bool in_same_component(const Connectivity& mesh, Face a, Face b, Edge without = Edge());

/// The faces of the smaller of two parts: those that can be reached from `a` or those that can be from `b`, whichever
/// search ends first; nothing when a path leads from one to the other. In the order in which they are reached.
/// Requires: live faces. Throws ContractViolation.
/// Cost:     as above.
MESHOPS_API std::optional<std::vector<Face>> smaller_part(const Connectivity& mesh, Face a, Face b,
                                                          Edge without = Edge());

}  // namespace meshops
