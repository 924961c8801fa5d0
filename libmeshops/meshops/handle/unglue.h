// What:   the handle operator that makes two boundary edges of one inner edge; each end of the edge that lies on the
//         boundary becomes two vertices.
// Law:    the exact inverse of glue(), case by case: a glue() followed by the unglue() of its effect restores every
//         live record. An unglue() followed by the glue() of its two halfedges does so, too, except that an inner
//         vertex may refer to another of its halfedges.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"
#include "meshops/handle/glue.h"

namespace meshops {

struct UnglueEffect {
  GlueCase what;       ///< the case of glue() of which this is the inverse
  Halfedge first{};    ///< the halfedge `h`, now on the boundary; its opposite keeps its face
  Halfedge second{};   ///< boundary halfedge of the new or restored edge: glue(first, second) is the inverse
  Vertex new_start{};  ///< second vertex, new or restored, at the start of `h`; invalid when the start was inner
  Vertex new_end{};    ///< second vertex, new or restored, at the end of `h`; invalid when the end was inner
  Delta delta() const { return -delta_of(what); }
};

/// Returns why the edge of `h` cannot be unglued, or nothing when it can. The reasons: the halfedge does not exist, its
/// edge is on the boundary, or an end has several fans (core/fans.h).
/// Cost:     the degrees of the ends that are on the boundary.
MESHOPS_API std::optional<Blocker> unglue_blocker(const Connectivity& mesh, Halfedge h);

/// Returns the case of glue() of which unglue() would be the inverse.
/// Requires: unglue_blocker() is empty. Throws ContractViolation.
/// Cost:     the degrees of the ends that are on the boundary. If both are, also the shorter way between them along the
///           curve, or the shorter of two curves; if both are on one curve, also in_same_component() (core/reach.h).
MESHOPS_API GlueCase unglue_case(const Connectivity& mesh, Halfedge h);

/// Splits an inner edge into two boundary edges. `h` is then on the boundary, and a new edge replaces it in its face.
/// Effect:   new elements get copies of all properties of the old ones, including the point. Old vertices keep the fan
///           on the side of the opposite of `h`; new ones get the fan with the former face of `h`.
/// Requires: unglue_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
/// Inverse:  glue(first, second).
/// Cost:     the cost of unglue_case().
MESHOPS_API UnglueEffect unglue(Connectivity& mesh, Halfedge h);

/// Undoes a glue(): the edge and the vertices that glue() marked deleted are live again, with their own properties.
/// Requires: unglue_blocker() of the glued edge is empty; the edge ends at the vertices at which glue() left it, which
///           are on the boundary exactly where glue() merged two vertices; the elements that glue() marked deleted are
///           still marked; the mesh has status of every kind. All of this is checked: a sound mesh stays sound whatever
///           the effect contains.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Cost:     the cost of unglue_case().
MESHOPS_API UnglueEffect unglue(Connectivity& mesh, const GlueEffect& effect);

}  // namespace meshops
