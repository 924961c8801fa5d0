#include "rbpa/plane/choose_alpha.h"

#include <doctest/doctest.h>

#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/filtration.h"
#include "support/generate.h"

using rbpa::AlphaChoice;
using rbpa::AlphaRule;
using rbpa_test::Points;

TEST_SUITE_BEGIN("filtration");

TEST_CASE("each rule chooses the radius of its function") {
  const Points points = rbpa_test::sparse_grid(12, 0.6, 5);
  const rbpa::Delaunay delaunay(points);
  CHECK(rbpa::choose_alpha({.radius = 0.7}, delaunay).alpha == 0.7);
  for (const double share : {0.5, 1.0}) {
    const AlphaChoice least{.rule = AlphaRule::least, .max_components = 2, .cover = share};
    CHECK(rbpa::choose_alpha(least, delaunay).alpha == rbpa::smallest_covering(delaunay, {.share = share}));
    for (const std::size_t most : {1U, 3U}) {
      const AlphaChoice automatic{.rule = AlphaRule::automatic, .max_components = most, .cover = share};
      CHECK(rbpa::choose_alpha(automatic, delaunay).alpha ==
            rbpa::smallest_covering(delaunay, {.share = share, .max_components = most}));
    }
  }
  const std::vector<rbpa::Plateau> plateaus = rbpa::plateaus(delaunay, rbpa::filtration(delaunay));
  REQUIRE(!plateaus.empty());
  for (std::size_t rank = 1; rank <= plateaus.size(); ++rank) {
    const rbpa::ChosenAlpha chosen = rbpa::choose_alpha({.rule = AlphaRule::plateau, .rank = rank}, delaunay);
    CHECK(chosen.alpha == plateaus[rank - 1].alpha);
    CHECK(chosen.plateaus == plateaus);
  }
  CHECK_THROWS_AS(rbpa::choose_alpha({.rule = AlphaRule::plateau, .rank = plateaus.size() + 1}, delaunay),
                  rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::choose_alpha({.rule = AlphaRule::least, .cover = 0}, delaunay), meshops::ContractViolation);
}

TEST_CASE("no rule chooses a radius for points without a triangle") {
  for (const Points& points : {Points(), Points{{0, 0}, {1, 1}}, Points{{0, 0}, {1, 1}, {2, 2}}}) {
    const rbpa::Delaunay delaunay(points);
    for (const AlphaRule rule : {AlphaRule::automatic, AlphaRule::least, AlphaRule::plateau})
      CHECK(!rbpa::choose_alpha({.rule = rule, .rank = 9}, delaunay).alpha);
    CHECK(rbpa::choose_alpha({.radius = 2}, delaunay).alpha == 2);
  }
}

TEST_SUITE_END();
