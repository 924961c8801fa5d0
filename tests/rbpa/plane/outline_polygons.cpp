#include "rbpa/plane/outline_polygons.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/pictures.h"
#include "support/polygon_laws.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::Polygon;
using rbpa::PolygonFilter;

TEST_SUITE_BEGIN("shape");

namespace {

/// Returns the polygons after checking every law.
std::vector<Polygon> checked(const Points& points, double alpha) {
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
  const std::vector<Polygon> polygons = rbpa::outline_polygons(complex);
  const std::string wrong = wrong_with_polygons(polygons, rbpa::triangles(complex), points);
  CHECK_MESSAGE(wrong.empty(), wrong, ", alpha ", literal(alpha));
  const rbpa::ComplexCounts counts = rbpa::count(complex);
  CHECK(polygons.size() == counts.solid_components);
  CHECK(rbpa::outline_polygons(points, rbpa::alpha_complex(points, alpha, {.neighbors = true})) == polygons);
  return polygons;
}

std::vector<Part> parts(const std::vector<Polygon>& polygons) {
  std::vector<Part> result;
  for (const Polygon& p : polygons) result.push_back({p.area, p.perimeter, p.holes.size()});
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Polygon> checked(const Picture& picture) {
  const std::vector<Polygon> polygons = checked(points_of(picture), picture_alpha);
  CHECK(parts(polygons) == parts_of(picture));
  return polygons;
}

/// Returns the number of points that the two rings share.
std::size_t touches(const rbpa::Ring& a, const rbpa::Ring& b) {
  return static_cast<std::size_t>(std::count_if(a.points.begin(), a.points.end(), [&](std::uint32_t p) {
    return std::find(b.points.begin(), b.points.end(), p) != b.points.end();
  }));
}

double sum_of_areas(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons) sum += p.area;
  return sum;
}

}  // namespace

TEST_CASE("without triangles there are no polygons") {
  CHECK(checked(Points{}, 1).empty());
  CHECK(checked({{0, 0}, {1, 0}, {2, 0}}, infinity).empty());
}

TEST_CASE("one triangle is one polygon, whatever the order of its points") {
  const std::vector<Polygon> polygons = checked({{0, 4}, {3, 0}, {0, 0}}, infinity);
  REQUIRE(polygons.size() == 1);
  CHECK(polygons[0].shell.points == std::vector<std::uint32_t>{2, 1, 0});
  CHECK(polygons[0].holes.empty());
  CHECK(polygons[0].area == 6);
  CHECK(polygons[0].perimeter == 12);
}

TEST_CASE("two triangles that touch in a point are two polygons") {
  const std::vector<Polygon> polygons = checked({{-2, -1}, {-2, 1}, {0, 0}, {2, -1}, {2, 1}}, 1.25);
  REQUIRE(polygons.size() == 2);
  CHECK(polygons[0].shell.points == std::vector<std::uint32_t>{0, 2, 1});
  CHECK(polygons[1].shell.points == std::vector<std::uint32_t>{2, 3, 4});
}

TEST_CASE("a band whose ends touch in a point is a shell and a hole that touches it there") {
  const std::vector<Polygon> polygons = checked({"##.",  //
                                                 "#.#",  //
                                                 "###"});
  REQUIRE(polygons.size() == 1);
  REQUIRE(polygons[0].holes.size() == 1);
  CHECK(touches(polygons[0].shell, polygons[0].holes[0]) == 1);
}

TEST_CASE("a hole that touches itself is two holes that touch") {
  const std::vector<Polygon> polygons = checked({"####",  //
                                                 "#.##",  //
                                                 "##.#",  //
                                                 "####"});
  REQUIRE(polygons.size() == 1);
  REQUIRE(polygons[0].holes.size() == 2);
  CHECK(touches(polygons[0].holes[0], polygons[0].holes[1]) == 1);
}

TEST_CASE("a chain of holes, with a shell among them, is cut at its touching points") {
  CHECK(checked({"######",  //
                 "#.#.##",  //
                 "##.#.#",  //
                 "#.##.#",  //
                 "###.##",  //
                 "######"})[0]
            .holes.size() == 6);
  CHECK(checked({".#####",  //
                 "#.####",  //
                 "##.###",  //
                 "###.##",  //
                 "####.#",  //
                 "#####."})
            .size() == 2);
}

TEST_CASE("an island in a hole is a polygon of its own, also where it touches the hole") {
  CHECK(checked({"#####",  //
                 "#...#",  //
                 "#.#.#",  //
                 "#...#",  //
                 "#####"})
            .size() == 2);
  CHECK(checked({"#####",  //
                 "##..#",  //
                 "#.#.#",  //
                 "#..##",  //
                 "#####"})
            .size() == 2);
}

