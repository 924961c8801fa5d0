#include "rbpa/plane/divide/divide_and_conquer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rbpa/base/exact/magnitude.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using meshops::Patch;
using rbpa::Point;

TEST_SUITE_BEGIN("divide");

namespace {

using P = rbpa::Predicates<double>;

std::vector<Triangle> triangles_of(const Patch& patch) {
  std::vector<Triangle> found;
  for (const auto& t : patch.triangles)
    found.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  return canonical(std::move(found));
}

constexpr auto all_are_kept = [](const auto&...) { return 0; };

/// Triangulates the points; sites are positions in `points`.
void delaunay(
    const Points& points, Patch& patch, unsigned threads = 1, const std::function<void()>& working = [] {},
    const rbpa::Fate& fate = all_are_kept) {
  std::vector<rbpa::SitePoint> places;
  for (const Point& p : points) places.push_back({p, static_cast<std::uint32_t>(places.size())});
  rbpa::Threads some(threads);
  patch = rbpa::divide_and_conquer<double>(places, fate, some, working);
}

Patch triangulated(const Points& points) {
  Patch patch;
  delaunay(points, patch);
  return patch;
}

/// Returns the first fault of a patch, "" when there is none: orientation, adjacency, one hull.
std::string wrong_in(const Patch& patch, const Points& points) {
  const auto name = [&](std::size_t t) { return "triangle " + std::to_string(t); };
  if (patch.across.size() != patch.triangles.size()) return "sizes";
  std::size_t open = 0;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(patch.triangles[t][i % 3])]; };
    if (P::orientation(at(0), at(1), at(2)) <= 0) return name(t) + " does not turn left";
    for (std::size_t i = 0; i < 3; ++i) {
      const int across = patch.across[t][i];
      if (across == Patch::nothing) {
        ++open;
        for (const Point& p : points)
          if (P::orientation(at(i), at(i + 1), p) < 0) return name(t) + " has a side open that is not of the hull";
        continue;
      }
      const auto s = static_cast<std::size_t>(across);
      if (across < 0 || s >= 3 * patch.triangles.size()) return name(t) + " is across of nothing";
      if (patch.across[s / 3][s % 3] != static_cast<int>(3 * t + i)) return name(t) + " is not across of what is";
      if (patch.triangles[s / 3][s % 3] != patch.triangles[t][(i + 1) % 3] ||
          patch.triangles[s / 3][(s + 1) % 3] != patch.triangles[t][i] || s / 3 == t)
        return name(t) + " is across of another edge";
    }
  }
  return !patch.triangles.empty() && open < 3 ? "no hull" : "";
}

std::string wrong_with(const Points& points) {
  const Patch patch = triangulated(points);
  if (const std::string wrong = wrong_in(patch, points); !wrong.empty()) return wrong;
  return difference(delaunay_by_winners(points), triangles_of(patch));
}

void check(const std::string& name, const Points& points) {
  const std::string wrong = wrong_with(points);
  if (wrong.empty()) return;
  const Points few = shrink(points, [](const Points& some) { return !wrong_with(some).empty(); });
  FAIL_CHECK(name << ": " << wrong << "; less points: " << literal(few) << ": " << wrong_with(few));
}

Points distinct(const Points& points) {
  const std::vector<std::uint32_t> lowest = lowest_equal(points);
  Points kept;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] == i) kept.push_back(points[i]);
  return kept;
}

std::size_t calls(const Points& points) {
  std::size_t count = 0;
  Patch patch;
  delaunay(points, patch, 1, [&] { ++count; });
  CHECK(patch.triangles.size() >= points.size() - 2);
  return count;
}

}  // namespace

TEST_CASE("each side of each triangle has the right apex and no triangle is missing, on all subsets of small grids") {
  const double even[] = {0, 1, 2, 3}, stretched[] = {0, 1, 4, 20};
  for (const auto& x : {even, stretched}) {
    Points grid;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 4; ++i) grid.push_back({x[i], x[j]});
    for (std::uint32_t subset = 0; subset < std::uint32_t{1} << grid.size(); ++subset) {
      Points points;
      for (std::size_t i = 0; i < grid.size(); ++i)
        if (subset >> i & 1U) points.push_back(grid[i]);
      check("subset " + std::to_string(subset), points);
    }
  }
}

TEST_CASE("each side of each triangle has the right apex and no triangle is missing, on few points") {
  Random random(1);
  for (int round = 0; round < trials(3000); ++round) {
    CAPTURE(round);
    const TileSet set = few_points(random);
    check(set.name, distinct(set.points));
  }
}

TEST_CASE("each side of each triangle has the right apex and no triangle is missing, on sets that are hard for tiles") {
  for (const TileSet& set : tile_sets()) check(set.name, distinct(set.points));
}

TEST_CASE("points on a line have no triangle, and one point off the line makes a triangle for each pair of neighbors") {
  const double steps[][2] = {{1, 0}, {0, 1}, {3, -7}, {0.5, 0.25}, {-1, -1}};
  for (const auto& step : steps)
    for (const int count : {0, 1, 2, 3, 4, 5, 100, 1000}) {
      CAPTURE(count);
      Points line = collinear_run(count, step[0], step[1], 7);
      CHECK(triangulated(line).triangles.empty());
      line.push_back({1e4, 1.1e4});
      if (count < 2) continue;
      CHECK(triangulated(line).triangles.size() == line.size() - 2);
      if (count <= 100) check("line and a point", line);
    }
}

