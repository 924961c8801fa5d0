#include "meshops/handle/glue.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "meshops/core/contract.h"
#include "meshops/front/boundary_curve.h"
#include "support/check_sound.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Glues and checks the change of the counts by the table.
GlueCase checked_glue(TestMesh& mesh, Halfedge first, Halfedge second) {
  const TopologyCounts before = count_topology(mesh);
  REQUIRE_FALSE(glue_blocker(mesh, first, second));
  const GlueCase expected = glue_case(mesh, first, second);
  const GlueEffect effect = glue(mesh, first, second);
  CHECK(effect.what == expected);
  CHECK(effect.survivor == first);
  check_changed_by(effect.delta(), before, mesh);
  return effect.what;
}

}  // namespace

TEST_SUITE("glue") {
  TEST_CASE("edges on two components join them") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    CHECK(checked_glue(mesh, b[0], b[4]) == GlueCase::join);
  }

  TEST_CASE("edges of one curve that are not adjacent split it") {
    TestMesh mesh;
    const Strip s = strip(mesh, 3);
    CHECK(checked_glue(mesh, s.left, s.right) == GlueCase::split_curve);
    CHECK(count_topology(mesh).boundary_curves == 2);
  }

  TEST_CASE("edges on two curves of one component make a handle") {
    TestMesh mesh;
    const Strip s = strip(mesh, 4);
    glue(mesh, s.left, s.right);  // an annulus
    const auto curves = boundary_curves(mesh);
    REQUIRE(curves.size() == 2);
    const Halfedge first = curves[0].front();
    const auto second =
        std::find_if(curves[1].begin(), curves[1].end(), [&](Halfedge h) { return !glue_blocker(mesh, first, h); });
    REQUIRE(second != curves[1].end());
    CHECK(checked_glue(mesh, first, *second) == GlueCase::handle);
    CHECK(count_topology(mesh).genus() == 1);
  }

  TEST_CASE("adjacent edges zip, at either end, and the last two close the curve") {
    TestMesh mesh;
    strip(mesh, 2);
    bool other_end = false;
    for (;;) {
      const auto curves = boundary_curves(mesh);
      REQUIRE(curves.size() == 1);
      const Halfedge h = curves[0].front(), next = mesh.next_halfedge_handle(h);
      const auto length = curves[0].length();
      other_end = !other_end;
      const GlueCase done = other_end ? checked_glue(mesh, h, next) : checked_glue(mesh, next, h);
      CHECK(done == (length == 2 ? GlueCase::close : GlueCase::zip));
      if (length == 2) break;
    }
    const TopologyCounts sphere = count_topology(mesh);
    CHECK(sphere.boundary_curves == 0);
    CHECK(sphere.euler() == 2);
  }

  TEST_CASE("the lower handle of two merged vertices stays") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    const Vertex a0 = mesh.from_vertex_handle(b[0]), a1 = mesh.to_vertex_handle(b[3]);
    glue(mesh, b[3], b[0]);
    CHECK_FALSE(mesh.status(a0).deleted());
    CHECK(mesh.status(a1).deleted());
  }

  TEST_CASE("a refusal names its reason and leaves the mesh as it was") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    const Halfedge inner = mesh.opposite_halfedge_handle(b[0]);
    CHECK(glue_blocker(mesh, b[0], b[0])->kind == BlockerKind::same_edge);
    CHECK(glue_blocker(mesh, b[0], inner)->kind == BlockerKind::same_edge);
    CHECK(glue_blocker(mesh, inner, b[3])->kind == BlockerKind::not_on_boundary);
    CHECK(glue_blocker(mesh, Halfedge(), b[3])->kind == BlockerKind::missing);
    CHECK(glue_blocker(mesh, Halfedge(99), b[3])->kind == BlockerKind::missing);
    // The far ends of sides 0 and 1 of one triangle are joined by side 2.
    CHECK(glue_blocker(mesh, b[0], b[1])->kind == BlockerKind::loop_edge);
    const auto label = std::vector<int>{0, 1, 2, 3, 4, 5};
    const auto before = canonical_faces(mesh, label);
    CHECK_THROWS_AS(glue(mesh, b[0], b[1]), ContractViolation);
    CHECK(canonical_faces(mesh, label) == before);
  }

  TEST_CASE("gluing without status to mark deletions throws") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    const auto b = separate_triangles(mesh, 2);
    CHECK_THROWS_AS(glue(mesh, b[0], b[3]), ContractViolation);
  }

  TEST_CASE("random gluings keep the mesh sound and follow the table in all five cases") {
    std::mt19937 random(7);
    int seen[5] = {};
    for (int round = 0; round < 60; ++round) {
      TestMesh mesh;
      separate_triangles(mesh, 12);
      for (int step = 0; step < 40; ++step) {
        std::vector<Halfedge> open;
        for (const auto& curve : boundary_curves(mesh)) open.insert(open.end(), curve.begin(), curve.end());
        if (open.size() < 2) break;
        const Halfedge first = open[random() % open.size()];
        // Neighbors are rare among random pairs, so that half of the pairs are neighbors by choice.
        const Halfedge second = random() % 2 ? mesh.next_halfedge_handle(first) : open[random() % open.size()];
        if (glue_blocker(mesh, first, second)) continue;
        ++seen[static_cast<int>(checked_glue(mesh, first, second))];
      }
      mesh.garbage_collection();
      check_sound(mesh);
    }
    for (const int times : seen) CHECK(times > 0);
  }
}
