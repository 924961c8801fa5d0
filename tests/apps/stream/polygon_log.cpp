// Polygons come out in order, also if few of them fit into memory.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "stream/polygon_log.h"
#include "stream/scratch_file.h"
#include "support/program.h"
#include "support/random.h"

using namespace rbpa::app;
using rbpa::Corner;
using rbpa::CornerPolygon;
using rbpa::Point;

namespace {

/// Collects everything that it is given as numbers.
class Taking final : public PolygonSink {
 public:
  void begin(const PolygonFacts& facts) override {
    numbers.insert(numbers.end(), {-1, facts.area, facts.perimeter, double(facts.holes), double(facts.points)});
  }
  void ring(std::span<const Point> points) override {
    numbers.push_back(-2);
    for (const Point& p : points) numbers.insert(numbers.end(), {p.x, p.y});
  }
  void end() override { numbers.push_back(-3); }
  void finish() override { numbers.push_back(-4); }

  std::vector<double> numbers = {};
};

void give(PolygonSink& sink, const std::vector<CornerPolygon>& polygons) {
  for (const CornerPolygon& polygon : polygons) {
    sink.begin({polygon.area, polygon.perimeter, polygon.holes.size(), polygon.points});
    const auto ring = [&](const rbpa::CornerRing& corners) {
      std::vector<Point> points;
      for (const Corner& corner : corners) points.push_back(corner.at);
      sink.ring(points);
    };
    ring(polygon.shell);
    for (const rbpa::CornerRing& hole : polygon.holes) ring(hole);
    sink.end();
  }
  sink.finish();
}

}  // namespace

TEST_CASE("polygons of any size, some with holes before them, are sorted with any memory, after any stop") {
  rbpa_test::Random random(1);
  const auto ring = [&](std::size_t corners) {
    rbpa::CornerRing made;
    for (std::size_t i = 0; i < corners; ++i)
      made.push_back({i, {double(random.below(1'000'000)), double(random.below(1'000'000))}});
    return made;
  };
  const auto ring_before = [](const rbpa::CornerRing& a, const rbpa::CornerRing& b) {
    return std::pair(a[0].at, a[1].at) < std::pair(b[0].at, b[1].at);
  };
  std::vector<CornerPolygon> polygons, added;
  std::vector<rbpa::TakenHoles> taken;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const bool is_large = i % 300 == 7;  // some stay in their file until it is their turn
    CornerPolygon& polygon = polygons.emplace_back(CornerPolygon{
        .shell = ring(is_large ? 9000 : 3 + random.below(9)), .area = double(i), .perimeter = 0.5, .points = 7});
    for (std::size_t hole = i == 1500 ? 2000 : random.below(4); hole > 0; --hole)
      polygon.holes.push_back(ring(3 + random.below(is_large ? 9000 : 5)));
    std::sort(polygon.holes.begin(), polygon.holes.end(), ring_before);

    CornerPolygon& rest = added.emplace_back(polygon);
    rest.holes.clear();
    for (const rbpa::CornerRing& hole : polygon.holes) {
      const std::uint64_t name = random.below(i % 2 == 0 ? 4 : 1);
      if (name == 0) {
        rest.holes.push_back(hole);
        continue;
      }
      const rbpa::ComponentName names = {random.below(2), name, i};
      taken.push_back({names, {hole}});
      ++rest.taken_holes;
      rest.names.push_back(names);
    }
    std::sort(rest.names.begin(), rest.names.end());
    rest.names.erase(std::unique(rest.names.begin(), rest.names.end()), rest.names.end());
  }
  CHECK(taken.size() > 1000);
  for (std::size_t i = taken.size(); i > 1; --i) std::swap(taken[i - 1], taken[random.below(i)]);

  const apps_test::Folder folder;
  StreamRequest request;
  request.scratch = folder.path("s");
  const Scratch scratch(request);
  LogState state;
  {
    PolygonLog log(scratch);
    log.add(std::span(taken).first(700));
    log.add(std::span(added).first(2000));
    state = log.flush();
    log.add(taken);  // and killed
    log.add(added);
    log.flush();
  }
  PolygonLog log(scratch);
  log.resume(state);
  log.add(std::span(taken).subspan(700));
  log.add(std::span(added).subspan(2000));
  log.flush();

  std::sort(polygons.begin(), polygons.end(), rbpa::comes_before);
  Taking expected;
  give(expected, polygons);
  for (const std::uint64_t memory : {150'000U, 1'000'000U, 1'000'000'000U}) {
    CAPTURE(memory);
    Taking found;
    log.sorted(memory, found);
    CHECK(found.numbers == expected.numbers);
    CHECK(std::filesystem::is_empty(folder.path("s/runs")));
  }

  for (const std::string& path : {scratch.polygons(), scratch.holes()}) {
    const std::string whole = scratch_content(path);
    std::string bytes = whole;
    bytes[bytes.size() - 3] = char(bytes[bytes.size() - 3] ^ 1);
    replace_content(path, bytes);
    Taking found;
    CHECK_THROWS_AS(log.sorted(1'000'000, found), BadInput);
    replace_content(path, whole);
  }
}

TEST_CASE("a hole without its polygon, and a polygon without its hole, are reported") {
  const rbpa::CornerRing ring = {{0, {0, 0}}, {1, {1, 0}}, {2, {0, 1}}};
  const std::vector<rbpa::TakenHoles> taken = {{{1, 2, 3}, {ring}}};
  for (const bool is_named : {false, true}) {
    const apps_test::Folder folder;
    StreamRequest request;
    request.scratch = folder.path("s");
    const Scratch scratch(request);
    PolygonLog log(scratch);
    CornerPolygon polygon{.shell = ring, .taken_holes = is_named ? 2U : 1U};
    if (is_named) polygon.names = {{1, 2, 3}};
    log.add(taken);
    log.add(std::span(&polygon, 1));
    log.flush();
    Taking found;
    CHECK_THROWS_AS(log.sorted(1'000'000, found), BadInput);
  }
}
