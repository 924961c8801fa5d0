// What:   the operator that merges one vertex of an edge into the other.
// Law:    collapse(h) is: flip at the vertex until h and its two neighbors are its only edges, then weld the face.
// Source: Lewiner et al., section on stellar operators; Dey, Edelsbrunner, Guha, Nekhayev, Topology preserving edge
//         contraction (1999) for the link condition.
#pragma once

#include <optional>
#include <string>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/effect.h"
#include "meshops/stellar/keep.h"

namespace meshops {

/// Why h cannot be collapsed, or nothing when it can: a face beside it is not a triangle; it is an inner edge between
/// boundary vertices (they would become a pinch); another edge joins its vertices (it would become a loop); nothing but
/// an edge would be left; Keep::simplicial: the link condition, i.e. the ends have a common neighbor other than the
/// apexes, or both have three edges on a tetrahedron. Of this and of all operators that delete: the mesh has no status.
MESHOPS_API std::optional<std::string> collapse_blocker(const Connectivity& mesh, Halfedge h,
                                                        Keep keep = Keep::simplicial);

/// The vertex v of h = v→w vanishes into w, which takes over its fan; the triangles beside h close.
/// Effect:      v, the edge of h, the edges from v to the apexes, and the faces beside h are marked deleted. Every
///              other halfedge from or to v is now one from or to w. The edges from w to the apexes survive for both.
///              Only when v has two edges, of the two from w to the apex that on the right survives.
/// Requires:    collapse_blocker() is empty; the mesh has status.
/// Throws:      ContractViolation, mesh untouched.
/// Invalidates: what is marked deleted.
/// Inverse:     split_vertex(left, right) with what is returned, up to handles; undo(), exactly.
/// Δ:           V −1, E −3, F −2; along a boundary edge V −1, E −2, F −1; the topology stays.
/// Cost:        the degree of v; Keep::simplicial: for each edge of v up to the degree of w.
MESHOPS_API WeldEffect collapse(Connectivity& mesh, Halfedge h, Keep keep = Keep::simplicial);

}  // namespace meshops