TEST_CASE("chessboards, framed and bare, have the expected polygons") {
  Picture board;
  for (int r = 0; r < 8; ++r) board.push_back(r % 2 == 0 ? "#.#.#.#." : ".#.#.#.#");
  CHECK(checked(board).size() == 32);
  Picture framed = {std::string(10, '#')};
  for (const std::string& row : board) framed.push_back("#" + row + "#");
  framed.push_back(std::string(10, '#'));
  checked(framed);
}

TEST_CASE("each triangle of a touching chain or ring is a polygon") {
  CHECK(checked(chain_of_triangles(100), 3).size() == 100);
  CHECK(checked(ring_of_pinches(60), ring_of_pinches_alpha).size() == 60);
}

TEST_CASE("random pictures have the parts, holes, areas and perimeters of a flood fill") {
  Random random(3);
  for (const double solid : {0.3, 0.5, 0.6, 0.7, 0.8, 0.9})
    for (int run = 0; run < 25; ++run) checked(random_picture(12, 15, solid, random));
}

TEST_CASE("filters fill and drop parts of random pictures as a flood fill does") {
  Random random(4);
  for (const double solid : {0.5, 0.6, 0.7, 0.8})
    for (int run = 0; run < 10; ++run) {
      const Picture picture = random_picture(14, 14, solid, random);
      const Points points = points_of(picture);
      const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, picture_alpha);
      const rbpa::AlphaComplex arrays = rbpa::alpha_complex(points, picture_alpha, {.neighbors = true});
      for (const double hole : {0.0, 4.0, 5.0, 8.5, 40.0, infinity})
        for (const double part : {0.0, 4.0, 4.5, 30.0, infinity}) {
          CAPTURE(hole);
          CAPTURE(part);
          REQUIRE(parts(rbpa::outline_polygons(complex, {hole, part})) == parts_of(picture, hole, part));
          REQUIRE(rbpa::outline_polygons(points, arrays, {hole, part}) ==
                  rbpa::outline_polygons(complex, {hole, part}));
        }
    }
}

TEST_CASE("filters that fill a hole cover its islands, and others keep them") {
  const Picture picture = {"#######",  //
                           "#.....#",  //
                           "#.###.#",  //
                           "#.#.#.#",  //
                           "#.###.#",  //
                           "#.....#",  //
                           "#######"};
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points_of(picture), picture_alpha);
  const auto left = [&](double hole, double part) { return parts(rbpa::outline_polygons(complex, {hole, part})); };
  CHECK(left(0, 0) == std::vector<Part>{{32, 32, 1}, {96, 96, 1}});
  CHECK(left(4, 0) == left(0, 0));
  CHECK(left(4.5, 0) == std::vector<Part>{{36, 24, 0}, {96, 96, 1}});
  CHECK(left(100, 0) == left(4.5, 0));
  CHECK(left(101, 0) == std::vector<Part>{{196, 56, 0}});
  CHECK(left(0, 33) == std::vector<Part>{{96, 96, 1}});
  CHECK(left(4.5, 33) == left(4.5, 0));
  CHECK(left(0, 1000).empty());
}

TEST_CASE("filters refuse invalid areas") {
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(Points{{0, 0}, {1, 0}, {0, 1}}, 1);
  const rbpa::AlphaComplex arrays = rbpa::alpha_complex(Points{{0, 0}, {1, 0}, {0, 1}}, 1, {.neighbors = true});
  for (const double bad : {-1.0, -infinity, std::nan("")}) {
    CHECK_THROWS_AS(rbpa::outline_polygons(Points(3), arrays, {.min_hole_area = bad}), rbpa::InvalidInput);
    CHECK_THROWS_AS(rbpa::outline_polygons(complex, {.min_hole_area = bad}), rbpa::InvalidInput);
    CHECK_THROWS_AS(rbpa::outline_polygons(complex, {.min_part_area = bad}), rbpa::InvalidInput);
  }
}

TEST_CASE("arrays of other points are refused, and a cancelled run ends") {
  const Points points = uniform(5000, 1);
  const rbpa::AlphaComplex arrays = rbpa::alpha_complex(points, 0.7, {.neighbors = true});
  CHECK_THROWS_AS(rbpa::outline_polygons(Points(17), arrays), meshops::ContractViolation);
  Points mirrored = points;
  for (Point& p : mirrored) p.x = -p.x;
  CHECK_THROWS_AS(rbpa::outline_polygons(mirrored, rbpa::alpha_complex(points, infinity, {.neighbors = true})),
                  meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::outline_polygons(points, arrays, {}, [] { return false; }), rbpa::Cancelled);
}

