#include "rbpa/space/repair/refine_filling.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"
#include "support/arguments.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/spiral.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::FilledSurface;
using rbpa::Point3;
using rbpa::RefinedSurface;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

struct Sample {
  Points3 points, normals;
};

/// Returns points spread over the unit sphere along a spiral, without those that are left out.
template <typename IsOut>
Sample sphere_without(int count, const IsOut& is_out) {
  Sample sample{.points = spiral(count), .normals = {}};
  std::erase_if(sample.points, is_out);
  sample.normals = sample.points;
  return sample;
}

FilledSurface filled(const Sample& sample, double radius) {
  const Surface surface = rbpa::indexable_surface(rbpa::surface(sample.points, sample.normals, radius));
  return rbpa::fill_holes(sample.points, surface, rbpa::surface_curves(sample.points, surface));
}

Points3 joined(const Points3& points, const RefinedSurface& refined) {
  Points3 all = points;
  all.insert(all.end(), refined.points.begin(), refined.points.end());
  return all;
}

/// Checks that refining keeps the number of boundary curves and all old triangles, that no triangles cross, and that
/// each added point adds two triangles.
void check_refined(const Sample& sample, const FilledSurface& before, const RefinedSurface& refined) {
  const Points3 all = joined(sample.points, refined);
  CHECK(rbpa::surface_curves(all, refined.surface).size() ==
        rbpa::surface_curves(sample.points, before.surface).size());
  CHECK(rbpa::crossing_triangles(all, refined.surface.triangles, 3).empty());
  CHECK(std::is_sorted(refined.surface.triangles.begin(), refined.surface.triangles.end()));
  REQUIRE(refined.is_new.size() == refined.surface.triangles.size());
  std::vector<std::array<std::uint32_t, 3>> old, kept;
  for (std::size_t t = 0; t < before.is_new.size(); ++t)
    if (!before.is_new[t]) old.push_back(before.surface.triangles[t]);
  for (std::size_t t = 0; t < refined.is_new.size(); ++t)
    if (!refined.is_new[t]) kept.push_back(refined.surface.triangles[t]);
  CHECK(old == kept);
  REQUIRE(refined.between.size() == refined.points.size());
  for (std::size_t k = 0; k < refined.points.size(); ++k)
    for (const std::uint32_t v : refined.between[k]) CHECK(v < sample.points.size() + k);
  CHECK(refined.surface.triangles.size() == before.surface.triangles.size() + 2 * refined.points.size());
}

double longest_new_edge(const Points3& points, const Surface& surface, const std::vector<bool>& is_new) {
  double longest = 0;
  for (std::size_t t = 0; t < is_new.size(); ++t)
    for (std::size_t k = 0; k < 3 && is_new[t]; ++k) {
      const Point3 &p = points[surface.triangles[t][k]], &q = points[surface.triangles[t][(k + 1) % 3]];
      longest = std::max(longest, length(p - q));
    }
  return longest;
}

/// Returns the greatest angle in degrees between the normal of a new triangle and that of the shape at its middle.
template <typename Normal>
double farthest_normal(const Points3& points, const RefinedSurface& refined, const Normal& normal_at) {
  double least = 1;
  for (std::size_t t = 0; t < refined.is_new.size(); ++t) {
    if (!refined.is_new[t]) continue;
    const auto& row = refined.surface.triangles[t];
    const Point3 &a = points[row[0]], &b = points[row[1]], &c = points[row[2]];
    const Point3 n = cross(b - a, c - a), m = normal_at((a + b + c) / 3);
    least = std::min(least, dot(n, m) / length(n) / length(m));
  }
  return std::acos(least) * 180 / std::acos(-1.0);
}

}  // namespace

