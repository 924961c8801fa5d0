#include "rbpa/plane/contours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "rbpa/base/error.h"
#include "support/arguments.h"
#include "support/delaunay_arrays.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::Contour;
using rbpa::Point;

TEST_SUITE_BEGIN("contours");

namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;

/// Returns each side of the triangles, the lower index first, with the number of its triangles.
std::map<Side, int> sides_of(const AlphaComplex& of) {
  std::map<Side, int> sides;
  for (const auto& t : of.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  return sides;
}

bool is_same(const rbpa::Contours& a, const rbpa::Contours& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contour& s, const Contour& t) {
    return s.level == t.level && s.is_closed == t.is_closed && std::ranges::equal(s.points, t.points);
  });
}

/// Calls visit(a, b) for each segment of the lines.
template <typename Lines, typename Visit>
void for_each_segment(const Lines& lines, Visit visit) {
  for (const Contour& line : lines)
    for (std::size_t k = 0; k + (line.is_closed ? 0 : 1) < line.points.size(); ++k)
      visit(line.points[k], line.points[(k + 1) % line.points.size()]);
}

/// Small sets on grids, with values 0, 1 and 2, so that each crossing of level 1 is exact: a point, or the middle of a
/// side; alpha leaves gaps.
struct Trial {
  Points points;
  std::vector<double> values;
  AlphaComplex of;

  explicit Trial(int number, int values_from = 3) {
    const auto seed = static_cast<std::uint64_t>(number);
    Random random(seed);
    points = random_grid(6, static_cast<std::size_t>(random.integer(3, 30)), false, seed);
    for (std::size_t i = 0; i < points.size(); ++i)
      values.push_back(values_from == 3 ? random.integer(0, 2) : 2 * random.integer(0, 1));
    of = rbpa::alpha_complex(points, random.integer(0, 1) ? 1.2 : 100.0, {.neighbors = true});
  }
};

}  // namespace

TEST_CASE("lines pass each side between lower and higher points once, and end only on the boundary") {
  std::size_t closed = 0, open = 0;
  for (int seed = 0; seed < trials(400); ++seed) {
    const Trial trial(seed, 2);
    std::map<Point, int> crossings;  // middle of each crossed side, and its number of triangles
    for (const auto& side : sides_of(trial.of)) {
      const auto [a, b] = side.first;
      const Point &p = trial.points[a], &q = trial.points[b];
      if (trial.values[a] != trial.values[b]) crossings[{(p.x + q.x) / 2, (p.y + q.y) / 2}] = side.second;
    }
    const double level = 1;
    for (const Contour& line : rbpa::contours(trial.points, trial.of, trial.values, std::span(&level, 1))) {
      (line.is_closed ? closed : open) += 1;
      for (std::size_t k = 0; k < line.points.size(); ++k) {
        const auto at = crossings.find(line.points[k]);
        REQUIRE(at != crossings.end());
        const bool is_end = !line.is_closed && (k == 0 || k + 1 == line.points.size());
        CHECK(at->second == (is_end ? 1 : 2));
        crossings.erase(at);
      }
    }
    CHECK(crossings.empty());
  }
  CHECK(closed > 10);
  CHECK(open > 50);
}

TEST_CASE("lines do not cross, have higher points on their left, and none is shorter than its two ends") {
  for (int seed = 0; seed < trials(400); ++seed) {
    const Trial trial(seed);
    const double level = 1;
    const auto lines = rbpa::contours(trial.points, trial.of, trial.values, std::span(&level, 1));
    std::vector<std::pair<Point, Point>> segments;
    for_each_segment(lines, [&](const Point& a, const Point& b) {
      CHECK(!(a == b));
      segments.emplace_back(a, b);
    });
    const auto side = [](const auto& s, const Point& p) { return exact::orientation(s.first, s.second, p); };
    for (const auto& s : segments)
      for (const auto& t : segments)
        CHECK_FALSE((side(s, t.first) * side(s, t.second) < 0 && side(t, s.first) * side(t, s.second) < 0));
    // A corner of the triangle of a segment is on its left exactly if it is higher.
    for (const auto& s : segments) {
      const Point middle{(s.first.x + s.second.x) / 2, (s.first.y + s.second.y) / 2};
      for (const auto& t : trial.of.triangles) {
        const auto at = [&](std::size_t k) -> const Point& { return trial.points[t[k % 3]]; };
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) inside = inside && exact::orientation(at(k), at(k + 1), middle) > 0;
        for (std::size_t k = 0; inside && k < 3; ++k) {
          if (trial.values[t[k]] > 1) CHECK(side(s, at(k)) > 0);
          if (trial.values[t[k]] < 1) CHECK(side(s, at(k)) < 0);
        }
      }
    }
  }
}