TEST_CASE("dust, and a plate with many holes, can be cancelled in every sort") {
  const Points points = uniform(60000, 5);
  for (const double alpha : {0.6, 0.9}) {  // some triangles and a few holes; most of them
    CAPTURE(alpha);
    const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
    const rbpa::AlphaComplex arrays = rbpa::alpha_complex(points, alpha, {.neighbors = true, .boundary = true});
    std::size_t calls = 0;
    const auto count_asks = [&](const PolygonFilter& filter) {
      calls = 0;
      const auto go_on = [&] { return ++calls > 0; };
      const std::vector<Polygon> made = rbpa::outline_polygons(points, arrays, filter, go_on);
      const std::size_t of_arrays = calls;
      calls = 0;
      CHECK(rbpa::outline_polygons(complex, filter, go_on) == made);
      CHECK(2 * calls > of_arrays);
      return of_arrays;
    };
    const auto edges = static_cast<double>(arrays.boundary.size());
    const double compared = edges * std::log2(edges) / 2;  // at least
    const std::size_t unfilled = count_asks({}), filled = count_asks({.min_hole_area = infinity});
    CHECK(static_cast<double>(filled - unfilled) >
          2 * compared / 16384);  // by where edges begin, and by where they end
    for (std::size_t last = 1; last <= filled; last += all_trials() ? 1U : 5U) {
      std::size_t left = last;
      CHECK_THROWS_AS(rbpa::outline_polygons(points, arrays, {.min_hole_area = infinity}, [&] { return --left > 0; }),
                      rbpa::Cancelled);
      CHECK(left == 0);  // and was not called again
    }
  }
}

TEST_CASE("shells less holes have exactly the area of the triangles on integer grids") {
  Random random(5);
  for (int run = 0; run < trials(300); ++run) {
    const int columns = random.integer(3, 20);
    const auto count = static_cast<std::size_t>(random.integer(3, columns * columns));
    const Points points = random_grid(columns, count, random.chance(0.3), random.bits());
    for (const double alpha : {0.5, 0.75, 1.0, 1.2, 1.5, 2.5, 4.0, infinity}) {
      const std::vector<Polygon> polygons = checked(points, alpha);
      const long long twice = twice_area(rbpa::triangles(rbpa::rbpa(points, alpha)), points);
      REQUIRE(2 * sum_of_areas(polygons) == static_cast<double>(twice));
      CHECK(2 * rbpa::total(polygons).area == static_cast<double>(twice));
    }
  }
}

TEST_CASE("random grids include holes that begin where their shell does") {
  Random random(8);
  std::size_t found = 0;
  for (int run = 0; run < trials(400); ++run) {
    const Points points = random_grid(9, static_cast<std::size_t>(random.integer(20, 60)), false, random.bits());
    for (const double alpha : {1.0, 1.25, 1.6, 2.0})
      for (const Polygon& polygon : checked(points, alpha))
        for (const rbpa::Ring& hole : polygon.holes) found += hole.points[0] == polygon.shell.points[0] ? 1U : 0U;
  }
  CHECK(found > 0);
}

TEST_CASE("as many holes as a wheel has spokes meet in its hub") {
  Points points = {{0, 0}};
  for (int turn = 0; turn < 3; ++turn) {
    const double c = turn == 0 ? 1 : -0.5, s = turn == 0 ? 0 : (turn == 1 ? 0.866 : -0.866);
    for (int x = 10; x <= 22; x += 3)
      for (const int y : {-3, 3}) points.push_back({std::round(c * x - s * y), std::round(s * x + c * y)});
  }
  for (int x = -36; x <= 36; x += 4)
    for (int y = -36; y <= 36; y += 4)
      if (x * x + y * y >= 24 * 24 && x * x + y * y <= 36 * 36)
        points.push_back({static_cast<double>(x), static_cast<double>(y)});
  const std::vector<Polygon> polygons = checked(points, 6);
  REQUIRE(polygons.size() == 1);
  std::size_t through_hub = 0;
  for (const rbpa::Ring& hole : polygons[0].holes)
    through_hub += std::find(hole.points.begin(), hole.points.end(), 0U) != hole.points.end() ? 1U : 0U;
  CHECK(through_hub == 3);
}

TEST_CASE("polygons of generated sets of every kind obey the laws at every alpha") {
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    std::vector<double> alphas = usual_alphas(points);
    alphas.insert(alphas.end(), set.alphas.begin(), set.alphas.end());
    for (const double alpha : alphas) {
      INFO(set.name);
      for (const Polygon& p : checked(points, alpha)) {
        CHECK(p.area >= 0);
        CHECK(p.perimeter >= 0);
      }
    }
  }
}

