// Tetrahedra from triples, compared with those of the triangulation of all points by insertion.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/solid/solid.h"
#include "support/arguments.h"
#include "support/space_sets.h"

using rbpa::Point3;
using rbpa::Solid;
using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the tetrahedra of the triangulation within alpha.
Solid within(const Solid& all, const Points3& points, double alpha) {
  Solid kept;
  std::vector<std::uint32_t> number(all.simplices.size(), Solid::none);
  for (std::size_t t = 0; t < all.simplices.size(); ++t) {
    const auto& [a, b, c, d] = all.simplices[t];
    if (rbpa::space::exact::compare_circumradius(points[a], points[b], points[c], points[d], alpha) > 0) continue;
    number[t] = static_cast<std::uint32_t>(kept.simplices.size());
    kept.simplices.push_back(all.simplices[t]);
  }
  for (std::size_t t = 0; t < all.simplices.size(); ++t) {
    if (number[t] == Solid::none) continue;
    auto& neighbors = kept.neighbors.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      neighbors[k] = all.neighbors[t][k] == Solid::none ? Solid::none : number[all.neighbors[t][k]];
  }
  return kept;
}

double spacing(const Points3& points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return longest / std::cbrt(static_cast<double>(points.size()));
}

}  // namespace

TEST_CASE("triples give the rows, neighbors, duplicates and isolated points of the whole triangulation, at any alpha") {
  Random random(3121);
  std::size_t compared = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(space_kinds));
    Points3 points = space_set(kind, 80 + random.below(700), random);
    for (std::size_t copies = random.below(20); copies > 0; --copies)
      points.push_back(points[random.below(points.size())]);
    random.shuffle(points);
    CAPTURE(name(kind));
    CAPTURE(trial);
    const Solid all = rbpa::solid(points, INFINITY);
    for (const double spacings : {0.3, 0.6, 0.7, 0.85, 1.0, 1.3}) {
      const double alpha = spacings * spacing(points);
      if (!(alpha > 0) || std::isinf(alpha)) continue;
      CAPTURE(spacings);
      const Solid kept = within(all, points, alpha);
      rbpa::SolidOptions options;
      options.threads = static_cast<unsigned>(1 + random.below(2));
      const Solid found = rbpa::solid(points, alpha, options);
      REQUIRE(found.simplices == kept.simplices);
      REQUIRE(found.neighbors == kept.neighbors);
      CHECK(found.distinct == all.distinct);
      CHECK(found.duplicates.size() == all.duplicates.size());
      std::vector<bool> used(points.size(), false);
      for (const auto& corners : kept.simplices)
        for (const std::uint32_t corner : corners) used[corner] = true;
      for (const rbpa::Duplicate& d : all.duplicates) used[d.index] = true;
      std::vector<std::uint32_t> isolated;
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (!used[i]) isolated.push_back(i);
      CHECK(found.isolated == isolated);
      compared += kept.simplices.size();
    }
  }
  CHECK(compared > 10'000);
}

TEST_CASE("triples give the same on a large set, with any number of threads") {
  Random random(3122);
  const Points3 points = space_set(SpaceKind::cube, 20'000, random);
  const double alpha = 0.8 * spacing(points);
  const Solid kept = within(rbpa::solid(points, INFINITY), points, alpha);
  std::size_t calls = 0;
  for (const unsigned threads : {1u, 2u}) {
    rbpa::SolidOptions options;
    options.threads = threads;
    options.progress = [&](const rbpa::Progress&) { return ++calls > 0; };
    const Solid found = rbpa::solid(points, alpha, options);
    CHECK(found.simplices == kept.simplices);
    CHECK(found.neighbors == kept.neighbors);
  }
  CHECK(kept.simplices.size() > 30'000);
  CHECK(calls > 8);
  rbpa::SolidOptions options;
  options.progress = [](const rbpa::Progress& progress) { return progress.triangles == 0; };
  CHECK_THROWS_AS(rbpa::solid(points, alpha, options), rbpa::Cancelled);
  options.neighbors = false;
  options.progress = {};
  CHECK(rbpa::solid(points, alpha, options).neighbors.empty());
}

TEST_SUITE_END();
