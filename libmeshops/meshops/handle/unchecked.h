// What: glue() and unglue() split into their checks and their changes, for operators that check many at once.
// Law:  nothing is checked twice: functions that refuse change nothing, and functions that change check nothing.
#pragma once

#include "meshops/core/connectivity.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"

namespace meshops::detail {

/// Why not, or nullptr: a reason costs no memory.
const char* glue_refusal(const Connectivity& mesh, Halfedge first, Halfedge second);
const char* unglue_refusal(const Connectivity& mesh, Halfedge h);
/// Of two vertices that become one, by the boundary halfedges that leave them; of one that stays, where both are equal.
/// Cost: the degrees.
const char* merge_refusal(const Connectivity& mesh, Halfedge out, Halfedge other_out);

/// Requires that the refusal is null.
GlueCase case_of_glue(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Requires also that the mesh has status of every kind.
GlueEffect glue_links(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what);
/// Requires that the refusal is null.
UnglueEffect unglue_links(Connectivity& mesh, Halfedge h);

}  // namespace meshops::detail