TEST_CASE("a hole in a torus, whose curvature varies, is filled close to it, at its outer and its inner side") {
  constexpr double ring = 1, tube = 0.4, pi = 3.14159265358979;
  for (const double where : {0.0, pi / 2, pi})
    for (const double width : {0.2, 0.3}) {
      CAPTURE(where);
      CAPTURE(width);
      const Point3 middle = {ring + tube * std::cos(where), 0, tube * std::sin(where)};
      Sample sample;
      for (int i = 0; i < 160; ++i)
        for (int j = 0; j < 64; ++j) {
          const double u = 2 * pi * (i + 0.5 * (j % 2)) / 160, w = 2 * pi * j / 64;
          const double out = ring + tube * std::cos(w);
          const Point3 p = {out * std::cos(u), out * std::sin(u), tube * std::sin(w)};
          if (length(p - middle) < width) continue;
          sample.points.push_back(p);
          sample.normals.push_back({std::cos(w) * std::cos(u), std::cos(w) * std::sin(u), std::sin(w)});
        }
      const FilledSurface before = filled(sample, 0.05);
      const RefinedSurface refined = rbpa::refine_filling(sample.points, before.surface, before.is_new);
      check_refined(sample, before, refined);
      CHECK(refined.smooth == 1);
      CHECK(refined.points.size() > 20);
      for (const Point3& p : refined.points)
        CHECK(std::abs(std::hypot(std::hypot(p.x, p.y) - ring, p.z) / tube - 1) < 0.02);
      CHECK(farthest_normal(joined(sample.points, refined), refined, [&](const Point3& p) {
              const double out = std::hypot(p.x, p.y);
              return Point3{p.x - ring * p.x / out, p.y - ring * p.y / out, p.z};
            }) < 6);
    }
}

TEST_CASE("a cap of a sphere is filled by triangles as small as those around, close to the sphere") {
  for (const double top : {0.95, 0.9, 0.8, 0.6}) {
    const Sample sample = sphere_without(3000, [&](const Point3& p) { return p.z > top; });
    const FilledSurface before = filled(sample, 0.08);
    const RefinedSurface refined = rbpa::refine_filling(sample.points, before.surface, before.is_new);
    check_refined(sample, before, refined);
    CHECK(refined.smooth == 1);
    CHECK(refined.flat + refined.coarse == 0);
    // About as many points as the sphere has there.
    const double missing = 3000 * (1 - top) / 2, added = static_cast<double>(refined.points.size());
    CHECK(added > 0.4 * missing);
    CHECK(added < 2 * missing);
    double farthest = 0;
    for (const Point3& p : refined.points) farthest = std::max(farthest, std::abs(std::hypot(p.x, p.y, p.z) - 1));
    CHECK(farthest < 0.005);
    CHECK(farthest_normal(joined(sample.points, refined), refined, [](const Point3& p) { return p; }) < 4);
    const Points3 all = joined(sample.points, refined);
    const auto before_components = rbpa::surface_components(sample.points, before.surface).all;
    const auto components = rbpa::surface_components(all, refined.surface).all;
    REQUIRE(components.size() == 1);
    const double ball = 4 * std::acos(-1.0) / 3;
    CHECK(std::abs(components.front().volume - ball) < 0.7 * std::abs(before_components.front().volume - ball));
    CHECK(longest_new_edge(all, refined.surface, refined.is_new) < 0.25);
  }
}

TEST_CASE("a hole in a plane is filled in the plane; a hole of three edges gets no point") {
  Sample sheet;
  for (int x = 0; x < 24; ++x)
    for (int y = 0; y < 24; ++y)
      if (std::hypot(x - 11.5, y - 11.5) > 7) sheet.points.push_back({double(x), double(y), 0});
  sheet.normals.assign(sheet.points.size(), {0, 0, 1});
  const Surface open = rbpa::indexable_surface(rbpa::surface(sheet.points, sheet.normals, 0.8));
  std::vector<rbpa::Hole> holes = rbpa::surface_curves(sheet.points, open);
  std::erase_if(holes, [](const rbpa::Hole& hole) { return hole.edges.size() > 60; });
  REQUIRE(holes.size() == 1);
  const FilledSurface before = rbpa::fill_holes(sheet.points, open, holes);
  const RefinedSurface refined = rbpa::refine_filling(sheet.points, before.surface, before.is_new);
  check_refined(sheet, before, refined);
  CHECK(refined.points.size() > 60);
  for (const Point3& p : refined.points) {
    CHECK(std::abs(p.z) < 1e-12);
    CHECK(std::hypot(p.x - 11.5, p.y - 11.5) < 8);
  }
  const Points3 all = joined(sheet.points, refined);
  CHECK(rbpa::surface_components(all, refined.surface).all.front().area == doctest::Approx(23.0 * 23.0));

  Surface tetrahedron;
  tetrahedron.triangles = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
  tetrahedron.neighbors = {{3, 2, 1}, {3, 0, 2}, {3, 1, 0}, {2, 0, 1}};
  const Points3 corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const RefinedSurface same = rbpa::refine_filling(corners, tetrahedron, {false, false, false, true});
  CHECK(same.coarse == 1);
  CHECK(same.points.empty());
  CHECK(same.surface.triangles == tetrahedron.triangles);
  CHECK(same.surface.neighbors == tetrahedron.neighbors);
}

