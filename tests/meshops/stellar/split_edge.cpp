#include "meshops/stellar/split_edge.h"

#include "meshops/stellar/weld_edge.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("split_edge") {
  TEST_CASE("every split_edge is refused with nothing changed, or follows the table and is undone by a weld") {
    int split = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (h.idx() % stride(mesh)) return;
        if (refuses(mesh, split_edge_blocker(mesh, h, keep), [&] { split_edge(mesh, h, keep); })) return;
        const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
        check_split(
            mesh, keep,
            [&] {
              const SplitEffect effect = split_edge(mesh, h, keep);
              CHECK(mesh.from_vertex_handle(h) == a);
              CHECK(mesh.to_vertex_handle(h) == effect.added.vertex);
              CHECK(mesh.from_vertex_handle(effect.halfedge) == effect.added.vertex);
              CHECK(mesh.to_vertex_handle(effect.halfedge) == b);
              return effect;
            },
            [&](const SplitEffect& effect) {
              CHECK_FALSE(weld_edge_blocker(mesh, effect.halfedge, Keep::manifold));
              const WeldEdgeEffect weld = weld_edge(mesh, effect.halfedge, Keep::manifold);
              CHECK(weld.line == h);
              CHECK(weld.delta() == -effect.delta());
            });
        ++split;
      });
    });
    CHECK(split > 1000);
  }

  TEST_CASE("an edge is split along its first halfedge") {
    TestMesh mesh, other;
    add_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}});
    add_triangles(other, 4, {{0, 1, 2}, {0, 2, 3}});
    split_edge(mesh, Edge(2));
    split_edge(other, other.halfedge_handle(Edge(2), 0));
    CHECK(snapshot(mesh) == snapshot(other));
  }

  TEST_CASE("an inner edge gets four faces, a boundary edge two, seen from either side") {
    TestMesh mesh;
    add_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}});
    const SplitEffect inner = split_edge(mesh, mesh.find_halfedge(Vertex(0), Vertex(2)));
    CHECK(mesh.valence(inner.added.vertex) == 4);
    CHECK_FALSE(mesh.is_boundary(inner.added.vertex));
    CHECK(inner.added.edges().size() == 3);
    CHECK(inner.added.faces().size() == 2);
    const Halfedge rim = mesh.find_halfedge(Vertex(0), Vertex(1));
    for (const Halfedge h : {rim, mesh.opposite_halfedge_handle(rim)}) {
      const SplitEffect outer = split_edge(mesh, h);
      CHECK(mesh.valence(outer.added.vertex) == 3);
      CHECK(mesh.is_boundary(outer.added.vertex));
      CHECK(outer.added.edges().size() == 2);
      CHECK(outer.added.faces().size() == 1);
      CHECK(outer.delta() == Delta{.vertices = 1, .edges = 2, .faces = 1});
      check_sound(mesh);
    }
    CHECK(mesh.n_faces() == 6);
  }

  TEST_CASE("every reason against splitting an edge is reported") {
    TestMesh mesh;
    CHECK(split_edge_blocker(mesh, Edge(0))->kind == BlockerKind::missing);
    CHECK(split_edge_blocker(mesh, Halfedge(0))->kind == BlockerKind::missing);
    CHECK(split_edge_blocker(mesh, Edge())->kind == BlockerKind::missing);
    for (int i = 0; i < 5; ++i) mesh.new_vertex();
    mesh.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    mesh.add_face({Vertex(1), Vertex(0), Vertex(4)});
    CHECK(split_edge_blocker(mesh, mesh.find_halfedge(Vertex(1), Vertex(0)))->kind == BlockerKind::not_triangle);
    CHECK(split_edge_blocker(mesh, mesh.find_halfedge(Vertex(2), Vertex(3)))->kind == BlockerKind::not_triangle);
    CHECK_FALSE(split_edge_blocker(mesh, mesh.find_halfedge(Vertex(0), Vertex(4))));
    TestMesh sphere;
    two_triangle_sphere(sphere);
    CHECK(split_edge_blocker(sphere, Edge(0))->kind == BlockerKind::double_edge);
    CHECK_FALSE(split_edge_blocker(sphere, Edge(0), Keep::manifold));
    CHECK_THROWS_AS(split_edge(sphere, Edge(0)), ContractViolation);
  }

  TEST_CASE("a mesh without status can be split") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    const Halfedge h = separate_triangles(mesh, 1)[0];
    split_edge(mesh, h);
    check_sound(mesh);
    CHECK(mesh.n_faces() == 2);
  }
}
