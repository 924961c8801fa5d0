// What:   cuts a surface open along edges, so that it can be laid out flat; and glues it together again.
// Law:    along the cut graph of homology(), every component becomes a disc: χ = 1, one boundary curve. glue_back() of what
//         cut_open() returned restores every live record, but for which of its halfedges an inner vertex names.
// Source: Erickson and Har-Peled, Optimally cutting a surface into a disk (2004).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/unglue.h"
#include "meshops/topology/homology.h"

namespace meshops {

/// Why the mesh cannot be cut along these edges, or nothing when it can: the reason of unglue_blocker() for one of them, or an
/// edge is named twice.
/// Cost: the degrees of their ends; the number of edges, times its logarithm.
MESHOPS_API std::optional<std::string> cut_open_blocker(const Connectivity& mesh, std::span<const Edge> edges);

/// Unglues edges, in the order in which they are given.
/// Effect:   a vertex becomes as many as fans of faces are left around it; new vertices and edges have copies of all
///           properties of the old ones, their places too.
/// Returns:  the effects, in this order.
/// Requires: cut_open_blocker() is empty. Throws ContractViolation, mesh untouched.
/// Inverse:  glue_back().
/// Cost:     that of an unglue() for each edge.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, std::span<const Edge> edges);

/// Cuts every component into one disc: along the cut graph; and a sphere, where that is empty, along its least edge.
/// Requires: what homology() returned for this mesh, which nobody has changed since. Throws ContractViolation when its edges
///           cannot be cut, mesh untouched.
MESHOPS_API std::vector<UnglueEffect> cut_open(Connectivity& mesh, const Homology& homology);

/// Glues together what cut_open() parted, the last edge first.
/// Requires: the mesh has status of every kind, and is as cut_open() left it. Throws ContractViolation.
MESHOPS_API void glue_back(Connectivity& mesh, std::span<const UnglueEffect> cuts);

}  // namespace meshops
