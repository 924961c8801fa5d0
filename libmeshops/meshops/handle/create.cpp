#include "meshops/handle/create.h"

#include "meshops/handle/insert_triangle.h"

namespace meshops {

Halfedge create_triangle(Connectivity& mesh) {
  TriangleSides sides;
  for (Vertex& v : sides.corner) v = mesh.new_vertex();
  return insert_triangle(mesh, sides).side[0];
}

}  // namespace meshops
