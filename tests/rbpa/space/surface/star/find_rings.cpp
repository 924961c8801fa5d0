#include "rbpa/space/surface/star/find_rings.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include "rbpa/space/cells/scale.h"
#include "support/arguments.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Threads;
using rbpa::space::Cells;
using rbpa::space::find_rings;
using rbpa::space::Rings;
using rbpa::space::Site;

TEST_SUITE_BEGIN("space");

namespace {

/// For each site and each of its triangles (v, x, y): the point z of the triangle (v, z, x) to which the ball rolls
/// about x.
using Turns = std::map<std::array<Site, 3>, Site>;

struct Found {
  Turns turns;
  std::size_t rolled;
};

Found turns_of(const Cells& cells, bool by_regions) {
  Rings rings;
  const meshops::GoOn never;
  meshops::Steps step(never);
  find_rings(cells, by_regions, 0, static_cast<Site>(cells.sites().size()), rings, step);
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

TEST_CASE("the free region around a point gives the result of rolling about every edge") {
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
  CHECK(rolled < sites / 4);  // otherwise nothing was compared
}

TEST_CASE("regions are found on scan lines, where whole circles bound the region for long") {
  Threads threads;
  for (const double radius : {0.55, 0.8, 1.5})
    for (const double noise : {0.0, 1e-3}) {
      CAPTURE(radius);
      CAPTURE(noise);
      Random random(93);
      Points3 points;
      for (int line = 0; line < 7; ++line)
        for (int i = 0; i < 110; ++i) {
          const double x = i / 20.0 + 0.0185 * line, y = line + noise * random.unit();
          points.push_back({x, y, 0.3 * std::sin(x / 5) * std::cos(y / 6) + noise * random.unit()});
        }
      const Cells cells(points, radius, threads);
      const Found region = turns_of(cells, true);
      CHECK(region.turns == turns_of(cells, false).turns);
      CHECK(region.turns.size() > points.size());
      CHECK(100 * region.rolled < points.size());
    }
}

TEST_CASE("points that another one sees in one direction, at nearly one distance, hide no triangle") {
  // The least and the greatest depth of one cap on the other's circle differ by the root of the rounding error.
  const Points3 points = {{0x1.8bdd177148d58p-4, 0x1.23717c3b551a6p-2, 0x1.774e661651e3ap-1},
                          {0x1.7e8a57ef5b78bp-1, 0x1.f3c6ffc0772f7p-1, 0x1.cdc9a87ca6b8p-6},
                          {0x1.8013cb1d75a54p-2, 0x1.38c0a288475fp-1, 0x1.cf98d3a1adf27p-1},
                          {0x1.95492e1b237e7p-1, 0x1.aa9682b87af08p-3, 0x1.897afc9282521p-1},
                          {0x1.0fcdf3d41cbccp-1, 0x1.52e01162de8a4p-2, 0x1.b1d2fa929a1bcp-2},
                          {0x1.928350ee0915p-5, 0x1.28b8b3aeae769p-1, 0x1.3f3857a253ep-9},
                          {0x1.90a291f888268p-2, 0x1.18c5e8edf22f8p-2, 0x1.a2132821a2067p-1},
                          {0x1.a286ca1f6b4cfp-1, 0x1.fa0b20e5ed5bp-1, 0x1.5437d0403a4ap-5},
                          {0x1.92834ffabb326p-5, 0x1.28b8b43a990c1p-1, 0x1.3f36f97075162p-9},
                          {0x1.a286cb017ff8dp-1, 0x1.fa0b21ba3f85p-1, 0x1.5437c2ec397f7p-5}};
  Threads threads;
  const Cells cells(points, 0x1.15367330c7df8p+0, threads);
  CHECK(turns_of(cells, true).turns == turns_of(cells, false).turns);
}

TEST_CASE("a near copy of a point, farther away by less than the rounding error, hides nothing") {
  Random random(93);
  Threads threads;
  for (int trial = 0; trial < trials(300); ++trial) {
    Points3 points = space_set(SpaceKind::cube, 4 + random.below(8), random);
    const double size = std::pow(10, -6.5 - 3 * random.unit());
    const auto nearly = [&](double a, double b) { return a + (1 + size * (2 * random.unit() - 1)) * (b - a); };
    for (std::size_t k = 1 + random.below(4); k > 0; --k) {
      const rbpa::Point3 v = points[0], p = points[1 + random.below(3)];
      points.push_back({nearly(v.x, p.x), nearly(v.y, p.y), nearly(v.z, p.z)});
    }
    const Cells cells(points, 0.4 + 0.8 * random.unit(), threads);
    CHECK(turns_of(cells, true).turns == turns_of(cells, false).turns);
  }
}

TEST_CASE("at most one region in a hundred is lost where few points are at one place") {
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

TEST_CASE("at most one region in a thousand is lost in a volume, where caps cut out the middle of arcs") {
  Random random(94);
  Threads threads;
  std::size_t sites = 0, rolled = 0;
  for (const double radius : {0.2, 0.3, 0.5}) {
    Points3 points;
    for (int i = 0; i < 2000; ++i) points.push_back({random.unit(), random.unit(), random.unit()});
    rolled += turns_of(Cells(points, radius, threads), true).rolled;
    sites += points.size();
  }
  CHECK(1000 * rolled < sites);
}

TEST_SUITE_END();
