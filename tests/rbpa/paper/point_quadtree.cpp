#include "rbpa/paper/point_quadtree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "paper/small_sets.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/hrbpa.h"
#include "support/generate.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::paper::Leaf;
using rbpa::paper::quadtree;

TEST_SUITE_BEGIN("paper");

namespace {

using Real = long double;

/// Counts the points in a square, including its upper and right side only where these are sides of the root.
std::size_t held(const Points& points, Real x, Real y, Real side, Real right, Real top) {
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const Point& p) {
    return p.x >= x && (p.x < x + side || x + side >= right) && p.y >= y && (p.y < y + side || y + side >= top);
  }));
}

void check(const Points& points, std::size_t capacity) {
  CAPTURE(capacity);
  const std::vector<Leaf> leaves = quadtree(points, capacity);
  const rbpa::paper::Box box = rbpa::paper::box_of(points);
  const Real size = std::max(box.width, box.height), right = box.x + size, top = box.y + size;
  std::map<std::pair<Real, std::pair<Real, Real>>, std::size_t> in_parent;  // by side length and corner
  Real area = 0;
  std::size_t sum = 0;
  for (const Leaf& leaf : leaves) {
    area += (leaf.side / size) * (leaf.side / size);
    sum += leaf.points;
    CHECK(leaf.points <= capacity);
    CHECK(leaf.points == held(points, leaf.x, leaf.y, leaf.side, right, top));
    if (leaf.side == size) continue;
    // The square that it was cut from had too many points.
    const Real parent = 2 * leaf.side;
    const Real x = box.x + std::floor((leaf.x - box.x) / parent) * parent,
               y = box.y + std::floor((leaf.y - box.y) / parent) * parent;
    CHECK(held(points, x, y, parent, right, top) > capacity);
  }
  CHECK(area == 1);
  CHECK(sum == points.size());
}

}  // namespace

TEST_CASE("leaves tile the root, none holds too many points, and only squares with too many points were cut") {
  Random random(101);
  const auto distinct_of = [&](Points points) { return distinct(std::move(points), random); };
  for (const std::size_t k : {1u, 2u, 3u, 7u, 64u}) {
    check(distinct_of(random_grid(33, 200, true, 1)), k);  // cuts are exact on a grid with a power of two of intervals
    check(distinct_of(random_grid(17, 40, true, 2)), k);
    check(distinct_of({{0, 0}, {64, 0}, {0, 64}, {64, 64}, {32, 32}, {33, 32}, {31, 31}, {32, 31}}), k);
    check({{3, 4}, {3, 5}}, k);
  }
}

TEST_CASE("a point on a cut belongs to the upper or right square") {
  // A square of side 4, with three points on the cross of the cuts.
  const std::vector<Leaf> leaves = quadtree(Points{{0, 0}, {4, 4}, {2, 1}, {1, 2}, {2, 2}}, 2);
  REQUIRE(leaves.size() == 4);
  std::map<std::pair<Real, Real>, std::size_t> held;
  for (const Leaf& leaf : leaves) held[{leaf.x, leaf.y}] = leaf.points;
  CHECK(held == std::map<std::pair<Real, Real>, std::size_t>{{{0, 0}, 1}, {{2, 0}, 1}, {{0, 2}, 1}, {{2, 2}, 2}});
}

TEST_CASE("the minimal radius is half the side of the smallest leaf, and equals that of the default search") {
  int sets = 0;
  for (const NamedSet& set : generated_sets()) {
    Points points = set.make();
    if (points.size() > 5000) continue;
    Random random(points.size());
    points = distinct(points, random);
    for (const std::size_t k : {1u, 4u, 64u}) {
      CAPTURE(set.name);
      CAPTURE(k);
      const rbpa::Hierarchy direct = rbpa::hrbpa(points, 1, {.leaf_capacity = k});
      if (direct.levels.empty()) continue;  // on a line
      const std::vector<Leaf> leaves = quadtree(points, k);
      Real smallest = leaves[0].side;
      for (const Leaf& leaf : leaves) smallest = std::min(smallest, leaf.side);
      CHECK(rbpa::paper::minimal_radius(leaves) == std::max(double(smallest / 2), 0x1p-1074));
      if (is_lost_in_rounding(direct.least_radius, points)) continue;
      CHECK(rbpa::paper::minimal_radius(leaves) == direct.least_radius);
      ++sets;
    }
  }
  CHECK(sets > 100);
}

TEST_CASE("squares are cut until their corners coincide, for a pair as close as doubles can be, near 0 and far out") {
  const std::vector<Leaf> deep = quadtree(Points{{0, 0}, {5e-324, 0}, {1, 1}}, 1);
  CHECK(rbpa::paper::minimal_radius(deep) == 5e-324);
  CHECK(deep.size() > 3000);
  // Near 1, long double has no number for the right side of so small a square.
  const std::vector<Leaf> shallow = quadtree(Points{{1, 0}, {1, 5e-324}, {0, 0}}, 1);
  CHECK(std::count_if(shallow.begin(), shallow.end(), [](const Leaf& leaf) { return leaf.points == 2; }) == 1);
  CHECK(rbpa::paper::minimal_radius(shallow) < 1e-18);
  CHECK(rbpa::paper::minimal_radius(shallow) > 1e-40);
}

TEST_SUITE_END();
