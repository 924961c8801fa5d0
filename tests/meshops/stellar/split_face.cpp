#include "meshops/stellar/split_face.h"

#include "meshops/stellar/weld_face.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("split_face") {
  TEST_CASE("every split_face follows the table and is undone by a weld") {
    int split = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      for_each_face(mesh, [&](Face f) {
        if (f.idx() % stride(mesh)) return;
        REQUIRE_FALSE(split_face_blocker(mesh, f));
        const Vertex w = mesh.from_vertex_handle(mesh.halfedge_handle(f));
        check_split(
            mesh, keep,
            [&] {
              const SplitEffect effect = split_face(mesh, f);
              CHECK(mesh.valence(effect.added.vertex) == 3);
              CHECK(mesh.to_vertex_handle(effect.halfedge) == w);
              CHECK(mesh.halfedge_handle(effect.added.vertex) == effect.halfedge);
              for (const Halfedge h : mesh.fh_range(f)) CHECK(mesh.to_vertex_handle(h) != w);
              return effect;
            },
            [&](const SplitEffect& effect) {
              const WeldFaceEffect weld = weld_face(mesh, effect.added.vertex, Keep::manifold);
              CHECK(weld.face == f);
            });
        ++split;
      });
    });
    CHECK(split > 1000);
  }

  TEST_CASE("a single triangle becomes three, and its boundary stays") {
    TestMesh mesh;
    add_triangles(mesh, 3, {{0, 1, 2}});
    const SplitEffect effect = split_face(mesh, Face(0));
    CHECK(effect.delta() == Delta{.vertices = 1, .edges = 3, .faces = 2});
    CHECK(mesh.n_faces() == 3);
    CHECK_FALSE(mesh.is_boundary(effect.added.vertex));
    CHECK(counts(mesh).curves == 1);
  }

  TEST_CASE("every reason against splitting a face is reported") {
    TestMesh mesh;
    for (int i = 0; i < 4; ++i) mesh.new_vertex();
    CHECK(split_face_blocker(mesh, Face(0))->kind == BlockerKind::missing);
    CHECK(split_face_blocker(mesh, Face())->kind == BlockerKind::missing);
    mesh.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    CHECK(split_face_blocker(mesh, Face(0))->kind == BlockerKind::not_triangle);
    CHECK_THROWS_AS(split_face(mesh, Face(0)), ContractViolation);
  }
}
