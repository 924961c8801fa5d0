#include "rbpa/space/persistence/solid_plateaus.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <thread>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_radii.h"
#include "rbpa/space/solid/voids.h"
#include "support/for_solids.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::SolidPlateau;

TEST_SUITE_BEGIN("space");

namespace {

std::vector<SolidPlateau> plateaus_of(const Points3& points) {
  const Solid delaunay = rbpa::solid(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  return rbpa::solid_plateaus(points, delaunay, rbpa::circumradii(points, delaunay.simplices));
}

Points3 box(std::size_t count, std::uint64_t seed, double x, double size) {
  Points3 points = jittered_cubes(count, seed);
  double greatest = 0;
  for (const Point3& p : points) greatest = std::max(greatest, p.x);
  for (Point3& p : points) p = {x + p.x * size / greatest, p.y * size / greatest, p.z * size / greatest};
  return points;
}

Points3 join(Points3 points, const Points3& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

/// Checks the numbers against the complex at the radius, from the definition.
void check_numbers(const Points3& points, const SolidPlateau& plateau) {
  const Solid solid = rbpa::solid(points, plateau.alpha);
  CHECK(plateau.tetrahedra == solid.simplices.size());
  CHECK(plateau.covered == solid.distinct - solid.isolated.size());
  meshops::DisjointSets sets(points.size());
  for (const auto& row : solid.simplices)
    for (std::size_t k = 1; k < 4; ++k) sets.join(row[0], row[k]);
  std::vector<double> sizes(points.size(), 0);
  std::set<std::uint32_t> corners;
  for (const auto& row : solid.simplices) corners.insert(row.begin(), row.end());
  for (const std::uint32_t corner : corners) ++sizes[sets.find(corner)];
  double sum = 0, squares = 0;
  std::size_t components = 0;
  for (const double size : sizes) {
    sum += size;
    squares += size * size;
    components += size > 0;
  }
  CHECK(plateau.components == components);
  CHECK(plateau.effective_parts == doctest::Approx(sum * sum / squares));
  const rbpa::SolidBoundary boundary = rbpa::solid_boundary(solid);
  const double volume = rbpa::measure(points, boundary.surface).volume;
  CHECK(plateau.volume == doctest::Approx(volume));
  double hollow = 0;
  for (const rbpa::SolidVoid& v : rbpa::voids(points, solid, boundary).all) hollow += v.volume;
  CHECK(plateau.void_share == doctest::Approx(hollow / (hollow + volume)).epsilon(1e-9));
}

}  // namespace

TEST_CASE("two bodies are one plateau, and both together another; numbers are those of the complex") {
  const Points3 points = join(box(600, 11, 0, 1), box(600, 12, 4, 1));
  const std::vector<SolidPlateau> found = plateaus_of(points);
  REQUIRE(found.size() >= 1);
  const SolidPlateau& best = found.front();
  CHECK(best.components == 2);
  CHECK(best.effective_parts == doctest::Approx(2).epsilon(0.01));
  CHECK(best.is_long);
  CHECK(best.is_structured);
  CHECK(best.from < 0.2);
  CHECK(best.to.value_or(0) > 1);
  CHECK(best.alpha < *best.to);
  for (const SolidPlateau& plateau : found) check_numbers(points, plateau);
}

TEST_CASE("a hollow body is a plateau with its void; an outlier and dust do not change it") {
  Points3 points;
  for (int i = 0; i < 14; ++i)
    for (int j = 0; j < 14; ++j)
      for (int k = 0; k < 14; ++k)
        if (std::max({std::abs(i - 6.5), std::abs(j - 6.5), std::abs(k - 6.5)}) > 4)
          points.push_back({i + 0.01 * ((i * 7 + j * 3 + k) % 10), j + 0.01 * ((i + j * 7 + k * 3) % 10),
                            k + 0.01 * ((i * 3 + j + k * 7) % 10)});
  const std::vector<SolidPlateau> found = plateaus_of(points);
  REQUIRE(!found.empty());
  CHECK(found.front().is_long);
  CHECK(found.front().void_share == doctest::Approx(0.33).epsilon(0.2));
  CHECK(found.front().components == 1);
  check_numbers(points, found.front());
  points.push_back({1000, 0, 0});
  points.push_back({1000.5, 0, 0});
  points.push_back({1000, 0.5, 0});
  points.push_back({1000, 0, 0.5});
  const std::vector<SolidPlateau> with_dust = plateaus_of(points);
  CHECK(with_dust.front().from == found.front().from);
  CHECK(with_dust.front().alpha == doctest::Approx(found.front().alpha).epsilon(1e-9));
}

TEST_CASE("a set without structure is one piece, and no structured plateau is long in it") {
  for (const std::size_t count : {50u, 200u, 1000u, 4000u})
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      CAPTURE(count);
      CAPTURE(seed);
      const std::vector<SolidPlateau> found = plateaus_of(uniform_cube(count, 5400 + seed));
      for (const SolidPlateau& plateau : found)
        if (plateau.is_structured) CHECK(!plateau.is_long);
      CHECK(!found.front().is_structured);
    }
}

TEST_CASE("shuffled points have the same plateaus, and scaled ones the same scaled") {
  Random random(5401);
  Points3 points = join(box(300, 13, 0, 1), box(200, 14, 3, 0.7));
  const std::vector<SolidPlateau> expected = plateaus_of(points);
  REQUIRE(!expected.empty());
  random.shuffle(points);
  CHECK(plateaus_of(points) == expected);
  for (Point3& p : points) p = {0.125 * p.x, 0.125 * p.y, 0.125 * p.z};
  const std::vector<SolidPlateau> scaled = plateaus_of(points);
  REQUIRE(scaled.size() == expected.size());
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    CHECK(scaled[i].from == 0.125 * expected[i].from);
    CHECK(scaled[i].alpha == 0.125 * expected[i].alpha);
    CHECK(scaled[i].tetrahedra == expected[i].tetrahedra);
  }
}

