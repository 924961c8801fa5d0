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

struct GlueEffect {
  struct Ends {
    Vertex from{}, to{};
  };
  GlueCase what;        ///< the case of this glue
  Halfedge survivor{};  ///< `first`, now inner: its edge is the glued one
  Halfedge removed{};   ///< `second`: its edge is marked deleted
  Ends first_ends;      ///< ends of `first` before the glue; of two merged vertices the lower handle stays
  Ends second_ends;     ///< ends of `second` before the glue
  Delta delta() const { return delta_of(what); }
};

/// Returns why `first` and `second` cannot be glued, or nothing when they can. The reasons: the mesh lacks status of
/// some kind, one of the two does not exist or is not a boundary halfedge, both are of one edge, an edge joins two
/// vertices that would become one (that edge would become a loop), or an end has several fans (core/fans.h).
/// Cost:     the degrees of the ends.
MESHOPS_API std::optional<Blocker> glue_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Returns the case of glue() for these boundary halfedges.
/// Requires: glue_blocker() is empty, except that the mesh needs no status. Throws ContractViolation.
/// Cost:     the degrees of the ends; the shorter of two ways along a curve; the smaller of two components when the
///           edges are on two curves.
MESHOPS_API GlueCase glue_case(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues two boundary halfedges head to tail: the start of `first` meets the end of `second`.
/// Effect:      the edge of `second` and up to two vertices are marked deleted; of two vertices the lower handle stays.
/// Requires:    glue_blocker() is empty; the mesh has status of every kind (deletion needs it).
/// Throws:      ContractViolation; the mesh is then unchanged.
/// Invalidates: `second`, its edge, and the vertices that were merged into others.
/// Inverse:     unglue().
/// Cost:        as glue_case().
MESHOPS_API GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues for a caller that has determined the case `what` already, for example a tracker (topology/tracker.h).
/// Requires: as glue() without `what`; `what` is the result of glue_case(), which is not checked.
/// Cost:     the degrees of the ends.
MESHOPS_API GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what);

}  // namespace meshops
