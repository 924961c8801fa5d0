#include "meshops/stellar/flip.h"

#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("flip") {
  TEST_CASE("every flip is refused with nothing changed, or keeps the counts and can be flipped back") {
    int flipped = 0, refused = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      const std::string shape = isomorphism_class(mesh);
      for_each_edge(mesh, [&](Edge e) {
        if (e.idx() % stride(mesh)) return;
        if (refuses(mesh, flip_blocker(mesh, e, keep), [&] { flip(mesh, e, keep); })) {
          ++refused;
          return;
        }
        const Halfedge h = mesh.halfedge_handle(e, 0);
        const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
        check_weld(
            mesh, keep, shape, [&] { return flip(mesh, e, keep); },
            [&](TestMesh& copy, const FlipEffect& effect) {
              CHECK_FALSE(flip_blocker(copy, effect.edge, Keep::manifold));
              flip(copy, effect.edge, Keep::manifold);
              CHECK(copy.from_vertex_handle(h) == b);
              CHECK(copy.to_vertex_handle(h) == a);
            },
            [&](const FlipEffect& effect) { undo(mesh, effect); });
        ++flipped;
      });
    });
    CHECK(flipped > 1000);
    CHECK(refused > 1000);
  }

  TEST_CASE("the edge turns counter-clockwise and each face keeps a side") {
    TestMesh mesh;
    add_triangles(mesh, 4, {{0, 1, 2}, {1, 0, 3}});
    const Halfedge h = mesh.find_halfedge(Vertex(0), Vertex(1));
    const Halfedge ca = mesh.find_halfedge(Vertex(2), Vertex(0)), db = mesh.find_halfedge(Vertex(3), Vertex(1));
    const Face left = mesh.face_handle(h), right = mesh.face_handle(mesh.opposite_halfedge_handle(h));
    flip(mesh, mesh.edge_handle(h));
    CHECK(mesh.from_vertex_handle(h) == Vertex(3));
    CHECK(mesh.to_vertex_handle(h) == Vertex(2));
    CHECK(mesh.face_handle(h) == left);
    CHECK(mesh.face_handle(ca) == left);
    CHECK(mesh.face_handle(db) == right);
    check_sound(mesh);
  }

  TEST_CASE("every reason against a flip is reported") {
    TestMesh mesh;
    CHECK(flip_blocker(mesh, Edge(0))->kind == BlockerKind::missing);
    add_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}});
    CHECK(flip_blocker(mesh, mesh.edge_handle(mesh.find_halfedge(Vertex(0), Vertex(1))))->kind ==
          BlockerKind::on_boundary);
    TestMesh polygons;
    for (int i = 0; i < 5; ++i) polygons.new_vertex();
    polygons.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    polygons.add_face({Vertex(1), Vertex(0), Vertex(4)});
    CHECK(flip_blocker(polygons, polygons.edge_handle(polygons.find_halfedge(Vertex(0), Vertex(1))))->kind ==
          BlockerKind::not_triangle);
    TestMesh tetrahedron;
    corpus()[5].build(tetrahedron);
    CHECK(flip_blocker(tetrahedron, Edge(0))->kind == BlockerKind::double_edge);
    flip(tetrahedron, Edge(0), Keep::manifold);
    check_sound(tetrahedron);
    TestMesh sphere;
    two_triangle_sphere(sphere);
    CHECK(flip_blocker(sphere, Edge(0), Keep::manifold)->kind == BlockerKind::loop_edge);
  }
}
