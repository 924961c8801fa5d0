// What: decides whether two halfedges lie on one boundary curve, or two faces in one component.
// Cost: for two curves or components, the size of the smaller, because both are searched in turns. A sequence of
//       operators that each split one in two, or each join two, pays O(n log n) for these searches in total.
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

/// Returns whether a path across edges other than `without` leads from face `a` to face `b`; true when `a` is `b`.
/// Requires: `a` and `b` are live.
/// Throws:   ContractViolation otherwise.
/// Cost:     time and memory linear in the smaller component when there are two, otherwise in the faces visited before
///           the two searches meet.
MESHOPS_API bool in_same_component(const Connectivity& mesh, Face a, Face b, Edge without = Edge());

/// Returns the faces that paths across edges other than `without` reach from `a`, or the faces that such paths reach
/// from `b`, whichever are fewer (those of `a` when equally many), in breadth-first order. Returns nothing when such a
/// path leads from `a` to `b`.
/// Requires: `a` and `b` are live.
/// Throws:   ContractViolation otherwise.
/// Cost:     the cost of in_same_component().
MESHOPS_API std::optional<std::vector<Face>> smaller_part(const Connectivity& mesh, Face a, Face b,
                                                          Edge without = Edge());

}  // namespace meshops
