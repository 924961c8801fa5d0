// The parts of a stream: compressed blocks, tiles of the plane, counts in cells, files of tiles.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "stream/cell_counts.h"
#include "stream/pack_block.h"
#include "stream/plan_tiles.h"
#include "stream/tile_file.h"
#include "stream/tile_tree.h"
#include "support/program.h"
#include "support/random.h"

using namespace rbpa::app;
using rbpa::Point;
using rbpa::Region;

namespace {

/// Returns the size of the block. Checks that decompressing gives the same bits.
std::size_t compressed_size_of(const IndexedPoints& points) {
  PackingHint hint;
  std::string bytes;
  pack_block(points.points, points.indices, hint, bytes);
  IndexedPoints back;
  REQUIRE(unpack_block(bytes, back));
  CHECK(back.indices == points.indices);
  const auto same = [](const Point& a, const Point& b) {
    return std::bit_cast<std::uint64_t>(a.x) == std::bit_cast<std::uint64_t>(b.x) &&
           std::bit_cast<std::uint64_t>(a.y) == std::bit_cast<std::uint64_t>(b.y);
  };
  CHECK(std::equal(points.points.begin(), points.points.end(), back.points.begin(), back.points.end(), same));
  for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, bytes.size() / 2, bytes.size() - 1}) {
    IndexedPoints nothing;
    CHECK_FALSE(unpack_block(std::string_view(bytes).substr(0, cut), nothing));
  }
  return bytes.size();
}

double any_double(rbpa_test::Random& random) {
  const double value = std::bit_cast<double>(random.bits());
  return std::isfinite(value) ? value : 0.5;
}

}  // namespace

