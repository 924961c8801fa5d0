#include "meshops/handle/create.h"

#include "meshops/handle/insert_triangle.h"

namespace meshops {

CreateTriangleEffect create_triangle(Connectivity& mesh) {
  TriangleSides sides;
  for (Vertex& v : sides.corner) v = mesh.new_vertex();
  const InsertedTriangle made = insert_triangle(mesh, sides);
  return {made.face, made.side[0], mesh.opposite_halfedge_handle(made.side[0])};
}

}  // namespace meshops
