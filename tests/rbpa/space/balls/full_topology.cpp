#include "rbpa/space/balls/full_topology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/dangling_faces.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"
#include "rbpa/space/solid/solid_radii.h"
#include "rbpa/space/solid/voids.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::FullCounts;
using rbpa::Point3;
using rbpa::Solid;

TEST_SUITE_BEGIN("space");

namespace {

using Simplex = std::vector<std::uint32_t>;

/// Returns all faces of the solid and of the dangling simplices, by dimension.
std::array<std::set<Simplex>, 4> simplices_of(const Solid& solid, const rbpa::DanglingFaces& more) {
  std::array<std::set<Simplex>, 4> all;
  const auto add = [&](Simplex s) {
    std::sort(s.begin(), s.end());
    for (std::uint32_t subset = 1; subset < (1u << s.size()); ++subset) {
      Simplex face;
      for (std::size_t i = 0; i < s.size(); ++i)
        if ((subset >> i & 1u) != 0) face.push_back(s[i]);
      all[face.size() - 1].insert(face);
    }
  };
  for (const auto& t : solid.simplices) add({t.begin(), t.end()});
  for (const auto& t : more.triangles) add({t.begin(), t.end()});
  for (const auto& e : more.edges) add({e.begin(), e.end()});
  for (const std::uint32_t p : more.points) add({p});
  return all;
}

/// Returns the rank over Z/2 of the boundary matrix from simplices to their faces.
std::size_t rank(const std::set<Simplex>& simplices, const std::set<Simplex>& faces) {
  std::map<Simplex, std::size_t> number;
  for (const Simplex& face : faces) number.emplace(face, number.size());
  std::map<std::size_t, std::set<std::size_t>> columns;  // by their greatest row
  for (const Simplex& simplex : simplices) {
    std::set<std::size_t> column;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      Simplex face = simplex;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
      column.insert(number.at(face));
    }
    while (!column.empty()) {
      const auto [at, is_new] = columns.emplace(*column.rbegin(), column);
      if (is_new) break;
      for (const std::size_t row : at->second)
        if (!column.insert(row).second) column.erase(row);
    }
  }
  return columns.size();
}

}  // namespace

TEST_CASE("Betti numbers and voids of the full complex are those of its boundary matrices and left-out tetrahedra") {
  std::size_t with_voids = 0, voids_of_triangles = 0;
  for_solids(60, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity);
    if (delaunay.simplices.size() > 1000) return;
    const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
    std::vector<double> sorted = radii;
    std::sort(sorted.begin(), sorted.end());
    for (const double share : {0.02, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 1.0}) {
      const double alpha = sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))] * 0.97;
      if (!(alpha > 0)) continue;
      CAPTURE(alpha);
      const Solid solid = rbpa::within(delaunay, radii, alpha);
      const auto all = simplices_of(solid, rbpa::dangling_faces(points, delaunay, radii, alpha));
      const std::size_t r1 = rank(all[1], all[0]), r2 = rank(all[2], all[1]), r3 = rank(all[3], all[2]);
      for (const unsigned threads : {1u, 3u}) {
        const FullCounts counts = rbpa::count_full(points, delaunay, radii, alpha, threads);
        CHECK(counts.points == all[0].size());
        CHECK(counts.edges == all[1].size());
        CHECK(counts.triangles == all[2].size());
        CHECK(counts.tetrahedra == all[3].size());
        CHECK(counts.components == all[0].size() - r1);
        CHECK(counts.tunnels == all[1].size() - r1 - r2);
        CHECK(counts.voids == all[2].size() - r2 - r3);
      }
      const std::size_t voids = all[2].size() - r2 - r3;
      const Solid space = rbpa::void_space(points, delaunay, radii, alpha);
      const auto boundary = rbpa::solid_boundary(space);
      const auto components = rbpa::solid_components(points, space, boundary);
      CHECK(components.all.size() == voids);
      for (const auto& triangle : boundary.surface.triangles) {
        Simplex ascending(triangle.begin(), triangle.end());
        std::sort(ascending.begin(), ascending.end());
        CHECK(all[2].contains(ascending));
      }
      for (const auto& row : space.simplices) {
        Simplex ascending(row.begin(), row.end());
        std::sort(ascending.begin(), ascending.end());
        CHECK(!all[3].contains(ascending));
      }
      CHECK(space.distinct == delaunay.distinct);
      const rbpa::FullVoids one_by_one = rbpa::full_voids(points, space, alpha, 1);
      REQUIRE(one_by_one.all.size() == voids);
      std::size_t triangles = 0;
      for (std::size_t i = 0; i < voids; ++i) {
        CHECK(one_by_one.all[i].volume == components.all[i].volume);
        CHECK(one_by_one.all[i].points.size() >= 4);
        triangles += one_by_one.all[i].triangles.size();
      }
      CHECK(triangles == one_by_one.boundary.triangles.size());
      with_voids += voids > 0 ? 1u : 0u;
      const auto of_solid = rbpa::voids(points, solid, rbpa::solid_boundary(solid));
      voids_of_triangles += voids - std::min(voids, of_solid.all.size());
    }
  });
  CHECK(with_voids > 10);
  CHECK(voids_of_triangles > 10);  // voids that only triangles separate
}

