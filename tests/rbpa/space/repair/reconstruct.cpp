#include "rbpa/space/repair/reconstruct.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "rbpa/base/error.h"
#include "rbpa/space/repair/watertight.h"
#include "rbpa/space/surface/auto_radii.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_levels.h"
#include "support/spiral.h"

using namespace rbpa_test;
using rbpa::NormalSource;
using rbpa::reconstruct;
using rbpa::Reconstruction;
using rbpa::ReconstructionStep;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns points of a sphere of this radius around (x, 0, 0), without its cap above 0.9 of the radius.
Points3 cut_sphere(double x, double radius, int count) {
  Points3 points;
  for (const rbpa::Point3& p : spiral(count))
    if (p.z <= 0.9) points.push_back({x + radius * p.x, radius * p.y, radius * p.z});
  return points;
}

}  // namespace

TEST_CASE("a reconstruction is that of its steps one by one") {
  const Points3 points = cut_sphere(0, 1, 600);
  const auto normals = rbpa::estimate_normals(points);
  const auto radii = rbpa::auto_radii(points);
  const rbpa::Surface surface = rbpa::surface(points, normals, radii);
  const Reconstruction made = reconstruct(points, {.explain = true});
  CHECK(made.source == NormalSource::estimate);
  CHECK(made.points == points);
  CHECK(made.normals == normals);
  CHECK(made.radii == radii);
  CHECK(made.surface.triangles == surface.triangles);
  CHECK(made.holes == rbpa::holes(points, normals, radii, surface));
  CHECK(made.unused == rbpa::unused_points(points, normals, radii, surface));
  CHECK(reconstruct(points, {.normals = normals, .radii = {0.3}}).surface.triangles ==
        rbpa::surface(points, normals, 0.3).triangles);

  const Reconstruction closed = reconstruct(points, {.watertight = true, .refine = true});
  const auto expected = rbpa::make_watertight(points, rbpa::indexable_surface(surface), {.refine = true});
  CHECK(closed.is_watertight());
  CHECK(closed.surface.triangles == expected.surface.triangles);
  CHECK(closed.filled == expected.is_new);
  CHECK(closed.inside == std::vector<std::size_t>{0});
  REQUIRE(closed.points.size() == points.size() + expected.added.points.size());
  CHECK(closed.normals.size() == closed.points.size());
  CHECK(std::equal(expected.added.points.begin(), expected.added.points.end(),
                   closed.points.end() - static_cast<std::ptrdiff_t>(expected.added.points.size())));
}

TEST_CASE("outliers keep their numbers and are in no triangle") {
  const Points3 sphere = cut_sphere(0, 1, 600);
  Points3 points = sphere;
  points.insert(points.begin() + 7, {50, 0, 0});
  points.insert(points.begin(), {-40, 0, 0});
  const auto at = [](std::uint32_t i) { return i < 7 ? i + 1 : i + 2; };
  for (const bool refine : {false, true}) {
    const Reconstruction alone = reconstruct(sphere, {.explain = true, .filled = rbpa::HoleChoice(), .refine = refine});
    const Reconstruction made =
        reconstruct(points, {.outlier_factor = 4, .explain = true, .filled = rbpa::HoleChoice(), .refine = refine});
    CHECK(made.outliers.points == std::vector<std::uint32_t>{0, 8});
    CHECK(made.points.size() == alone.points.size() + 2);
    CHECK(made.points[8] == points[8]);
    CHECK(made.normals[8] == rbpa::Point3{});
    CHECK(made.added.points.empty() == !refine);
    REQUIRE(made.surface.triangles.size() == alone.surface.triangles.size());
    for (std::size_t t = 0; t < alone.surface.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) CHECK(made.surface.triangles[t][k] == at(alone.surface.triangles[t][k]));
    REQUIRE(made.added.between.size() == alone.added.between.size());
    for (std::size_t i = 0; i < alone.added.between.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) CHECK(made.added.between[i][k] == at(alone.added.between[i][k]));
  }
}

TEST_CASE("components are chosen, dropped ones are counted, and their holes go with them") {
  Points3 points = cut_sphere(0, 1, 600), small = cut_sphere(5, 0.5, 300);
  points.insert(points.end(), small.begin(), small.end());
  const Reconstruction all = reconstruct(points, {.radii = {0.2}, .explain = true});
  const Reconstruction largest = reconstruct(points, {.radii = {0.2}, .components = {.max_components = 1}});
  REQUIRE(all.components.all.size() == 2);
  CHECK(all.holes.size() == 2);
  CHECK(largest.components.all.size() == 1);
  CHECK(largest.holes.size() == 1);
  CHECK(largest.dropped.components == 1);
  CHECK(largest.dropped.points == small.size());
  CHECK(largest.dropped.triangles + largest.surface.triangles.size() == all.surface.triangles.size());

  const Reconstruction shells =
      reconstruct(points, {.source = NormalSource::none, .components = {.shell = rbpa::ShellChoice::largest}});
  CHECK(shells.normals.empty());
  CHECK(shells.radii.size() == 1);
  CHECK(shells.components.all.size() == 1);
}

TEST_CASE("triangles of moved points are taken for the given ones") {
  const Points3 points = cut_sphere(0, 1, 600);
  const Reconstruction moved = reconstruct(points, {.scale_space = 2, .moved = true});
  const Reconstruction made = reconstruct(points, {.scale_space = 2});
  CHECK(made.scale_space == 2);
  CHECK(made.points == points);
  CHECK(moved.points != points);
  CHECK(made.surface.triangles == moved.surface.triangles);
}

TEST_CASE("steps are announced, wrong options are refused, and a run can be cancelled") {
  const Points3 points = cut_sphere(0, 1, 600);
  std::vector<ReconstructionStep> steps;
  reconstruct(points, {.on_step = [&](ReconstructionStep step) { steps.push_back(step); }});
  CHECK(steps == std::vector{ReconstructionStep::normals, ReconstructionStep::radii, ReconstructionStep::rolling});
  CHECK_THROWS_AS(reconstruct(points, {.normals = {{0, 0, 1}}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(reconstruct(points, {.source = NormalSource::none, .radii = {1, 2}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(reconstruct(points, {.components = {.shell = rbpa::ShellChoice::outer}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(reconstruct(points, {.progress = [](const rbpa::Progress&) { return false; }}), rbpa::Cancelled);
  const Reconstruction none = reconstruct(points, {.radii = {1e-6}, .explain = true});
  CHECK(none.surface.triangles.empty());
  CHECK(none.larger_ball == rbpa::radius_with_triangles(points, none.normals));
  CHECK(reconstruct({}, {.watertight = true}).surface.triangles.empty());
}

TEST_SUITE_END();
