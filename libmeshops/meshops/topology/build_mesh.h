// What: a halfedge mesh from a soup of faces.
// Law:  the mesh is sound; a point on which several fans stand gets a vertex for each.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Fills an empty mesh. Vertex i is point i, with its first fan, or isolated; further fans get the numbers after the
/// last point. Face i is face i of the soup, and its halfedge is the first side. Edges are in the order of their ends.
/// Returns:  the point of each vertex.
/// Requires: the mesh is empty; the soup has no defects but pinches (find_defects()).
/// Throws:   ContractViolation that names the first other defect, or as require_parted(), mesh untouched; Cancelled, mesh
///           empty.
/// Cost:     near-linear; no search in the kernel is needed.
MESHOPS_API std::vector<std::uint32_t> build_mesh(Connectivity& mesh, const PolygonSoup& soup, const GoOn& go_on = {});

/// The faces of a mesh as a soup, in the order of their handles; deleted ones are left out. A deleted vertex keeps its
/// number, as a point without a face.
/// Requires: `point_of_vertex` has a value per vertex, or is empty: then a vertex is its own point.
MESHOPS_API PolygonSoup soup_of(const Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex = {});

}  // namespace meshops
