#include "rbpa/space/repair/watertight.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"
#include "support/spiral.h"

using namespace rbpa_test;
using rbpa::make_watertight;
using rbpa::Surface;
using rbpa::WatertightSurface;

TEST_SUITE_BEGIN("space");

namespace {

struct Scan {
  Points3 points, normals;

  /// Adds a unit sphere around (x, 0, 0), without its cap above 0.9.
  void add_sphere(double x, int count) {
    for (const rbpa::Point3& n : spiral(count)) {
      if (n.z > 0.9) continue;
      points.push_back({x + n.x, n.y, n.z});
      normals.push_back(n);
    }
  }
  /// Adds a triangle around (0, 0, z), facing up.
  void add_triangle(double z) {
    points.insert(points.end(), {{0, 0, z}, {0.1, 0, z}, {0, 0.1, z}});
    normals.insert(normals.end(), 3, {0, 0, 1});
  }
  Surface surface() const { return rbpa::surface(points, normals, 0.3); }
};

std::ptrdiff_t count_of(const std::vector<bool>& which, bool value) {
  return std::count(which.begin(), which.end(), value);
}

}  // namespace

TEST_CASE("islands are dropped, holes are closed, and the result is that of the steps one by one") {
  Scan scan;
  scan.add_sphere(0, 600);
  scan.add_triangle(5);
  const Surface open = scan.surface();
  const auto components = rbpa::surface_components(scan.points, open);
  CHECK(rbpa::islands(components) == std::vector<bool>{false, true});
  const WatertightSurface found = make_watertight(scan.points, open);
  CHECK(found.is_watertight());
  CHECK(found.components == std::vector<bool>{true, false});
  REQUIRE(found.kept.size() == open.triangles.size());
  CHECK(count_of(found.kept, false) == static_cast<std::ptrdiff_t>(1 + found.given_up));
  CHECK(count_of(found.kept, true) == count_of(found.is_new, false));
  CHECK(found.added.points.empty());

  const Surface sphere = rbpa::indexable_surface(rbpa::keep_components(open, components, {true, false}));
  const rbpa::ClosedSurface closed = rbpa::close_surface(scan.points, sphere);
  CHECK(found.surface.triangles == closed.surface.triangles);
  CHECK(found.surface.neighbors == closed.surface.neighbors);
  CHECK(found.is_new == closed.is_new);
  CHECK(found.holes == closed.holes);
}

TEST_CASE("components that may not stay are dropped in addition to islands") {
  Scan scan;
  scan.add_sphere(0, 900);
  scan.add_sphere(9, 600);
  scan.add_triangle(5);
  const Surface open = scan.surface();
  REQUIRE(rbpa::surface_components(scan.points, open).all.size() == 3);
  const WatertightSurface found = make_watertight(scan.points, open, {.kept = {false, true, true}});
  CHECK(found.is_watertight());
  CHECK(found.components == std::vector<bool>{false, true, false});
  CHECK(rbpa::surface_components(scan.points, found.surface).all.size() == 1);
  const WatertightSurface none = make_watertight(scan.points, open, {.kept = {false, false, false}});
  CHECK_FALSE(none.is_watertight());
  CHECK(none.surface.triangles.empty());
  CHECK(none.open.empty());
  CHECK_THROWS_AS(make_watertight(scan.points, open, {.kept = {true}}), meshops::ContractViolation);
}

TEST_CASE("fillings are refined and checked at the given places") {
  Scan scan;
  scan.add_sphere(0, 600);
  const Surface open = scan.surface();
  const WatertightSurface refined = make_watertight(scan.points, open, {.refine = true});
  CHECK(refined.is_watertight());
  REQUIRE_FALSE(refined.added.points.empty());
  CHECK(refined.added.points.size() == refined.added.between.size());
  CHECK(refined.surface.triangles.size() > make_watertight(scan.points, open).surface.triangles.size());

  Points3 doubled = scan.points;
  for (rbpa::Point3& p : doubled) p = {2 * p.x, 2 * p.y, 2 * p.z};
  const WatertightSurface larger = make_watertight(scan.points, open, {.places = doubled, .refine = true});
  CHECK(larger.surface.triangles == refined.surface.triangles);
  REQUIRE(larger.added.points.size() == refined.added.points.size());
  for (std::size_t i = 0; i < larger.added.points.size(); ++i)
    CHECK(larger.added.points[i].z == doctest::Approx(2 * refined.added.points[i].z));

  std::swap(doubled.front(), doubled.back());  // these are far from each other, so that their triangles cross others
  const WatertightSurface crossed = make_watertight(scan.points, open, {.places = doubled});
  CHECK(crossed.open.empty());
  CHECK(crossed.crossing == rbpa::crossing_triangles(doubled, crossed.surface.triangles, rbpa::most_crossing_pairs));
  CHECK_FALSE(crossed.is_watertight());
  doubled.pop_back();
  CHECK_THROWS_AS(make_watertight(scan.points, open, {.places = doubled}), meshops::ContractViolation);
}

TEST_CASE("a choice of holes is filled as if they were listed") {
  Scan scan;
  scan.add_sphere(0, 600);
  scan.add_triangle(5);
  const Surface open = scan.surface(), indexable = rbpa::indexable_surface(open);
  const auto curves = rbpa::surface_curves(scan.points, indexable);
  const auto kinds = rbpa::curve_kinds(scan.points, rbpa::surface_components(scan.points, indexable), curves);
  const auto listed = rbpa::fill_holes(scan.points, indexable, rbpa::chosen_curves(curves, kinds));
  const auto chosen = rbpa::fill_holes(scan.points, open, rbpa::HoleChoice());
  CHECK(chosen.surface.triangles == listed.surface.triangles);
  CHECK(chosen.surface.neighbors == listed.surface.neighbors);
  CHECK(chosen.holes == listed.holes);
  CHECK(chosen.holes.size() == 1);
  CHECK(chosen.has_filled());
  CHECK_FALSE(rbpa::fill_holes(scan.points, open, rbpa::HoleChoice{.most_edges = 3, .rims = false}).has_filled());
}

TEST_CASE("a sheet in a plane stays open, with the reason and its curve") {
  const Scan scan{corners_of_bricks(4, 4, 1), Points3(16, {0, 0, 1})};
  const WatertightSurface found =
      make_watertight(scan.points, rbpa::surface(scan.points, scan.normals, 1), {.refine = true});
  CHECK_FALSE(found.is_watertight());
  CHECK(found.open.size() == 1);
  REQUIRE(found.holes.size() == 1);
  CHECK(found.holes[0].outcome != rbpa::HoleOutcome::filled);
  CHECK(found.crossing.empty());
  CHECK(found.added.points.empty());
}

TEST_CASE("making a surface watertight can be cancelled, and no triangle is not watertight") {
  Scan scan;
  scan.add_sphere(0, 600);
  const Surface open = scan.surface();
  CHECK_THROWS_AS(make_watertight(scan.points, open, {}, {.progress = [](const rbpa::Progress&) { return false; }}),
                  rbpa::Cancelled);
  CHECK_FALSE(make_watertight({}, {}).is_watertight());
}

TEST_SUITE_END();
