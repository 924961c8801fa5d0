// What: builds a halfedge mesh from a soup of faces, and returns the faces of a mesh as a soup.
// Law:  the mesh is sound; a point on which several fans stand gets a vertex for each fan.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Fills an empty mesh. Vertex i stands on point i and has its first fan, or is isolated; further fans get the numbers
/// after the last point. Face i is face i of the soup, and its halfedge is its first side. Edges are in the order of
/// their ends.
/// Returns:  the point of each vertex.
/// Requires: the mesh is empty; the only defects of the soup are pinches (find_defects()).
/// Throws:   ContractViolation that names the first other defect, or as require_parted(), mesh untouched; Cancelled,
///           mesh empty.
/// Cost:     near-linear.
MESHOPS_API std::vector<std::uint32_t> build_mesh(Connectivity& mesh, const PolygonSoup& soup, const GoOn& go_on = {});

/// Returns the faces of a mesh as a soup, in the order of their handles, without deleted ones. A deleted vertex keeps
/// its number, as a point without a face.
/// Requires: `point_of_vertex` has the point of each vertex, or is empty: then each vertex is its own point.
MESHOPS_API PolygonSoup soup_of(const Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex = {});

}  // namespace meshops
