#include "meshops/stellar/remove_vertex.h"

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "stellar/laws.h"
#include "support/arguments.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("remove_vertex") {
  TEST_CASE(
      "remove_vertex is refused exactly when no halfedge collapses, and otherwise collapses the first that does") {
    int removed = 0, refused = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      const std::string shape = isomorphism_class(mesh);
      for_each_vertex(mesh, [&](Vertex v) {
        if (v.idx() % stride(mesh)) return;
        Halfedge first;
        for (const Halfedge h : mesh.voh_range(v))
          if (!first.is_valid() && !collapse_blocker(mesh, h, keep)) first = h;
        CHECK(first.is_valid() == !remove_vertex_blocker(mesh, v, keep));
        if (refuses(mesh, remove_vertex_blocker(mesh, v, keep), [&] { remove_vertex(mesh, v, keep); })) {
          ++refused;
          return;
        }
        check_weld(
            mesh, keep, shape, [&] { return remove_vertex(mesh, v, keep); },
            [&](TestMesh& copy, const WeldEffect& effect) {
              CHECK(effect.halfedge == first);
              split_vertex(copy, effect.left, effect.right, Keep::manifold);
            },
            [&](const WeldEffect& effect) { undo(mesh, effect); });
        ++removed;
      });
    });
    CHECK(removed > rbpa_test::trials(1000));
    CHECK(refused > 100);
  }

  TEST_CASE("every reason against removing a vertex is reported") {
    TestMesh mesh;
    mesh.new_vertex();
    CHECK(remove_vertex_blocker(mesh, Vertex(-1))->kind == BlockerKind::missing);
    CHECK(remove_vertex_blocker(mesh, Vertex(0))->kind == BlockerKind::isolated);
    TestMesh triangle;
    add_triangles(triangle, 3, {{0, 1, 2}});
    CHECK(remove_vertex_blocker(triangle, Vertex(0))->kind == BlockerKind::only_edge_left);
    CHECK_THROWS_AS(remove_vertex(triangle, Vertex(0)), ContractViolation);
  }

  TEST_CASE("a sphere is reduced to a tetrahedron, then to two triangles") {
    TestMesh mesh = built(corpus()[6]);
    remove_vertex(mesh, Vertex(0));
    remove_vertex(mesh, Vertex(5));
    CHECK(counts(mesh) == Delta{4, 6, 4, 0, 1, 0});
    for (int i = 1; i < 5; ++i) CHECK(remove_vertex_blocker(mesh, Vertex(i))->kind == BlockerKind::double_triangle);
    remove_vertex(mesh, Vertex(1), Keep::manifold);
    CHECK(counts(mesh) == Delta{3, 3, 2, 0, 1, 0});
    check_sound(mesh);
    CHECK(remove_vertex_blocker(mesh, Vertex(2), Keep::manifold));
  }
}
