#include "meshops/handle/unglue.h"

#include <doctest/doctest.h>

#include <random>

#include "meshops/core/live.h"
#include "meshops/front/boundary_curve.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/laws.h"
#include "support/on_corpus.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Returns the stride over the halfedges of a specimen to try: all of a small one, some of a large one.
int stride(const TestMesh& mesh) { return mesh.n_faces() > 300 ? 13 : 1; }

}  // namespace

TEST_SUITE("unglue") {
  TEST_CASE("unglue splits every inner edge of every specimen by the table, and gluing restores every record") {
    int seen[5] = {};
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      const TopologyCounts counts = count_topology(mesh);
      const auto before = live_snapshot(mesh, Named::any);
      const int n = static_cast<int>(mesh.n_halfedges());
      for (int i = 0; i < n; i += stride(mesh)) {
        const Halfedge h(i);
        if (const auto blocker = unglue_blocker(mesh, h)) {
          CHECK((blocker->kind == BlockerKind::missing || blocker->kind == BlockerKind::on_boundary));
          check_refused(mesh, describe(*blocker), [&] { unglue(mesh, h); });
          continue;
        }
        const GlueCase expected = unglue_case(mesh, h);
        const UnglueEffect effect = unglue(mesh, h);
        CHECK(effect.what == expected);
        ++seen[static_cast<int>(effect.what)];
        check_changed_by(effect.delta(), counts, mesh);
        CHECK_FALSE(glue_blocker(mesh, effect.first, effect.second));
        const GlueEffect glued = glue(mesh, effect.first, effect.second);
        CHECK(glued.what == effect.what);
        CHECK(live_snapshot(mesh, Named::any) == before);
        // Undoing the glue revives the elements that it marked deleted.
        const UnglueEffect again = unglue(mesh, glued);
        CHECK(again.second == effect.second);
        CHECK(again.new_start == effect.new_start);
        CHECK(again.new_end == effect.new_end);
        check_sound(mesh);
        glue(mesh, again.first, again.second);
        CHECK(live_snapshot(mesh, Named::any) == before);
      }
    });
    for (const int times : seen) CHECK(times > 0);
  }

  TEST_CASE("unglue undoes a glue of any case, and every live record is as before") {
    int seen[5] = {};
    std::mt19937 random(11);
    for (int round = 0; round < 40; ++round) {
      TestMesh mesh;
      separate_triangles(mesh, 14);
      std::vector<std::vector<int>> states;
      std::vector<GlueEffect> done;
      for (int step = 0; step < 60; ++step) {
        std::vector<Halfedge> open;
        for (const auto& curve : boundary_curves(mesh)) open.insert(open.end(), curve.begin(), curve.end());
        if (open.size() < 2) break;
        const Halfedge first = open[random() % open.size()];
        const Halfedge second = random() % 2 ? mesh.next_halfedge_handle(first) : open[random() % open.size()];
        if (glue_blocker(mesh, first, second)) continue;
        states.push_back(live_snapshot(mesh));
        done.push_back(glue(mesh, first, second));
        ++seen[static_cast<int>(done.back().what)];
      }
      while (!done.empty()) {
        const TopologyCounts counts = count_topology(mesh);
        const UnglueEffect effect = unglue(mesh, done.back());
        CHECK(effect.what == done.back().what);
        CHECK(effect.first == done.back().survivor);
        CHECK(effect.second == done.back().removed);
        check_changed_by(effect.delta(), counts, mesh);
        CHECK(live_snapshot(mesh) == states.back());
        states.pop_back();
        done.pop_back();
      }
    }
    for (const int times : seen) CHECK(times > 0);
  }

  TEST_CASE("new vertices and edges have copies of the properties of the old ones") {
    TestMesh mesh;
    const Strip s = strip(mesh, 3);
    glue(mesh, s.left, s.right);
    const Halfedge seam = s.left;
    OpenMesh::EPropHandleT<int> crease;
    mesh.add_property(crease);
    mesh.property(crease, mesh.edge_handle(seam)) = 7;
    mesh.set_point(mesh.from_vertex_handle(seam), {1, 2, 3});
    const UnglueEffect effect = unglue(mesh, seam);
    REQUIRE(effect.new_start.is_valid());
    CHECK(mesh.point(effect.new_start) == TestMesh::Point(1, 2, 3));
    CHECK(mesh.property(crease, mesh.edge_handle(effect.second)) == 7);
  }

  TEST_CASE("a glue cannot be undone twice, nor after its elements were changed") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    const GlueEffect glued = glue(mesh, b[0], b[3]);
    unglue(mesh, glued);
    check_refused(mesh, "is on the boundary", [&] { unglue(mesh, glued); });
    const GlueEffect other = glue(mesh, b[0], b[4]);
    CHECK(other.survivor == glued.survivor);
    check_refused(mesh, "the edge is no longer as glue() left it", [&] { unglue(mesh, glued); });
    check_refused(mesh, "unglue: halfedge 99 does not exist or is deleted", [&] { unglue(mesh, Halfedge(99)); });
  }
}
