// What:   cuts a surface open along edges, so that it can be laid out flat, and glues it together again.
// Law:    cut_open(mesh, homology(mesh)) makes every component with faces a disc: χ = 1, one boundary curve.
//         glue_back() restores every live record, except that an inner vertex may refer to another of its halfedges.
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

/// Returns why the mesh cannot be cut along these edges, or nothing when it can. The reasons: an edge does not exist,
/// is deleted or is on the boundary; an end of it has several fans (core/fans.h); an edge is named twice.
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

/// Cuts every component with faces to one disc: along the cut graph, or along the least edge of a sphere, where the cut
/// graph is empty.
/// Returns:  the effects: those of the cut graph, in its order, then those of the spheres, by ascending edge.
/// Requires: `homology` is the result of homology() for this mesh, which has not changed since; not checked. Throws
///           ContractViolation when the cut graph cannot be cut; the mesh is then unchanged.
/// Cost:     near-linear in the mesh, and as an unglue() for each cut.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, const Homology& homology);

/// Glues together the edges that cut_open() cut, the last edge first.
/// Requires: the mesh has status of every kind, and is as cut_open() left it. Throws ContractViolation at the first
///           edge that cannot be glued; edges that were glued before stay glued.
MESHOPS_API void glue_back(Connectivity& mesh, std::span<const UnglueEffect> cuts);

}  // namespace meshops
