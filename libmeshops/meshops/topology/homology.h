// What:   finds loops that generate the first homology of a mesh, and edges along which to cut it into discs.
// Law:    a component of genus g with k boundary curves has b₁ = 2g + max(k − 1, 0) generators, which are a basis of H₁
//         over the integers. After cuts along the cut graph, each component with faces is a disc or a sphere.
// Cost:   n log n in the size of the mesh, plus, for every loop, the depth of the tree of shortest paths.
// Source: Eppstein, Dynamic generators of topologically embedded graphs (SODA 2003), the tree and cotree; Erickson and
//         Whittlesey, Greedy optimal homotopy and homology generators (SODA 2005), the choice of the cotree.
#pragma once

#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"

namespace meshops {

/// Closed walk of halfedges: each starts where the halfedge before it ends, and the first starts where the last ends.
using Loop = std::vector<Halfedge>;

/// Loops that generate the first homology of a mesh, and edges along which to cut the mesh.
struct Homology {
  /// Loops that pass no vertex twice. The first halfedge of a loop is the first halfedge of the edge that closes the
  /// loop; this edge is in no other loop. The loops are in ascending order of their first halfedges.
  std::vector<Loop> generators;
  /// Inner edges to cut, ascending. No edge dangles: each inner vertex is an end of none of the edges, or of at least
  /// two. Discs and spheres have no such edges. (A sphere becomes a disc when any face is removed.)
  std::vector<Edge> cut_graph;
};

/// Finds loops and a cut with few edges, as if each edge had length 1.
/// Requires: validate(mesh) is empty; not checked.
/// Throws:   Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, const GoOn& go_on = {});

/// Finds loops and a cut that are short by the lengths of the edges. `lengths` has an entry for each edge index;
/// entries of deleted edges are not read. Each generator is a loop from and to the least vertex of its component,
/// without the common path from that vertex to the loop. With these paths, the basis has the least total length of all
/// bases of such loops.
/// Requires: validate(mesh) is empty, not checked; `lengths` has an entry ≥ 0 for each edge, with a finite sum.
/// Throws:   ContractViolation when `lengths` is not as required; Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on = {});

/// Returns only the generators of homology() with lengths, in about half the time. Requires and throws as homology().
MESHOPS_API std::vector<Loop> homology_generators(const Connectivity& mesh, std::span<const double> lengths,
                                                  const GoOn& go_on = {});

}  // namespace meshops
