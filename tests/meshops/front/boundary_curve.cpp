#include "meshops/front/boundary_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "meshops/core/contract.h"
#include "meshops/handle/glue.h"
#include "support/corpus.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("boundary_curve") {
  TEST_CASE("every boundary halfedge is on exactly one curve, in the order of next") {
    TestMesh mesh;
    const Strip s = strip(mesh, 5);
    glue(mesh, s.left, s.right);
    separate_triangles(mesh, 3);
    std::multiset<int> on_curves;
    const auto curves = boundary_curves(mesh);
    CHECK(curves.size() == 5);
    for (const auto& curve : curves) {
      std::size_t length = 0;
      Halfedge expected = curve.front();
      for (const Halfedge h : curve) {
        CHECK(h == expected);
        expected = mesh.next_halfedge_handle(h);
        on_curves.insert(h.idx());
        ++length;
      }
      CHECK(expected == curve.front());
      CHECK(length == curve.length());
    }
    std::multiset<int> boundary;
    for (const auto h : mesh.halfedges())
      if (mesh.is_boundary(h)) boundary.insert(h.idx());
    CHECK(on_curves == boundary);
  }

  TEST_CASE("a curve runs backwards as well, with the mesh on the left") {
    TestMesh mesh;
    strip(mesh, 4);
    const BoundaryCurve curve = boundary_curves(mesh)[0];
    std::vector<int> forward, backward;
    for (const Halfedge h : curve) forward.push_back(h.idx());
    for (auto at = curve.end(); at != curve.begin();) backward.push_back((*--at).idx());
    std::reverse(backward.begin(), backward.end());
    CHECK(backward == forward);
    CHECK(forward.size() == curve.length());
  }

  TEST_CASE("the curve at a vertex leaves it; inner and isolated vertices have none") {
    TestMesh mesh;
    std::vector<std::array<int, 3>> wheel;
    for (int i = 0; i < 6; ++i) wheel.push_back({0, 1 + i, 1 + (i + 1) % 6});
    add_triangles(mesh, 7, wheel);
    mesh.new_vertex();
    CHECK_FALSE(boundary_curve_at(mesh, Vertex(0)));
    CHECK_FALSE(boundary_curve_at(mesh, Vertex(7)));
    for (int v = 1; v < 7; ++v) {
      const auto curve = boundary_curve_at(mesh, Vertex(v));
      REQUIRE(curve);
      CHECK(mesh.from_vertex_handle(curve->front()) == Vertex(v));
      CHECK(curve->length() == 6);
      CHECK(curve->contains(boundary_curves(mesh)[0].front()));
    }
    const auto other = separate_triangles(mesh, 1);
    CHECK_FALSE(boundary_curves(mesh)[0].contains(other[1]));
  }

  TEST_CASE("a curve is a bidirectional range for the standard algorithms") {
    static_assert(std::bidirectional_iterator<BoundaryCurve::Iterator>);
    TestMesh mesh;
    strip(mesh, 2);
    const BoundaryCurve curve = boundary_curves(mesh)[0];
    CHECK(std::distance(curve.begin(), curve.end()) == 6);
    CHECK(std::find(curve.begin(), curve.end(), Halfedge()) == curve.end());
  }

  TEST_CASE("an inner halfedge is refused") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 1);
    CHECK_THROWS_AS(BoundaryCurve(mesh, mesh.opposite_halfedge_handle(b[0])), ContractViolation);
    CHECK_THROWS_AS(BoundaryCurve(mesh, Halfedge()), ContractViolation);
  }
}
