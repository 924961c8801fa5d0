#include "meshops/stellar/split_vertex.h"

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Visits every way to split a vertex that one of the first outgoing halfedges leaves: with each other halfedge, and
/// with none.
template <typename Visit>
void for_each_run(const TestMesh& mesh, Vertex w, Visit visit) {
  std::vector<std::optional<Halfedge>> out = {std::nullopt};
  for (const Halfedge h : mesh.voh_range(w)) out.push_back(h);
  for (const auto& left : out)
    for (const auto& right : out) visit(left, right);
}

}  // namespace

TEST_SUITE("split_vertex") {
  TEST_CASE("every split_vertex is refused with nothing changed, or follows the table and is undone by a collapse") {
    int split = 0, refused = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      for_each_vertex(mesh, [&](Vertex w) {
        if (w.idx() % (is_large(mesh) ? 61 : rbpa_test::all_trials() || mesh.n_faces() < 30 ? 1 : 11)) return;
        for_each_run(mesh, w, [&](std::optional<Halfedge> left, std::optional<Halfedge> right) {
          if (refuses(mesh, split_vertex_blocker(mesh, left, right, keep),
                      [&] { split_vertex(mesh, left, right, keep); })) {
            ++refused;
            return;
          }
          check_split(
              mesh, keep,
              [&] {
                const SplitEffect effect = split_vertex(mesh, left, right, keep);
                CHECK(mesh.from_vertex_handle(effect.halfedge) == effect.added.vertex);
                CHECK(mesh.to_vertex_handle(effect.halfedge) == w);
                CHECK(effect.added.at_boundary == mesh.is_boundary(mesh.edge_handle(effect.halfedge)));
                if (left) CHECK(mesh.next_halfedge_handle(effect.halfedge) == *left);
                if (right)
                  CHECK(mesh.prev_halfedge_handle(mesh.opposite_halfedge_handle(effect.halfedge)) ==
                        mesh.opposite_halfedge_handle(*right));
                return effect;
              },
              [&](const SplitEffect& effect) {
                REQUIRE_FALSE(collapse_blocker(mesh, effect.halfedge, Keep::manifold));
                const WeldEffect collapsed = collapse(mesh, effect.halfedge, Keep::manifold);
                CHECK(collapsed.left == left);
                CHECK(collapsed.right == right);
              });
          ++split;
        });
      });
    });
    CHECK(split > 1000);
    CHECK(refused > 1000);
  }

  TEST_CASE("splits of edges and faces are splits of vertices") {
    TestMesh mesh, other;
    corpus()[6].build(mesh);
    corpus()[6].build(other);
    const Halfedge h(5);
    split_edge(mesh, h);
    const Halfedge o = other.opposite_halfedge_handle(h);
    split_vertex(other, other.next_halfedge_handle(h), other.opposite_halfedge_handle(other.prev_halfedge_handle(o)));
    CHECK(snapshot(mesh) == snapshot(other));
    split_face(mesh, Face(0));
    const Halfedge out = other.halfedge_handle(Face(0));
    split_vertex(other, out, other.opposite_halfedge_handle(other.prev_halfedge_handle(out)));
    CHECK(snapshot(mesh) == snapshot(other));
  }

  TEST_CASE("every reason against splitting a vertex is reported") {
    TestMesh wheel;
    corpus()[2].build(wheel);
    const Halfedge a = wheel.find_halfedge(Vertex(0), Vertex(1)), b = wheel.find_halfedge(Vertex(0), Vertex(2));
    const Halfedge rim = wheel.find_halfedge(Vertex(1), Vertex(2));
    CHECK(split_vertex_blocker(wheel, std::nullopt, std::nullopt)->kind == BlockerKind::none_given);
    CHECK(split_vertex_blocker(wheel, Halfedge(99), a)->kind == BlockerKind::missing);
    CHECK(split_vertex_blocker(wheel, std::nullopt, Halfedge())->kind == BlockerKind::missing);
    CHECK(split_vertex_blocker(wheel, a, rim)->kind == BlockerKind::other_vertex);
    CHECK(split_vertex_blocker(wheel, a, std::nullopt)->kind == BlockerKind::not_on_boundary);
    CHECK(split_vertex_blocker(wheel, std::nullopt, a)->kind == BlockerKind::not_on_boundary);
    CHECK(split_vertex_blocker(wheel, a, a)->kind == BlockerKind::double_edge);
    CHECK_FALSE(split_vertex_blocker(wheel, a, a, Keep::manifold));
    CHECK_FALSE(split_vertex_blocker(wheel, a, b));
    CHECK_FALSE(split_vertex_blocker(wheel, b, a));
    CHECK_FALSE(split_vertex_blocker(wheel, rim, std::nullopt));
    CHECK_FALSE(split_vertex_blocker(wheel, std::nullopt, rim));
  }
}