TEST_CASE("sets of every kind have plateaus in order, and a run can be cancelled") {
  for_solids(100, [&](const Points3& points) {
    const Solid all = rbpa::solid(points, std::numeric_limits<double>::infinity());
    if (all.simplices.empty() || all.simplices.size() > 3000) return;
    const std::vector<SolidPlateau> found = plateaus_of(points);
    CHECK(!found.empty());
    for (const SolidPlateau& plateau : found) {
      CHECK(plateau.from <= plateau.alpha);
      if (plateau.to) CHECK(plateau.alpha < *plateau.to);
      CHECK(plateau.ratio >= 1);
    }
  });
  const Points3 points = uniform_cube(2000, 5402);
  const Solid delaunay = rbpa::solid(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  CHECK_THROWS_AS(rbpa::solid_plateaus(points, delaunay, radii, [] { return false; }), rbpa::Cancelled);
  CHECK_THROWS_AS(rbpa::solid_plateaus(Points3(points.begin(), points.end() - 1), delaunay, radii),
                  meshops::ContractViolation);
  Solid broken = delaunay;
  broken.neighbors[5][2] = 100'000;
  CHECK_THROWS_AS(rbpa::solid_plateaus(points, broken, radii), meshops::ContractViolation);
  for (auto& row : broken.neighbors) row = {0, 0, 0, 0};  // nothing reaches the outside
  CHECK_THROWS_AS(rbpa::solid_plateaus(points, broken, radii), meshops::ContractViolation);
  const Points3 one = {{1, 2, 3}};
  CHECK(plateaus_of(one).empty());
}

TEST_CASE("plateaus and pairs are the same with any number of threads; with one, nothing runs in another thread") {
  const Points3 points = uniform_cube(12'000, 5403);
  const rbpa::SolidFiltration filtration = rbpa::solid_filtration(points);
  const auto self = std::this_thread::get_id();
  const rbpa::GoOn stays = [&] { return std::this_thread::get_id() == self; };
  const auto& radii = filtration.tetrahedron_alpha;
  const auto plateaus = rbpa::solid_plateaus(points, filtration.delaunay, radii, stays, 1);
  const auto pairs = rbpa::solid_persistence(filtration, stays, 1);
  for (const unsigned threads : {1u, 2u}) {
    int calls = 0;
    const auto beside = [&](const rbpa::GoOn& go_on) { calls += go_on() ? 1 : 0; };
    CHECK(rbpa::solid_plateaus(points, filtration.delaunay, radii, {}, threads, beside) == plateaus);
    CHECK(rbpa::solid_plateaus({}, {}, {}, {}, threads, beside).empty());
    CHECK(rbpa::solid_persistence(filtration, {}, threads, beside) == pairs);
    CHECK(calls == 3);
  }
  CHECK(rbpa::auto_alpha(filtration.delaunay, radii, 0.9, stays, 1) ==
        rbpa::auto_alpha(filtration.delaunay, radii, 0.9, {}, 2));
}
