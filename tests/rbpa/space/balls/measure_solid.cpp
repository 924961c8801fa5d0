#include "rbpa/space/balls/measure_solid.h"

#include <doctest/doctest.h>

#include <limits>

#include "rbpa/base/error.h"
#include "rbpa/space/persistence/choose_solid_alpha.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::AlphaRule;
using rbpa::measure_solid;
using rbpa::MeasuredSolid;
using rbpa::SolidStep;

TEST_SUITE_BEGIN("space");

TEST_CASE("a measured solid is that of its steps one by one") {
  Random random(7);
  const Points3 points = space_set(SpaceKind::cube, 200, random);
  const rbpa::Solid delaunay = rbpa::solid(points, std::numeric_limits<double>::infinity());
  const auto radii = rbpa::circumradii(points, delaunay.simplices);
  const double alpha = rbpa::choose_solid_alpha({.rule = AlphaRule::least}, points, delaunay, radii).alpha;
  const rbpa::Solid solid = rbpa::solid(points, alpha);
  const rbpa::SolidBoundary boundary = rbpa::solid_boundary(solid);

  const MeasuredSolid made = measure_solid(points, {.alpha = {.rule = AlphaRule::least}, .components = true});
  CHECK(made.alpha == alpha);
  CHECK(made.solid.simplices == solid.simplices);
  CHECK(made.boundary.surface.triangles == boundary.surface.triangles);
  CHECK(made.measures.volume == rbpa::measure(points, boundary.surface).volume);
  CHECK(made.voids.size() == rbpa::voids(points, solid, boundary).all.size());
  CHECK(made.components.size() == made.counts.solid_components);
  CHECK_FALSE(made.full.has_value());

  const MeasuredSolid full = measure_solid(points, {.alpha = {.radius = alpha}, .full = true, .balls = true});
  const auto topology = rbpa::full_topology(points, delaunay, radii, alpha);
  CHECK(full.solid.simplices == solid.simplices);
  REQUIRE(full.full.has_value());
  CHECK(full.full->tunnels == topology.counts.tunnels);
  CHECK(full.voids.size() == topology.voids.all.size());
  CHECK(full.around_voids().triangles == topology.voids.boundary.triangles);
  REQUIRE(full.balls.has_value());
  CHECK(full.balls->volume == rbpa::union_of_balls(points, alpha).volume);
}

TEST_CASE("only the steps that options call for are run, and a run can be cancelled") {
  Random random(8);
  const Points3 points = space_set(SpaceKind::cube, 50, random);
  std::vector<SolidStep> steps;
  const auto on_step = [&](SolidStep step) { steps.push_back(step); };
  measure_solid(points, {.boundary = false, .counts = false, .on_step = on_step});
  CHECK(steps == std::vector{SolidStep::tetrahedra});
  steps.clear();
  const MeasuredSolid some = measure_solid(points, {.alpha = {.rule = AlphaRule::least},
                                                    .boundary = false,
                                                    .counts = false,
                                                    .full = true,
                                                    .balls = true,
                                                    .components = true,
                                                    .on_step = on_step});
  CHECK(steps == std::vector{SolidStep::tetrahedra, SolidStep::choosing, SolidStep::boundary, SolidStep::counting,
                             SolidStep::balls});
  CHECK(some.counts == rbpa::SolidCounts{});
  CHECK(some.full.has_value());
  CHECK(some.balls.has_value());
  CHECK_FALSE(some.components.empty());
  steps.clear();
  const MeasuredSolid made = measure_solid(points, {.balls = true, .triangulation = true, .on_step = on_step});
  CHECK(steps == std::vector{SolidStep::tetrahedra, SolidStep::choosing, SolidStep::boundary, SolidStep::counting});
  CHECK(made.solid.simplices == made.triangulation.simplices);
  CHECK_FALSE(made.balls.has_value());  // alpha is infinity
  CHECK_THROWS_AS(measure_solid(points, {.alpha = {.rule = AlphaRule::plateau, .rank = 1000}}), rbpa::InvalidInput);
  CHECK_THROWS_AS(measure_solid(points, {.progress = [](const rbpa::Progress&) { return false; }}), rbpa::Cancelled);
}

TEST_SUITE_END();
