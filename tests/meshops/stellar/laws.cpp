#include "stellar/laws.h"

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "meshops/handle/glue.h"
#include "meshops/topology/count.h"

namespace meshops::test {

Delta counts(const Connectivity& mesh) {
  const TopologyCounts c = count_topology(mesh);
  return {static_cast<int>(c.vertices),        static_cast<int>(c.edges),      static_cast<int>(c.faces),
          static_cast<int>(c.boundary_curves), static_cast<int>(c.components), static_cast<int>(c.genus())};
}

bool is_simplicial(const Connectivity& mesh) {
  std::set<std::array<int, 2>> ends;
  std::set<std::array<int, 3>> corners;
  bool simplicial = true;
  for_each_edge(mesh, [&](Edge e) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    const int a = mesh.from_vertex_handle(h).idx(), b = mesh.to_vertex_handle(h).idx();
    simplicial = ends.insert({std::min(a, b), std::max(a, b)}).second && simplicial;
  });
  for_each_face(mesh, [&](Face f) {
    const Halfedge h = mesh.halfedge_handle(f);
    if (mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) != mesh.prev_halfedge_handle(h)) return;
    std::array<int, 3> c = {mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx(),
                            mesh.to_vertex_handle(mesh.next_halfedge_handle(h)).idx()};
    std::sort(c.begin(), c.end());
    simplicial = corners.insert(c).second && simplicial;
  });
  return simplicial;
}

void two_triangle_sphere(TestMesh& mesh) {
  const auto b = separate_triangles(mesh, 2);
  glue(mesh, b[0], b[3]);
  glue(mesh, b[1], b[5]);
  glue(mesh, b[2], b[4]);
  mesh.garbage_collection();
}

void random_tiny_mesh(TestMesh& mesh, unsigned number) {
  std::mt19937 random(number);
  const int triangles = 1 + static_cast<int>(random() % 8);
  std::vector<Halfedge> open = separate_triangles(mesh, triangles);
  const auto attempts = random() % 60;
  for (unsigned i = 0; i < attempts && open.size() > 1; ++i) {
    const Halfedge h = open[random() % open.size()];
    const Halfedge with = random() % 2 ? mesh.next_halfedge_handle(h) : open[random() % open.size()];
    if (!glue_blocker(mesh, h, with)) glue(mesh, h, with);
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](Halfedge x) { return !is_live(mesh, x) || !mesh.is_boundary(x); }),
        open.end());
  }
  mesh.garbage_collection();
}

void on_every_mesh(const std::function<void(TestMesh&, Keep)>& visit) {
  for (const Keep keep : {Keep::simplicial, Keep::manifold}) {
    CAPTURE(static_cast<int>(keep));
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      mesh.garbage_collection();
      visit(mesh, keep);
    });
    for (unsigned number = 0; number < static_cast<unsigned>(rbpa_test::trials(300)); ++number) {
      CAPTURE(number);
      TestMesh mesh;
      random_tiny_mesh(mesh, number);
      visit(mesh, keep);
    }
  }
}

}  // namespace meshops::test
