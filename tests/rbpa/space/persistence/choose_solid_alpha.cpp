#include "rbpa/space/persistence/choose_solid_alpha.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/solid_sets.h"

using rbpa::AlphaRule;
using rbpa::Solid;
using rbpa_test::Points3;

TEST_SUITE_BEGIN("space");

TEST_CASE("each rule chooses the radius of its function") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Points3 points = rbpa_test::jittered_cubes(300, 4);
  const Solid delaunay = rbpa::solid(points, infinity, {.neighbors = true});
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  const auto choose = [&](const rbpa::AlphaChoice& choice) {
    return rbpa::choose_solid_alpha(choice, points, delaunay, radii);
  };
  CHECK(choose({.radius = 0.7}).alpha == 0.7);
  for (const double share : {0.9, 1.0}) {
    CHECK(choose({.rule = AlphaRule::least, .cover = share}).alpha == rbpa::min_alpha(delaunay, radii, share));
    CHECK(choose({.rule = AlphaRule::automatic, .cover = share}).alpha == rbpa::auto_alpha(delaunay, radii, share));
  }
  const std::vector<rbpa::SolidPlateau> plateaus = rbpa::solid_plateaus(points, delaunay, radii);
  REQUIRE(!plateaus.empty());
  for (std::size_t rank = 1; rank <= plateaus.size(); ++rank) {
    const rbpa::ChosenSolidAlpha chosen = choose({.rule = AlphaRule::plateau, .rank = rank});
    CHECK(chosen.alpha == plateaus[rank - 1].alpha);
    CHECK(chosen.plateaus == plateaus);
  }
  CHECK_THROWS_AS(choose({.rule = AlphaRule::plateau, .rank = plateaus.size() + 1}), rbpa::InvalidInput);
}

TEST_CASE("each rule chooses infinity for points without a tetrahedron") {
  for (const Points3& points : {Points3(), Points3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}) {
    const Solid delaunay = rbpa::solid(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
    for (const AlphaRule rule : {AlphaRule::automatic, AlphaRule::least, AlphaRule::plateau})
      CHECK(std::isinf(rbpa::choose_solid_alpha({.rule = rule, .rank = 9}, points, delaunay, {}).alpha));
  }
}

TEST_SUITE_END();
