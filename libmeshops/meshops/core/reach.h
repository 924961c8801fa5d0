// What: decides whether two halfedges lie on one boundary curve, or two faces in one component.
// Cost: for two curves or components, the size of the smaller, because both are searched in turns. A sequence of
//       operators that each split one curve or component in two, or each join two, searches in O(m log m) time for m
//       halfedges of these curves, or m faces of these components, together.
#pragma once

#include <optional>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Returns whether the halfedges `a` and `b` lie on one boundary curve.
/// Requires: `a` and `b` are live boundary halfedges.
/// Throws:   ContractViolation otherwise.
/// Cost:     the shorter of the two ways along the curve from `a` to `b`; for two curves, the length of the shorter.
MESHOPS_API bool on_same_curve(const Connectivity& mesh, Halfedge a, Halfedge b);

/// Returns whether a path across edges other than `without` leads from face `a` to face `b`; true if `a` is `b`.
/// Requires: `a` and `b` are live.
/// Throws:   ContractViolation otherwise.
/// Cost:     time and memory linear in the smaller component if `a` and `b` are in two; otherwise linear in the number
///           of faces visited before the two searches meet.
MESHOPS_API bool in_same_component(const Connectivity& mesh, Face a, Face b, Edge without = Edge());

/// Compares the faces that paths across edges other than `without` reach from the face `a` with the faces that such
/// paths reach from the face `b`, and returns the smaller set, in breadth-first order; the set of `a` if both have the
/// same size. Returns nothing if such a path leads from `a` to `b`.
/// Requires: `a` and `b` are live.
/// Throws:   ContractViolation otherwise.
/// Cost:     the cost of in_same_component().
MESHOPS_API std::optional<std::vector<Face>> smaller_part(const Connectivity& mesh, Face a, Face b,
                                                          Edge without = Edge());

}  // namespace meshops
