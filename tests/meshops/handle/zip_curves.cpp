#include "meshops/handle/zip_curves.h"

#include <doctest/doctest.h>

#include <map>

#include "meshops/front/boundary_curve.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/unglue.h"
#include "support/corpus.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

Halfedge along(const TestMesh& mesh, Halfedge h, std::size_t steps) {
  while (steps-- > 0) h = mesh.next_halfedge_handle(h);
  return h;
}

}  // namespace

TEST_SUITE("zip_curves") {
  TEST_CASE("zip_curves sews any two curves of equal length at any shift, by the table, and the seam opens again") {
    int joins = 0, handles = 0;
    for (const Specimen& specimen : corpus()) {
      CAPTURE(specimen.name);
      TestMesh whole;
      specimen.build(whole);
      const auto curves = boundary_curves(whole);
      const std::string before = curves.size() < 10 ? isomorphism_class(whole) : "";
      const TopologyCounts counts = count_topology(whole);
      for (std::size_t a = 0; a < std::min<std::size_t>(curves.size(), 4); ++a)
        for (std::size_t b = 0; b < std::min<std::size_t>(curves.size(), 6); ++b) {
          if (a == b) continue;
          for (std::size_t shift = 0; shift < std::min<std::size_t>(curves[b].length(), 5); ++shift) {
            TestMesh mesh = whole;
            const Halfedge first = curves[a].front(), second = along(mesh, curves[b].front(), shift);
            if (const auto blocker = zip_curves_blocker(mesh, first, second)) {
              check_refused(mesh, describe(*blocker), [&] { zip_curves(mesh, first, second); });
              continue;
            }
            const ZipCurvesEffect effect = zip_curves(mesh, first, second);
            (effect.begins_with() == GlueCase::join ? joins : handles) += 1;
            CHECK(effect.glued.size() == curves[a].length());
            check_changed_by(effect.delta(), counts, mesh);
            if (before.empty()) continue;
            std::vector<Halfedge> seam;
            Halfedge h = first;
            for (const Halfedge on_curve : BoundaryCurve(whole, first)) seam.push_back(on_curve);
            while (!seam.empty()) {
              h = seam.back();
              seam.pop_back();
              unglue(mesh, h);
            }
            CHECK(isomorphism_class(mesh) == before);
          }
        }
    }
    CHECK(joins > 0);
    CHECK(handles > 0);
  }

  TEST_CASE("two triangles sewn along their boundaries are a sphere, and two annuli are a torus") {
    TestMesh sphere;
    const auto b = separate_triangles(sphere, 2);
    const ZipCurvesEffect effect = zip_curves(sphere, b[0], b[3]);
    CHECK(effect.begins_with() == GlueCase::join);
    CHECK(count_topology(sphere).euler() == 2);
    TestMesh torus;
    for (int i = 0; i < 2; ++i) {
      const Strip s = strip(torus, 4);
      glue(torus, s.left, s.right);
    }
    REQUIRE(boundary_curves(torus).size() == 4);
    std::map<std::size_t, int> lengths;
    for (const auto& curve : boundary_curves(torus)) ++lengths[curve.length()];
    REQUIRE(lengths.size() == 1);
    const auto curves = boundary_curves(torus);
    CHECK(zip_curves(torus, curves[0].front(), curves[2].front()).begins_with() == GlueCase::join);
    CHECK(zip_curves(torus, curves[1].front(), curves[3].front()).begins_with() == GlueCase::handle);
    const TopologyCounts counts = count_topology(torus);
    CHECK(counts.components == 1);
    CHECK(counts.genus() == 1);
    CHECK(counts.boundary_curves == 0);
  }

  TEST_CASE("each reason has a message of its own") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 3);
    glue(mesh, b[3], b[6]);
    CHECK(*zip_curves_blocker(mesh, b[0], b[4]) == Blocker(BlockerKind::curve_length, b[4], 4));
    CHECK(zip_curves_blocker(mesh, b[0], b[1])->kind == BlockerKind::same_curve);
    CHECK(zip_curves_blocker(mesh, b[0], Halfedge(77))->kind == BlockerKind::missing);
    CHECK(zip_curves_blocker(mesh, b[0], mesh.opposite_halfedge_handle(b[0]))->kind == BlockerKind::not_on_boundary);
    // A ring of six triangles whose rims, of three edges each, are joined by edges.
    TestMesh ring;
    add_triangles(ring, 6, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}});
    const auto curves = boundary_curves(ring);
    REQUIRE(curves.size() == 2);
    // Each vertex of a rim has edges to two vertices of the other: only one shift merges none of these pairs.
    int refused = 0;
    for (std::size_t shift = 0; shift < 3; ++shift) {
      const auto blocker = zip_curves_blocker(ring, curves[0].front(), along(ring, curves[1].front(), shift));
      if (!blocker) continue;
      CHECK(blocker->kind == BlockerKind::loop_edge);
      ++refused;
    }
    CHECK(refused == 2);
  }
}