TEST_CASE("polygons of real data obey the laws at every alpha") {
  std::size_t sets = 0;
  for (const PointFile& file : point_files(bundled_data())) {
    const Points points = read_points(file);
    if (points.size() > 5000) continue;
    ++sets;
    for (const double alpha : usual_alphas(points)) {
      INFO(file.name);
      checked(points, alpha);
    }
  }
  CHECK(sets >= 20);
}

TEST_CASE("shuffled points give the same polygons in the same order") {
  Random random(6);
  for (const double alpha : {0.8, 1.0, 1.25, 3.0}) {
    const Points points = sparse_grid(40, 0.5, random.bits());
    Points shuffled = points;
    random.shuffle(shuffled);
    const std::vector<Polygon> a = checked(points, alpha), b = checked(shuffled, alpha);
    CHECK(coordinates_of(a, points) == coordinates_of(b, shuffled));
    CHECK(parts(a) == parts(b));
    CHECK(rbpa::total(a).perimeter == rbpa::total(b).perimeter);
  }
}

TEST_CASE("polygons move by integers, scale by powers of two and turn by right angles with their points") {
  for (const double alpha : {0.8, 1.0, 1.25, 3.0}) {
    const Points points = sparse_grid(30, 0.5, 7);
    const std::vector<Polygon> polygons = checked(points, alpha);
    CHECK(checked(moved(points, 1000, -77), alpha) == polygons);

    const std::vector<Polygon> larger = checked(scaled(points, 5), alpha * 32);
    REQUIRE(larger.size() == polygons.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      CHECK(larger[i].shell == polygons[i].shell);
      CHECK(larger[i].holes == polygons[i].holes);
      CHECK(larger[i].area == 1024 * polygons[i].area);
      CHECK(larger[i].perimeter == 32 * polygons[i].perimeter);
    }

    Points turned;
    for (const Point& p : points) turned.push_back({-p.y, p.x});
    const std::vector<Polygon> after = checked(turned, alpha);
    CHECK(parts(after) == parts(polygons));
    // The rings are the same, except where they begin.
    const auto rings = [](const std::vector<Polygon>& all) {
      std::vector<std::vector<std::uint32_t>> result;
      const auto add = [&](rbpa::Ring ring) {
        std::rotate(ring.points.begin(), std::min_element(ring.points.begin(), ring.points.end()), ring.points.end());
        result.push_back(ring.points);
      };
      for (const Polygon& p : all) {
        add(p.shell);
        for (const rbpa::Ring& hole : p.holes) add(hole);
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    CHECK(rings(after) == rings(polygons));
  }
}

TEST_CASE("areas and perimeters at the limits of double are right, or infinite") {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const auto one = [](const Points& points) { return checked(points, infinity).at(0); };
  CHECK(one({{0, 0}, {0x1p-537, 0}, {0, 0x1p-536}}).area == least);
  CHECK(one({{0, 0}, {3 * least, 0}, {0, 4 * least}}).perimeter == 12 * least);
  CHECK(one({{0, 0}, {3 * 0x1p1020, 0}, {0, 4 * 0x1p1020}}).perimeter == 12 * 0x1p1020);
  CHECK(one({{0, 0}, {3 * 0x1p1020, 0}, {0, 4 * 0x1p1020}}).area == infinity);
  CHECK(one({{-most, -most}, {most, -most}, {0, most}}).perimeter == infinity);
  CHECK(rbpa::total(checked({{-most, -most}, {most, -most}, {0, most}}, infinity)).area == infinity);
  // Far from the origin the products are large and the area is small.
  CHECK(one({{0x1p52, 0x1p52}, {0x1p52 + 1, 0x1p52}, {0x1p52, 0x1p52 + 1}}).area == 0.5);
}

TEST_CASE("a power of two scales areas and perimeters, to the last bit") {
  for (const Points& points : {uniform(40, 61), Points{{0, 0}, {1, 1e-130}, {0.5, 0.7}, {3, 1e-200}}}) {
    const Polygon before = checked(points, infinity).at(0);
    for (const int exponent : {-410, -390, -200, 200, 390, 410}) {
      CAPTURE(exponent);
      const Polygon after = checked(scaled(points, exponent), infinity).at(0);
      CHECK(after.perimeter == std::ldexp(before.perimeter, exponent));
      CHECK(after.area == std::ldexp(before.area, 2 * exponent));
    }
  }
}

TEST_SUITE_END();
