// Who does the tasks, and in which order, changes nothing: the bytes of mesh and shape.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "robustness/moments.h"
#include "stream/runs.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/spacing.h"
#include "tasks/lists.h"

using namespace tasks_test;
using apps_test::Folder;
using rbpa::Point;
using stream_test::Made;
using Points = std::vector<Point>;
namespace fs = std::filesystem;

namespace {

template <typename T>
void shuffle(std::vector<T>& values, rbpa_test::Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

Made wanted_of(const Folder& folder, const Points& points, double alpha) {
  folder.file("p.f64xy", stream_test::raw(points));
  return stream_test::wanted(folder, "p.f64xy", alpha);
}

/// All tasks, some of them twice.
void run_all(const Folder& folder, rbpa_test::Random& random) {
  for (std::vector<std::string>& list : lists_in(folder.path("tasks"))) {
    for (std::size_t i = list.size() / 8; i > 0; --i) list.push_back(list[random.below(list.size())]);
    shuffle(list, random);
    for (const std::string& line : list) run_line(line);
  }
}

void check(const Points& points, double alpha, std::uint64_t tile_size, rbpa_test::Random& random) {
  const Folder folder;
  const Made wanted = wanted_of(folder, points, alpha);
  cut(folder, alpha, tile_size);
  run_all(folder, random);
  CHECK(stream_test::take(folder) == wanted);
}

/// Points with holes and islands in many tiles.
Points some_points(std::uint64_t seed, unsigned size) {
  rbpa_test::Random random(seed);
  Points points;
  for (unsigned i = 0; i < size * size * 3 / 2; ++i)
    points.push_back({double(random.below(size)), double(random.below(size))});
  return points;
}

}  // namespace

TEST_CASE("generated sets give the same bytes with the tasks of a list in any order, some twice") {
  rbpa_test::Random random(31);
  std::size_t number = 0;
  for (const rbpa_test::NamedSet& set : rbpa_test::generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    if (points.empty() || (robustness::moments() <= 8 && number++ % 7 != 0)) continue;
    const double spacing = rbpa_test::mean_spacing(points);
    std::vector<double> alphas = {1.5 * spacing};
    if (robustness::moments() > 8) alphas.insert(alphas.end(), set.alphas.begin(), set.alphas.end());
    for (const double alpha : alphas) {
      CAPTURE(alpha);
      if (!(alpha > 0) || std::isinf(2 * alpha)) continue;
      check(points, alpha, points.size() / 18 + 5, random);
    }
  }
}

TEST_CASE("sets of others give the same bytes") {
  rbpa_test::Random random(32);
  for (const char* name : {"lidar_strip_1000.xy", "shape_smap_dstorm.xy", "shape_hdbscan_clusterable.xy"}) {
    CAPTURE(name);
    std::ifstream file(std::string(RBPA_TEST_DATA) + "/" + name);
    Points points;
    for (Point p; file >> p.x >> p.y;) points.push_back(p);
    REQUIRE(points.size() > 100);
    check(points, 2 * rbpa_test::mean_spacing(points), points.size() / 25 + 1, random);
  }
}

TEST_CASE("there are as many lists as merges need, and the tasks of a list need only lists before it") {
  const Folder folder;
  folder.file("p.f64xy", stream_test::raw(some_points(1, 50)));
  cut(folder, 0.75, 12);
  const auto lists = lists_in(folder.path("tasks"));
  REQUIRE(lists.size() == 4);  // hundreds of tiles, sixteen to a merge
  CHECK(lists[0].size() > 256);
  CHECK(lists.back().size() == 1);
  std::vector<std::string> there;
  for (const auto& entry : fs::directory_iterator(folder.path("tasks/tiles"))) there.push_back(entry.path());
  for (const std::vector<std::string>& list : lists) {
    std::vector<std::string> made;
    std::size_t inputs = 0;
    for (const std::string& line : list) {
      const std::vector<std::string> words = words_of(line);
      for (std::size_t i = 2; i < words.size(); ++i) {
        if (words[i] == "-o")
          made.push_back(words[++i]);
        else if (words[i].ends_with(".tile") || words[i].ends_with(".partial")) {
          ++inputs;
          CHECK(std::count(there.begin(), there.end(), words[i]) == 1);
        }
      }
    }
    CHECK(inputs == there.size());  // and each of them once
    std::erase_if(made, [](const std::string& name) { return !name.ends_with(".partial"); });
    there = made;
  }
}

TEST_CASE("partials merged in any groups and any order give the same bytes") {
  rbpa_test::Random random(33);
  const Folder folder;
  const Made wanted = wanted_of(folder, some_points(2, 100), 0.75);
  cut(folder, 0.75, 500);
  const auto lists = lists_in(folder.path("tasks"));
  for (const std::string& line : lists.front()) run_line(line);
  const std::vector<std::string> tiles = partials_of_tiles(folder.path("tasks"));
  REQUIRE(tiles.size() > 25);
  const std::vector<std::string> some(tiles.begin() + 3, tiles.begin() + 21);
  merge(some, {folder.path("tasks/partials/first.partial")});
  for (int round = 0; round < robustness::moments(); ++round) {
    std::vector<std::string> open = some;
    shuffle(open, random);
    merge(open, {folder.path("tasks/partials/other.partial")});
    for (const char* kind : {".partial", ".polygons", ".holes"}) {
      REQUIRE(folder.has(std::string("tasks/partials/first") + kind));
      const std::string other = folder.content(std::string("tasks/partials/other") + kind);
      std::string expected = folder.content(std::string("tasks/partials/first") + kind);
      // The head has the name of the file of polygons, and a checksum of itself.
      if (kind == std::string(".partial")) {
        const std::size_t end = expected.find('\n');
        REQUIRE(other.find('\n') == end);
        CHECK(other.substr(end) == expected.substr(end));
      } else {
        CHECK(other == expected);
      }
    }

    open = tiles;
    for (int step = 0; open.size() > 4; ++step) {
      shuffle(open, random);
      const std::size_t count = 1 + random.below(4);
      const std::vector<std::string> group(open.end() - static_cast<std::ptrdiff_t>(count), open.end());
      open.resize(open.size() - count);
      open.push_back(folder.path("step-" + std::to_string(round) + "-" + std::to_string(step) + ".partial"));
      merge(group, {open.back()});
    }
    merge(open, {folder.path("t.npy"), folder.path("p.geojson"), folder.path("p.wkt")}, folder.path("s.json"));
    CHECK(stream_test::take(folder) == wanted);
  }
}

TEST_CASE("one tile, and points without a triangle, give the same bytes") {
  rbpa_test::Random random(34);
  check({{0, 0}, {1, 0}, {0, 1}}, 1, 100, random);
  check({{0, 0}, {9, 0}, {0, 9}, {0, 0}}, 1, 1, random);
}

TEST_CASE("files of triangles read in several pieces give the same bytes") {
  rbpa_test::Random random(35);
  check(some_points(3, 240), 1.0, 200'000, random);  // more than a megabyte
}
