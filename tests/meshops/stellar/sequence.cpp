// Long random sequences of all stellar operators.
#include <random>

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

constexpr int kinds = 8;

/// Tries one operator at a random place. Returns: the change of the counts.
std::optional<Delta> step(TestMesh& mesh, std::mt19937& random, Keep keep, int kind) {
  const auto pick = [&](std::size_t count) { return static_cast<int>(random() % count); };
  const Halfedge h(pick(mesh.n_halfedges()));
  const Vertex v(pick(mesh.n_vertices()));
  const Face f(pick(mesh.n_faces()));
  const auto run = [](const auto& blocker, auto operate) -> std::optional<Delta> {
    if (blocker) return std::nullopt;
    return operate().delta();
  };
  switch (kind) {
    case 0:
      return run(split_edge_blocker(mesh, h, keep), [&] { return split_edge(mesh, h, keep); });
    case 1:
      return run(weld_edge_blocker(mesh, h, keep), [&] { return weld_edge(mesh, h, keep); });
    case 2:
      return run(split_face_blocker(mesh, f), [&] { return split_face(mesh, f); });
    case 3:
      return run(weld_face_blocker(mesh, v, keep), [&] { return weld_face(mesh, v, keep); });
    case 4:
      return run(flip_blocker(mesh, mesh.edge_handle(h), keep), [&] { return flip(mesh, mesh.edge_handle(h), keep); });
    case 5:
      return run(collapse_blocker(mesh, h, keep), [&] { return collapse(mesh, h, keep); });
    case 6:
      return run(remove_vertex_blocker(mesh, v, keep), [&] { return remove_vertex(mesh, v, keep); });
    default: {
      if (!is_live(mesh, h)) return std::nullopt;
      std::optional<Halfedge> left = h, right = h;
      for (auto n = random() % 4; n > 0; --n) right = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(*right));
      if (random() % 4 == 0) (random() % 2 ? left : right).reset();
      return run(split_vertex_blocker(mesh, left, right, keep), [&] { return split_vertex(mesh, left, right, keep); });
    }
  }
}

void run_sequence(const Specimen& specimen, Keep keep, int steps, unsigned seed) {
  INFO(specimen.name);
  TestMesh mesh;
  specimen.build(mesh);
  mesh.garbage_collection();
  std::mt19937 random(seed);
  const std::size_t faces = mesh.n_faces();
  Delta expected = counts(mesh);
  std::array<int, kinds> done = {};
  for (int i = 0; i < steps; ++i) {
    // Removals follow when the mesh has grown, and splits when it has shrunk.
    const bool large = mesh.n_faces() > 2 * faces + 40;
    int kind = static_cast<int>(random() % kinds);
    if (large && (kind == 0 || kind == 2 || kind == 7)) kind = 5;
    if (const auto delta = step(mesh, random, keep, kind)) {
      expected = expected + *delta;
      ++done[static_cast<std::size_t>(kind)];
    }
    if (i % 100 == 99) {
      REQUIRE(counts(mesh) == expected);
      check_sound(mesh);
      mesh.garbage_collection();
      check_sound(mesh);
      if (keep == Keep::simplicial && specimen.simplicial) REQUIRE(is_simplicial(mesh));
    }
  }
  for (const int times : done) CHECK(times > steps / 500);
}

}  // namespace

TEST_SUITE("stellar sequences") {
  TEST_CASE("ten thousand random operators keep the mesh sound, keep its topology, and keep it simplicial on request") {
    for (const Keep keep : {Keep::simplicial, Keep::manifold})
      for (const Specimen& specimen : corpus()) run_sequence(specimen, keep, 10000, 20101);
  }
}
