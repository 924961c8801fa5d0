// What:   finds loops that generate the first homology of a mesh over Z/2 and have the least total length.
// Law:    each component gets b₁ loops. The i-th shortest loop of any other basis is at least as long as the i-th
//         shortest of the result, up to the rounding of sums (docs/reference/operators.md, section 8).
// Cost:   for every vertex of the cut graph of homology(), a search for shortest paths, which ends at half the length
//         of the longest known loop of the component. The search takes n log n time for the n elements that it reaches,
//         and a word for every 64 loops.
// Source: Erickson and Whittlesey, Greedy optimal homotopy and homology generators (SODA 2005).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/core/progress.h"
#include "meshops/topology/homology.h"

namespace meshops {

/// Bits of every edge that determine the homology classes of loops: two loops are homologous over Z/2 exactly if the
/// exclusive or of the bits of their edges is equal. Bit i of an edge is bit i % 64 of word i / 64.
struct HomologySignature {
  std::size_t loops = 0;             ///< b₁ of the mesh, which is the number of bits in use
  std::size_t words = 0;             ///< number of words for each edge
  std::vector<std::uint64_t> edges;  ///< `words` words for each edge, by edge index

  /// Returns the words of an edge. Throws ContractViolation if the handle is invalid, or if the edge does not exist and
  /// `words` is not 0.
  std::span<const std::uint64_t> of(Edge e) const {
    require(e.idx() >= 0 && (static_cast<std::size_t>(e.idx()) + 1) * words <= edges.size(), "HomologySignature: edge ",
            e.idx(), " does not exist");
    return std::span(edges).subspan(static_cast<std::size_t>(e.idx()) * words, words);
  }
};

/// Returns the bits of each edge. The bits of deleted edges are 0.
/// Requires: validate(mesh) is empty; not checked.
/// Throws:   Cancelled.
/// Cost:     linear in the mesh times `words`; also, for each bit, the depth of a tree of faces.
MESHOPS_API HomologySignature homology_signature(const Connectivity& mesh, const GoOn& go_on = {});

/// Returns a basis of shortest loops, in ascending order of length. A loop passes no vertex twice. It begins with the
/// first halfedge of an edge, and consists of that edge and the shortest paths from its ends to one root vertex,
/// without the common part of the paths. Loops of equal length are ordered by the root vertex, then by the edge.
/// Requires: validate(mesh) is empty, not checked; `lengths` has a length ≥ 0 for each edge, by edge index, with a
///           finite sum; entries of deleted edges are not read.
/// Throws:   ContractViolation when `lengths` is not as required; Cancelled.
MESHOPS_API std::vector<Loop> shortest_homology_basis(const Connectivity& mesh, std::span<const double> lengths,
                                                      const GoOn& go_on = {});

/// Returns the loops of shortest_homology_basis() that are shorter than `below`. Requires and throws as that function.
/// Cost: the searches end at half of `below`, so that short loops of large meshes are cheap to find.
MESHOPS_API std::vector<Loop> shortest_homology_loops(const Connectivity& mesh, std::span<const double> lengths,
                                                      double below, const GoOn& go_on = {});

}  // namespace meshops