TEST_CASE("an obstacle in the place of the smooth filling keeps it flat, and nothing crosses") {
  Sample sample = sphere_without(3000, [](const Point3& p) { return p.z > 0.8; });
  // A small octahedron around the pole, where the missing cap of the sphere would pass.
  const std::size_t first = sample.points.size();
  for (const Point3& d : {Point3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    sample.points.push_back({0.03 * d.x, 0.03 * d.y, 1 + 0.03 * d.z});
    sample.normals.push_back(d);
  }
  const FilledSurface before = filled(sample, 0.08);
  REQUIRE(rbpa::surface_components(sample.points, before.surface).all.size() == 2);
  REQUIRE(first + 6 == sample.points.size());
  const RefinedSurface refined = rbpa::refine_filling(sample.points, before.surface, before.is_new);
  check_refined(sample, before, refined);
  CHECK(refined.smooth == 0);
  CHECK(refined.flat == 1);
}

TEST_CASE(
    "many holes of lumps are closed without crossings, with the same points in any order and by any number of "
    "threads") {
  std::size_t smooth = 0;
  for (int trial = 0; trial < trials(24); ++trial) {
    CAPTURE(trial);
    Random random(700 + static_cast<std::uint64_t>(trial));
    std::vector<Point3> centers;
    for (int i = 0; i < 5; ++i) {
      Point3 c = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      const double size = std::hypot(c.x, c.y, c.z);
      centers.push_back({c.x / size, c.y / size, c.z / size});
    }
    const double width = random.between(0.2, 0.45), bumps = random.between(0, 0.3);
    Sample sample = sphere_without(1500, [&](const Point3& p) {
      return std::any_of(centers.begin(), centers.end(), [&](const Point3& c) { return length(p - c) < width; });
    });
    for (Point3& p : sample.points) {
      const double r = 1 + bumps * std::sin(5 * p.x) * std::cos(4 * p.y + p.z);
      p = {r * p.x, r * p.y, r * p.z};
    }
    const FilledSurface before = filled(sample, 0.13);
    const RefinedSurface refined = rbpa::refine_filling(sample.points, before.surface, before.is_new, {.threads = 1});
    check_refined(sample, before, refined);
    smooth += refined.smooth;

    const std::vector<std::uint32_t> order = random_order(sample.points.size(), random);
    const Sample shuffled{in_order(sample.points, order), in_order(sample.normals, order)};
    const FilledSurface again = filled(shuffled, 0.13);
    const RefinedSurface other = rbpa::refine_filling(shuffled.points, again.surface, again.is_new, {.threads = 2});
    CHECK(other.points == refined.points);
    CHECK(other.surface.triangles.size() == refined.surface.triangles.size());
  }
  CHECK(smooth > static_cast<std::size_t>(trials(24)));
}

TEST_CASE("wrong calls of refine_filling are refused") {
  const Points3 corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Surface one;
  one.triangles = {{0, 1, 2}};
  one.neighbors = {{Surface::none, Surface::none, Surface::none}};
  CHECK_THROWS_AS(rbpa::refine_filling(corners, one, {}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::refine_filling(Points3{{0, 0, 0}}, one, {true}), meshops::ContractViolation);
  Points3 infinite = corners;
  infinite[0].x = INFINITY;
  CHECK_THROWS_AS(rbpa::refine_filling(infinite, one, {true}), rbpa::InvalidInput);
  CHECK(rbpa::refine_filling(corners, one, {true}).coarse == 1);
  CHECK(rbpa::refine_filling(corners, one, {false}).surface.triangles == one.triangles);
}

TEST_SUITE_END();
