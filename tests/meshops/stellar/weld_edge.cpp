#include "meshops/stellar/weld_edge.h"

#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/undo.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("weld_edge") {
  TEST_CASE("every weld_edge is refused with nothing changed, or follows the table and is undone by a split") {
    int welded = 0, refused = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      const std::string shape = isomorphism_class(mesh);
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (h.idx() % stride(mesh)) return;
        if (refuses(mesh, weld_edge_blocker(mesh, h, keep), [&] { weld_edge(mesh, h, keep); })) {
          ++refused;
          return;
        }
        check_weld(
            mesh, keep, shape, [&] { return weld_edge(mesh, h, keep); },
            [](TestMesh& copy, const WeldEdgeEffect& effect) {
              CHECK(copy.to_vertex_handle(effect.line) == effect.survivor);
              split_edge(copy, effect.line, Keep::manifold);
            },
            [&](const WeldEdgeEffect& effect) { undo(mesh, effect); });
        ++welded;
      });
    });
    CHECK(welded > 100);
    CHECK(refused > 100);
  }

  TEST_CASE("the halfedge determines which of the two edges is removed") {
    TestMesh mesh;
    add_triangles(mesh, 5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
    const Halfedge h = mesh.find_halfedge(Vertex(0), Vertex(1));
    const Halfedge far = mesh.find_halfedge(Vertex(3), Vertex(0));
    const WeldEdgeEffect effect = weld_edge(mesh, h);
    CHECK(effect.line == far);
    CHECK(mesh.from_vertex_handle(far) == Vertex(3));
    CHECK(mesh.to_vertex_handle(far) == Vertex(1));
    CHECK(effect.survivor == Vertex(1));
    CHECK(effect.removed.vertex == Vertex(0));
    CHECK(effect.removed.edges()[0] == mesh.edge_handle(h));
    for (const Edge e : effect.removed.edges()) CHECK_FALSE(is_live(mesh, e));
    for (const Face f : effect.removed.faces()) CHECK_FALSE(is_live(mesh, f));
    CHECK(counts(mesh) == Delta{4, 5, 2, 1, 1, 0});
  }

  TEST_CASE("every reason against welding an edge is reported") {
    TestMesh wheel;
    corpus()[2].build(wheel);
    CHECK(weld_edge_blocker(wheel, Halfedge())->kind == BlockerKind::missing);
    CHECK(weld_edge_blocker(wheel, wheel.find_halfedge(Vertex(0), Vertex(1)))->kind == BlockerKind::wrong_degree);
    CHECK(weld_edge_blocker(wheel, wheel.find_halfedge(Vertex(1), Vertex(0)))->kind == BlockerKind::not_on_boundary);
    CHECK_FALSE(weld_edge_blocker(wheel, wheel.find_halfedge(Vertex(1), Vertex(2))));
    TestMesh octahedron;
    corpus()[6].build(octahedron);
    CHECK_FALSE(weld_edge_blocker(octahedron, Halfedge(0)));
    TestMesh square;
    corpus()[1].build(square);
    CHECK(weld_edge_blocker(square, square.find_halfedge(Vertex(1), Vertex(2)))->kind == BlockerKind::wrong_degree);
    TestMesh house;  // a triangle under a square
    for (int i = 0; i < 6; ++i) house.new_vertex();
    house.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    house.add_face({Vertex(1), Vertex(0), Vertex(4)});
    CHECK(weld_edge_blocker(house, house.find_halfedge(Vertex(0), Vertex(4)))->kind == BlockerKind::not_triangle);
    CHECK(weld_edge_blocker(house, house.find_halfedge(Vertex(0), Vertex(3)))->kind == BlockerKind::not_triangle);
    // A boundary curve of three edges: two of them cannot be merged, as the third joins their ends.
    TestMesh cone;
    add_triangles(cone, 4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
    CHECK(weld_edge_blocker(cone, cone.find_halfedge(Vertex(1), Vertex(2)))->kind == BlockerKind::double_edge);
    CHECK_FALSE(weld_edge_blocker(cone, cone.find_halfedge(Vertex(1), Vertex(2)), Keep::manifold));
    // Now the curve has two edges, and the next would be a loop.
    weld_edge(cone, cone.find_halfedge(Vertex(1), Vertex(2)), Keep::manifold);
    const Vertex rim(2);
    REQUIRE(cone.valence(rim) == 3);
    const Halfedge last = cone.halfedge_handle(rim);
    CHECK(weld_edge_blocker(cone, last, Keep::manifold)->kind == BlockerKind::loop_edge);
  }

  TEST_CASE("a weld without status to mark deletions throws") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    const Halfedge h = separate_triangles(mesh, 1)[0];
    const Halfedge half = split_edge(mesh, h).halfedge;
    CHECK(weld_edge_blocker(mesh, half) == Blocker(BlockerKind::no_status));
    CHECK_THROWS_AS(weld_edge(mesh, half), ContractViolation);
  }
}
