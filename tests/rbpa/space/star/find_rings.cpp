#include "rbpa/space/star/find_rings.h"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "rbpa/space/cells/scale.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Threads;
using rbpa::space::Cells;
using rbpa::space::find_rings;
using rbpa::space::Rings;
using rbpa::space::Site;

TEST_SUITE_BEGIN("space");

namespace {

/// Of each site, and each of its triangles (v, x, y), the point z of the triangle (v, z, x) to which the ball rolls about x.
using Turns = std::map<std::array<Site, 3>, Site>;

struct Found {
  Turns turns;
  std::size_t rolled;
};

Found turns_of(const Cells& cells, bool by_regions) {
  Rings rings;
  find_rings(cells, by_regions, 0, static_cast<Site>(cells.sites().size()), rings);
  REQUIRE(rings.first.size() == cells.sites().size() + 1);
  Found found{.turns = {}, .rolled = rings.rolled};
  for (Site v = 0; v < cells.sites().size(); ++v)
    for (std::size_t first = rings.first[v], last = first; first < rings.first[v + 1]; first = last = last + 1) {
      while (rings.points[last] != Rings::end_of_cycle) ++last;
      REQUIRE(last >= first + 2);
      for (std::size_t k = first; k < last; ++k) {
        const Site x = rings.points[k], y = rings.points[k == first ? last - 1 : k - 1];
        const bool is_new = found.turns.insert({{v, x, y}, rings.points[k + 1 == last ? first : k + 1]}).second;
        CHECK(is_new);
      }
    }
  return found;
}

}  // namespace

TEST_CASE("around a point, the free region tells what rolling about every edge tells") {
  Random random(91);
  Threads threads;
  std::size_t sites = 0, rolled = 0, turns = 0;
  for (int k = 0; k < space_kinds; ++k) {
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (int trial = 0; trial < 40; ++trial) {
      const Points3 points = space_set(static_cast<SpaceKind>(k), 3 + random.below(trial < 30 ? 12 : 50), random);
      const double radius = space_radius(points, random);
      if (rbpa::space::scale_to_double(points, radius) != 0) continue;
      const Cells cells(points, radius, threads);
      const Found region = turns_of(cells, true), roll = turns_of(cells, false);
      CHECK(region.turns == roll.turns);
      CHECK(roll.rolled == cells.sites().size());
      sites += cells.sites().size();
      rolled += region.rolled;
      turns += roll.turns.size();
    }
  }
  CHECK(turns > 10'000);
  CHECK(rolled < sites / 4);  // otherwise nothing has been compared
}

TEST_CASE("where points are not many at one place, one region of a hundred is lost at most") {
  Random random(92);
  Threads threads;
  for (const SpaceKind kind : {SpaceKind::near_sphere, SpaceKind::noisy_sphere, SpaceKind::cube}) {
    CAPTURE(name(kind));
    const Points3 points = space_set(kind, 2000, random);
    for (const double radius : {0.02, 0.1, 0.3}) {
      const Found found = turns_of(Cells(points, radius, threads), true);
      CHECK(100 * found.rolled < points.size());
    }
  }
}

TEST_SUITE_END();
