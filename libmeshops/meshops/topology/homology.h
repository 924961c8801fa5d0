// What:   finds loops that generate the first homology of a mesh, and edges along which to cut it into discs.
// Law:    a component of genus g with k boundary curves has b₁ = 2g + max(k − 1, 0) generators, a basis of H₁ over the
//         integers; cut along the cut graph, each component with faces is a disc, unless it is a sphere.
// Cost:   n log n in the size of the mesh, plus for every loop the depth of the tree of shortest paths.
// Source: Eppstein, Dynamic generators of topologically embedded graphs (SODA 2003), the tree and cotree; Erickson and
//         Whittlesey, Greedy optimal homotopy and homology generators (SODA 2005), the choice of the cotree.
#pragma once

#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"

namespace meshops {

/// Closed walk: halfedges, each of which starts where the halfedge before ends; the first starts where the last ends.
using Loop = std::vector<Halfedge>;

/// Loops of a mesh, and edges along which to cut it.
struct Homology {
  /// Loops that pass no vertex twice. The first halfedge of a loop is the first halfedge of the edge that closes the
  /// loop; this edge is in no other loop. Loops are in ascending order of their first halfedges.
  std::vector<Loop> generators;
  /// Inner edges to cut, ascending; none dangles: an inner vertex is the end of none of these edges, or of at least
  /// two. Discs have none, nor have spheres. (A sphere becomes a disc when any face is removed.)
  std::vector<Edge> cut_graph;
};

/// Finds loops and a cut with few edges: each edge has length 1.
/// Requires: validate(mesh) is empty; not checked.
/// Throws:   Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, const GoOn& go_on = {});

/// Finds loops and a cut that are short by the lengths of the edges. `lengths` has an entry for each edge index;
/// entries of deleted edges are not read. Each generator is a loop from and to the least vertex of its component,
/// without the path from that vertex to the loop and back. With these paths, the basis has the least total length of
/// all bases of such loops.
/// Requires: validate(mesh) is empty, not checked; `lengths` has an entry ≥ 0 for each edge, with a finite sum.
/// Throws:   ContractViolation when `lengths` is not as required; Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on = {});

/// Returns only the generators of homology() with lengths, in about half the time. Requires and throws the same.
MESHOPS_API std::vector<Loop> homology_generators(const Connectivity& mesh, std::span<const double> lengths,
                                                  const GoOn& go_on = {});

}  // namespace meshops
