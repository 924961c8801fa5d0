#include "meshops/stellar/collapse.h"

#include "meshops/handle/glue.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/interpolate.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

Halfedge ccw(const Connectivity& mesh, Halfedge h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

/// Flips all edges at the start of h that can be flipped: those beside h on its left first, then those on its right.
void flip_around(TestMesh& mesh, Halfedge h) {
  const Vertex v = mesh.from_vertex_handle(h);
  const unsigned stop = mesh.is_boundary(v) ? 2 : 3;
  const auto flip_next = [&](Halfedge out) {
    const Edge e = mesh.edge_handle(out);
    if (mesh.valence(v) <= stop || mesh.is_boundary(e)) return false;
    flip(mesh, e, Keep::manifold);
    return true;
  };
  if (!mesh.is_boundary(h))
    while (flip_next(ccw(mesh, h))) {
    }
  if (!mesh.is_boundary(mesh.opposite_halfedge_handle(h)))
    while (flip_next(mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h)))) {
    }
}

/// Returns for each vertex the number of vertices of its component.
std::vector<int> component_vertices(const TestMesh& mesh) {
  std::vector<int> count(mesh.n_vertices(), 0);
  for_each_vertex(mesh, [&](Vertex first) {
    std::vector<Vertex> reached = {first};
    std::vector<char> seen(mesh.n_vertices(), 0);
    seen[static_cast<std::size_t>(first.idx())] = 1;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const Vertex v : mesh.vv_range(reached[i]))
        if (char& mark = seen[static_cast<std::size_t>(v.idx())]; !mark) {
          mark = 1;
          reached.push_back(v);
        }
    count[static_cast<std::size_t>(first.idx())] = static_cast<int>(reached.size());
  });
  return count;
}

}  // namespace

