#include "rbpa/fill/validity.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/fill/rings/simple_rings.h"
#include "support/triangle.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::Polygon;
using rbpa::Ring;
using rbpa::RingsMeet;
using rbpa_test::Points;

std::string why(const Points& points, const std::vector<Polygon>& polygons) {
  return rbpa::why_invalid(points, polygons).value_or("");
}

}  // namespace

TEST_CASE("rings that share a vertex may touch there, from outside or inside, several at once, but not cross") {
  const Points points = {{0, 0}, {4, 4}, {-4, 4}, {1, 3}, {-1, 3}, {-3, -1}, {3, -1}, {2, -4}, {-2, -4}};
  const Ring upper{{0, 1, 2}};
  const auto meet = [&](const std::vector<Ring>& rings) { return rbpa::nest_rings(points, rings).meet; };
  CHECK_FALSE(meet({upper, {{0, 3, 4}}}));                            // from inside
  CHECK_FALSE(meet({upper, {{0, 5, 6}}}));                            // from outside
  CHECK_FALSE(meet({upper, {{0, 3, 4}}, {{0, 5, 8}}, {{0, 7, 6}}}));  // four
  // Two kites with common tips. Each edge lies next to one of the other kite, so that edges meet only in the tips.
  const Points crossed = {{0, 0}, {4, 0}, {2, 3}, {2, 1}, {2, -1}, {2, -3}};
  const auto cross = rbpa::nest_rings(crossed, std::vector<Ring>{{{0, 2, 1, 4}}, {{0, 3, 1, 5}}}).meet;
  REQUIRE(cross);
  CHECK(cross->how == RingsMeet::How::cross_at_a_point);
  CHECK(cross->first.ring != cross->second.ring);
  const std::string words = why(crossed, {{.shell = {{0, 2, 1, 4}}}, {.shell = {{0, 3, 1, 5}}}});
  CHECK(words.find(" crosses the shell of polygon ") != std::string::npos);
  CHECK(words.find("at (0, 0)") != std::string::npos);
}

TEST_CASE("polygons that touch in any number of points are a valid multipolygon; along an edge they are not") {
  const Points points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 2}, {4, 4},
                         {2, 4}, {1, 2}, {3, 2}, {3, 0}, {2, 1}, {4, 0}};
  const Polygon lower{.shell = {{0, 1, 2, 3}}};
  CHECK(why(points, {lower, {.shell = {{2, 4, 5, 6}}}}) == "");
  CHECK(why(points, {lower, {.shell = {{2, 4, 5, 6}}}, {.shell = {{10, 9, 11}}}}) == "");  // a corner on an edge
  CHECK(why(points, {lower, {.shell = {{1, 11, 10}}}, {.shell = {{2, 4, 5, 6}}}}).find("runs along") !=
        std::string::npos);
  CHECK(why(points, {lower, {.shell = {{7, 2, 6}}}}).find("runs along") != std::string::npos);
  CHECK(why(points, {lower, lower}).find("runs along") != std::string::npos);
  // Three polygons that touch each other in a ring of points: their inside has several pieces, as that of a
  // multipolygon may.
  const Points ring = {{0, 0}, {4, 0}, {2, 1}, {8, 0}, {6, 1}, {4, 4}, {4, 3}};
  CHECK(why(ring, {{.shell = {{0, 1, 2}}}, {.shell = {{1, 3, 4}}}, {.shell = {{2, 4, 5}}}}) == "");
}

TEST_CASE("empty input is valid; a missing shell is not") {
  const Points points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 1}, {1, 2}};
  CHECK(why({}, {}) == "");
  CHECK(why(points, {{}, {.shell = {{0, 1, 2, 3}}}, {}}) == "");
  CHECK(why(points, {{.shell = {}, .holes = {{{4, 5, 6}}}}}).find("the shell of polygon 0: found 0 points") == 0);
  CHECK(why(points, {{.shell = {{0, 1, 2, 3}}, .holes = {{}}}}).find("hole 0 of polygon 0: found 0 points") == 0);
}

TEST_CASE("holes that touch in a ring cut the inside in two; a chain of holes does not") {
  const Points points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 4}, {4, 2},
                         {6, 4}, {4, 6}, {4, 3}, {4, 5}, {0, 4}, {8, 4}};
  const Polygon shell{.shell = {{0, 1, 2, 3}}};
  Polygon chain = shell;
  chain.holes = {{{10, 5, 8}}, {{8, 6, 9}}};  // from the shell to the middle
  CHECK(why(points, {chain}) == "");
  Polygon closed = shell;
  closed.holes = {{{10, 5, 8}}, {{8, 11, 9}}};  // and on to the opposite side
  CHECK(why(points, {closed}).find("expected an inside in one piece") != std::string::npos);
}

TEST_CASE("validation can be cancelled") {
  Points points;
  Polygon comb;
  for (std::uint32_t i = 0; i < 300000; ++i) {
    points.push_back({double(i), i % 2 == 0 ? 1.0 : 2.0});
    comb.shell.points.push_back(i);
  }
  comb.shell.points.push_back(300000);
  points.push_back({0, 0});
  CHECK_THROWS_AS(rbpa::why_invalid(points, std::vector{comb}, [] { return false; }), rbpa::Cancelled);
}

TEST_SUITE_END();
