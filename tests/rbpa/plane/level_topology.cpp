#include "rbpa/plane/level_topology.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <map>
#include <ostream>

#include "meshops/core/contract.h"
#include "meshops/topology/build_mesh.h"
#include "rbpa/hrbpa.h"
#include "rbpa/plane/filtration/growth.h"
#include "rbpa/plane/mesh/linked_faces.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/order.h"
#include "support/pictures.h"
#include "support/random.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::ComplexCounts;

namespace rbpa {
std::ostream& operator<<(std::ostream& out, const ComplexCounts& c) {
  return out << "points " << c.points_covered << " edges " << c.edges << " triangles " << c.triangles << " curves "
             << c.boundary_curves << " solid " << c.solid_components << " components " << c.components << " holes "
             << c.holes;
}
}  // namespace rbpa

namespace {

std::size_t check_levels(const Points& points, double alpha, std::size_t leaf_capacity) {
  CAPTURE(alpha);
  CAPTURE(leaf_capacity);
  const rbpa::Hierarchy h = rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = {}});
  const auto counts = rbpa::level_topology(h);
  REQUIRE(counts.size() == h.levels.size());
  // Extreme sets have hundreds of levels, each with exact arithmetic.
  for (std::size_t i = 0; i < counts.size(); i += 1 + counts.size() / 20) {
    CAPTURE(h.levels[i].alpha);
    REQUIRE(counts[i] == rbpa::count(rbpa::rbpa(points, h.levels[i].alpha)));
  }
  return counts.size();
}

void add_face(meshops::PolygonSoup& soup, const rbpa::SolidAlphaComplex& complex, std::uint32_t face) {
  std::array<std::uint32_t, 3> corners;
  auto h = complex.mesh.halfedge_handle(meshops::Face(static_cast<int>(face)));
  for (auto& corner : corners) {
    corner = complex.input_index[static_cast<std::size_t>(complex.mesh.to_vertex_handle(h).idx())];
    h = complex.mesh.next_halfedge_handle(h);
  }
  soup.add_face(corners);
}

/// Makes a mesh in bulk, of the points that have faces.
rbpa::SolidAlphaComplex complex_of(meshops::PolygonSoup soup) {
  std::map<std::uint32_t, std::uint32_t> number;
  for (std::uint32_t& corner : soup.corners)
    corner = number.try_emplace(corner, static_cast<std::uint32_t>(number.size())).first->second;
  soup.points = number.size();
  rbpa::SolidAlphaComplex complex;
  complex.input_index = meshops::build_mesh(complex.mesh, soup);
  return complex;
}

}  // namespace

TEST_SUITE("filtration") {
  TEST_CASE("the topology of a level is that of a mesh rebuilt at its radius") {
    std::size_t levels = 0;
    for (const NamedSet& set : generated_sets()) {
      Points points = set.first(100);
      CAPTURE(set.name);
      levels += check_levels(points, infinity, 4);
      if (!set.alphas.empty()) levels += check_levels(points, set.alphas.back(), 1);
    }
    CHECK(levels > 100);
  }

  TEST_CASE("a complex that touches itself, on a level or at the end, is one space and several surfaces") {
    Random random(11);
    std::size_t pinches = 0;
    for (std::size_t i = 0; i < 60; ++i) {
      const Points points = points_of(random_picture(9, 9, 0.3 + 0.008 * static_cast<double>(i), random));
      // Radii below, at, and above the radius of the pictures' pixels.
      for (const double alpha : {picture_alpha, 1.5, infinity}) check_levels(points, alpha, 1 + i % 7);
      const ComplexCounts solid = rbpa::count(rbpa::rbpa(points, picture_alpha));
      pinches += solid.solid_components - solid.components;
    }
    CHECK(pinches > 100);
  }

  TEST_CASE("triangles may come in any order: the counts are those of the triangles so far") {
    Random random(12);
    for (int round = 0; round < 20; ++round) {
      const rbpa::SolidAlphaComplex complex =
          rbpa::rbpa(points_of(random_picture(4, 5, 0.7, random)), round % 2 ? infinity : picture_alpha);
      const std::vector<std::uint32_t> order = random_order(complex.mesh.n_faces(), random);
      const rbpa::OwnedTriangles faces = rbpa::linked_faces(complex.mesh);
      rbpa::Growth growth(faces, complex.mesh.n_vertices(), complex.input_index);
      meshops::PolygonSoup so_far;
      for (const std::uint32_t face : order) {
        growth.add(face);
        add_face(so_far, complex, face);
        REQUIRE(growth.counts() == rbpa::count(complex_of(so_far)));
      }
    }
  }

  TEST_CASE("points without triangles have no levels, and levels of another complex are refused") {
    CHECK(rbpa::level_topology(rbpa::hrbpa(Points{{0, 0}, {1, 1}, {2, 2}}, 1)).empty());
    rbpa::Hierarchy h = rbpa::hrbpa(Points{{0, 0}, {1, 0}, {0, 1}}, 1);
    CHECK(rbpa::level_topology(h).back().boundary_curves == 1);
    h.levels.pop_back();
    CHECK_THROWS_AS(rbpa::level_topology(h), meshops::ContractViolation);
  }
}
