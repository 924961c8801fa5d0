#include "meshops/topology/count.h"

#include <doctest/doctest.h>

#include "meshops/front/boundary_curve.h"
#include "meshops/handle/glue.h"
#include "support/check_sound.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("count") {
  TEST_CASE("a disc, an annulus and an isolated vertex are counted") {
    TestMesh mesh;
    const Strip s = strip(mesh, 4);
    TopologyCounts counts = count_topology(mesh);
    CHECK(counts.euler() == 1);
    CHECK(counts.boundary_curves == 1);
    CHECK(counts.genus() == 0);
    glue(mesh, s.left, s.right);
    counts = count_topology(mesh);
    CHECK(counts.euler() == 0);
    CHECK(counts.boundary_curves == 2);
    CHECK(counts.genus() == 0);
    mesh.new_vertex();
    counts = count_topology(mesh);
    CHECK(counts.isolated == 1);
    CHECK(counts.components == 2);
    CHECK(counts.genus() == 0);
  }

  TEST_CASE("a torus made of a band is counted") {
    // A band is closed to an annulus, whose two curves are then glued edge by edge.
    TestMesh mesh;
    const Strip s = strip(mesh, 5);
    glue(mesh, s.left, s.right);
    const auto curves = boundary_curves(mesh);
    REQUIRE(curves.size() == 2);
    std::vector<Halfedge> one(curves[0].begin(), curves[0].end()), other(curves[1].begin(), curves[1].end());
    REQUIRE(one.size() == other.size());
    // Curves run in opposite directions along the seam; shifted by two, no merged vertices are neighbors.
    std::size_t glued = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      const std::size_t j = (2 * one.size() + 2 - i) % other.size();
      if (glue_blocker(mesh, one[i], other[j])) continue;
      glue(mesh, one[i], other[j]);
      ++glued;
    }
    const TopologyCounts counts = count_topology(mesh);
    CHECK(counts.components == 1);
    CHECK(counts.genus() == 1);
    CHECK(counts.euler() == 2 - 2 - static_cast<long>(counts.boundary_curves));
    check_sound(mesh);
  }
}
