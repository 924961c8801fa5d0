#include "support/meshes.h"

#include <algorithm>

#include "meshops/handle/create.h"
#include "meshops/handle/glue.h"

namespace meshops::test {

std::vector<Halfedge> separate_triangles(Connectivity& mesh, int count) {
  std::vector<Halfedge> boundary;
  for (int t = 0; t < count; ++t) {
    Halfedge h = create_triangle(mesh).inner;
    for (int i = 0; i < 3; ++i) {
      boundary.push_back(mesh.opposite_halfedge_handle(h));
      h = mesh.next_halfedge_handle(h);
    }
  }
  return boundary;
}

Strip strip(Connectivity& mesh, int pairs) {
  // Each pair is a square cut along a diagonal; squares are glued side by side.
  Strip result;
  Halfedge right;
  for (int i = 0; i < pairs; ++i) {
    const auto b = separate_triangles(mesh, 2);
    glue(mesh, b[2], b[3]);  // the diagonal
    if (i == 0)
      result.left = b[0];
    else
      glue(mesh, right, b[0]);
    right = b[4];
  }
  result.right = right;
  return result;
}

std::vector<std::string> canonical_faces(const Connectivity& mesh, const std::vector<int>& label) {
  const auto labels_of = [&](Halfedge first) {
    std::string text;
    Halfedge h = first;
    do {
      text += std::to_string(label[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())]) + ' ';
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
    return text;
  };
  // A face begins at the rotation that gives the least text; each side names the loop beyond it, from the shared edge
  // on.
  std::vector<std::string> faces;
  for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i) {
    if (mesh.status(Face(i)).deleted()) continue;
    const Halfedge first = mesh.halfedge_handle(Face(i));
    std::string best;
    Halfedge h = first;
    do {
      std::string text = labels_of(h) + ": ";
      Halfedge side = h;
      do {
        const Halfedge beyond = mesh.opposite_halfedge_handle(side);
        text += (mesh.is_boundary(beyond) ? "curve " : "face ") + labels_of(beyond) + "; ";
        side = mesh.next_halfedge_handle(side);
      } while (side != h);
      if (best.empty() || text < best) best = text;
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
    faces.push_back(best);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace meshops::test
