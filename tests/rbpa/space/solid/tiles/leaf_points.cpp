// The points of a leaf and around it, compared with all points.
#include "rbpa/space/solid/tiles/leaf_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "support/arguments.h"
#include "support/solid_sets.h"
#include "support/space_sets.h"

using rbpa::Point3;
using rbpa::space::Box;
using rbpa::space::Leaf;
using rbpa::space::Leaves;
using rbpa::space::Place;
using rbpa::space::Tile;
using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

TEST_CASE("a tile has the points of its cells and no others") {
  Random random(3181);
  rbpa::Threads one;
  Tile tile;
  std::size_t known = 0, unknown = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(static_cast<std::size_t>(SpaceKind::nearest)));
    const Points3 points = space_set(kind, 50 + random.below(1500), random);
    CAPTURE(name(kind));
    const Leaves leaves(points, 20 + random.below(300), one);
    const std::size_t l = random.below(leaves.size());
    const Leaf& leaf = leaves[l];
    if (leaf.first == leaf.end || !tile.gather(leaves, l)) continue;
    const auto cell_of = [&](const Point3& p) {
      return std::array<int, 3>{leaf.grid.along_x(p.x) + Tile::margin, leaf.grid.along_y(p.y) + Tile::margin,
                                leaf.grid.along_z(p.z) + Tile::margin};
    };
    std::vector<Place> expected, found, own;
    for (std::size_t i = 0; i < leaves.size(); ++i)
      for (Place place = leaves[i].first; place < leaves[i].end; ++place) {
        const auto cell = cell_of(leaves.point(place));
        bool is_in = true;
        for (std::size_t k = 0; k < 3; ++k) is_in = is_in && 0 <= cell[k] && cell[k] < tile.cells()[k];
        if (is_in) expected.push_back(place);
      }
    const auto cells = static_cast<std::size_t>(tile.cells()[0] * tile.cells()[1] * tile.cells()[2]);
    for (std::size_t c = 0; c < cells; ++c)
      for (Tile::Local i = tile.first_in(c); i < tile.first_in(c + 1); ++i) {
        found.push_back(tile.place(i));
        const Point3& p = leaves.point(tile.place(i));
        CHECK((tile.x(i) == p.x && tile.y(i) == p.y && tile.z(i) == p.z));
        const auto at = cell_of(p);
        CHECK(tile.cell(at[0], at[1], at[2]) == c);
        CHECK(tile.is_own(i) == (leaf.first <= tile.place(i) && tile.place(i) < leaf.end));
        if (tile.is_own(i)) own.push_back(tile.place(i));
      }
    CHECK(found.size() == tile.size());
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
    REQUIRE(!own.empty());
    CHECK(2 * own.size() > leaf.end - leaf.first);
    std::sort(own.begin(), own.end());

    // Boxes near the leaf.
    for (int i = 0; i < 20; ++i) {
      const Point3& p = leaves.point(own[random.below(own.size())]);
      const double reach = leaf.grid.size * (random.below(8) == 0 ? 1e6 : 4 * random.unit());
      const Box box = {{p.x - reach, p.y - reach, p.z - reach}, {p.x + reach, p.y + reach, p.z + reach}};
      std::array<Tile::Range, 3> ranges;
      if (!tile.ranges(box, ranges)) {
        ++unknown;
        continue;
      }
      ++known;
      std::size_t in_box = 0, in_cells = 0;
      for (std::size_t other = 0; other < leaves.size(); ++other)
        for (Place place = leaves[other].first; place < leaves[other].end; ++place) {
          const Point3& q = leaves.point(place);
          in_box += box.meets({q, q}) ? 1u : 0u;
        }
      for (int x = ranges[0].low; x <= ranges[0].high; ++x)
        for (int y = ranges[1].low; y <= ranges[1].high; ++y)
          for (int z = ranges[2].low; z <= ranges[2].high; ++z)
            for (Tile::Local k = tile.first_in(tile.cell(x, y, z)); k < tile.first_in(tile.cell(x, y, z) + 1); ++k) {
              const Point3& q = leaves.point(tile.place(k));
              in_cells += box.meets({q, q}) ? 1u : 0u;
            }
      CHECK(in_cells == in_box);
    }
  }
  CHECK(known > 100);
  CHECK(unknown > 20);
}

TEST_CASE("a tile with cells as small as rounding, or with too many points, is refused") {
  rbpa::Threads one;
  Tile tile;
  Points3 points;
  for (int i = 0; i < 64; ++i)
    points.push_back({1 + (i % 4) * 0x1p-52, 1 + (i / 4 % 4) * 0x1p-52, 1 + (i / 16) * 0x1p-52});
  CHECK(!tile.gather(Leaves(points, 1000, one), 0));
  for (Point3& p : points) p = {(p.x - 1) * 0x1p52, (p.y - 1) * 0x1p52, (p.z - 1) * 0x1p52};
  CHECK(tile.gather(Leaves(points, 1000, one), 0));
  CHECK(tile.size() == 64);
  const Points3 many = uniform_cube(Tile::most_points + 1, 3182);
  CHECK(!tile.gather(Leaves(many, many.size(), one), 0));
}

TEST_SUITE_END();
