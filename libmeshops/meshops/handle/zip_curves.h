// What:   sews two boundary curves of equal length together, edge by edge.
// Law:    zip_curves() equals one glue() that joins two components or makes a handle, then a glue() that zips for each
//         further edge but the last, then a glue() that closes the curve; the counts change by the sum of the deltas.
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
  std::vector<GlueEffect> glued;  ///< the effects of the glues in their order, from `first` on along its curve

  GlueCase begins_with() const { return glued.front().what; }  ///< join or handle; `glued` must not be empty
  Delta delta() const {
    Delta sum;
    for (const GlueEffect& edge : glued) sum = sum + edge.delta();
    return sum;
  }
};

/// Returns why the curves through `first` and `second` cannot be sewn, or nothing when they can. The reasons: the mesh
/// lacks status of some kind, a halfedge does not exist or is not on the boundary, both are on one curve, the curves
/// differ in length, an edge joins two vertices that would become one, or a vertex has several fans (core/fans.h).
/// Cost:     the degrees of the vertices on both curves.
MESHOPS_API std::optional<Blocker> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues `first` to `second`, the edge after `first` to the edge before `second`, and so on all around. The two curves
/// become one closed seam of inner edges. Use it for pieces that were built separately.
/// Effect:      the edges of the curve through `first` stay; those of the other curve are marked deleted, and of each
///              pair of merged vertices the one of the higher handle.
/// Requires:    zip_curves_blocker() is empty; the mesh has status of every kind.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the curve through `second`.
/// Inverse:     undo(), exactly.
/// Cost:        the cost of one glue(), plus the degrees of the vertices on both curves.
MESHOPS_API ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second);

/// Unglues the seam, from its last edge to its first. If the mesh is as zip_curves() left it, every record is restored.
/// Requires: each effect in `glued` meets the requirements of unglue() (unglue.h) in its turn.
/// Throws:   ContractViolation at the first edge that does not; the later edges of the seam stay unglued.
/// Cost:     the cost of an unglue() for each edge.
MESHOPS_API void undo(Connectivity& mesh, const ZipCurvesEffect& effect);

}  // namespace meshops
