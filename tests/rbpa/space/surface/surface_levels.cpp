#include "rbpa/space/surface/surface_levels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "meshops/core/validate.h"
#include "rbpa/base/error.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/surface/levels/sub_surface.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "space/surface/model.h"
#include "support/order.h"
#include "support/refusal_of.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

using Radii = std::vector<double>;

Radii some_radii(const Points3& points, Random& random) {
  std::set<double> radii;
  for (int i = 0; i < 3; ++i) radii.insert(space_radius(points, random));
  return {radii.begin(), radii.end()};
}

Points3 some_normals(const Points3& points, Random& random) {
  Points3 normals = random_normals(points.size(), random);
  const bool is_flat = random.chance(0.5);
  if (random.chance(0.2)) return normals;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (random.chance(0.9)) normals[i] = is_flat || points[i] == Point3{} ? Point3{0, 0, 1} : points[i];
  return normals;
}

std::size_t boundary_sides(const Surface& surface) {
  std::size_t count = 0;
  for (const auto& neighbors : surface.neighbors)
    count += static_cast<std::size_t>(std::count(neighbors.begin(), neighbors.end(), Surface::none));
  return count;
}

bool is_same(const Surface& s, const Surface& t) {
  return s.triangles == t.triangles && s.neighbors == t.neighbors && s.levels == t.levels;
}

}  // namespace

TEST_CASE("surfaces by several radii follow the rule literally") {
  Random random(301);
  std::size_t added = 0, glued_across = 0;
  for_space_sets(25, 5, 13, random, [&](const Points3& points) {
    const Points3 normals = some_normals(points, random);
    const Radii radii = some_radii(points, random);
    const Surface surface = rbpa::surface(points, normals, radii);
    ModelSurface model(points, normals);
    for (const double radius : radii) model.add(radius);
    CHECK(is_model(surface, model));
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      added += surface.levels[t] > 0;
      for (const std::uint32_t other : surface.neighbors[t])
        glued_across += other != Surface::none && surface.levels[other] < surface.levels[t];
    }
  });
  CHECK(added > 500);
  CHECK(glued_across > 100);
}

TEST_CASE("a radius removes nothing and changes no gluing; the mesh is sound; one radius equals surface()") {
  Random random(302);
  std::size_t more = 0;
  for_space_sets(4, 30, 0, random, [&](const Points3& points) {
    const Points3 normals = some_normals(points, random);
    const Radii radii = some_radii(points, random);
    const Surface all = rbpa::surface(points, normals, radii);
    rbpa::require_linked(rbpa::space::arrays_of(all), points.size());
    for (std::uint32_t i = 1; i <= radii.size(); ++i) {
      const Surface fewer = rbpa::surface(points, normals, std::span(radii).first(i));
      CHECK(is_same(rbpa::space::sub_surface(i, all), fewer));
      more += all.triangles.size() > fewer.triangles.size();
      if (i > 1) continue;
      const Surface one = rbpa::surface(points, normals, radii[0]);
      CHECK(one.triangles == fewer.triangles);
      CHECK(one.neighbors == fewer.neighbors);
      CHECK(one.duplicates == all.duplicates);
    }
    CHECK(meshops::validate(rbpa::surface_mesh(points, all).mesh).empty());
  });
  CHECK(more > 20);
}

