// A sound mesh by its definition alone, read off the records without trust in any of them.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops::test {

/// All records name live elements; next and prev are inverse to each other; halfedges that follow each other meet; each
/// face is one loop of three sides or more; each edge has two ends, and a face on one side at least; around each vertex
/// the edges, joined at the corners of faces, are one path or one circle, or none; a vertex names an edge of its own,
/// on the boundary the first of its path. Cost: quadratic in degrees.
bool is_sound_by_definition(const Connectivity& mesh);

}  // namespace meshops::test
