#include "meshops/stellar/keep.h"

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

struct Tally {
  int kept = 0, lost = 0;
};

/// Checks that, where the manifold mode operates on a simplicial mesh, the simplicial mode refuses exactly if the
/// result is not simplicial.
template <typename Blocker, typename Operate>
void compare(const TestMesh& mesh, Tally& tally, Blocker blocker, Operate operate) {
  if (blocker(Keep::manifold)) {
    CHECK(blocker(Keep::simplicial));
    return;
  }
  TestMesh copy = mesh;
  operate(copy);
  const bool simplicial = is_simplicial(copy);
  CHECK(blocker(Keep::simplicial).has_value() == !simplicial);
  ++(simplicial ? tally.kept : tally.lost);
}

void on_simplicial_meshes(const std::function<void(const TestMesh&)>& visit) {
  on_corpus([&](const Specimen&, TestMesh& mesh) {
    if (!is_large(mesh) && is_simplicial(mesh)) visit(mesh);
  });
  for (unsigned number = 0; number < 1000; ++number) {
    CAPTURE(number);
    TestMesh mesh;
    random_tiny_mesh(mesh, number);
    if (is_simplicial(mesh)) visit(mesh);
  }
}

}  // namespace

TEST_SUITE("keep") {
  TEST_CASE("Keep::simplicial refuses exactly the changes after which the mesh would not be simplicial") {
    Tally collapses, flips, edge_splits, edge_welds, face_welds, vertex_splits;
    on_simplicial_meshes([&](const TestMesh& mesh) {
      for_each_halfedge(mesh, [&](Halfedge h) {
        compare(
            mesh, collapses, [&](Keep keep) { return collapse_blocker(mesh, h, keep); },
            [&](TestMesh& copy) { collapse(copy, h, Keep::manifold); });
        compare(
            mesh, edge_splits, [&](Keep keep) { return split_edge_blocker(mesh, h, keep); },
            [&](TestMesh& copy) { split_edge(copy, h, Keep::manifold); });
        compare(
            mesh, edge_welds, [&](Keep keep) { return weld_edge_blocker(mesh, h, keep); },
            [&](TestMesh& copy) { weld_edge(copy, h, Keep::manifold); });
        for (const Halfedge right : mesh.voh_range(mesh.from_vertex_handle(h)))
          compare(
              mesh, vertex_splits, [&](Keep keep) { return split_vertex_blocker(mesh, h, right, keep); },
              [&](TestMesh& copy) { split_vertex(copy, h, right, Keep::manifold); });
      });
      for_each_edge(mesh, [&](Edge e) {
        compare(
            mesh, flips, [&](Keep keep) { return flip_blocker(mesh, e, keep); },
            [&](TestMesh& copy) { flip(copy, e, Keep::manifold); });
      });
      for_each_vertex(mesh, [&](Vertex v) {
        compare(
            mesh, face_welds, [&](Keep keep) { return weld_face_blocker(mesh, v, keep); },
            [&](TestMesh& copy) { weld_face(copy, v, Keep::manifold); });
      });
    });
    for (const Tally& tally : {collapses, flips, edge_welds, face_welds, vertex_splits}) {
      CHECK(tally.kept > 0);
      CHECK(tally.lost > 0);
    }
    CHECK(edge_splits.kept > 0);
    CHECK(edge_splits.lost == 0);  // on a simplicial mesh both triangles of an edge have different apexes
  }
}
