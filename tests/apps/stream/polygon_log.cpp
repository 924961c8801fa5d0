// Polygons come out in order, however few of them fit into memory.
#include <doctest/doctest.h>

#include <algorithm>
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

/// Writes all that it is given into numbers.
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

TEST_CASE("polygons of any size, with any memory, after any stop") {
  rbpa_test::Random random(1);
  const auto ring = [&](std::size_t corners) {
    rbpa::CornerRing made;
    for (std::size_t i = 0; i < corners; ++i)
      made.push_back({i, {double(random.below(1'000'000)), double(random.below(1'000'000))}});
    return made;
  };
  std::vector<CornerPolygon> polygons;
  for (int i = 0; i < 3000; ++i) {
    const bool is_large = i % 300 == 7;  // some stay in the log until it is their turn
    CornerPolygon& polygon = polygons.emplace_back(CornerPolygon{
        .shell = ring(is_large ? 9000 : 3 + random.below(9)), .area = double(i), .perimeter = 0.5, .points = 7});
    for (std::size_t hole = random.below(4); hole > 0; --hole)
      polygon.holes.push_back(ring(3 + random.below(is_large ? 5000 : 5)));
  }
  const apps_test::Folder folder;
  StreamRequest request;
  request.scratch = folder.path("s");
  const Scratch scratch(request);
  LogState state;
  {
    PolygonLog log(scratch);
    log.add(std::span(polygons).first(2000));
    state = log.flush();
    log.add(polygons);  // and killed
    log.flush();
  }
  PolygonLog log(scratch);
  log.resume(state);
  log.add(std::span(polygons).subspan(2000));
  log.flush();

  std::sort(polygons.begin(), polygons.end(), rbpa::comes_before);
  Taking expected;
  give(expected, polygons);
  for (const std::uint64_t memory : {150'000U, 1'000'000U, 1'000'000'000U}) {
    CAPTURE(memory);
    Taking found;
    log.sorted(memory, found);
    CHECK(found.numbers == expected.numbers);
  }

  std::string bytes = folder.content("s/polygons");
  bytes[bytes.size() - 3] = char(bytes[bytes.size() - 3] ^ 1);
  replace_content(scratch.polygons(), bytes);
  Taking found;
  CHECK_THROWS_AS(log.sorted(1'000'000, found), Failure);
}
