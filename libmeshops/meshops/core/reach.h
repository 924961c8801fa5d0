// What: decides whether two halfedges lie on one boundary curve, or two faces in one component.
// Cost: the size of the smaller of the two curves or components, because both are searched in turns. A sequence of
//       operators that only split or only join pays O(n log n) for these searches in total.
#pragma once

#include <optional>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Returns whether `a` and `b` lie on one boundary curve.
/// Requires: `a` and `b` are live boundary halfedges.
/// Throws:   ContractViolation otherwise.
/// Cost:     the shorter of the two ways from `a` to `b`; the length of the shorter curve when they lie on two.
MESHOPS_API bool on_same_curve(const Connectivity& mesh, Halfedge a, Halfedge b);

/// Returns whether a path across edges other than `without` leads from face `a` to face `b`.
/// Requires: `a` and `b` are live.
/// Throws:   ContractViolation otherwise.
/// Cost:     time and memory linear in the smaller component when there are two, otherwise in the faces visited before
///           the two searches meet.
MESHOPS_API bool in_same_component(const Connectivity& mesh, Face a, Face b, Edge without = Edge());

/// Returns all faces that paths across edges other than `without` reach from `a`, or all that they reach from `b`,
/// whichever search ends first, in the order of the search; nothing when such a path leads from `a` to `b`.
/// Requires: `a` and `b` are live.
/// Throws:   ContractViolation otherwise.
/// Cost:     as in_same_component().
MESHOPS_API std::optional<std::vector<Face>> smaller_part(const Connectivity& mesh, Face a, Face b,
                                                          Edge without = Edge());

}  // namespace meshops
