#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "oracle/gudhi_betti.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_topology.h"
#include "rbpa/space/solid/voids.h"
#include "support/arguments.h"
#include "support/solid_sets.h"
#include "support/space_sets.h"

using namespace rbpa_test;

namespace {

using Numbers = std::array<std::size_t, 3>;

Numbers betti(const Points3& points, const rbpa::Solid& solid) {
  const rbpa::SolidCounts counts = rbpa::voids(points, solid, rbpa::solid_boundary(solid)).counts;
  return {counts.components, counts.tunnels, counts.voids};
}

}  // namespace

TEST_CASE("solids of every kind at radii around their spacing have GUDHI's Betti numbers of the same tetrahedra") {
  const std::size_t count = argument("points", 2000);
  Numbers most{};
  for (const SolidSet& set : solid_sets(count)) {
    CAPTURE(set.name);
    Random random(501);
    for (int trial = 0; trial < 6; ++trial) {
      const double alpha = space_radius(set.points, random);
      CAPTURE(alpha);
      const rbpa::Solid solid = rbpa::solid(set.points, alpha);
      if (solid.simplices.empty()) continue;
      const Numbers found = betti(set.points, solid);
      CHECK(found == gudhi_betti(solid.simplices));
      for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], found[i]);
    }
  }
  CHECK(std::all_of(most.begin(), most.end(), [](std::size_t n) { return n > 10; }));
}

TEST_CASE("solids of uniform points from nearly empty to nearly full have GUDHI's Betti numbers") {
  const std::size_t count = argument("points", 2000);
  const Points3 points = uniform_cube(count, 1);
  Numbers most{};
  for (double alpha = 0.45; alpha < 1.3; alpha += 0.05) {
    CAPTURE(alpha);
    const rbpa::Solid solid = rbpa::solid(points, alpha);
    const Numbers found = betti(points, solid);
    CHECK(found == gudhi_betti(solid.simplices));
    for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], found[i]);
  }
  CHECK(std::all_of(most.begin(), most.end(), [&](std::size_t n) { return n > count / 100; }));
}
