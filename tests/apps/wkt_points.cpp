// Well-known text: every geometry, every notation, and invalid ones.
#include <doctest/doctest.h>

#include <bit>
#include <random>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/number.h"
#include "io/polygon/wkt.h"
#include "support/refusal_of.h"

using rbpa::Point;
using namespace rbpa::app;

namespace {

std::vector<Point> points_of(const std::string& text) { return read_wkt_points(text, "p.wkt", false).points; }
std::vector<Point> vertices_of(const std::string& text) { return read_wkt_points(text, "p.wkt", true).points; }

std::string refusal(const std::string& text) {
  return rbpa_test::refusal_of<BadInput>([&] { vertices_of(text); });
}

}  // namespace

TEST_SUITE("well-known text in") {
  TEST_CASE("points are read in every way of writing") {
    const std::vector<Point> expected = {{1, 2}, {-3.5, 4e2}};
    for (const std::string text :
         {"POINT (1 2)\nPOINT (-3.5 4e2)\n", "point(1 2)point(-3.5 400)", "MULTIPOINT (1 2, -3.5 400)",
          "MULTIPOINT ((1 2), (-3.5 400))", "MultiPoint((1 2),(-3.5 400));", "POINT Z (1 2 3) POINT M (-3.5 400 1)",
          "POINTZM(1 2 3 4)\r\n\r\nPOINTZ (-3.5 400 9)", "GEOMETRYCOLLECTION (POINT (1 2), POINT (-3.5 400))",
          "POINT EMPTY MULTIPOINT (EMPTY, 1 2) MULTIPOINT Z EMPTY POINT\n(-3.5\n400)",
          "SRID=0;POINT(1 2) POINT(-3.5 400)"}) {
      CAPTURE(text);
      CHECK(points_of(text) == expected);
      CHECK(vertices_of(text) == expected);
    }
    CHECK(points_of("  \n").empty());
  }

  TEST_CASE("vertices of lines and polygons are points; the closing point of a ring counts once") {
    const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    CHECK(vertices_of("LINESTRING (0 0, 1 0, 1 1, 0 1)") == square);
    CHECK(vertices_of("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))") == square);
    CHECK(vertices_of("POLYGON ((0 0, 1 0), (1 1, 0 1, 1 1))") == square);
    CHECK(vertices_of("MULTILINESTRING ((0 0, 1 0), (1 1, 0 1))") == square);
    CHECK(vertices_of("MULTIPOLYGON (((0 0, 1 0, 0 0)), EMPTY, ((1 1, 0 1, 1 1)))") == square);
    CHECK(vertices_of("TRIANGLE ((0 0, 1 0, 1 1, 0 0)) POINT (0 1)") == square);
    CHECK(vertices_of("TIN (((0 0, 1 0, 1 1, 0 0)), ((0 1, 0 1)))") == square);
    CHECK(vertices_of("LINESTRING (0 0, 1 0, 0 0)").size() == 3);  // a line that comes back is not a ring
  }

  TEST_CASE("every double is read to the last bit") {
    std::mt19937_64 random(6);
    std::vector<Point> points;
    std::string text;
    while (points.size() < 2000) {
      const std::uint64_t x = random(), y = random();
      const Point p{std::bit_cast<double>(x), std::bit_cast<double>(y)};
      if (!rbpa::is_finite(p)) continue;
      points.push_back(p);
      text += "POINT (" + text_of(p.x) + " " + text_of(p.y) + ")\n";
    }
    text += "POINT (-0 0)";
    points.push_back({-0.0, 0.0});
    const std::vector<Point> found = points_of(text);
    REQUIRE(found.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(std::bit_cast<std::uint64_t>(found[i].x) == std::bit_cast<std::uint64_t>(points[i].x));
      CHECK(std::bit_cast<std::uint64_t>(found[i].y) == std::bit_cast<std::uint64_t>(points[i].y));
    }
  }

  TEST_CASE("the system is that of the SRID, one for all") {
    CHECK(read_wkt_points("SRID=28992;POINT(1 2)\nPOINT(3 4)\n", "p", false).crs->text() == "EPSG:28992");
    CHECK_FALSE(read_wkt_points("SRID=0;POINT(1 2)\n", "p", false).crs);
    CHECK(refusal("SRID=28992;POINT(1 2)\nSRID=4326;POINT(1 2)\n") ==
          "p.wkt:2: found SRID=4326, expected one system for all points, SRID=28992");
    CHECK(refusal("SRID=x;POINT(1 2)") ==
          "p.wkt:1: found 'x;POINT(1 2)', expected the number of a coordinate reference system");
    CHECK(refusal("SRID=1 POINT(1 2)") == "p.wkt:1: found 'POINT(1 2)', expected ';'");
  }

  TEST_CASE("an invalid geometry is refused by its line") {
    CHECK(refusal("POINT (1 2)\n\nCURVE (1 2)\n") ==
          "p.wkt:3: found 'CURVE (1 2)', expected a geometry, such as 'POINT (1 2)'");
    CHECK(refusal("1 2\n") == "p.wkt:1: found '1 2', expected a geometry, such as 'POINT (1 2)'");
    CHECK(refusal("POINT (1)") == "p.wkt:1: found ')', expected a number");
    CHECK(refusal("POINT (1 2") == "p.wkt:1: found the end of the text, expected ')'");
    CHECK(refusal("POINT (1 2, 3 4)") == "p.wkt:1: found ', 3 4)', expected ')'");
    CHECK(refusal("POINT (1 2 3 4 5)") == "p.wkt:1: found '5)', expected ')'");
    CHECK(refusal("POINT (1 a)") == "p.wkt:1: found 'a', expected a number");
    CHECK(refusal("POINT (1 nan)") == "p.wkt:1: found 'nan', expected a finite number");
    CHECK(refusal("POINT (1 1e999)").starts_with("p.wkt:1: found '1e999', expected a number within the range"));
    CHECK(refusal("POINT (1 2x)") == "p.wkt:1: found 'x)', expected a blank, ',' or ')' after a number");
    CHECK(refusal("POINT 1 2") == "p.wkt:1: found '1 2', expected '('");
    CHECK(refusal("POINT Q (1 2)") == "p.wkt:1: found ' Q (1 2)', expected '(' or EMPTY");
    CHECK(refusal("POLYGON (0 0, 1 1)") == "p.wkt:1: found '0 0, 1 1)', expected '('");
    CHECK(refusal("MULTIPOINT ((1 2, 3 4))") == "p.wkt:1: found ', 3 4))', expected ')'");
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "GEOMETRYCOLLECTION(";
    CHECK(refusal(deep).find("expected at most 32 nested collections") != std::string::npos);
  }
}
