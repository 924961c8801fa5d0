// What: the checks and the changes of glue() and unglue() as separate functions, for operators that check many glues
//       before the first change.
// Law:  nothing is checked twice: functions that refuse change nothing, and functions that change check nothing.
#pragma once

#include <optional>

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"

namespace meshops::detail {

/// Returns why two halfedges are not boundary halfedges, or nothing when both are.
std::optional<Blocker> boundary_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);
/// Returns glue_blocker(), except that the mesh needs no status.
std::optional<Blocker> glue_links_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);
/// Returns why two vertices cannot be merged, or nothing when they can. `out` and `other_out` are the boundary
/// halfedges that leave the two vertices; if they are equal, there is one vertex, which stays.
/// Cost: the degrees of both vertices.
std::optional<Blocker> merge_blocker(const Connectivity& mesh, Halfedge out, Halfedge other_out);

/// Returns the case of glue(). Requires: glue_links_blocker() is empty.
GlueCase case_of_glue(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues. Requires: glue_links_blocker() is empty; the mesh has status of every kind; `what` is case_of_glue().
GlueEffect glue_links(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what);
/// Unglues. Requires: unglue_blocker() is empty.
UnglueEffect unglue_links(Connectivity& mesh, Halfedge h);

}  // namespace meshops::detail