TEST_CASE("four triangles around nothing bound a void") {
  // Edges of length √8: triangles have the circumradius √(8/3), the tetrahedron √3.
  const Points3 points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {9, 9, 9}};
  const Solid delaunay = rbpa::solid(points, infinity);
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  const FullCounts hollow = rbpa::count_full(points, delaunay, radii, 1.7);
  CHECK(hollow.points == 5);
  CHECK(hollow.edges == 6);
  CHECK(hollow.triangles == 4);
  CHECK(hollow.tetrahedra == 0);
  CHECK(hollow.components == 2);
  CHECK(hollow.tunnels == 0);
  CHECK(hollow.voids == 1);
  const Solid space = rbpa::void_space(points, delaunay, radii, 1.7);
  REQUIRE(space.simplices.size() == 1);
  CHECK(space.neighbors[0] == std::array<std::uint32_t, 4>{Solid::none, Solid::none, Solid::none, Solid::none});
  CHECK(space.isolated == std::vector<std::uint32_t>{4});
  const auto components = rbpa::solid_components(points, space, rbpa::solid_boundary(space));
  CHECK(components.all[0].volume == doctest::Approx(8.0 / 3));
  CHECK(rbpa::count_full(points, delaunay, radii, 1.74).voids == 0);
  CHECK(rbpa::void_space(points, delaunay, radii, 1.74).simplices.empty());
  CHECK(rbpa::count_full(points, delaunay, radii, 1.5).tunnels == 3);
}

TEST_CASE("the triangles of a tetrahedron within a sphere are an island in its void") {
  Points3 points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const Point3& p : on_unit_sphere(600, 9)) points.push_back({6 * p.x, 6 * p.y, 6 * p.z});
  const Solid delaunay = rbpa::solid(points, infinity);
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  const rbpa::FullVoids voids = rbpa::full_voids(points, rbpa::void_space(points, delaunay, radii, 1.7), 1.7);
  REQUIRE(voids.all.size() >= 2);
  CHECK(voids.all[0].islands == 1);
  CHECK(voids.all[0].volume > 700);
  const auto inner = std::find_if(voids.all.begin(), voids.all.end(), [](const rbpa::SolidVoid& hollow) {
    return hollow.points == std::vector<std::uint32_t>{0, 1, 2, 3};
  });
  REQUIRE(inner != voids.all.end());
  CHECK(inner->islands == 0);
  CHECK(inner->volume == doctest::Approx(8.0 / 3));
  CHECK(inner->triangles.size() == 4);
}

TEST_CASE("invalid triangulations and radii are refused by name; points in a plane have no voids") {
  const Points3 points = uniform_cube(30, 8);
  const Solid delaunay = rbpa::solid(points, infinity), bare = rbpa::solid(points, infinity, {.neighbors = false});
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  CHECK_THROWS_WITH_AS(rbpa::count_full(points, delaunay, {}, 1),
                       doctest::Contains("count_full: found 0 radii for 114 tetrahedra, expected one for each"),
                       meshops::ContractViolation);
  CHECK_THROWS_WITH_AS(rbpa::void_space(points, bare, radii, 1), doctest::Contains("void_space: the triangulation has"),
                       meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::count_full(points, delaunay, radii, 0), rbpa::InvalidInput);
  const Points3 flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(rbpa::void_space(flat, rbpa::solid(flat, infinity), {}, 1).simplices.empty());
}

TEST_SUITE_END();
