// What: finds the boundary edges and the sharp edges of a mesh of triangles as curves, which end in fixed vertices.
// Cost: linear, and a sort of the edges.
#pragma once

#include <vector>

#include "meshops/core/connectivity.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/simplify/distance/surface_distance.h"
#include "rbpa/space/simplify/remesh.h"

namespace rbpa::space {

struct MeshCurves {
  static constexpr int none = 0, fixed = -1;

  std::vector<int> of_edge;             ///< for each edge by index, the number of its curve, from 1, or `none`
  std::vector<int> of_vertex;           ///< for each vertex, its curve, `none`, or `fixed`: corners, ends, kept ones
  std::vector<int> degree;              ///< for each vertex, the number of edges that it should have
  std::vector<SurfaceDistance> shapes;  ///< shapes[k − 1] has the segments of curve k, as triangles a, b, b

  /// Finds the curves of a sound mesh of triangles, with its places.
  MeshCurves(const meshops::Connectivity& mesh, const std::vector<Point3>& places, const RemeshOptions& options);

  /// Returns the number of edges that a vertex should have if it is not fixed.
  static int usual_degree(const meshops::Connectivity& mesh, meshops::Vertex v) { return mesh.is_boundary(v) ? 4 : 6; }
};

}  // namespace rbpa::space
