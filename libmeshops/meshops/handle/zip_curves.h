// What:   glues two boundary curves of equal length together, edge by edge.
// Law:    zip_curves() equals a glue() that joins two components or makes a handle, then a glue() of case zip for each
//         further edge but the last, then a glue() that closes the curve. The counts change by the sum of the deltas.
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
  std::vector<GlueEffect> glued;  ///< the effects of the glues, in their order along the curve from `first` on

  GlueCase begins_with() const { return glued.front().what; }  ///< join or handle; requires that `glued` is not empty
  Delta delta() const {
    Delta sum;
    for (const GlueEffect& edge : glued) sum = sum + edge.delta();
    return sum;
  }
};

/// Returns why the curves through `first` and `second` cannot be glued, or nothing when they can. The reasons: the mesh
/// lacks status of some kind, a halfedge does not exist, is deleted or is not on the boundary, both are on one curve,
/// the curves differ in length, an edge joins two vertices that would become one, or a vertex has several fans
/// (core/fans.h).
/// Cost:     the degrees of the vertices on both curves.
MESHOPS_API std::optional<Blocker> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues `first` to `second`, the edge after `first` to the edge before `second`, and so on all around. The two curves
/// become one closed seam of inner edges. The operator joins pieces that were built separately.
/// Effect:      the edges of the curve through `first` stay; the edges of the other curve are marked deleted. Of each
///              two vertices that merge, the one of the higher handle is marked deleted.
/// Requires:    zip_curves_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: the edges of the curve through `second`, and the vertices that are marked deleted.
/// Inverse:     undo(), exactly.
/// Cost:        the cost of one glue(), plus the degrees of the vertices on both curves.
MESHOPS_API ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second);

/// Unglues the seam, from its last edge to its first. If the mesh is as zip_curves() left it, every record is restored.
/// Requires: in its turn, each effect in `glued` meets the requirements of unglue() (handle/unglue.h).
/// Throws:   ContractViolation at the first effect that does not meet them; edges unglued before stay unglued.
/// Cost:     the cost of an unglue() for each edge.
MESHOPS_API void undo(Connectivity& mesh, const ZipCurvesEffect& effect);

}  // namespace meshops