TEST_CASE("shuffled points have the same surface by several radii, with any number of threads") {
  Random random(303);
  std::size_t triangles = 0;
  for_space_sets(3, 40, 0, random, [&](Points3 points) {
    const Radii radii = some_radii(points, random);
    sort_distinct(points);
    const Points3 normals = some_normals(points, random);
    const Surface expected = rbpa::surface(points, normals, radii);
    triangles += expected.triangles.size();
    const std::vector<std::uint32_t> order = random_order(points.size(), random);
    const Points3 shuffled = in_order(points, order), turned = in_order(normals, order);
    const Surface actual = rbpa::surface(shuffled, turned, radii);
    CHECK(renumbered(actual.triangles, order) == expected.triangles);
    CHECK(boundary_sides(actual) == boundary_sides(expected));
    for (std::size_t t = 0; t < actual.triangles.size(); ++t) {
      const Triangle there = renumbered({actual.triangles[t]}, order)[0];
      const auto at = std::lower_bound(expected.triangles.begin(), expected.triangles.end(), there);
      REQUIRE(at != expected.triangles.end());
      CHECK(expected.levels[static_cast<std::size_t>(at - expected.triangles.begin())] == actual.levels[t]);
    }
  });
  CHECK(triangles > 500);

  const Points3 sphere = space_set(SpaceKind::noisy_sphere, 2500, random);
  const Radii radii = {0.1, 0.2, 0.5};
  const Surface one = rbpa::surface(sphere, sphere, radii, {.threads = 1});
  CHECK(*std::max_element(one.levels.begin(), one.levels.end()) == 2);
  for (const unsigned threads : {2u, 5u})
    CHECK(is_same(rbpa::surface(sphere, sphere, radii, {.threads = threads}), one));
}

TEST_CASE("two triangles of the surface between which the ball of one radius rolls stay glued") {
  Random random(304);
  std::size_t pairs = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const SpaceKind kind = std::array{SpaceKind::noisy_sphere, SpaceKind::plate, SpaceKind::grid}[random.below(3)];
    const Points3 points = space_set(kind, 40, random);
    const Points3 normals = some_normals(points, random);
    const Radii radii = some_radii(points, random);
    const Surface all = rbpa::surface(points, normals, radii);
    for (std::uint32_t level = 0; level < radii.size(); ++level) {
      const Surface alone = rbpa::surface(points, normals, radii[level]);
      const auto place = [&](std::uint32_t t) {
        const auto found = std::lower_bound(all.triangles.begin(), all.triangles.end(), alone.triangles[t]);
        if (found == all.triangles.end() || *found != alone.triangles[t]) return Surface::none;
        return static_cast<std::uint32_t>(found - all.triangles.begin());
      };
      for (std::uint32_t t = 0; t < alone.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          if (alone.neighbors[t][k] == Surface::none) continue;
          const std::uint32_t here = place(t), there = place(alone.neighbors[t][k]);
          if (here == Surface::none || there == Surface::none) continue;
          CHECK(all.neighbors[here][k] == there);
          ++pairs;
        }
    }
  }
  CHECK(pairs > 1000);
}

TEST_CASE("a second radius closes what the first leaves open, on a sphere of sparse and dense parts") {
  Points3 points;
  const auto put = [&](double from, double to, std::size_t count) {  // a spiral
    for (std::size_t i = 0; i < count; ++i) {
      const double z = from + (to - from) * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const double angle = 2.399963 * static_cast<double>(i), s = std::sqrt(1 - z * z);
      points.push_back({s * std::cos(angle), s * std::sin(angle), z});
    }
  };
  put(-1, 0, 250);
  put(0, 1, 2000);
  const Surface dense = rbpa::surface(points, points, 0.08), both = rbpa::surface(points, points, Radii{0.08, 0.3});
  CHECK(boundary_sides(dense) > 50);
  CHECK(boundary_sides(both) == 0);
  CHECK(both.triangles.size() == 2 * points.size() - 4);
  CHECK(std::count(both.levels.begin(), both.levels.end(), 0u) == static_cast<long>(dense.triangles.size()));
}

TEST_CASE("radii that do not ascend are refused") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, normals(3, {0, 0, 1});
  const auto refusal = [&](const Radii& radii) -> std::string {
    return refusal_of<rbpa::InvalidInput>([&] { rbpa::surface(points, normals, radii); });
  };
  CHECK(refusal({}) == "found no radius, expected at least one above 0");
  CHECK(refusal({1, 1}) == "radius 1 comes after 1, expected strictly ascending radii");
  CHECK(refusal({2, 1}) == "radius 1 comes after 2, expected strictly ascending radii");
  for (const double bad :
       {-1.0, 0.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK(refusal({1, bad}).find("expected a finite number above 0") != std::string::npos);
  CHECK(refusal({1, 2}).empty());
}

TEST_SUITE_END();
