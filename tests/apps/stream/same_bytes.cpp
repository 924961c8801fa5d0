// `rbpa stream` makes the bytes of mesh and shape, for any tiles.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "robustness/moments.h"
#include "stream/runs.h"
#include "support/generate.h"
#include "support/las_file.h"
#include "support/pictures.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/spacing.h"

using namespace stream_test;
using apps_test::Folder;
using rbpa::Point;
using Points = std::vector<Point>;

namespace {

void check_all_tiles(const Points& points, double alpha, const std::vector<std::uint64_t>& sizes,
                     const rbpa::app::AreaArguments& areas = {}) {
  CAPTURE(alpha);
  if (alpha == 0) return;  // half of the least double is not a radius
  const Folder folder("p.f64xy", raw(points));
  const Made expected = wanted(folder, "p.f64xy", alpha, areas);
  for (const std::uint64_t size : sizes) {
    CAPTURE(size);
    CHECK(streamed(folder, {"p.f64xy"}, alpha, {.tile_size = size, .areas = areas}) == expected);
  }
}

}  // namespace

TEST_CASE("generated sets have the same bytes in tiles of a few points and of more") {
  std::size_t number = 0;
  for (const rbpa_test::NamedSet& set : rbpa_test::generated_sets()) {
    if (robustness::moments() <= 8 && number++ % 3 != 0) continue;
    CAPTURE(set.name);
    const Points points = set.make();
    if (points.empty()) continue;  // an empty file is not a file of points
    const double spacing = rbpa_test::mean_spacing(points);
    std::vector<double> alphas = set.alphas;
    alphas.push_back(spacing);
    if (robustness::moments() > 8)
      alphas.insert(alphas.end(), {0.5 * spacing, 2 * spacing, 10 * spacing});
    else if (alphas.size() > 2)
      alphas.erase(alphas.begin() + 1, alphas.end() - 1);
    for (const double alpha : alphas) {
      if (std::isinf(2 * alpha)) continue;
      // If alpha is large, a tile of few points has all the others around it; and thousands of files take long.
      const bool is_wide = alpha > 4 * spacing && points.size() > 200;
      const std::uint64_t size = is_wide ? points.size() / 7 + 1 : points.size() > 60 ? points.size() / 12 : 5;
      check_all_tiles(points, alpha, {size});
    }
  }
}

TEST_CASE("points on borders and corners of tiles, with circles through corners, give the same bytes") {
  Points points;
  for (int x = -20; x < 20; ++x)
    for (int y = -20; y < 20; ++y)
      if ((x * 7 + y * 3) % 11 != 0) points.push_back({double(x), double(y)});
  for (const double alpha : {std::sqrt(0.5), 1.0}) check_all_tiles(points, alpha, {4, 64});
  check_all_tiles(points, 3.0, {100});
}

TEST_CASE("a dense cell, few far points, empty tiles and a ring around everything give the same bytes") {
  rbpa_test::Random random(5);
  const auto some = [&](double from, double to) {
    return from + (to - from) * double(random.below(1U << 30U)) / double(1U << 30U);
  };
  Points points;
  for (int i = 0; i < 3000; ++i) points.push_back({some(0, 1e-6), some(0, 1e-6)});
  for (int i = 0; i < 400; ++i) points.push_back({some(-1000, 1000), some(-1000, 1000)});
  points.push_back({1e18, -1e18});
  for (const double alpha : {1e-7, 60.0}) check_all_tiles(points, alpha, {100, 1500});

  Points ring;
  for (int i = 0; i < 4000; ++i) {
    const double turn = some(0, 2 * M_PI), radius = some(90, 110);
    ring.push_back({radius * std::cos(turn), radius * std::sin(turn)});
  }
  for (int i = 0; i < 300; ++i) ring.push_back({some(-10, 10), some(-10, 10)});
  check_all_tiles(ring, 2.5, {3, 40});
}

