// What: removes the vertices without triangles from a mesh that stands on sites.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/patch/site_vertices.h"

namespace meshops::detail {

/// Renumbers the other vertices, which keep their order and properties; the mesh is left with them and with its first
/// `edges` edges and `faces` faces.
/// Returns: the site of each vertex that is left. `vertices` cannot be used any further.
/// Cost:    linear; little where no vertex but the last is to go.
std::vector<Site> compact(Connectivity& mesh, const SiteVertices& vertices, std::size_t edges, std::size_t faces);

}  // namespace meshops::detail
