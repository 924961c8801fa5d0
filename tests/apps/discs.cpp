// `rbpa discs`: polygons and rows of coverage, radii of a column, and wrong calls.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;
using std::numbers::pi;

namespace {

// A pair that meets, a disc with another inside, and a disc of radius 0.
const std::string table = "x,y,r,name\n0,0,1,a\n1.5,0,1,b\n5,5,2,c\n5,5,1,d\n10,0,0,e\n";

}  // namespace

TEST_SUITE("discs") {
  TEST_CASE("discs with radii of a column have components as polygons, and a row each") {
    const Folder folder("t.csv", table);
    const Outcome outcome = folder.rbpa("discs t.csv --radius column:r --corners 8 -o o.geojson -o o.csv -o o.png");
    CHECK(outcome.err ==
          "rbpa: 5 points (1 duplicate), 2 polygons with 0 holes, area 18.3962, boundary 22.2418 -> o.geojson, o.csv, "
          "o.png\n");
    const Json features = Json::parse(folder.content("o.geojson"))["features"];
    REQUIRE(features.size() == 2);
    CHECK(features[0]["properties"]["points"] == 2);
    CHECK(features[1]["properties"]["points"] == 1);
    CHECK(features[1]["properties"]["area"].get<double>() == doctest::Approx(8 * std::sqrt(2.0)));  // an octagon
    const double half = std::acos(0.75), share = pi - half + 0.75 * std::sin(half);
    CHECK(std::stod(folder.rbpa("discs t.csv --radius column:r -o - --output-format csv -q").out.substr(39)) ==
          doctest::Approx(share));
    CHECK(contains(folder.content("o.csv"), "5,5,,1,0,0\n10,0,,0,0,0\n"));
    // The disc of radius 0 is drawn as a point, the disc in another is not.
    REQUIRE(folder.rbpa("discs t.csv --radius column:r -o o.svg -q").code == 0);
    const std::string picture = folder.content("o.svg"), points = picture.substr(picture.find("isolated"));
    REQUIRE(contains(points, "h0"));
    CHECK(points.find("h0") == points.rfind("h0"));
  }

  TEST_CASE("one radius for all discs leaves a hole where it is not covered") {
    const Folder folder("ring.xy", "1 0\n0.5 0.866\n-0.5 0.866\n-1 0\n-0.5 -0.866\n0.5 -0.866\n");
    CHECK(contains(folder.rbpa("discs ring.xy --radius 0.6 -o r.wkt").err, " 1 polygon with 1 hole, "));
    CHECK(contains(folder.rbpa("discs ring.xy --radius 1.01 -o r.wkt").err, " 1 polygon with 0 holes, "));
    CHECK(contains(folder.rbpa("discs ring.xy --radius 0 -o r.wkt").err, " 0 polygons with 0 holes, area 0, "));
    CHECK(folder.content("r.wkt") == "MULTIPOLYGON EMPTY\n");
    folder.file("degrees.csv", "lon,lat\n4,52\n5,52\n");
    CHECK(contains(folder.rbpa("discs degrees.csv --radius 1 -o r.csv").err, "coordinates are degrees"));
  }

  TEST_CASE("wrong calls and radii are refused, and nothing is written") {
    const Folder folder(
        {{"t.csv", table}, {"missing.csv", "x,y,r\n0,0,1\n1,1,\n"}, {"negative.csv", "x,y,r\n0,0,1\n1,1,-3\n"}});
    const std::pair<const char*, const char*> calls[] = {
        {"t.csv --radius -1", "--radius: found '-1', expected a number, at least 0, or column:NAME"},
        {"t.csv --radius column:", "--radius: found 'column:'"},
        {"t.csv --radius inf", "--radius: found 'inf'"},
        {"t.csv --radius column:name", "t.csv: found texts in column 'name', expected radii"},
        {"t.csv --radius column:height",
         "no field 'height' beside the coordinates, expected one, as --radius requires"},
        {"t.csv --radius 1 --corners 2", "--corners: found '2', expected a whole number of corners from 3 to 100000"},
        {"missing.csv --radius column:r", "missing.csv: found point 1 without a value of 'r', expected a radius"},
        {"negative.csv --radius column:r", "negative.csv: radius 1 is -3, expected a finite number of at least 0"}};
    for (const auto& row : calls) {
      const std::string call = row.first, message = row.second;
      CAPTURE(call);
      const Outcome outcome = folder.rbpa("discs " + call + " -o o.wkt");
      CHECK(outcome.code != 0);
      CHECK(contains(outcome.err, message));
      CHECK(!folder.has("o.wkt"));
    }
  }
}
