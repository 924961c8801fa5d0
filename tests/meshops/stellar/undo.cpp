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
  TEST_CASE("a long sequence undone in reverse order restores every bit") {
    for (const Keep keep : {Keep::simplicial, Keep::manifold})
      on_corpus([&](const Specimen&, TestMesh& mesh) {
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
      });
  }

  TEST_CASE("a removal writes nothing to the records of the removed elements") {
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

  TEST_CASE("undo restores properties with the handles") {
    TestMesh mesh = built(corpus()[6]);
    mesh.set_point(Vertex(0), {1, 2, 3});
    undo(mesh, collapse(mesh, mesh.halfedge_handle(Vertex(0))));
    CHECK(mesh.point(Vertex(0)) == TestMesh::Point(1, 2, 3));
  }

  TEST_CASE("elements that are not marked, or were collected, cannot be restored") {
    TestMesh mesh = built(corpus()[6]);
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

  TEST_CASE("an effect that is not of this mesh is refused, or leaves a sound mesh") {
    int refused = 0, opened = 0;
    std::mt19937 random(12);
    for (unsigned number = 0; number < 2000; ++number) {
      CAPTURE(number);
      TestMesh mesh;
      random_tiny_mesh(mesh, number);
      std::vector<WeldEffect> effects;
      for (int step = 0; step < 30; ++step) {
        const Halfedge h(static_cast<int>(random() % mesh.n_halfedges()));
        if (!collapse_blocker(mesh, h, Keep::manifold)) effects.push_back(collapse(mesh, h, Keep::manifold));
        if (effects.empty()) continue;
        WeldEffect effect = effects[random() % effects.size()];
        const WeldEffect& other = effects[random() % effects.size()];
        const Halfedge any(static_cast<int>(random() % (mesh.n_halfedges() + 1)));
        if (random() % 4 == 0) effect.removed.vertex = other.removed.vertex;
        if (random() % 4 == 0) effect.removed.edge[random() % 3] = other.removed.edge[random() % 3];
        if (random() % 4 == 0) effect.removed.face[random() % 2] = other.removed.face[random() % 2];
        if (random() % 4 == 0) (random() % 2 ? effect.left : effect.right) = any;
        if (random() % 4 == 0) effect.removed.at_boundary = !effect.removed.at_boundary;
        if (random() % 2 == 0 && effect.left && is_live(mesh, *effect.left))
          effect.survivor = mesh.from_vertex_handle(*effect.left);
        effect.named[random() % 3] = any;
        const auto before = snapshot(mesh);
        try {
          undo(mesh, effect);
          check_sound(mesh);
          ++opened;
        } catch (const ContractViolation&) {
          CHECK(snapshot(mesh) == before);
          ++refused;
        }
      }
    }
    CHECK(opened > 1000);
    CHECK(refused > 1000);
  }

  TEST_CASE("a flip is undone if there is an edge to flip, and the mesh stays sound") {
    int refused = 0, flipped = 0;
    std::mt19937 random(13);
    for (unsigned number = 0; number < 500; ++number) {
      TestMesh mesh;
      random_tiny_mesh(mesh, number);
      for (int e = -1; e <= static_cast<int>(mesh.n_edges()); ++e) {
        const auto any = [&] { return Halfedge(static_cast<int>(random() % (mesh.n_halfedges() + 2)) - 1); };
        const bool can = !flip_blocker(mesh, Edge(e), Keep::manifold);
        const auto before = snapshot(mesh);
        try {
          undo(mesh, FlipEffect{Edge(e), {any(), any()}});
          CHECK(can);
          check_sound(mesh);
          ++flipped;
        } catch (const ContractViolation&) {
          CHECK_FALSE(can);
          CHECK(snapshot(mesh) == before);
          ++refused;
        }
      }
    }
    CHECK(flipped > 1000);
    CHECK(refused > 1000);
  }
}
