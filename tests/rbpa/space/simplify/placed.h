// What: a mesh without points and the place of each vertex, as decimate(), remesh() and subdivide() take them.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/live.h"
#include "meshops/topology/build_mesh.h"
#include "space/simplify/triangle_sets.h"

namespace rbpa_test {

/// A mesh without points; places[v] is the place of vertex v. Its elements have status properties unless that is
/// declined.
struct Placed {
  explicit Placed(const Triangles& t, bool has_status = true) {
    meshops::PolygonSoup soup;
    soup.points = t.points.size();
    for (const auto& corners : t.corners) soup.add_face(corners);
    for (const std::uint32_t point : meshops::build_mesh(mesh, soup)) places.push_back(t.points[point]);
    if (has_status) meshops::request_status(mesh);
  }
  OpenMesh::PolyConnectivity mesh;
  std::vector<Point3> places;
};

}  // namespace rbpa_test
