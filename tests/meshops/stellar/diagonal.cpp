#include "meshops/stellar/diagonal.h"

#include <random>

#include "meshops/front/boundary_curve.h"
#include "meshops/handle/close_curve.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Visits the small meshes of laws.h after closing some of their boundary curves and removing some of their edges:
/// their faces are polygons, some of which touch themselves.
void on_polygons(const std::function<void(TestMesh&, Keep)>& visit) {
  std::mt19937 random(31);
  on_every_mesh([&](TestMesh& mesh, Keep keep) {
    if (is_large(mesh)) return;
    for (const BoundaryCurve& curve : boundary_curves(mesh))
      if (random() % 2 && !close_curve_blocker(mesh, curve.front())) close_curve(mesh, curve.front());
    for (auto tries = mesh.n_edges() / 3; tries > 0; --tries) {
      const Halfedge h(static_cast<int>(random() % mesh.n_halfedges()));
      if (!remove_diagonal_blocker(mesh, h)) remove_diagonal(mesh, h);
    }
    mesh.garbage_collection();
    check_sound(mesh);
    visit(mesh, keep);
  });
}

}  // namespace

TEST_SUITE("diagonal") {
  TEST_CASE("every insert_diagonal is refused with nothing changed, or follows the table and can be removed") {
    int drawn = 0, refused = 0;
    on_polygons([&](TestMesh& mesh, Keep keep) {
      for_each_halfedge(mesh, [&](Halfedge from) {
        Halfedge to = from;
        for (int step = 0; step < 9; ++step, to = mesh.next_halfedge_handle(to)) {
          if (refuses(mesh, insert_diagonal_blocker(mesh, from, to, keep),
                      [&] { insert_diagonal(mesh, from, to, keep); })) {
            ++refused;
            continue;
          }
          const Face face = mesh.face_handle(from);
          const Halfedge named = mesh.halfedge_handle(face);
          check_split(
              mesh, keep,
              [&] {
                const InsertDiagonalEffect effect = insert_diagonal(mesh, from, to, keep);
                CHECK(mesh.face_handle(effect.diagonal) == effect.face);
                CHECK(mesh.face_handle(mesh.opposite_halfedge_handle(effect.diagonal)) == face);
                CHECK(mesh.face_handle(named) == face);
                return effect;
              },
              [&](const InsertDiagonalEffect& effect) { remove_diagonal(mesh, effect.diagonal); });
          ++drawn;
        }
      });
    });
    CHECK(drawn > 1000);
    CHECK(refused > 1000);
  }

  TEST_CASE("every remove_diagonal is refused with nothing changed, or merges two faces that can be cut again") {
    int removed = 0, refused = 0;
    on_polygons([&](TestMesh& whole, Keep) {
      const std::string shape = isomorphism_class(whole);
      for_each_halfedge(whole, [&](Halfedge h) {
        TestMesh mesh = whole;
        if (refuses(mesh, remove_diagonal_blocker(mesh, h), [&] { remove_diagonal(mesh, h); })) {
          ++refused;
          return;
        }
        const Delta before = counts(mesh);
        const Face gone = mesh.face_handle(h), stays = mesh.face_handle(mesh.opposite_halfedge_handle(h));
        const RemoveDiagonalEffect effect = remove_diagonal(mesh, h);
        CHECK(effect.face == gone);
        CHECK(effect.survivor == stays);
        check_sound(mesh);
        CHECK(counts(mesh) == before + effect.delta());
        insert_diagonal(mesh, effect.from, effect.to, Keep::manifold);
        CHECK(isomorphism_class(mesh) == shape);
        ++removed;
      });
    });
    CHECK(removed > 1000);
    CHECK(refused > 1000);
  }

  TEST_CASE("every reason against a diagonal is reported") {
    TestMesh mesh;
    for (int i = 0; i < 5; ++i) mesh.new_vertex();
    mesh.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    mesh.add_face({Vertex(2), Vertex(1), Vertex(4)});
    const auto side = [&](int from, int to) { return mesh.find_halfedge(Vertex(from), Vertex(to)); };
    CHECK(insert_diagonal_blocker(mesh, side(0, 1), Halfedge())->kind == BlockerKind::missing);
    CHECK(insert_diagonal_blocker(mesh, side(0, 1), side(2, 1))->kind == BlockerKind::other_face);
    CHECK(insert_diagonal_blocker(mesh, side(1, 0), side(3, 2))->kind == BlockerKind::other_face);
    const auto neighbors = BlockerKind::corners_adjacent;
    CHECK(insert_diagonal_blocker(mesh, side(0, 1), side(0, 1)) ==
          Blocker(BlockerKind::same_edge, mesh.edge_handle(side(0, 1))));
    CHECK(insert_diagonal_blocker(mesh, side(0, 1), side(1, 2))->kind == neighbors);
    CHECK(insert_diagonal_blocker(mesh, side(1, 2), side(0, 1))->kind == neighbors);
    insert_diagonal(mesh, side(1, 2), side(3, 0));
    check_sound(mesh);
    CHECK(side(1, 3).is_valid());
    CHECK(remove_diagonal_blocker(mesh, side(0, 1))->kind == BlockerKind::on_boundary);
    CHECK(remove_diagonal_blocker(mesh, Halfedge(99))->kind == BlockerKind::missing);

    // The other side of a square is another face; its diagonal would join vertices that are joined already.
    TestMesh pillow;
    for (int i = 0; i < 4; ++i) pillow.new_vertex();
    pillow.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    close_curve(pillow, pillow.find_halfedge(Vertex(1), Vertex(0)));
    insert_diagonal(pillow, pillow.find_halfedge(Vertex(0), Vertex(1)), pillow.find_halfedge(Vertex(2), Vertex(3)));
    const Halfedge from = pillow.find_halfedge(Vertex(0), Vertex(3)), to = pillow.find_halfedge(Vertex(2), Vertex(1));
    CHECK(insert_diagonal_blocker(pillow, from, to)->kind == BlockerKind::double_edge);
    CHECK_FALSE(insert_diagonal_blocker(pillow, from, to, Keep::manifold));

    // With one edge of a pillow removed, the others are a path, and the remaining face is on both sides of each.
    TestMesh path;
    for (int i = 0; i < 4; ++i) path.new_vertex();
    path.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    close_curve(path, path.find_halfedge(Vertex(1), Vertex(0)));
    remove_diagonal(path, path.find_halfedge(Vertex(0), Vertex(1)));
    check_sound(path);
    const Halfedge onward = path.find_halfedge(Vertex(2), Vertex(3)), back = path.find_halfedge(Vertex(2), Vertex(1));
    CHECK(remove_diagonal_blocker(path, onward)->kind == BlockerKind::face_on_both_sides);
    CHECK(insert_diagonal_blocker(path, onward, back, Keep::manifold)->kind == BlockerKind::corner_repeated);
    // A path of two edges in a sphere: the triangles beside its two ends would have the same corners.
    TestMesh two;
    add_triangles(two, 3, {{0, 1, 2}});
    close_curve(two, two.find_halfedge(Vertex(1), Vertex(0)));
    remove_diagonal(two, two.find_halfedge(Vertex(0), Vertex(1)));
    const Halfedge one_end = two.find_halfedge(Vertex(0), Vertex(2)),
                   other_end = two.find_halfedge(Vertex(1), Vertex(2));
    CHECK(describe(insert_diagonal_blocker(two, one_end, other_end).value()) ==
          "face 1 would be cut into two triangles with the same corners");
    CHECK_FALSE(insert_diagonal_blocker(two, one_end, other_end, Keep::manifold));
  }
}
