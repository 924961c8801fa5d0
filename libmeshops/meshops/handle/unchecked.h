// What: the checks and the changes of glue() and unglue() as separate functions, for operators that check several glues
//       before the first change.
// Law:  functions that check change nothing, and functions that change check nothing; nothing is checked twice.
#pragma once

#include <optional>

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"

namespace meshops::detail {

/// Returns why the two are not both live boundary halfedges, or nothing when they are.
std::optional<Blocker> boundary_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);
/// Returns the reason of glue_blocker(), except that the mesh needs no status.
std::optional<Blocker> glue_links_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);
/// Returns why two vertices cannot be merged, or nothing when they can. `out` and `other_out` are the boundary
/// halfedges that leave the two vertices. If `out` equals `other_out`, there is only one vertex and nothing to merge.
/// Cost: the degrees of both vertices.
std::optional<Blocker> merge_blocker(const Connectivity& mesh, Halfedge out, Halfedge other_out);

/// Returns the case of glue() of the two halfedges. Requires: glue_links_blocker() is empty; not checked.
/// Cost: constant if the edges are adjacent; otherwise the shorter way between them along their curve; for two curves,
///       the length of the shorter, and the cost of in_same_component() (core/reach.h).
GlueCase case_of_glue(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues. Requires: glue_links_blocker() is empty; the mesh has status of every kind; `what` is case_of_glue(). Not
/// checked.
GlueEffect glue_links(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what);
/// Unglues. Requires: unglue_blocker() is empty; not checked. Cost: the cost of unglue_case().
UnglueEffect unglue_links(Connectivity& mesh, Halfedge h);

}  // namespace meshops::detail