TEST_CASE("a point whose value is the level is above it: the line is the limit of lower ones") {
  for (int seed = 0; seed < trials(400); ++seed) {
    const Trial trial(seed);
    const double level = 1, lower = 1 - 0x1p-40;
    const auto limit = rbpa::contours(trial.points, trial.of, trial.values, std::span(&level, 1));
    auto near = rbpa::contours(trial.points, trial.of, trial.values, std::span(&lower, 1));
    const auto moved = [&](const Point& p) {  // to multiples of 1/2, on which all points of the limit are
      return Point{std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
    };
    std::multiset<std::pair<Point, Point>> expected, found;
    for_each_segment(near, [&](const Point& a, const Point& b) {
      if (!(moved(a) == moved(b))) expected.insert({moved(a), moved(b)});
    });
    for_each_segment(limit, [&](const Point& a, const Point& b) { found.insert({a, b}); });
    CHECK(found == expected);
  }
}

TEST_CASE("lines of a plane are straight, and rings around a cone have the radius of their level") {
  const Points points = uniform(2000, 11);
  const AlphaComplex of = delaunay_arrays(points);
  std::vector<double> plane, cone;
  for (const Point& p : points) {
    plane.push_back(3 * p.x - 4 * p.y);
    cone.push_back(-std::hypot(p.x - 22, p.y - 22));
  }
  const std::vector<double> levels = {-40, 0, 40};
  const auto straight = rbpa::contours(points, of, plane, levels);
  CHECK(straight.size() >= 3);
  for (const Contour& line : straight)
    for (const Point& p : line.points)
      CHECK(3 * p.x - 4 * p.y == doctest::Approx(levels[line.level]).epsilon(1e-12).scale(40));
  const std::vector<double> radii = {-15, -10};
  const auto rings = rbpa::contours(points, of, cone, radii);
  REQUIRE(rings.size() == 2);
  for (const Contour& ring : rings) {
    CHECK(ring.is_closed);
    CHECK(ring.points.front() == *std::min_element(ring.points.begin(), ring.points.end()));
    double area = 0;
    for_each_segment(std::span(&ring, 1), [&](const Point& a, const Point& b) { area += (a.x * b.y - a.y * b.x) / 2; });
    const double radius = radii[ring.level];
    CHECK(area == doctest::Approx(3.14159 * radius * radius).epsilon(0.02));  // positive: counter-clockwise
  }
}

TEST_CASE("shuffled points and any number of threads have the same lines, on sets of every kind") {
  Random random(5);
  std::size_t lines = 0;
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    Points points = set.first(3000);
    const auto values_of = [](const Points& at) {
      std::vector<double> values;
      for (const Point& p : at) values.push_back(std::fmod(std::abs(p.x), 5.0) + std::fmod(std::abs(p.y), 3.0));
      return values;
    };
    const std::vector<double> levels = {0.5, 1, 2, 3.25, 6};
    const auto first = rbpa::contours(points, delaunay_arrays(points), values_of(points), levels, {.threads = 1});
    random.shuffle(points);
    const AlphaComplex again = delaunay_arrays(points);
    for (const unsigned threads : {2U, 7U})
      CHECK(is_same(first, rbpa::contours(points, again, values_of(points), levels, {.threads = threads})));
    lines += first.size();
  }
  CHECK(lines > 1000);
}

TEST_CASE("values and levels of any size work, and wrong ones are refused") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Points points = {{0, 0}, {4, 0}, {0, 4}};
  const AlphaComplex of = delaunay_arrays(points);
  const auto line = [&](std::vector<double> values, double level) {
    const auto lines = rbpa::contours(points, of, values, std::span(&level, 1));
    REQUIRE(lines.size() == 1);
    return Points(lines[0].points.begin(), lines[0].points.end());
  };
  CHECK(line({-most, most, most}, 0) == Points{{0, 2}, {2, 0}});  // higher points are on the left
  CHECK(line({most, -most, -most}, 0) == Points{{2, 0}, {0, 2}});
  CHECK(line({0, 4 * least, 4 * least}, 2 * least) == Points{{0, 2}, {2, 0}});
  CHECK(line({3 * least, 5 * least, 5 * least}, 5 * least) == Points{{0, 4}, {4, 0}});
  const std::vector<double> values = {0, 1, 2}, none = {}, falling = {2, 1}, twice = {1, 1}, nan = {0, NAN, 1};
  CHECK(rbpa::contours(points, of, values, std::vector<double>{0, 2.5}).empty());  // 0 is the least: all is above
  CHECK(rbpa::contours({}, AlphaComplex{}, none, values).empty());
  for (const auto& levels : {falling, twice, nan})
    CHECK_THROWS_AS(rbpa::contours(points, of, values, levels), rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(rbpa::contours(points, of, nan, values), "values: value 1 is nan, expected a finite number",
                       rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::contours(points, of, none, values), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::contours(points, of, values, values, {.go_on = [] { return false; }}), rbpa::Cancelled);
  CHECK(rbpa::levels_every(0.5, std::vector<double>{-0.5, 1.2}) == std::vector<double>{0, 0.5, 1});
  CHECK(rbpa::levels_every(5, std::vector<double>{1, 4}).empty());
  CHECK(rbpa::levels_every(5, none).empty());
  for (const double step : {0.0, -1.0, 1e-6, 1e-300, std::nan("")})
    CHECK_THROWS_AS(rbpa::levels_every(step, values), rbpa::InvalidInput);
}

TEST_SUITE_END();
