// Leaves of points, compared with their specification.
#include "rbpa/space/solid/tiles/leaves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "support/arguments.h"
#include "support/space_sets.h"

using rbpa::Point3;
using rbpa::space::Box;
using rbpa::space::Leaf;
using rbpa::space::Leaves;
using rbpa::space::Place;
using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

TEST_CASE("every distinct point is one site, in the box of its leaf and in its cell") {
  Random random(3171);
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(static_cast<std::size_t>(SpaceKind::nearest)));
    Points3 points = space_set(kind, 1 + random.below(2000), random);
    for (std::size_t copies = random.below(60); copies > 0; --copies)
      points.push_back(points[random.below(8) % points.size()]);
    random.shuffle(points);
    CAPTURE(name(kind));
    rbpa::Threads threads(static_cast<unsigned>(1 + random.below(2)));
    const Leaves leaves(points, 1 + random.below(300), threads);

    using Key = std::tuple<double, double, double>;
    const auto key = [](const Point3& p) { return Key{p.x + 0.0, p.y + 0.0, p.z + 0.0}; };
    std::map<Key, std::uint32_t> lowest;
    for (std::uint32_t i = 0; i < points.size(); ++i) lowest.emplace(key(points[i]), i);
    std::set<std::uint32_t> named;
    for (std::size_t l = 0; l < leaves.size(); ++l) {
      const Leaf& leaf = leaves[l];
      std::size_t cell = 0;
      for (Place i = leaf.first; i < leaf.end; ++i) {
        const Point3& p = leaves.point(i);
        CHECK(lowest.at(key(p)) == leaves.index()[i]);
        CHECK(named.insert(leaves.index()[i]).second);
        CHECK(leaf.box.meets({p, p}));
        std::array<int, 3> at = {leaf.grid.along_x(p.x), leaf.grid.along_y(p.y), leaf.grid.along_z(p.z)};
        for (std::size_t k = 0; k < 3; ++k) at[k] = std::clamp(at[k], 0, leaf.cells[k] - 1);
        const auto of = static_cast<std::size_t>((at[0] * leaf.cells[1] + at[1]) * leaf.cells[2] + at[2]);
        REQUIRE(of >= cell);
        cell = of;
        CHECK(leaves.first_in(leaf, cell) <= i);
        CHECK(i < leaves.first_in(leaf, cell + 1));
      }
    }
    CHECK(named.size() == lowest.size());
    CHECK(leaves.distinct() == lowest.size());
    const auto duplicates = leaves.duplicates();
    REQUIRE(duplicates.size() == points.size() - lowest.size());
    for (std::size_t i = 0; i < duplicates.size(); ++i) {
      CHECK((i == 0 || duplicates[i - 1].index < duplicates[i].index));
      CHECK(duplicates[i].stands_for == lowest.at(key(points[duplicates[i].index])));
      CHECK(duplicates[i].stands_for != duplicates[i].index);
    }
    // Leaves that a box touches.
    const Point3 &p = points[random.below(points.size())], &q = points[random.below(points.size())];
    const Box box = {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                     {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
    std::vector<std::size_t> touched, expected;
    leaves.for_each_leaf(box, [&](std::size_t i) { touched.push_back(i); });
    for (std::size_t l = 0; l < leaves.size(); ++l)
      if (leaves[l].box.meets(box)) expected.push_back(l);
    CHECK(touched == expected);
  }
}

TEST_CASE("a few far points do not make the cells of the others larger") {
  Random random(3173);
  rbpa::Threads one;
  Points3 points = space_set(SpaceKind::cube, 5'000, random);
  const double size = Leaves(points, 10'000, one)[0].grid.size;
  points.push_back({1e6, -1e5, 3e7});
  points.push_back({-1e9, 1e5, 3});
  const Leaves leaves(points, 10'000, one);
  CHECK(leaves[0].grid.size < 1.15 * size);
  CHECK(leaves.crowding() < 3.5);
}

TEST_CASE("evenly spread points are not crowded") {
  Random random(3172);
  rbpa::Threads one;
  const Leaves even(space_set(SpaceKind::cube, 20'000, random), 4096, one);
  CHECK(even.crowding() > 2);
  CHECK(even.crowding() < 3.5);
  const Leaves uneven(space_set(SpaceKind::clusters, 20'000, random), 4096, one);
  CHECK(uneven.crowding() > 5);
}

TEST_SUITE_END();
