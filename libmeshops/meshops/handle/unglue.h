// What:   the handle operator that makes two boundary edges of one inner edge; each end of the edge that lies on the
//         boundary becomes two vertices.
// Law:    unglue() is the exact inverse of glue(), case by case: a glue() followed by the unglue() of its effect
//         restores every live record. An unglue() followed by the glue() of its two halfedges restores every live
//         record, too, except that the halfedge of an inner vertex may differ.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"
#include "meshops/handle/glue.h"

namespace meshops {

/// The changes that unglue() made; glue(first, second) is the inverse.
struct UnglueEffect {
  GlueCase what;       ///< the case of the glue() that is the inverse
  Halfedge first{};    ///< the halfedge `h`, now on the boundary; the opposite of `h` keeps its face
  Halfedge second{};   ///< boundary halfedge of the second edge, new or restored; glue(first, second) is the inverse
  Vertex new_start{};  ///< second vertex, new or restored, at the start of `h`; invalid if the start was inner
  Vertex new_end{};    ///< second vertex, new or restored, at the end of `h`; invalid if the end was inner
  Delta delta() const { return -delta_of(what); }
};

/// Returns why the edge of `h` cannot be unglued, or nothing when it can. The reasons: the halfedge does not exist or
/// is deleted, its edge is on the boundary, or an end of the edge has several fans (core/fans.h).
/// Cost:     the degrees of the ends that are on the boundary.
MESHOPS_API std::optional<Blocker> unglue_blocker(const Connectivity& mesh, Halfedge h);

/// Returns the case of the glue() whose inverse is the unglue() of the edge of `h`.
/// Requires: unglue_blocker() is empty. Throws ContractViolation.
/// Cost:     the degrees of the ends that are on the boundary. If both are on one curve, also the shorter way between
///           them along it, and in_same_component() (core/reach.h); if they are on two, also the length of the shorter.
MESHOPS_API GlueCase unglue_case(const Connectivity& mesh, Halfedge h);

/// Splits an inner edge into two boundary edges. `h` comes to the boundary, and a new halfedge replaces `h` in its
/// face.
/// Effect:   each new element gets copies of all properties of the old one, including the point. An old vertex keeps
///           the fan on the side of the opposite of `h`; a new vertex gets the fan with the former face of `h`.
/// Requires: unglue_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
/// Inverse:  glue(first, second).
/// Cost:     the cost of unglue_case().
MESHOPS_API UnglueEffect unglue(Connectivity& mesh, Halfedge h);

/// Undoes a glue(): the edge and the vertices that glue() marked deleted are live again, with their own properties.
/// Requires: unglue_blocker() of the glued edge is empty; the edge still ends at the vertices at which glue() left it;
///           an end is on the boundary exactly if glue() merged two vertices there; the elements that glue() marked
///           deleted are still marked; the mesh has status of every kind. All of this is checked: a sound mesh stays
///           sound whatever the effect contains.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Cost:     the cost of unglue_case().
MESHOPS_API UnglueEffect unglue(Connectivity& mesh, const GlueEffect& effect);

}  // namespace meshops