TEST_CASE("one polygon in all tiles, with thousands of holes, has the same bytes") {
  rbpa_test::Random random(8);
  Points points;
  for (int i = 0; i < 40'000; ++i)
    points.push_back({double(random.below(1U << 24U)) / (1U << 24U), double(random.below(1U << 24U)) / (1U << 24U)});
  check_all_tiles(points, 0.0048, {400, 3000});
}

TEST_CASE(
    "small holes and parts are left out as by shape, with pinches, islands in holes, duplicates and points in holes") {
  rbpa_test::Random random(31);
  for (int run = 0; run < 6; ++run) {
    Points points = run < 3 ? rbpa_test::random_grid(16, 150, true, random.bits())
                            : rbpa_test::points_of(rbpa_test::random_picture(12, 12, 0.6, random));
    const double alpha = run < 3 ? 0.75 : rbpa_test::picture_alpha;
    for (int i = 0; i < 12; ++i) points.push_back({2.0 * random.integer(0, 11) + 1, 2.0 * random.integer(0, 11) + 1});
    for (int i = 0; i < 20; ++i) points.push_back(points[random.below(points.size())]);
    for (const char* hole : {"0", "1.5", "4.5", "inf"})
      for (const char* part : {"0", "1.5", "20", "inf"}) {
        CAPTURE(hole);
        CAPTURE(part);
        check_all_tiles(points, alpha, {20}, {hole, part});
      }
  }
}

TEST_CASE("coordinates at both ends of double, and both zeros, give the same bytes") {
  Points points;
  for (const double scale : {0x1p-1060, 1.0, 0x1p1000})
    for (int x = -4; x <= 4; ++x)
      for (int y = -4; y <= 4; ++y) points.push_back({x * scale, y == 0 ? -0.0 : y * scale});
  for (const double alpha : {0x1p-1060, 1.0, 0x1p1000}) check_all_tiles(points, alpha, {3, 1000});
}

TEST_CASE("files of several kinds, cut at random, with one point in several, give the same bytes with any threads") {
  rbpa_test::Random random(6);
  Points points;
  for (int i = 0; i < 6000; ++i) points.push_back({double(random.below(4000)) / 100, double(random.below(4000)) / 100});
  for (int i = 0; i < 500; ++i) points.push_back(points[random.below(points.size())]);
  const Folder folder("p.f64xy", raw(points));
  const Made expected = wanted(folder, "p.f64xy", 0.9);

  for (int round = 0; round < 4; ++round) {
    std::size_t cuts[] = {random.below(points.size()), random.below(points.size()), random.below(points.size())};
    std::sort(std::begin(cuts), std::end(cuts));
    const auto part = [&](std::size_t from, std::size_t to) { return std::span(points).subspan(from, to - from); };
    folder.file("a.f64xy", raw(part(0, cuts[0])));
    std::string text = "x;y;z\n";
    for (const Point& p : part(cuts[0], cuts[1])) text += std::to_string(p.x) + ";" + std::to_string(p.y) + ";7\n";
    folder.file("b.csv", text);
    apps_test::LasFile las;
    for (const Point& p : part(cuts[1], cuts[2]))
      las.points.push_back({.x = int(std::lround(p.x * 100)), .y = int(std::lround(p.y * 100))});
    folder.file("c.las", apps_test::bytes_of(las));
    folder.file("d.f64xy", raw(part(cuts[2], points.size())));
    if (cuts[0] == 0 || cuts[2] == points.size()) continue;  // an empty file is refused
    for (const unsigned threads : {1U, 3U})
      CHECK(streamed(folder, {"a.f64xy", "b.csv", "c.las", "d.f64xy"}, 0.9, {.tile_size = 300, .threads = threads}) ==
            expected);
  }
}

TEST_CASE("shuffled points give the same polygons") {
  rbpa_test::Random random(7);
  Points points;
  for (int i = 0; i < 3000; ++i) points.push_back({double(random.below(60)), double(random.below(60))});
  const Folder folder("p.f64xy", raw(points));
  const Made expected = wanted(folder, "p.f64xy", 0.75);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  folder.file("q.f64xy", raw(points));
  const Made made = streamed(folder, {"q.f64xy"}, 0.75, {.tile_size = 50});
  CHECK(made.polygons == expected.polygons);
  CHECK(made.text == expected.text);
  CHECK(made.triangles == wanted(folder, "q.f64xy", 0.75).triangles);
}

TEST_CASE("sets of others give the same bytes") {
  for (const char* name : {"lidar_strip_1000.xy", "shape_smap_dstorm.xy", "geo_us_zipcodes.xy",
                           "shape_hdbscan_clusterable.xy", "rob_delaunator_issue43.xy", "rob_jts_concavehull_155.xy"}) {
    CAPTURE(name);
    const std::string path = std::string(RBPA_TEST_DATA) + "/" + name;
    const Folder folder("p.xy", apps_test::read_file(path));
    const Points points = [&] {
      std::ifstream file(path);
      Points all;
      for (Point p; file >> p.x >> p.y;) all.push_back(p);
      return all;
    }();
    const double spacing = rbpa_test::mean_spacing(points);
    for (const double factor : {1.0, 3.0}) {
      const Made expected = wanted(folder, "p.xy", factor * spacing);
      CHECK(streamed(folder, {"p.xy"}, factor * spacing, {.tile_size = points.size() / 30 + 1}) == expected);
    }
  }
}
