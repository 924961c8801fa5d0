// What: removes the vertices without triangles from a mesh that stands on sites.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/patch/site_vertices.h"

namespace meshops::detail {

/// Removes the vertices without triangles and renumbers the others, which keep their order and properties. Also removes
/// the edges from number `edges` on and the faces from number `faces` on.
/// Returns:     the site of each remaining vertex.
/// Requires:    the removed edges and faces are unused; not checked.
/// Invalidates: `vertices`, which has the old numbers.
/// Cost:        linear in the mesh; small if only the last vertices are removed.
std::vector<Site> compact(Connectivity& mesh, const SiteVertices& vertices, std::size_t edges, std::size_t faces);

}  // namespace meshops::detail
