#include "rbpa/space/surface/split_fans.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "support/for_space_sets.h"
#include "support/space_sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::SplitFans;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

/// Calls visit() with shells, and with surfaces whose normals have any direction, for `trials` sets of each kind.
template <typename Visit>
void for_each_surface(std::uint64_t seed, int trials, const Visit& visit) {
  Random random(seed);
  for_space_sets(trials, 3, 29, random, [&](const Points3& points) {
    const double radius = space_radius(points, random);
    visit(points, rbpa::exposed_triangles(points, radius));
    visit(points, rbpa::surface(points, random_normals(points.size(), random), radius));
  });
}

}  // namespace

TEST_CASE("vertices are those of the halfedge mesh, and at each the triangles are one fan") {
  std::size_t split = 0;
  for_each_surface(321, 20, [&](const Points3& points, const Surface& surface) {
    const SplitFans fans = rbpa::split_fans(surface);
    REQUIRE(fans.triangles.size() == surface.triangles.size());
    CHECK(std::is_sorted(fans.point.begin(), fans.point.end()));
    const rbpa::SurfaceMesh made = rbpa::surface_mesh(points, surface);
    CHECK(made.input_index == fans.point);
    for (std::size_t t = 0; t < fans.triangles.size(); ++t)
      for (std::size_t j = 0; j < 3; ++j) CHECK(fans.point.at(fans.triangles[t][j]) == surface.triangles[t][j]);

    // All triangles at a vertex are reached from one of them through their sides at it.
    std::map<std::uint32_t, std::vector<std::uint32_t>> at;
    for (std::uint32_t t = 0; t < fans.triangles.size(); ++t)
      for (const std::uint32_t v : fans.triangles[t]) at[v].push_back(t);
    CHECK(at.size() == fans.point.size());
    split += fans.point.size() > 0 && std::adjacent_find(fans.point.begin(), fans.point.end()) != fans.point.end();
    for (const auto& [v, triangles] : at) {
      std::vector<std::uint32_t> reached = {triangles.front()};
      for (std::size_t i = 0; i < reached.size(); ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const std::uint32_t other = surface.neighbors[reached[i]][j];
          if (other == Surface::none || fans.triangles[reached[i]][j] == v) continue;
          // Across a side at the vertex, the neighbor has the same vertex.
          CHECK(std::count(fans.triangles[other].begin(), fans.triangles[other].end(), v) == 1);
          if (std::count(reached.begin(), reached.end(), other) == 0) reached.push_back(other);
        }
      CHECK(reached.size() == triangles.size());
    }
  });
  CHECK(split > 20);
}

TEST_CASE("an indexable surface has the same triangles, and neighbors are those with a common edge") {
  std::size_t glued_anew = 0, cut = 0, as_before = 0;
  for_each_surface(323, 40, [&](const Points3&, const Surface& surface) {
    const Surface made = rbpa::indexable_surface(surface);
    CHECK(made.triangles == surface.triangles);
    CHECK(made.distinct == surface.distinct);
    const SplitFans fans = rbpa::split_fans(made);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, std::size_t>>> at;
    for (std::uint32_t t = 0; t < fans.triangles.size(); ++t)
      for (std::size_t j = 0; j < 3; ++j)
        at[std::minmax(fans.triangles[t][(j + 1) % 3], fans.triangles[t][(j + 2) % 3])].emplace_back(t, j);
    for (const auto& of_edge : at) {
      const auto& sides = of_edge.second;
      REQUIRE(sides.size() <= 2);
      const auto across = [&](std::size_t i) { return made.neighbors[sides[i].first][sides[i].second]; };
      CHECK(across(0) == (sides.size() == 1 ? Surface::none : sides[1].first));
      if (sides.size() == 2) CHECK(across(1) == sides[0].first);
    }
    as_before += made.neighbors == surface.neighbors;
    for (std::size_t t = 0; t < made.neighbors.size(); ++t)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::uint32_t now = made.neighbors[t][j], before = surface.neighbors[t][j];
        glued_anew += now != before && now != Surface::none;
        cut += now == Surface::none && before != Surface::none;
      }
    CHECK(rbpa::indexable_surface(made).neighbors == made.neighbors);
  });
  CHECK(glued_anew > 100);
  CHECK(cut > 10);
  CHECK(as_before > 100);
}

TEST_CASE("two bodies that touch along an edge, over which the ball rolls between them, are separated") {
  const Points3 points = {{0, 0, 0}, {0, 0, 1}, {1, 0.4, 0.5}, {1, -0.4, 0.5}, {-1, 0.4, 0.5}, {-1, -0.4, 0.5}};
  const Surface surface = rbpa::exposed_triangles(points, 0.7);
  REQUIRE(surface.triangles.size() == 8);
  CHECK(rbpa::surface_components(points, surface).all.size() == 1);
  CHECK(rbpa::split_fans(surface).point.size() == 6);
  const Surface made = rbpa::indexable_surface(surface);
  const rbpa::SurfaceComponents components = rbpa::surface_components(points, made);
  REQUIRE(components.all.size() == 2);
  for (const rbpa::SurfaceComponent& component : components.all) {
    CHECK(component.is_closed());
    CHECK(component.triangles == 4);
    CHECK(component.volume > 0);
  }
  CHECK(rbpa::split_fans(made).point == std::vector<std::uint32_t>{0, 0, 1, 1, 2, 3, 4, 5});
}

TEST_SUITE_END();
