// What:   sews two boundary curves of equal length together, edge by edge.
// Law:    equals one glue() that joins two components or makes a handle, then a glue() that zips for each further edge
//         but the last, then a glue() that closes the curve; the counts change by the sum of the deltas of these calls.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"
#include "meshops/handle/glue.h"

namespace meshops {

struct ZipCurvesEffect {
  std::vector<GlueEffect> glued;  ///< the edges of the seam, which runs from `first` along its curve

  GlueCase begins_with() const { return glued.front().what; }  ///< join or handle
  Delta delta() const {
    Delta sum;
    for (const GlueEffect& edge : glued) sum = sum + edge.delta();
    return sum;
  }
};

/// Returns why the curves through `first` and `second` cannot be sewn, or nothing when they can. The reasons: the mesh
/// lacks status of some kind, a halfedge does not exist or is not on the boundary, both are on one curve, the lengths
/// differ, an edge joins two vertices that would become one, or a vertex has several fans (core/fans.h).
/// Cost:     the degrees of the vertices on both curves.
MESHOPS_API std::optional<Blocker> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues `first` to `second`, the edge after `first` to the edge before `second`, and so on all around. The two curves
/// become one closed seam of inner edges. Use it for pieces that were built separately.
/// Effect:      the edges of the curve of `first` stay; those of the other curve are marked deleted, and so is one
///              vertex of each merged pair: the lower handle stays.
/// Requires:    zip_curves_blocker() is empty; the mesh has status of every kind.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the curve through `second`.
/// Inverse:     undo(), exactly.
/// Cost:        as one glue(), plus the degrees of the vertices on both curves.
MESHOPS_API ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second);

/// Unglues the seam, from its last edge to its first. If the mesh is as zip_curves() left it, every record is restored.
/// Requires: as unglue() of each effect in `glued`. Throws ContractViolation at the first edge that cannot be unglued;
///           edges after it on the seam stay unglued.
MESHOPS_API void undo(Connectivity& mesh, const ZipCurvesEffect& effect);

}  // namespace meshops
