#include "meshops/history/history.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <type_traits>

#include "meshops/core/contract.h"
#include "meshops/core/live_range.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/meshes.h"
#include "support/on_corpus.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

// The steps of a history refer to it.
static_assert(!std::is_copy_constructible_v<History> && !std::is_move_constructible_v<History>);
static_assert(!std::is_copy_assignable_v<History> && !std::is_move_assignable_v<History>);

/// Performs one operator on random handles, if it is not refused. Returns: its number.
int random_step(History& history, TestMesh& mesh, std::mt19937& random) {
  const auto any = [&](std::size_t count) { return static_cast<int>(random() % std::max<std::size_t>(count, 1)); };
  const Halfedge h(any(mesh.n_halfedges())), g(any(mesh.n_halfedges()));
  const Face f(any(mesh.n_faces()));
  const Vertex v(any(mesh.n_vertices()));
  const Keep keep = random() % 2 ? Keep::manifold : Keep::simplicial;
  // Near means after h on its face or curve.
  const auto near = [&] {
    Halfedge at = h;
    for (unsigned steps = 1 + static_cast<unsigned>(random() % 4); steps > 0 && is_live(mesh, h); --steps)
      at = mesh.next_halfedge_handle(at);
    return at;
  }();
  const int what = any(19);
  switch (what) {
    case 0:
      history.create_triangle();
      break;
    case 1:
      history.destroy_triangle(f);
      break;
    case 2:
      history.glue(h, g);
      break;
    case 3:
      history.glue(h, near);
      break;
    case 4:
      history.unglue(h);
      break;
    case 5:
      history.close_curve(h);
      break;
    case 6:
      history.open_curve(f);
      break;
    case 7:
      history.flip(mesh.edge_handle(h), keep);
      break;
    case 8:
      history.collapse(h, keep);
      break;
    case 9:
      history.weld_edge(h, keep);
      break;
    case 10:
      history.weld_face(v, keep);
      break;
    case 11:
      history.remove_vertex(v, keep);
      break;
    case 12:
      history.insert_diagonal(h, near, keep);
      break;
    case 13:
      history.remove_diagonal(h);
      break;
    case 14:
      if (random() % 2)
        history.split_edge(h, keep);
      else
        history.split_face(mesh, f, CarryOver());
      break;
    case 15:
      history.remove_triangle(f);
      break;
    case 16:
      history.zip_curves(h, g);
      break;
    case 17:
      history.triangulate_face(
          f, [](Vertex a, Vertex b, Vertex c) { return a.idx() * b.idx() % 7 + c.idx(); }, keep);
      break;
    default:
      history.split_vertex(h, random() % 3 ? std::optional(near) : std::nullopt, keep);
  }
  return what;
}

}  // namespace

