#include "meshops/handle/close_curve.h"

#include <doctest/doctest.h>

#include "meshops/front/boundary_curve.h"
#include "meshops/handle/glue.h"
#include "support/corpus.h"
#include "support/laws.h"
#include "support/on_corpus.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("close_curve") {
  TEST_CASE("close_curve fills any boundary curve with a face, and opening restores every record") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      for (const BoundaryCurve& curve : boundary_curves(mesh)) {
        const Halfedge h = curve.front();
        if (const auto blocker = close_curve_blocker(mesh, h)) {
          CHECK(curve.length() == 2);
          CHECK(blocker->kind == BlockerKind::curve_too_short);
          check_refused(mesh, describe(*blocker), [&] { close_curve(mesh, h); });
          continue;
        }
        const auto before = live_snapshot(mesh);
        const TopologyCounts counts = count_topology(mesh);
        const CloseCurveEffect closed = close_curve(mesh, h);
        CHECK(mesh.face_handle(h) == closed.face);
        CHECK(mesh.valence(closed.face) == curve.length());
        check_changed_by(closed.delta(), counts, mesh);
        const TopologyCounts then = count_topology(mesh);
        const OpenCurveEffect opened = open_curve(mesh, closed.face);
        CHECK(opened.curve == h);
        check_changed_by(opened.delta(), then, mesh);
        CHECK(live_snapshot(mesh) == before);
      }
    });
  }

  TEST_CASE("open_curve removes any inner face, and closing restores the mesh; otherwise the reason is named") {
    int opened = 0, refused = 0;
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      const bool large = mesh.n_faces() > 300;
      const std::string before = isomorphism_class(mesh);
      const int faces = static_cast<int>(mesh.n_faces());  // closing adds more
      for (int i = 0; i < faces; i += large ? 97 : 1) {
        const Face f(i);
        if (!mesh.status(f).deleted() && !open_curve_blocker(mesh, f)) {
          ++opened;
          const TopologyCounts counts = count_topology(mesh);
          const OpenCurveEffect effect = open_curve(mesh, f);
          check_changed_by(effect.delta(), counts, mesh);
          CHECK_FALSE(close_curve_blocker(mesh, effect.curve));
          close_curve(mesh, effect.curve);
          CHECK(isomorphism_class(mesh) == before);
        } else {
          ++refused;
          check_refused(mesh, describe(*open_curve_blocker(mesh, f)), [&] { open_curve(mesh, f); });
        }
      }
    });
    CHECK(opened > 50);
    CHECK(refused > 50);
  }

  TEST_CASE("each reason has a message of its own") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 1);
    CHECK(open_curve_blocker(mesh, Face(0))->kind == BlockerKind::on_boundary);
    CHECK(open_curve_blocker(mesh, Face(7))->kind == BlockerKind::missing);
    CHECK(close_curve_blocker(mesh, mesh.opposite_halfedge_handle(b[0]))->kind == BlockerKind::not_on_boundary);
    CHECK(close_curve_blocker(mesh, Halfedge(99))->kind == BlockerKind::missing);
    // A triangle with others glued around it, which touches the boundary in its corners.
    TestMesh star;
    add_triangles(star, 6, {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}});
    CHECK(open_curve_blocker(star, Face(0))->kind == BlockerKind::on_boundary);
    TestMesh strip_of_two;
    strip(strip_of_two, 2);
    for (;;) {
      const auto curve = boundary_curves(strip_of_two).front();
      if (curve.length() == 2) break;
      glue(strip_of_two, curve.front(), strip_of_two.next_halfedge_handle(curve.front()));
    }
    CHECK(close_curve_blocker(strip_of_two, boundary_curves(strip_of_two).front().front())->kind ==
          BlockerKind::curve_too_short);
  }
}
