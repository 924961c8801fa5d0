// What:   cuts a surface open along edges, so that it can be laid out flat, and glues it together again.
// Law:    cut_open(mesh, homology(mesh)) makes every component with faces a disc: χ = 1, one boundary curve.
//         glue_back() restores every live record, except that the halfedge of an inner vertex may differ.
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
/// is deleted or is on the boundary; an end of an edge has several fans (core/fans.h); or an edge is named twice.
/// Cost: the degrees of the ends of the edges; also n log n for n edges.
MESHOPS_API std::optional<Blocker> cut_open_blocker(const Connectivity& mesh, std::span<const Edge> edges);

/// Unglues the edges, in the given order.
/// Effect:   a vertex becomes as many vertices as there are fans of faces around it after the cut. New vertices and
///           edges get copies of all properties of the old ones, including points.
/// Returns:  the effects of the unglue() calls, in the order of the edges.
/// Requires: cut_open_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
/// Inverse:  glue_back().
/// Cost:     the cost of an unglue() for each edge.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, std::span<const Edge> edges);

/// Cuts every component with faces to one disc: a sphere, which has no cut graph, along its least edge, any other
/// component along the cut graph.
/// Returns:  the effects of the cut graph, in the order of its edges, then those of the spheres, by ascending edge.
/// Requires: `homology` is the result of homology() for this mesh, which has not changed since; not checked. Throws
///           ContractViolation if the cut graph cannot be cut; the mesh is then unchanged.
/// Cost:     near-linear in the mesh, plus the cost of an unglue() for each cut.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, const Homology& homology);

/// Glues together the edges that cut_open() cut, from the last edge to the first.
/// Requires: the mesh has status of every kind, and is as cut_open() left it. Throws ContractViolation at the first
///           edge that cannot be glued; edges glued before stay glued.
MESHOPS_API void glue_back(Connectivity& mesh, std::span<const UnglueEffect> cuts);

}  // namespace meshops
