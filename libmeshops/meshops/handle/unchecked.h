// What: the checks and the changes of glue() and unglue() as separate functions, for operators that check many glues
//       before the first change.
// Law:  nothing is checked twice: functions that refuse change nothing, and functions that change check nothing.
#pragma once

#include "meshops/core/connectivity.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"

namespace meshops::detail {

/// Returns why the operator is refused, or nullptr when it is not. Reasons are literals, which allocate no memory.
const char* glue_refusal(const Connectivity& mesh, Halfedge first, Halfedge second);
const char* unglue_refusal(const Connectivity& mesh, Halfedge h);
/// Returns why two vertices cannot be merged, or nullptr when they can. `out` and `other_out` are the boundary
/// halfedges that leave the two vertices; if they are equal, there is one vertex, which stays.
/// Cost: the degrees of both vertices.
const char* merge_refusal(const Connectivity& mesh, Halfedge out, Halfedge other_out);

/// Returns the case of glue(). Requires: glue_refusal() is null.
GlueCase case_of_glue(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues. Requires: glue_refusal() is null; the mesh has status of every kind; `what` is case_of_glue().
GlueEffect glue_links(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what);
/// Unglues. Requires: unglue_refusal() is null.
UnglueEffect unglue_links(Connectivity& mesh, Halfedge h);

}  // namespace meshops::detail