TEST_SUITE("history") {
  TEST_CASE("undoing a random walk restores all records step by step, and redoing it repeats the walk") {
    std::array<int, 19> done{};
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      if (mesh.n_faces() > 200) return;
      std::mt19937 random(27);
      History history(mesh);
      std::vector<std::vector<int>> records = {snapshot(mesh)};
      for (int i = 0; i < 2000; ++i) {
        const std::size_t steps = history.steps();
        try {
          ++done[static_cast<std::size_t>(random_step(history, mesh, random))];
          records.push_back(snapshot(mesh));
        } catch (const ContractViolation&) {
          REQUIRE(history.steps() == steps);
          REQUIRE(snapshot(mesh) == records.back());
        }
        // Undo and redo on the way: later steps build on steps that were redone.
        if (i % 50 == 49)
          for (unsigned back = 0; back < 2; ++back) {
            const std::size_t to = history.steps() - std::min<std::size_t>(history.steps(), 20);
            history.undo_to(to);
            REQUIRE(snapshot(mesh) == records[to]);
            while (history.undone_steps() > 0) history.redo();
            REQUIRE(snapshot(mesh) == records.back());
          }
      }
      check_sound(mesh);
      REQUIRE(records.size() == history.steps() + 1);
      while (history.steps() > 0) {
        history.undo();
        REQUIRE(snapshot(mesh) == records[history.steps()]);
      }
      while (history.undone_steps() > 0) {
        history.redo();
        REQUIRE(snapshot(mesh) == records[history.steps()]);
      }
      history.undo_to(0);
      REQUIRE(snapshot(mesh) == records.front());
    });
    for (std::size_t what = 0; what < done.size(); ++what) {
      CAPTURE(what);
      CHECK(done[what] >= 5);
    }
  }

  TEST_CASE("each operator of a history returns what the operator returns") {
    TestMesh mesh;
    History history(mesh);
    const Face f = history.create_triangle().face;
    CHECK(history.destroy_triangle(f) == delta_of_destroy());
    history.undo();
    CHECK(history.remove_triangle(f) == delta_of_destroy());
  }

  TEST_CASE("another step after undo() leaves nothing to redo") {
    TestMesh mesh;
    History history(mesh);
    history.create_triangle();
    history.create_triangle();
    history.undo();
    CHECK(history.undone_steps() == 1);
    history.split_face(Face(0));
    CHECK(history.undone_steps() == 0);
    CHECK_THROWS_AS(history.redo(), ContractViolation);
    history.undo_to(0);
    CHECK(mesh.n_vertices() == 0);
    CHECK_THROWS_AS(history.undo(), ContractViolation);
    CHECK_THROWS_AS(history.undo_to(1), ContractViolation);
  }

  TEST_CASE("a mesh that other code changed is refused, and stays as it is") {
    TestMesh mesh;
    History history(mesh);
    history.create_triangle();
    mesh.new_vertex();
    const auto records = snapshot(mesh);
    CHECK_THROWS_AS(history.undo(), ContractViolation);
    CHECK_THROWS_AS(history.create_triangle(), ContractViolation);
    CHECK(snapshot(mesh) == records);
    OpenMesh::PolyMesh_ArrayKernelT<> without_status;
    CHECK_THROWS_AS(History{without_status}, ContractViolation);
  }

  TEST_CASE("redo() of a split with a hook calls the hook again") {
    TestMesh mesh;
    History history(mesh);
    history.create_triangle();
    for (const Vertex v : live_vertices(mesh)) mesh.set_point(v, {static_cast<float>(v.idx()), 0, 0});
    const Halfedge h = mesh.halfedge_handle(Face(0));
    const Vertex v = history.split_edge(mesh, h, CarryOver()).added.vertex;
    const TestMesh::Point place = mesh.point(v);
    history.undo();
    CHECK(mesh.n_vertices() == 3);
    history.redo();
    CHECK(mesh.point(v) == place);
    CHECK(place[0] == 0.5F);
  }

  TEST_CASE("redo() of a split uses copies of the arguments and the hook, and nothing else of the caller") {
    TestMesh mesh = built(corpus()[0]);
    for (const Vertex v : live_vertices(mesh)) mesh.set_point(v, {static_cast<float>(v.idx()), 1, 2});
    History history(mesh);
    OpenMesh::FPropHandleT<int> label;
    mesh.add_property(label);
    // The arguments are gone when the lambda returns, and other numbers are in their place.
    const auto split = [&](int which) {
      const Halfedge h = mesh.halfedge_handle(Face(0));
      const Face f = mesh.face_handle(h);
      const int number = 7 + which;
      const auto hook = [label, number](TestMesh& m, const auto& effect) {
        for (const Face added : effect.added.faces()) m.property(label, added) = number;
        PlaceVertex()(m, effect);
      };
      if (which == 0) return history.split_edge(mesh, h, hook).added.vertex;
      if (which == 1) return history.split_face(mesh, f, hook).added.vertex;
      if (which == 2) return history.split_vertex(mesh, h, h, hook, Keep::manifold).added.vertex;
      if (which == 3) return history.split_edge(mesh, h).added.vertex;
      if (which == 4) return history.split_face(mesh, f).added.vertex;
      return history.split_vertex(mesh, h, h, PlaceVertex(), Keep::manifold).added.vertex;
    };
    std::vector<std::vector<int>> records = {snapshot(mesh)};
    std::vector<TestMesh::Point> places;
    for (int which = 0; which < 6; ++which) {
      CAPTURE(which);
      const Vertex v = split(which);
      records.push_back(snapshot(mesh));
      places.push_back(mesh.point(v));
    }
    history.undo_to(0);
    CHECK(snapshot(mesh) == records[0]);
    for (std::size_t which = 0; which < 6; ++which) {
      CAPTURE(which);
      history.redo();
      CHECK(snapshot(mesh) == records[which + 1]);
      CHECK(mesh.point(Vertex(static_cast<int>(mesh.n_vertices()) - 1)) == places[which]);
    }
    int labelled = 0;
    for (const Face f : live_faces(mesh)) labelled += mesh.property(label, f) > 0;
    CHECK(labelled >= 3);
  }

  TEST_CASE("a split of another mesh than that of the history is refused") {
    TestMesh mesh, other;
    History history(mesh);
    history.create_triangle();
    separate_triangles(other, 1);
    const auto records = snapshot(other);
    CHECK_THROWS_AS(history.split_edge(other, Halfedge(0)), ContractViolation);
    CHECK_THROWS_AS(history.split_face(other, Face(0), CarryOver()), ContractViolation);
    CHECK_THROWS_AS(history.split_vertex(other, Halfedge(0), std::nullopt), ContractViolation);
    CHECK(snapshot(other) == records);
    CHECK(history.steps() == 1);
  }
}