TEST_SUITE("collapse") {
  TEST_CASE("every collapse is refused with nothing changed, or follows the table and is undone by a split") {
    int collapsed = 0, refused = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      const std::string shape = isomorphism_class(mesh);
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (h.idx() % stride(mesh)) return;
        if (refuses(mesh, collapse_blocker(mesh, h, keep), [&] { collapse(mesh, h, keep); })) {
          ++refused;
          return;
        }
        const Vertex v = mesh.from_vertex_handle(h), w = mesh.to_vertex_handle(h);
        check_weld(
            mesh, keep, shape,
            [&] {
              const WeldEffect effect = collapse(mesh, h, keep);
              CHECK(effect.removed.vertex == v);
              CHECK(effect.survivor == w);
              CHECK(effect.removed.edges()[0] == mesh.edge_handle(h));
              return effect;
            },
            [](TestMesh& copy, const WeldEffect& effect) {
              split_vertex(copy, effect.left, effect.right, Keep::manifold);
            },
            [&](const WeldEffect& effect) { undo(mesh, effect); });
        ++collapsed;
      });
    });
    CHECK(collapsed > 1000);
    CHECK(refused > 1000);
  }

  TEST_CASE("a collapse equals flips at the vertex and a weld, of a face or at the boundary") {
    int by_face = 0, by_edge = 0, by_triangle = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      if (keep == Keep::simplicial) return;
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (is_large(mesh) && h.idx() % 31) return;
        const Vertex v = mesh.from_vertex_handle(h);
        if (collapse_blocker(mesh, h, keep) || mesh.valence(v) == 2) return;
        const bool along_boundary = mesh.is_boundary(mesh.edge_handle(h));
        if (mesh.is_boundary(v) && !along_boundary) return;
        TestMesh direct = mesh, literal = mesh;
        collapse(direct, h, keep);
        if (!along_boundary) {
          flip_around(literal, h);
          REQUIRE(literal.valence(v) == 3);
          weld_face(literal, v, Keep::manifold);
          ++by_face;
        } else if (h.idx() % 2) {
          // The last flip is left out: a boundary vertex of degree three lies on an edge.
          while (literal.valence(v) > 3) {
            const Halfedge o = literal.opposite_halfedge_handle(h);
            const Halfedge beside = literal.is_boundary(h) ? literal.next_halfedge_handle(o) : ccw(literal, h);
            flip(literal, literal.edge_handle(beside), Keep::manifold);
          }
          weld_edge(literal, h, Keep::manifold);
          ++by_edge;
        } else {
          flip_around(literal, h);
          REQUIRE(literal.valence(v) == 2);
          const Face last = literal.face_handle(literal.is_boundary(h) ? literal.opposite_halfedge_handle(h) : h);
          literal.delete_face(last, true);
          ++by_triangle;
        }
        check_sound(literal);
        CHECK(isomorphism_class(direct) == isomorphism_class(literal));
      });
    });
    CHECK(by_face > 300);
    CHECK(by_edge > 100);
    CHECK(by_triangle > 100);
  }

  TEST_CASE("the refusals of Keep::manifold are exactly loops, pinches and components of three vertices") {
    int refused = 0;
    for (unsigned number = 0; number < 2000; ++number) {
      CAPTURE(number);
      TestMesh mesh;
      random_tiny_mesh(mesh, number);
      const std::vector<int> vertices_around = component_vertices(mesh);
      for_each_halfedge(mesh, [&](Halfedge h) {
        const Vertex v = mesh.from_vertex_handle(h), w = mesh.to_vertex_handle(h);
        int joins = 0;
        for (const Halfedge out : mesh.voh_range(v)) joins += mesh.to_vertex_handle(out) == w;
        const bool pinch = !mesh.is_boundary(mesh.edge_handle(h)) && mesh.is_boundary(v) && mesh.is_boundary(w);
        const bool expected = joins > 1 || pinch || vertices_around[static_cast<std::size_t>(v.idx())] == 3;
        CHECK(collapse_blocker(mesh, h, Keep::manifold).has_value() == expected);
        refused += expected;
      });
    }
    CHECK(refused > 1000);
  }

  TEST_CASE("the faces of the vertex may have any number of sides, except those of the edge") {
    // A square and two triangles around vertex 0; they are 0 1 2, 0 2 3 and 0 3 4 1.
    TestMesh mesh;
    for (int i = 0; i < 5; ++i) mesh.new_vertex();
    mesh.add_face({Vertex(0), Vertex(1), Vertex(2)});
    mesh.add_face({Vertex(0), Vertex(2), Vertex(3)});
    mesh.add_face({Vertex(0), Vertex(3), Vertex(4), Vertex(1)});
    const auto records = snapshot(mesh);
    const Halfedge h = mesh.find_halfedge(Vertex(0), Vertex(2));
    CHECK(collapse_blocker(mesh, mesh.find_halfedge(Vertex(0), Vertex(1))));
    const WeldEffect effect = collapse(mesh, h);
    check_sound(mesh);
    CHECK(counts(mesh) == Delta{4, 4, 1, 1, 1, 0});
    CHECK(mesh.valence(Face(2)) == 4);
    TestMesh copy = mesh;
    split_vertex(copy, effect.left, effect.right);
    check_sound(copy);
    CHECK(copy.n_faces() == 5);
    undo(mesh, effect);
    CHECK(snapshot(mesh) == records);
  }

  TEST_CASE("every reason against a collapse is reported") {
    TestMesh wheel;
    corpus()[2].build(wheel);
    CHECK(collapse_blocker(wheel, Halfedge())->kind == BlockerKind::missing);
    CHECK_FALSE(collapse_blocker(wheel, wheel.find_halfedge(Vertex(0), Vertex(1))));
    CHECK_FALSE(collapse_blocker(wheel, wheel.find_halfedge(Vertex(1), Vertex(0))));
    TestMesh square;
    corpus()[1].build(square);
    CHECK(collapse_blocker(square, square.find_halfedge(Vertex(0), Vertex(2)), Keep::manifold)->kind ==
          BlockerKind::pinch);
    CHECK_FALSE(collapse_blocker(square, square.find_halfedge(Vertex(0), Vertex(1))));
    CHECK_FALSE(collapse_blocker(square, square.find_halfedge(Vertex(1), Vertex(0))));
    TestMesh triangle;
    add_triangles(triangle, 3, {{0, 1, 2}});
    for (int i = 0; i < 6; ++i)
      CHECK(collapse_blocker(triangle, Halfedge(i), Keep::manifold)->kind == BlockerKind::only_edge_left);
    TestMesh polygon;
    for (int i = 0; i < 4; ++i) polygon.new_vertex();
    polygon.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
    CHECK(collapse_blocker(polygon, Halfedge(0))->kind == BlockerKind::not_triangle);
    CHECK(collapse_blocker(polygon, Halfedge(1))->kind == BlockerKind::not_triangle);
    TestMesh tetrahedron;
    corpus()[5].build(tetrahedron);
    for (int i = 0; i < 12; ++i) {
      CHECK(collapse_blocker(tetrahedron, Halfedge(i))->kind == BlockerKind::double_triangle);
      CHECK_FALSE(collapse_blocker(tetrahedron, Halfedge(i), Keep::manifold));
    }
    TestMesh sphere;
    two_triangle_sphere(sphere);
    for (int i = 0; i < 6; ++i)
      CHECK(collapse_blocker(sphere, Halfedge(i), Keep::manifold)->kind == BlockerKind::only_edge_left);
    // A face inside a face: its corners are joined by edges that bound no common face.
    TestMesh nested;
    add_triangles(nested, 3, {{0, 1, 2}});
    const Vertex center = split_face(nested, Face(0)).added.vertex;
    CHECK(collapse_blocker(nested, nested.find_halfedge(Vertex(0), Vertex(1)))->kind == BlockerKind::double_edge);
    CHECK_FALSE(collapse_blocker(nested, nested.find_halfedge(center, Vertex(0))));
    collapse(nested, nested.find_halfedge(Vertex(0), Vertex(1)), Keep::manifold);
    check_sound(nested);
    CHECK(counts(nested) == Delta{3, 4, 2, 1, 1, 0});
    // Now the boundary has two edges between the same vertices, and an inner vertex joins both of them once.
    for (const Halfedge h : nested.halfedges()) {
      if (!is_live(nested, h)) continue;
      const auto blocker = collapse_blocker(nested, h, Keep::manifold);
      REQUIRE(blocker);
      if (nested.is_boundary(nested.edge_handle(h)))
        CHECK(blocker->kind == BlockerKind::loop_edge);
      else
        CHECK(blocker->kind == BlockerKind::only_edge_left);
    }
  }

  TEST_CASE("a vertex of two edges collapses, and so does an edge to one") {
    // Two triangles with three common edges; one of these opens to two, with a vertex between them.
    TestMesh mesh;
    two_triangle_sphere(mesh);
    const SplitEffect split = split_vertex(mesh, Halfedge(0), Halfedge(0), Keep::manifold);
    check_sound(mesh);
    const Vertex w = mesh.to_vertex_handle(split.halfedge);
    REQUIRE(mesh.valence(w) == 2);
    const auto shape = isomorphism_class(mesh);
    const auto records = snapshot(mesh);
    for (const Halfedge h : {split.halfedge, mesh.opposite_halfedge_handle(split.halfedge)}) {
      REQUIRE_FALSE(collapse_blocker(mesh, h, Keep::manifold));
      const WeldEffect effect = collapse(mesh, h, Keep::manifold);
      check_sound(mesh);
      CHECK(counts(mesh) == Delta{3, 3, 2, 0, 1, 0});
      CHECK(effect.left == effect.right);
      TestMesh copy = mesh;
      split_vertex(copy, effect.left, effect.right, Keep::manifold);
      CHECK(isomorphism_class(copy) == shape);
      undo(mesh, effect);
      CHECK(snapshot(mesh) == records);
    }
  }

  TEST_CASE("a collapse with a hook is the collapse without it, and the hook sees both vertices") {
    int collapsed = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (h.idx() % stride(mesh) != 0) return;
        for_each_vertex(mesh, [&](Vertex v) { mesh.set_point(v, {float(v.idx()), 0, 1}); });
        TestMesh copy = mesh;
        const auto tried = try_collapse(copy, h, keep);
        const auto blocker = collapse_blocker(mesh, h, keep);
        REQUIRE(std::holds_alternative<Blocker>(tried) == blocker.has_value());
        if (blocker) {
          CHECK(std::get<Blocker>(tried) == *blocker);
          CHECK_THROWS_AS(collapse(mesh, h, PlaceVertex(), keep), ContractViolation);
          CHECK(snapshot(copy) == snapshot(mesh));
          return;
        }
        const auto records = snapshot(mesh);
        CHECK_THROWS_AS(collapse(
                            mesh, h, [](TestMesh&, const WeldEffect&) { throw 7; }, keep),
                        int);
        CHECK(snapshot(mesh) == records);
        const WeldEffect effect = collapse(mesh, h, PlaceVertex(), keep);
        CHECK(snapshot(mesh) == snapshot(copy));
        const auto middle = float(effect.survivor.idx() + effect.removed.vertex.idx()) / 2;
        CHECK(mesh.point(effect.survivor) == TestMesh::Point(middle, 0, 1));
        undo(mesh, effect);
        CHECK(snapshot(mesh) == records);
        ++collapsed;
      });
    });
    CHECK(collapsed > 1000);
  }

  TEST_CASE("Interpolate gives the survivor the mean of both vertices") {
    TestMesh mesh = built(corpus()[3]);
    OpenMesh::VPropHandleT<double> weight;
    mesh.add_property(weight);
    for_each_vertex(mesh, [&](Vertex v) {
      mesh.set_point(v, {float(2 * v.idx()), 0, 0});
      mesh.property(weight, v) = v.idx();
    });
    const Halfedge h = mesh.find_halfedge(Vertex(8), Vertex(14));
    const WeldEffect effect = collapse(mesh, h, Interpolate(weight));
    CHECK(effect.survivor == Vertex(14));
    CHECK(mesh.property(weight, Vertex(14)) == 11);
    CHECK(mesh.property(weight, Vertex(8)) == 8);
    CHECK(mesh.point(Vertex(14)) == TestMesh::Point(22, 0, 0));
  }

  TEST_CASE(
      "Interpolate gives means of the values before the collapse, of the points and of what is named twice, too") {
    TestMesh mesh = built(corpus()[3]);
    OpenMesh::VPropHandleT<double> weight;
    mesh.add_property(weight);
    const Halfedge h = mesh.find_halfedge(Vertex(8), Vertex(14));
    mesh.set_point(Vertex(8), {4, 0, 0});
    mesh.set_point(Vertex(14), {0, 0, 0});
    mesh.property(weight, Vertex(8)) = 4;
    mesh.property(weight, Vertex(14)) = 0;
    TestMesh named_last = mesh;
    collapse(mesh, h, Interpolate(mesh.points_pph(), weight, weight));
    CHECK(mesh.point(Vertex(14)) == TestMesh::Point(2, 0, 0));
    CHECK(mesh.property(weight, Vertex(14)) == 2);
    collapse(named_last, h, Interpolate(weight, weight, weight, named_last.points_pph()));
    CHECK(named_last.point(Vertex(14)) == TestMesh::Point(2, 0, 0));
    CHECK(named_last.property(weight, Vertex(14)) == 2);
  }

  TEST_CASE("Interpolate checks every property before it writes") {
    TestMesh mesh = built(corpus()[3]);
    OpenMesh::VPropHandleT<double> weight;
    mesh.add_property(weight);
    for_each_vertex(mesh, [&](Vertex v) {
      mesh.set_point(v, {float(v.idx()), 0, 0});
      mesh.property(weight, v) = v.idx();
    });
    const Halfedge h = mesh.find_halfedge(Vertex(8), Vertex(14));
    const auto records = snapshot(mesh);
    for (const int number : {-1, 1000, weight.idx()}) {
      const OpenMesh::VPropHandleT<float> wrong(number);
      CHECK_THROWS_AS(collapse(mesh, h, Interpolate(weight, wrong)), ContractViolation);
      CHECK(snapshot(mesh) == records);
      CHECK(mesh.point(Vertex(14)) == TestMesh::Point(14, 0, 0));
      CHECK(mesh.property(weight, Vertex(14)) == 14);
    }
  }
}
