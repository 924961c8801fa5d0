// What:   loops that generate the first homology of a mesh, and edges along which it is cut into discs.
// Law:    a component of genus g with k boundary curves has b₁ = 2g + max(k − 1, 0) generators, a basis of H₁ over the
//         integers; cut along the cut graph, each component that is not a sphere is a disc.
// Cost:   n log n in the size of the mesh, plus for every loop the depth of the tree of shortest ways.
// Source: Eppstein, Dynamic generators of topologically embedded graphs (SODA 2003), the tree and cotree; Erickson and
//         Whittlesey, Greedy optimal homotopy and homology generators (SODA 2005), the choice of the cotree.
#pragma once

#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"

namespace meshops {

/// The halfedges of a closed walk: each starts where the one before ends, the first where the last ends.
using Loop = std::vector<Halfedge>;

struct Homology {
  /// Loops that meet no vertex twice. The first halfedge of a loop is the first of the edge that closes it: it is in no
  /// other loop. In ascending order of that.
  std::vector<Loop> generators;
  /// Inner edges, ascending; without dangling edges: an inner vertex is an end of none or of at least two. Empty
  /// where there is nothing to cut, for discs and also for spheres: a sphere becomes a disc when any face is removed.
  std::vector<Edge> cut_graph;
};

/// Loops with few edges: the tree from the least vertex of a component is breadth-first.
/// Requires: validate(mesh) is empty.
/// Throws:   Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, const GoOn& go_on = {});

/// Loops and cut that are short by the lengths of the edges, by edge index; places of deleted edges are not read. Of
/// all bases of loops from and to the least vertex of their component these have the least total length, as long as the
/// way from that vertex and back is counted with the loop; the generators leave it out.
/// Requires: validate(mesh) is empty; a length for each edge, none negative, with a finite sum.
/// Throws:   ContractViolation; Cancelled.
MESHOPS_API Homology homology(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on = {});

/// The generators of homology() alone, in about half its time.
MESHOPS_API std::vector<Loop> homology_generators(const Connectivity& mesh, std::span<const double> lengths,
                                                  const GoOn& go_on = {});

}  // namespace meshops
