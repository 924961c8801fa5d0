// What:   finds loops that generate the first homology of a mesh, and edges along which to cut it into discs.
// Law:    a component of genus g with k boundary curves has b₁ = 2g + max(k − 1, 0) generators, a basis of H₁ over the
//         integers; cut along the cut graph, each component that is not a sphere is a disc.
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

/// Closed walk: halfedges, each of which starts where the one before it ends; the first starts where the last ends.
using Loop = std::vector<Halfedge>;

struct Homology {
  /// Loops that pass no vertex twice. The first halfedge of a loop is the first halfedge of the edge that closes the
  /// loop; this edge is in no other loop. Loops are in ascending order of their first halfedges.
  std::vector<Loop> generators;
  /// Inner edges, ascending; none dangles: an inner vertex is the end of none of them or of at least two. Empty when
  /// there is nothing to cut: for discs and also for spheres. (A sphere becomes a disc when any face is removed.)
  std::vector<Edge> cut_graph;
};

/// Finds loops with few edges: the tree from the least vertex of each component is breadth-first.
/// Requires: validate(mesh) is empty.
/// Throws:   Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, const GoOn& go_on = {});

/// Finds loops and a cut that are short by the lengths of the edges. `lengths` has an entry for each edge index;
/// entries of deleted edges are not read. Among all bases of loops from and to the least vertex of their component,
/// this one has the least total length if the path from that vertex to the loop and back is counted with the loop; the
/// generators leave this path out.
/// Requires: validate(mesh) is empty; `lengths` has an entry for each edge, none negative, with a finite sum.
/// Throws:   ContractViolation when `lengths` is not as required; Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on = {});

/// Returns only the generators of homology(), in about half the time. Requires and throws as homology() with lengths.
MESHOPS_API std::vector<Loop> homology_generators(const Connectivity& mesh, std::span<const double> lengths,
                                                  const GoOn& go_on = {});

}  // namespace meshops
