// What:   sews two boundary curves of equal length together, edge by edge.
// Law:    equals one glue() that joins two components or makes a handle, then a glue() that zips for each further edge
//         but the last, then a glue() that closes the curve; the counts change by the sum of the deltas of these calls.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

struct ZipCurvesEffect {
  GlueCase begins_with;  ///< join or handle
  std::size_t edges;     ///< number of edges of the seam, which runs from `first` along its curve

  Delta delta() const {
    Delta sum = delta_of(begins_with) + delta_of(GlueCase::close);
    const int zips = static_cast<int>(edges) - 2;
    sum.vertices += zips * delta_of(GlueCase::zip).vertices;
    sum.edges += zips * delta_of(GlueCase::zip).edges;
    return sum;
  }
};

/// Returns why the curves through `first` and `second` cannot be sewn, or nothing when they can. The reasons: the mesh
/// lacks status of some kind, a halfedge does not exist or is not on the boundary, both are on one curve, the lengths
/// differ, an edge joins two vertices that would become one, or a vertex has several fans (core/fans.h).
/// Cost:     the degrees of the vertices on both curves.
MESHOPS_API std::optional<std::string> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues `first` to `second`, the edge after `first` to the edge before `second`, and so on all around. The two curves
/// become one closed seam of inner edges. Use it for pieces that were built separately.
/// Effect:      the edges of the curve of `first` stay; those of the other curve are marked deleted, and so is one
///              vertex of each merged pair: the lower handle stays.
/// Requires:    zip_curves_blocker() is empty; the mesh has status of every kind.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the curve through `second`.
/// Inverse:     unglue() of the seam, from its last edge to its first.
/// Cost:        as one glue(), plus the degrees of the vertices on both curves.
MESHOPS_API ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second);

}  // namespace meshops
