#include "rbpa/plane/link_triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;

TEST_SUITE_BEGIN("shape");

TEST_CASE("neighbors from the triangles alone equal those that the run finds") {
  Random random(61);
  const double infinity = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 60; ++run) {
    const int columns = random.integer(3, 30);
    const auto count = static_cast<std::size_t>(random.integer(3, columns * columns));
    const Points points = random_grid(columns, count, random.chance(0.3), random.bits());
    for (const double alpha : {0.5, 0.75, 1.0, 1.6, infinity}) {
      const rbpa::AlphaComplex made = rbpa::alpha_complex(points, alpha, {.neighbors = true});
      CHECK(rbpa::link_triangles(made.triangles, points.size()) == made.neighbors);
    }
  }
  // Many triangles at the point of least index, and at that of greatest index.
  Points wheel = {{0, 0}};
  for (int i = 0; i < 500; ++i) wheel.push_back({std::cos(i * 0.0125), std::sin(i * 0.0125)});
  for (int turn = 0; turn < 2; ++turn) {
    const rbpa::AlphaComplex made = rbpa::alpha_complex(wheel, infinity, {.neighbors = true});
    CHECK(rbpa::link_triangles(made.triangles, wheel.size()) == made.neighbors);
    std::reverse(wheel.begin(), wheel.end());
  }
  CHECK(rbpa::link_triangles({}, 0).empty());
}

TEST_CASE("linking can be cancelled") {
  const rbpa::AlphaComplex made = rbpa::alpha_complex(uniform(60000, 5), 1);
  CHECK_THROWS_AS(rbpa::link_triangles(made.triangles, 60000, [] { return false; }), rbpa::Cancelled);
}

TEST_SUITE_END();
