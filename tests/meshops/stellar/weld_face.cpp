#include "meshops/stellar/weld_face.h"

#include "meshops/stellar/split_face.h"
#include "meshops/stellar/undo.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("weld_face") {
  TEST_CASE("every weld_face is refused with nothing changed, or follows the table and is undone by a split") {
    int welded = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      const std::string shape = isomorphism_class(mesh);
      for_each_vertex(mesh, [&](Vertex v) {
        if (v.idx() % stride(mesh)) return;
        if (refuses(mesh, weld_face_blocker(mesh, v, keep), [&] { weld_face(mesh, v, keep); })) return;
        check_weld(
            mesh, keep, shape, [&] { return weld_face(mesh, v, keep); },
            [](TestMesh& copy, const WeldFaceEffect& effect) { split_face(copy, effect.face); },
            [&](const WeldFaceEffect& effect) { undo(mesh, effect); });
        ++welded;
      });
    });
    CHECK(welded > 20);
  }

  TEST_CASE("every reason against welding a face is reported") {
    TestMesh mesh;
    mesh.new_vertex();
    CHECK(weld_face_blocker(mesh, Vertex(1))->kind == BlockerKind::missing);
    CHECK(weld_face_blocker(mesh, Vertex(0))->kind == BlockerKind::isolated);
    TestMesh wheel;
    corpus()[2].build(wheel);
    CHECK(weld_face_blocker(wheel, Vertex(0))->kind == BlockerKind::wrong_degree);
    CHECK(weld_face_blocker(wheel, Vertex(1))->kind == BlockerKind::on_boundary);
    TestMesh tetrahedron;
    corpus()[5].build(tetrahedron);
    CHECK(weld_face_blocker(tetrahedron, Vertex(0))->kind == BlockerKind::double_triangle);
    weld_face(tetrahedron, Vertex(0), Keep::manifold);
    CHECK(counts(tetrahedron) == Delta{3, 3, 2, 0, 1, 0});
    check_sound(tetrahedron);
    // A square and two triangles at a vertex; the position of the halfedge of the vertex does not matter.
    TestMesh polygons;
    for (int i = 0; i < 5; ++i) polygons.new_vertex();
    polygons.add_face({Vertex(0), Vertex(1), Vertex(2)});
    polygons.add_face({Vertex(0), Vertex(2), Vertex(3)});
    polygons.add_face({Vertex(0), Vertex(3), Vertex(4), Vertex(1)});
    for (const Halfedge h : polygons.voh_range(Vertex(0))) {
      polygons.set_halfedge_handle(Vertex(0), h);
      CHECK(weld_face_blocker(polygons, Vertex(0))->kind == BlockerKind::not_triangle);
    }
    TestMesh degree_two;
    two_triangle_sphere(degree_two);
    CHECK(weld_face_blocker(degree_two, Vertex(0), Keep::manifold)->kind == BlockerKind::wrong_degree);
  }
}
