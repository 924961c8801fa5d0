// What:   the handle operator that makes one inner edge of two boundary edges.
// Law:    the counts change exactly by delta_of(case) (effect.h); a sound mesh stays sound; unglue() is the inverse.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

/// The changes that glue() made, by which unglue() undoes them.
struct GlueEffect {
  struct Ends {
    Vertex from{}, to{};
  };
  GlueCase what;        ///< the case of this glue
  Halfedge survivor{};  ///< the halfedge `first`, now inner; its edge is the glued edge
  Halfedge removed{};   ///< the halfedge `second`; its edge is marked deleted
  Ends first_ends;      ///< ends of `first` before the glue; of two merged vertices, the lower handle stays
  Ends second_ends;     ///< ends of `second` before the glue
  Delta delta() const { return delta_of(what); }
};

/// Returns why `first` and `second` cannot be glued, or nothing when they can. The reasons: the mesh lacks status of
/// some kind; a halfedge does not exist, is deleted or is not on the boundary; both belong to one edge; two vertices
/// that would become one are joined by an edge, which would become a loop; or an end has several fans (core/fans.h).
/// Cost:     the degrees of the ends.
MESHOPS_API std::optional<Blocker> glue_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Returns the case of glue() of two boundary halfedges.
/// Requires: glue_blocker() is empty, except that the mesh needs no status. Throws ContractViolation.
/// Cost:     the degrees of the ends. Unless the edges are adjacent, also the shorter way between them along their
///           curve; for two curves, also the length of the shorter curve and the cost of in_same_component()
///           (core/reach.h).
MESHOPS_API GlueCase glue_case(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues two boundary halfedges head to tail: the start of `first` meets the end of `second`.
/// Effect:      `first` becomes inner, a side of the face beyond `second`. The edge of `second` is marked deleted.
///              Where two vertices meet, the vertex of the higher handle is marked deleted; the other keeps its
///              properties.
/// Requires:    glue_blocker() is empty.
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: `second`, its edge, and the vertices that are marked deleted.
/// Inverse:     unglue() of the returned effect, exactly.
/// Cost:        the cost of glue_case().
MESHOPS_API GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues two boundary halfedges as the overload without `what` does. The caller must know the case of the glue, as a
/// tracker does (topology/tracker.h).
/// Requires: the requirements of that overload; also, `what` is the result of glue_case(). That is not checked: `what`
///           only goes into the effect.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Cost:     the degrees of the ends.
MESHOPS_API GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what);

}  // namespace meshops