TEST_CASE("the triangles do not depend on the order of the points") {
  Random random(3);
  for (const Points& points : {uniform(5000, 4), perfect_grid(60, 1), integer_circle(32045), along_curves(500)}) {
    const std::vector<Triangle> expected = triangles_of(triangulated(points));
    for (int round = 0; round < 3; ++round) {
      Points shuffled = points;
      random.shuffle(shuffled);
      CHECK(translated(triangles_of(triangulated(shuffled)), shuffled, points) == expected);
    }
  }
}

TEST_CASE("triangles whose corners are kept stay, whatever other points are removed") {
  Random random(5);
  for (const Points& points : {perfect_grid(25, 1), rotated_integer_grid(20), integer_concentric(1105, true)}) {
    const std::vector<Triangle> all = triangles_of(triangulated(points));
    std::vector<std::uint32_t> of_kept;
    Points kept;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (random.chance(0.7)) {
        of_kept.push_back(i);
        kept.push_back(points[i]);
      }
    const std::vector<Triangle> fewer = renumbered(triangles_of(triangulated(kept)), of_kept);
    for (const Triangle& t : all) {
      const bool stays = std::all_of(
          t.begin(), t.end(), [&](std::uint32_t i) { return std::binary_search(of_kept.begin(), of_kept.end(), i); });
      if (stays) CHECK(std::binary_search(fewer.begin(), fewer.end(), t));
    }
  }
}

TEST_CASE("no set takes many more merge steps than scattered points") {
  constexpr std::size_t count = 100000;
  const std::size_t scattered = calls(uniform(count, 6));
  REQUIRE(scattered > 10);
  Points circle, spiral, line;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2.0 * static_cast<double>(i / 2) / (count / 2.0) - 1, u = 1 + t * t;
    circle.push_back({(i % 2 == 0 ? 1 : -1) * (1 - t * t) / u, 2 * t / u});
    spiral.push_back({(t + 2) * circle.back().x, (t + 2) * circle.back().y});
    line.push_back({static_cast<double>(i), i % 1000 == 0 ? 1.0 : 0.0});
  }
  for (const Points& points : {distinct(circle), distinct(spiral), line, clusters(count / 10, 8), perfect_grid(316, 1)})
    CHECK(calls(points) < 4 * scattered);
}

TEST_CASE("an exception during the work reaches the caller, and no call follows it") {
  const Points points = uniform(100000, 9);
  for (const unsigned threads : {1u, 2u, 5u}) {
    Patch patch;
    int calls = 0;
    const auto stop = [&] {
      if (++calls == 3) throw std::string("stop");
    };
    CHECK_THROWS_AS(delaunay(points, patch, threads, stop), std::string);
    CHECK(calls == 3);
  }
}

TEST_CASE("the number of threads changes neither the triangles nor their order") {
  for (const Points& points : {uniform(50000, 11), rounded_concentric(30000), along_curves(10000), clusters(3000, 12),
                               perfect_grid(200, 1), collinear_run(30000, 1, 0.5, 13)}) {
    const Patch expected = triangulated(points);
    for (const unsigned threads : {0u, 2u, 5u}) {
      CAPTURE(threads);
      Patch patch;
      delaunay(points, patch, threads);
      CHECK(patch.triangles == expected.triangles);
      CHECK(patch.across == expected.across);
    }
  }
}

TEST_CASE("a removed triangle is replaced by its mark in the neighbors") {
  const Points points = uniform(2000, 14);
  const Patch all = triangulated(points);
  const auto by_sum = [](unsigned sum) { return sum % 4 == 0 ? Patch::open : sum % 4 == 1 ? Patch::nothing : 0; };
  std::vector<int> number;  // for each triangle of the patch
  std::vector<std::array<meshops::Site, 3>> kept;
  for (const auto& t : all.triangles) {
    const int fate = by_sum(static_cast<unsigned>(t[0] + t[1] + t[2]));
    number.push_back(fate < 0 ? fate : static_cast<int>(kept.size()));
    if (fate == 0) kept.push_back(t);
  }
  Patch patch;
  const auto fate = [&](const rbpa::SitePoint& a, const rbpa::SitePoint& b, const rbpa::SitePoint& c) {
    return by_sum(a.site + b.site + c.site);
  };
  delaunay(
      points, patch, 1, [] {}, fate);
  REQUIRE(patch.triangles == kept);
  for (std::size_t t = 0; t < number.size(); ++t)
    for (std::size_t i = 0; number[t] >= 0 && i < 3; ++i) {
      const int across = all.across[t][i];
      const int other = across < 0 ? across : number[static_cast<std::size_t>(across) / 3];
      CHECK(patch.across[static_cast<std::size_t>(number[t])][i] == (other < 0 ? other : 3 * other + across % 3));
    }
}

TEST_CASE("three points have one triangle, and no points have none") {
  const Patch one = triangulated({{0, 0}, {1, 0}, {0, 1}});
  CHECK(one.triangles.size() == 1);
  CHECK(one.across.size() == 1);
  const Patch none = triangulated({});
  CHECK(none.triangles.empty());
  CHECK(none.across.empty());
}

TEST_SUITE_END();
