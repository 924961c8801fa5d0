// What:   the handle operator that makes one inner edge two boundary edges; the vertices at its ends that lie on the
//         boundary become two each.
// Law:    the exact inverse of glue(), case by case: a glue() and the unglue() of its effect leave every live record as
//         it was, and so do an unglue() and the glue() of its two halfedges (but for which of its halfedges an inner
//         vertex names).
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>
#include <string>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"
#include "meshops/handle/glue.h"

namespace meshops {

struct UnglueEffect {
  GlueCase what;       ///< the case of glue() that is undone
  Halfedge first{};    ///< the given halfedge, now on the boundary, with the face beyond its edge
  Halfedge second{};   ///< the other boundary halfedge, of a new edge: glue(first, second) is the inverse
  Vertex new_start{};  ///< a second vertex where `first` starts; an invalid handle when that vertex was inner
  Vertex new_end{};    ///< a second vertex where `first` ends; likewise
  Delta delta() const { return -delta_of(what); }
};

/// Why the edge of `h` cannot be unglued, or nothing when it can: no such halfedge, its edge is on the boundary, or an
/// end has several fans (core/fans.h).
/// Cost:     the degrees of the ends that are on the boundary.
MESHOPS_API std::optional<std::string> unglue_blocker(const Connectivity& mesh, Halfedge h);

/// What unglue() would undo.
/// Requires: unglue_blocker() is empty. Throws ContractViolation.
/// Cost:     that of unglue_blocker(), and no more when an end of the edge is inner; otherwise the shorter way along the curve, and the smaller of
///           the two parts when both ends are on one curve.
MESHOPS_API GlueCase unglue_case(const Connectivity& mesh, Halfedge h);

/// Parts an inner edge. `h` is on the boundary then, and a new edge replaces it in its face.
/// Effect:   new elements have copies of all properties of the old ones: a second vertex has the place of the first. Old
///           vertices keep the fan that the opposite of `h` is in, new ones get the fan of what was the face of `h`.
/// Requires: unglue_blocker() is empty. Throws ContractViolation, mesh untouched.
/// Inverse:  glue(first, second).
/// Cost:     that of unglue_case().
MESHOPS_API UnglueEffect unglue(Connectivity& mesh, Halfedge h);

/// Undoes a glue(): the edge and the vertices that it marked deleted live again, with their own properties.
/// Requires: the glued edge is inner and ends at the vertices that glue() left it with; what glue() marked deleted
///           still is. All of this is checked: a sound mesh stays sound whatever the effect contains. The mesh has status of
///           every kind.
/// Throws:   ContractViolation, mesh untouched.
/// Cost:     that of unglue_case().
MESHOPS_API UnglueEffect unglue(Connectivity& mesh, const GlueEffect& effect);

}  // namespace meshops
