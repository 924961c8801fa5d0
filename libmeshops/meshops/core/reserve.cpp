#include "meshops/core/reserve.h"

#include "meshops/core/large_pages.h"

namespace meshops {

void reserve(Connectivity& mesh, std::size_t vertices, std::size_t edges, std::size_t faces) {
  mesh.reserve(vertices, edges, faces);
  if (vertices == 0 || edges == 0 || faces == 0 || mesh.n_vertices() + mesh.n_edges() + mesh.n_faces() > 0) return;
  mesh.resize(1, 1, 1);  // one element of each kind shows where the arrays are
  prefer_large_pages(&mesh.vertex(Vertex(0)), vertices * sizeof(mesh.vertex(Vertex(0))));
  prefer_large_pages(&mesh.edge(Edge(0)), edges * sizeof(mesh.edge(Edge(0))));
  prefer_large_pages(&mesh.face(Face(0)), faces * sizeof(mesh.face(Face(0))));
  mesh.resize(0, 0, 0);
}

}  // namespace meshops
