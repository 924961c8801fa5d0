#include "meshops/handle/insert_triangle.h"

#include <doctest/doctest.h>

#include <map>
#include <random>

#include "meshops/front/boundary_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/glue.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

const std::array<Halfedge, 3> no_sides;

/// Mesh built in two ways in parallel: by insert_triangle(), and literally by create and glue. Vertices carry labels,
/// so that the meshes can be compared; a table maps halfedges of one to those of the other.
struct Twins {
  TestMesh fast, literal;
  std::map<int, int> twin;  // boundary halfedge of `fast` → its twin in `literal`
  std::vector<int> fast_label, literal_label;
  int next_label = 0;

  /// Adds a triangle on given sides of `fast` (invalid: a new edge).
  void insert(const std::array<Halfedge, 3>& side) {
    TriangleSides sides;
    sides.side = side;
    std::array<int, 3> label;
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned p = (i + 2) % 3;
      if (side[i].is_valid())
        label[i] = fast_label[static_cast<std::size_t>(fast.from_vertex_handle(side[i]).idx())];
      else if (side[p].is_valid())
        label[i] = fast_label[static_cast<std::size_t>(fast.to_vertex_handle(side[p]).idx())];
      else {
        sides.corner[i] = fast.new_vertex();
        fast_label.push_back(label[i] = next_label++);
      }
    }
    const InsertedTriangle done = insert_triangle(fast, sides);
    for (int i = 0; i < done.merged; ++i) fast.status(done.left_over[static_cast<unsigned>(i)]).set_deleted(true);

    Halfedge h = create_triangle(literal).inner;
    literal_label.insert(literal_label.end(), label.begin(), label.end());
    for (unsigned i = 0; i < 3; ++i) {
      const Halfedge outer = literal.opposite_halfedge_handle(h);
      h = literal.next_halfedge_handle(h);
      if (side[i].is_valid())
        glue(literal, Halfedge(twin.at(side[i].idx())), outer);
      else
        twin[fast.opposite_halfedge_handle(done.side[i]).idx()] = outer.idx();
    }
  }

  /// Returns whether create and glue would be accepted, tried on a copy.
  bool literal_accepts(const std::array<Halfedge, 3>& side) const {
    TestMesh copy = literal;
    Halfedge h = create_triangle(copy).inner;
    for (unsigned i = 0; i < 3; ++i) {
      const Halfedge outer = copy.opposite_halfedge_handle(h);
      h = copy.next_halfedge_handle(h);
      if (!side[i].is_valid()) continue;
      const Halfedge target(twin.at(side[i].idx()));
      if (glue_blocker(copy, target, outer)) return false;
      glue(copy, target, outer);
    }
    return true;
  }

  void check_equal() {
    check_sound(fast);
    check_sound(literal);
    CHECK(canonical_faces(fast, fast_label) == canonical_faces(literal, literal_label));
  }
};

}  // namespace

TEST_SUITE("insert_triangle") {
  TEST_CASE("insert_triangle without given sides equals create_triangle") {
    Twins t;
    t.insert(no_sides);
    t.check_equal();
  }

  TEST_CASE("insert_triangle on one given side adds a vertex") {
    Twins t;
    t.insert(no_sides);
    for (unsigned i = 0; i < 3; ++i) {
      std::array<Halfedge, 3> side;
      side[i] = boundary_curves(t.fast)[0].front();
      t.insert(side);
      t.check_equal();
    }
  }

  TEST_CASE("insert_triangle on adjacent sides fills a corner of the front, and on three sides closes a curve") {
    Twins t;
    t.insert(no_sides);
    // A fan around vertex `center`, until only the corner at it is open.
    const Halfedge start = boundary_curves(t.fast)[0].front();
    const Vertex center = t.fast.to_vertex_handle(start);
    for (int i = 0; i < 3; ++i) {
      std::array<Halfedge, 3> side;
      side[0] = t.fast.halfedge_handle(center);
      t.insert(side);
    }
    const Halfedge out = t.fast.halfedge_handle(center);
    t.insert({t.fast.prev_halfedge_handle(out), out, Halfedge()});
    t.check_equal();
    CHECK_FALSE(t.fast.is_boundary(center));
  }

  TEST_CASE("insert_triangle closes a curve of three edges") {
    Twins t;
    t.insert(no_sides);
    const Halfedge h = boundary_curves(t.fast)[0].front();
    const Halfedge next = t.fast.next_halfedge_handle(h);
    t.insert({h, next, t.fast.next_halfedge_handle(next)});
    t.check_equal();
    CHECK(boundary_curves(t.fast).empty());
  }

  TEST_CASE("insert_triangle on any sides of any curves leaves the same mesh as create and glue") {
    std::mt19937 random(11);
    int merges = 0;
    for (int round = 0; round < rbpa_test::trials(200); ++round) {
      Twins t;
      const int seeds = 1 + static_cast<int>(random() % 3);
      for (int i = 0; i < seeds; ++i) t.insert(no_sides);
      for (int step = 0; step < 14; ++step) {
        std::vector<Halfedge> open;
        for (const auto& curve : boundary_curves(t.fast)) open.insert(open.end(), curve.begin(), curve.end());
        if (open.empty()) break;
        std::array<Halfedge, 3> side;
        side[0] = open[random() % open.size()];
        const auto pick = random() % 4;
        if (pick == 1) side[1] = t.fast.next_halfedge_handle(side[0]);
        if (pick == 2) side[1] = open[random() % open.size()];
        if (pick == 3) side[2] = open[random() % open.size()];
        if (side[0] == side[1] || side[0] == side[2]) continue;
        // The corners must be different vertices, and vertices to be merged must not be neighbors: glue() refuses
        // these.
        if (!t.literal_accepts(side)) continue;
        const auto vertices_before = t.fast.n_vertices();
        t.insert(side);
        if (t.fast.n_vertices() == vertices_before && pick > 1) ++merges;
        t.check_equal();
      }
    }
    CHECK(merges > 50);
  }
}
