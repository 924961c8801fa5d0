// What:   cuts a surface open along edges, so that it can be laid out flat, and glues it together again.
// Law:    cut_open(mesh, homology(mesh)) makes every component a disc: χ = 1, one boundary curve. glue_back() of the
//         result restores every live record, except that an inner vertex may refer to another of its halfedges.
// Source: Erickson and Har-Peled, Optimally cutting a surface into a disk (2004).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/unglue.h"
#include "meshops/topology/homology.h"

namespace meshops {

/// Returns why the mesh cannot be cut along these edges, or nothing when it can: the reason of unglue_blocker() for one
/// of them, or that an edge is named twice.
/// Cost: the degrees of the ends of the edges; the number of edges, times its logarithm.
MESHOPS_API std::optional<Blocker> cut_open_blocker(const Connectivity& mesh, std::span<const Edge> edges);

/// Unglues edges, in the order in which they are given.
/// Effect:   a vertex becomes as many vertices as there are fans of faces around it after the cut; new vertices and
///           edges get copies of all properties of the old ones, including points.
/// Returns:  the effects, in the order of the edges.
/// Requires: cut_open_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
/// Inverse:  glue_back().
/// Cost:     as an unglue() for each edge.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, std::span<const Edge> edges);

/// Cuts every component to one disc: along the cut graph, or, for a sphere, where the cut graph is empty, along its
/// least edge.
/// Returns:  the effects, in the order of the cuts.
/// Requires: `homology` is the result of homology() for this mesh, which has not changed since. Throws
///           ContractViolation when the edges of `homology` cannot be cut; the mesh is then unchanged.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, const Homology& homology);

/// Glues together the edges that cut_open() cut, the last edge first.
/// Requires: the mesh has status of every kind, and is as cut_open() left it. Throws ContractViolation at the first
///           edge that cannot be glued; edges that were glued before it stay glued.
MESHOPS_API void glue_back(Connectivity& mesh, std::span<const UnglueEffect> cuts);

}  // namespace meshops
