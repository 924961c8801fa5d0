#include "meshops/front/boundary_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "meshops/core/contract.h"
#include "meshops/handle/glue.h"
#include "support/meshes.h"

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

  TEST_CASE("is a forward range for the standard algorithms") {
    static_assert(std::forward_iterator<BoundaryCurve::Iterator>);
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
