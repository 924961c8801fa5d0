#include "meshops/stellar/undo.h"

#include <random>
#include <variant>

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_vertex.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("undo") {
  TEST_CASE("a long sequence taken back in reverse order restores every bit") {
    for (const Keep keep : {Keep::simplicial, Keep::manifold})
      for (const Specimen& specimen : corpus()) {
        INFO(specimen.name);
        TestMesh mesh;
        specimen.build(mesh);
        const auto records = snapshot(mesh);
        std::mt19937 random(11);
        std::vector<std::variant<WeldEffect, FlipEffect>> done;
        for (int step = 0; step < 2000; ++step) {
          const Halfedge h(static_cast<int>(random() % mesh.n_halfedges()));
          if (random() % 4) {
            if (!flip_blocker(mesh, mesh.edge_handle(h), keep))
              done.emplace_back(flip(mesh, mesh.edge_handle(h), keep));
          } else if (!collapse_blocker(mesh, h, keep)) {
            done.emplace_back(collapse(mesh, h, keep));
          }
        }
        check_sound(mesh);
        for (; !done.empty(); done.pop_back()) std::visit([&](const auto& effect) { undo(mesh, effect); }, done.back());
        CHECK(snapshot(mesh) == records);
      }
  }

  TEST_CASE("a removal writes nothing to the records of what it removes") {
    for (unsigned number = 0; number < 500; ++number) {
      CAPTURE(number);
      TestMesh mesh;
      random_tiny_mesh(mesh, number);
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (collapse_blocker(mesh, h, Keep::manifold)) return;
        TestMesh after = mesh;
        const StarElements removed = collapse(after, h, Keep::manifold).removed;
        CHECK(after.halfedge_handle(removed.vertex) == mesh.halfedge_handle(removed.vertex));
        for (const Face f : removed.faces()) CHECK(after.halfedge_handle(f) == mesh.halfedge_handle(f));
        for (const Edge e : removed.edges())
          for (const unsigned side : {0u, 1u}) {
            const Halfedge gone = mesh.halfedge_handle(e, side);
            CHECK(after.to_vertex_handle(gone) == mesh.to_vertex_handle(gone));
            CHECK(after.next_halfedge_handle(gone) == mesh.next_halfedge_handle(gone));
            CHECK(after.prev_halfedge_handle(gone) == mesh.prev_halfedge_handle(gone));
            CHECK(after.face_handle(gone) == mesh.face_handle(gone));
          }
      });
    }
  }

  TEST_CASE("properties come back with the handles") {
    TestMesh mesh;
    corpus()[6].build(mesh);
    mesh.set_point(Vertex(0), {1, 2, 3});
    undo(mesh, collapse(mesh, mesh.halfedge_handle(Vertex(0))));
    CHECK(mesh.point(Vertex(0)) == TestMesh::Point(1, 2, 3));
  }

  TEST_CASE("what is not marked, or collected, cannot be brought back") {
    TestMesh mesh;
    corpus()[6].build(mesh);
    const WeldEffect effect = collapse(mesh, Halfedge(0));
    undo(mesh, effect);
    const auto before = snapshot(mesh);
    CHECK_THROWS_AS(undo(mesh, effect), ContractViolation);
    CHECK(snapshot(mesh) == before);
    const WeldEffect again = collapse(mesh, Halfedge(0));
    mesh.garbage_collection();
    CHECK_THROWS_AS(undo(mesh, again), ContractViolation);
    CHECK_THROWS_AS(undo(mesh, WeldEffect()), ContractViolation);
  }
}
