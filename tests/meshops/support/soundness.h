// Checks a mesh by the definition of soundness alone, without trust in any record.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops::test {

/// Returns whether all of this holds. All records name live elements. next and prev are inverse to each other, and
/// consecutive halfedges meet. Each face is one loop of three sides or more. Each edge has two ends, and a face on at
/// least one side. Around each vertex, the edges, joined at the corners of faces, form one path or one circle, or there
/// are none. A vertex refers to an edge of its own, on the boundary to the first of its path. Cost: quadratic in
/// degrees.
bool is_sound_by_definition(const Connectivity& mesh);

}  // namespace meshops::test