TEST_CASE("compressed blocks come back to the bit") {
  rbpa_test::Random random(1);
  const auto block = [&](std::size_t count, auto coordinate) {
    IndexedPoints points;
    for (std::size_t i = 0; i < count; ++i) {
      points.points.push_back({coordinate(), coordinate()});
      points.indices.push_back(i == 0 ? random.below(1'000'000'000'000) : points.indices.back() + 1 + random.below(9));
    }
    return points;
  };
  for (const std::size_t count : {1U, 2U, 63U, 4096U}) {
    // Centimeters within some hundred meters, far from the origin, take 2 · 16 bits and few for the index.
    const auto metres = block(count, [&] { return double(50'000'000 + std::int64_t(random.below(60'000))) / 100; });
    CHECK(compressed_size_of(metres) < 60 + count * 5);
    const auto whole = block(count, [&] { return double(random.below(1000)) * 64; });
    CHECK(compressed_size_of(whole) < 60 + count * 4);
    compressed_size_of(block(count, [&] { return any_double(random); }));
    compressed_size_of(block(count, [&] { return double(random.bits() >> 11U) / 0x1p53; }));
    compressed_size_of(block(count, [&] { return random.below(2) == 0 ? -0.0 : 0.0; }));
    compressed_size_of(block(count, [&] { return random.below(3) == 0 ? -0.0 : double(random.below(9)) / 10; }));
    compressed_size_of(
        block(count, [&] { return (random.below(2) == 0 ? 1 : -1) * std::numeric_limits<double>::max(); }));
    compressed_size_of(
        block(count, [&] { return double(random.below(5)) * std::numeric_limits<double>::denorm_min(); }));
    compressed_size_of(block(count, [&] { return (double(random.below(2000)) - 1000) / 1e15; }));
    compressed_size_of(block(count, [&] { return 0x1p51 + double(random.below(9)) - 4; }));
    compressed_size_of(block(count, [&] { return double(random.below(1000)) / 1000 + 1e9; }));
    compressed_size_of(block(count, [&] { return double(float(random.below(1000)) / 3); }));
  }
}

TEST_CASE("every point is in one tile, and reaches every tile near it") {
  rbpa_test::Random random(2);
  for (int round = 0; round < 50; ++round) {
    TileTree tree;
    const auto coordinate = [&] { return round % 2 == 0 ? double(random.below(64)) : any_double(random); };
    while (tree.tiles() < 20) {
      const Point p{coordinate(), coordinate()};
      const std::uint32_t tile = tree.tile_of(p);
      const bool x = random.below(2) == 0;
      const Region box = tree.box(tile);
      const double line = x ? p.x : p.y;
      if (line > (x ? box.x0 : box.y0))
        tree.cut(tile, x ? TileTree::Part::Kind::cut_x : TileTree::Part::Kind::cut_y, line);
    }
    const TileTree again(tree.parts());
    std::vector<std::uint32_t> order = tree.order();
    CHECK(order == again.order());
    std::sort(order.begin(), order.end());
    for (std::uint32_t tile = 0; tile < tree.tiles(); ++tile) {
      CHECK(order[tile] == tile);
      CHECK(again.box(tile) == tree.box(tile));
    }
    for (int i = 0; i < 100; ++i) {
      const Point p{coordinate(), coordinate()};
      const double reach = round % 3 == 0 ? double(random.below(9)) : std::abs(any_double(random));
      std::vector<std::uint32_t> near;
      tree.for_each_near(p, reach, [&](std::uint32_t tile) { near.push_back(tile); });
      std::sort(near.begin(), near.end());
      CHECK(std::adjacent_find(near.begin(), near.end()) == near.end());
      for (std::uint32_t tile = 0; tile < tree.tiles(); ++tile) {
        const Region& box = tree.box(tile);
        CHECK((tree.tile_of(p) == tile) == box.contains(p));
        // In long double the sum is exact, or so nearly that it does not matter here.
        using Long = long double;
        const bool is_near = Long(p.x) + reach >= box.x0 && Long(p.x) - reach <= box.x1 &&
                             Long(p.y) + reach >= box.y0 && Long(p.y) - reach <= box.y1;
        if (is_near && !(Long(p.x) - reach == box.x1 || Long(p.y) - reach == box.y1))
          CHECK(std::binary_search(near.begin(), near.end(), tile));
      }
    }
  }
}

TEST_CASE("counts add up in the allowed number of cells, for any points") {
  rbpa_test::Random random(3);
  for (int round = 0; round < 30; ++round) {
    CellCounts counts(100);
    std::uint64_t points = 0;
    for (int part = 0; part < 10; ++part) {
      std::vector<Point> some(random.below(300));
      for (Point& p : some)
        p = round % 3 == 0 ? Point{any_double(random), any_double(random)}
                           : Point{double(random.below(100)) * std::pow(10, part), -double(random.below(100))};
      counts.add(some);
      points += some.size();
    }
    CHECK(counts.points() == points);
    const std::vector<Cell> cells = counts.cells();
    CHECK(cells.size() <= 100);
    std::uint64_t sum = 0;
    for (const Cell& cell : cells) sum += cell.count;
    CHECK(sum == points);
  }
}

TEST_CASE("planned tiles are as small as required and not much smaller") {
  rbpa_test::Random random(4);
  std::vector<Point> points(100'000);
  for (Point& p : points) p = {double(random.below(1'000'000)) / 1000, double(random.below(1'000'000)) / 1000};
  CellCounts counts(20'000);
  counts.add(points);
  const TilePlan plan = plan_tiles(counts, {.points = 3000, .owned = 3000, .reach = 5});
  CHECK(plan.tree.tiles() < 90);
  std::vector<std::uint64_t> all(plan.tree.tiles());
  for (const Point& p : points) plan.tree.for_each_near(p, 5, [&](std::uint32_t tile) { ++all[tile]; });
  double sum = 0;
  for (const std::uint64_t count : all) {
    CHECK(count <= 3000);
    sum += double(count);
  }
  CHECK(std::abs(plan.points / sum - 1) < 0.02);
  CHECK_THROWS_AS(plan_tiles(counts, {.points = 3000, .owned = 3000, .reach = 500}), TooDense);
}

TEST_CASE("a file of a tile is read as written, or is damaged") {
  const apps_test::Folder folder;
  const std::string path = folder.path("t.tile");
  const Region box{0, -INFINITY, INFINITY, 50};
  rbpa_test::Random random(5);
  IndexedPoints points;
  TileWriter writer(path, box, 2);
  for (std::size_t i = 0; i < 20'000; ++i) {
    points.points.push_back({double(random.below(100)), double(random.below(100))});
    points.indices.push_back(3 * i);
    writer.add(points.points.back(), 3 * i, box.contains(points.points.back()));
    if (i % 7000 == 0) writer.flush();
  }
  const TileSummary summary = writer.finish();
  const auto read = [&](const Region& of, double alpha) {
    TileReader reader(path, of, alpha);
    CHECK(reader.summary() == summary);
    IndexedPoints found;
    while (reader.next(found)) continue;
    return found;
  };
  CHECK(read(box, 2).points == points.points);
  CHECK(read(box, 2).indices == points.indices);
  CHECK_THROWS_AS(read(Region{}, 2), Damaged);
  CHECK_THROWS_AS(read(box, 3), Damaged);

  const std::string whole = folder.content("t.tile");
  for (int i = 0; i < 200; ++i) {
    std::string changed = whole;
    const std::size_t at = random.below(whole.size());
    if (i % 4 == 0)
      changed.resize(at);
    else if (i % 4 == 1)
      changed += 'x';
    else
      changed[at] = char(changed[at] ^ char(1U << random.below(8)));
    folder.file("t.tile", changed);
    CHECK_THROWS_AS(read(box, 2), Damaged);
  }
  folder.file("t.tile", whole);
  CHECK(read(box, 2).points == points.points);
}
