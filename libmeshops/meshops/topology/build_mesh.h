// What: builds a halfedge mesh from a soup of faces, and returns the faces of a mesh as a soup.
// Law:  validate() finds no defect in the built mesh; a point with several fans of faces gets one vertex for each fan.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Fills an empty mesh. Vertex i stands on point i and has the fan of the first corner on that point; it is isolated if
/// no face has the point. The vertices of further fans follow, in the order of the first corners of the fans. Face i of
/// the mesh is face i of the soup, and its halfedge is its first side. Edges ascend by the lesser point at their ends,
/// then by the greater.
/// Returns:  the point of each vertex.
/// Requires: the mesh is empty; the only defects of the soup are pinches (find_defects()).
/// Throws:   ContractViolation if the mesh is not empty, if the soup has another defect (the message describes the
///           first), and as find_defects() does; the mesh is then unchanged. Cancelled; the mesh is then empty.
/// Cost:     near-linear.
MESHOPS_API std::vector<std::uint32_t> build_mesh(Connectivity& mesh, const PolygonSoup& soup, const GoOn& go_on = {});

/// Returns the live faces of a mesh as a soup, in the order of their handles. `point_of_vertex` has the point of each
/// vertex, including deleted vertices; if it is empty, vertex i stands on point i. The points of the soup are 0 to the
/// greatest of these points.
/// Throws: ContractViolation unless `point_of_vertex` is empty or has an entry for each vertex.
/// Cost:   linear in the mesh.
MESHOPS_API PolygonSoup soup_of(const Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex = {});

}  // namespace meshops
