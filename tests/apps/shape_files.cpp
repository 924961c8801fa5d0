// Files of a shape: numbers of polygons, the points in them and in none, coordinate systems.
#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/number.h"
#include "support/gdal_endings.h"
#include "support/generate.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;
using rbpa::Point;

namespace {

/// Two squares, of which one has a point twice, a point between them and one far away.
constexpr const char* squares = "0 0\n1 0\n1 1\n0 1\n3 3\n10 0\n11 0\n11 1\n10 1\n11 1\n90 90\n";

std::vector<Point> read(const std::string& path, rbpa::app::Format format) {
  return rbpa::app::read_points({.path = path, .format = format}).points;
}

const std::string to_degrees =
    ", as its crs member says; readers that follow RFC 7946 take it for degrees of WGS 84 (ogr2ogr -t_srs EPSG:4326 "
    "converts it)\n";

}  // namespace

TEST_SUITE("shape files") {
  TEST_CASE("GeoJSON numbers the polygons and counts their points") {
    const Folder folder("p.xy", squares);
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 -o s.geojson --isolated i.geojson --crs OGC:CRS84 -q").code == 0);
    CHECK(folder.content("s.geojson") ==
          "{\"type\":\"FeatureCollection\",\"features\":[\n"
          "{\"type\":\"Feature\",\"properties\":{\"number\":1,\"area\":1,\"perimeter\":4,\"holes\":0,\"points\":4},"
          "\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}},\n"
          "{\"type\":\"Feature\",\"properties\":{\"number\":2,\"area\":1,\"perimeter\":4,\"holes\":0,\"points\":5},"
          "\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[10,0],[11,0],[11,1],[10,1],[10,0]]]}}\n]}\n");
    CHECK(
        folder.content("i.geojson") ==
        "{\"type\":\"FeatureCollection\",\"features\":[\n"
        "{\"type\":\"Feature\",\"properties\":{\"index\":4},\"geometry\":{\"type\":\"Point\",\"coordinates\":[3,3]}},\n"
        "{\"type\":\"Feature\",\"properties\":{\"index\":10},\"geometry\":{\"type\":\"Point\",\"coordinates\":[90,90]}}"
        "\n"
        "]}\n");
  }

  TEST_CASE("CSV has every point with its polygon, and isolated points have their index") {
    const Folder folder("p.xy", squares);
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 -o s.csv --isolated i.csv -q").code == 0);
    CHECK(folder.content("s.csv") ==
          "x,y,polygon\n0,0,1\n1,0,1\n1,1,1\n0,1,1\n3,3,\n10,0,2\n11,0,2\n11,1,2\n10,1,2\n11,1,2\n90,90,\n");
    CHECK(folder.content("i.csv") == "x,y,index\n3,3,4\n90,90,10\n");
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 --isolated i.wkt -q").code == 0);
    CHECK(folder.content("i.wkt") == "MULTIPOINT ((3 3), (90 90))\n");
    REQUIRE(folder.rbpa("shape p.xy --alpha inf --isolated i.wkt --isolated i.csv -q").code == 2);
    REQUIRE(folder.rbpa("shape p.xy --alpha inf --isolated i.wkt -o s.csv -q").code == 0);
    CHECK(folder.content("i.wkt") == "MULTIPOINT EMPTY\n");
    CHECK(folder.rbpa("shape p.xy --alpha 1 --min-part-area 2 -o - --output-format csv -q").out ==
          "x,y,polygon\n0,0,\n1,0,\n1,1,\n0,1,\n3,3,\n10,0,\n11,0,\n11,1,\n10,1,\n11,1,\n90,90,\n");
  }

  TEST_CASE("written files are read again, to the last bit, and agree") {
    const Folder folder;
    std::string text;
    for (const Point& p : rbpa_test::uniform(3000, 5))
      text += rbpa::app::text_of(p.x * 1e3) + " " + rbpa::app::text_of(-p.y * 1e3) + "\n";
    const std::vector<Point> points = read(folder.file("p.xy", text), rbpa::app::Format::text);
    REQUIRE(
        folder.rbpa("shape p.xy --alpha 600 --min-hole-area 1 -o s.csv -o s.geojson --isolated i.geojson -q").code ==
        0);
    REQUIRE(folder.rbpa("shape p.xy --alpha 600 --min-hole-area 1 --isolated i.csv -q").code == 0);
    REQUIRE(folder.rbpa("shape p.xy --alpha 600 --min-hole-area 1 --isolated i.wkt -q").code == 0);
    CHECK(read(folder.path("s.csv"), rbpa::app::Format::text) == points);
    std::map<std::string, std::size_t> counts;
    std::vector<Point> isolated;
    std::istringstream lines(folder.content("s.csv"));
    std::string line;
    std::getline(lines, line);
    for (const Point& p : points) {
      std::getline(lines, line);
      const std::string number = line.substr(line.rfind(',') + 1);
      number.empty() ? isolated.push_back(p) : static_cast<void>(++counts[number]);
    }
    const json all = json::parse(folder.content("s.geojson"));
    REQUIRE(all["features"].size() > 3);
    for (const json& feature : all["features"])
      CHECK(feature["properties"]["points"] == counts[to_string(feature["properties"]["number"])]);
    CHECK(counts.size() == all["features"].size());
    REQUIRE(isolated.size() > 3);
    CHECK(read(folder.path("i.geojson"), rbpa::app::Format::geojson) == isolated);
    CHECK(read(folder.path("i.csv"), rbpa::app::Format::text) == isolated);
    CHECK(read(folder.path("i.wkt"), rbpa::app::Format::wkt) == isolated);
    const json isolated_file = json::parse(folder.content("i.geojson"));
    for (const json& feature : isolated_file["features"]) {
      const Point& p = points[feature["properties"]["index"].get<std::size_t>()];
      CHECK(feature["geometry"]["coordinates"] == json::array({p.x, p.y}));
    }
  }

  TEST_CASE("a coordinate system is carried from file to file; another than WGS 84 is warned of once") {
    const Folder folder("p.wkt", "SRID=28992;MULTIPOINT (0 0, 1 0, 1 1, 0 1)");
    const Outcome first = folder.rbpa("shape p.wkt --alpha 1 -o a.geojson -o b.geojson --isolated i.geojson");
    CHECK(first.err == "rbpa: a.geojson: written in EPSG:28992" + to_degrees +
                           "rbpa: 4 points, 1 polygon with 0 holes, area 1 -> a.geojson, b.geojson\n");
    const std::string member =
        "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:EPSG::"
        "28992\"}},";
    for (const std::string name : {"a.geojson", "b.geojson", "i.geojson"})
      CHECK(folder.content(name).starts_with(member));
    CHECK(contains(folder.rbpa("info a.geojson --vertices").out, "crs         EPSG:28992\n"));
    const Outcome again = folder.rbpa("shape a.geojson --vertices --alpha 1 -o - --output-format json -q");
    CHECK(again.out == folder.content("a.geojson"));
    CHECK(again.err == "rbpa: standard output: written in EPSG:28992" + to_degrees);  // in spite of -q
    CHECK(folder.rbpa("shape p.wkt --alpha 1 -o s.wkt -o s.csv -q").err.empty());
    // A file may name another system.
    CHECK(folder.rbpa("shape p.wkt --crs EPSG:4258 --alpha 1 -o a.geojson -q").err ==
          "rbpa: a.geojson: written in EPSG:4258" + to_degrees);
    CHECK(folder.rbpa("shape p.wkt --crs EPSG:4326 --alpha 1 -o a.geojson -q").err.empty());
    CHECK(!contains(folder.content("a.geojson"), "crs"));
  }

  TEST_CASE("EWKT contains the system, and requires a known one") {
    const Folder folder("p.xy", "0 0\n1 0\n1 1\n0 1\n9 9\n");
    REQUIRE(folder.rbpa("shape p.xy --crs EPSG:28992 --alpha 1 -o s.ewkt -o s.wkt --isolated i.ewkt -q").code == 0);
    CHECK(folder.content("s.wkt").starts_with("MULTIPOLYGON (((0 0"));
    CHECK(folder.content("s.ewkt") == "SRID=28992;" + folder.content("s.wkt"));
    CHECK(folder.content("i.ewkt") == "SRID=28992;MULTIPOINT ((9 9))\n");
    // The file is read again with its system, which is carried on.
    CHECK(contains(folder.rbpa("info s.ewkt --vertices").out, "crs         EPSG:28992\n"));
    CHECK(folder.rbpa("shape s.ewkt --vertices --alpha 1 -o - --output-format ewkt -q").out ==
          folder.content("s.ewkt"));
    CHECK(
        folder.rbpa("shape p.xy --crs OGC:CRS84 --alpha 9 -o - --output-format ewkt -q").out.starts_with("SRID=4326;"));
    CHECK(folder.rbpa("shape p.xy --crs EPSG:4258 --alpha 0.1 -o - --output-format ewkt -q").out ==
          "SRID=4258;MULTIPOLYGON EMPTY\n");
    const std::string expected =
        ", expected one with an EPSG code, which EWKT contains (--crs EPSG:28992, or the ending wkt)\n";
    const Outcome unknown = folder.rbpa("shape p.xy --alpha 1 -o n.ewkt -o n.wkt -q", 2);
    CHECK(unknown.err == "rbpa: n.ewkt: found points in an unknown coordinate system" + expected);
    CHECK(!folder.has("n.wkt"));
    CHECK(folder.rbpa("shape p.xy --crs ESRI:102100 --alpha 1 --isolated n.ewkt -o n.wkt -q").err ==
          "rbpa: n.ewkt: found points in ESRI:102100" + expected);
  }

  TEST_CASE("coordinates beyond degrees, of no known system, give a warning") {
    const Folder folder;
    const std::string but = ", but GeoJSON means degrees of WGS 84 (--crs EPSG:CODE names their system)\n";
    folder.file("p.xy", "0 0\n181 0\n0 1\n");
    CHECK(folder.rbpa("shape p.xy --alpha inf -o s.geojson -q").err ==
          "rbpa: s.geojson: coordinates go up to 181 and 1" + but);
    CHECK(folder.rbpa("shape p.xy --alpha inf -o s.wkt -q").err.empty());
    CHECK(folder.rbpa("shape p.xy --shift-longitude --alpha inf -o s.geojson -q").err.empty());
    folder.file("p.xy", "0 0\n180 0\n0 -90.5\n");
    CHECK(folder.rbpa("shape p.xy --alpha inf -o s.geojson -q").err ==
          "rbpa: s.geojson: coordinates go up to 180 and 90.5" + but);
    folder.file("p.xy", "0 0\n180 0\n0 -90\n");
    CHECK(folder.rbpa("shape p.xy --alpha inf -o s.geojson -q").err.empty());
    folder.file("p.geojson",
                "{\"type\":\"MultiPoint\",\"coordinates\":[[155000,463000],[155001,463000],[155000,463001]]}");
    const Outcome metres = folder.rbpa("shape p.geojson --alpha inf -o s.geojson");
    CHECK(metres.err ==
          "rbpa: p.geojson: expected longitudes and latitudes, found numbers up to 155001 and 463001: are they "
          "degrees?\nrbpa: s.geojson: coordinates go up to 155001 and 463001" +
              but + "rbpa: 3 points, 1 polygon with 0 holes, area 0.5 -> s.geojson\n");
  }

  TEST_CASE("--isolated accepts known endings, and a file of its own") {
    const Folder folder("p.xy", squares);
    CHECK(folder.rbpa("shape p.xy --alpha 1 --isolated i.svg").err ==
          "rbpa: --isolated: found the ending 'svg', expected one of geojson, json, wkt, ewkt, csv" +
              std::string(rbpa::app::has_gdal() ? ", gpkg, fgb" : "") + "\n");
    CHECK(folder.rbpa("shape p.xy --alpha 1 -o s.csv --isolated ./s.csv").code == 2);
    CHECK(folder.rbpa("shape p.xy --alpha 1 -o s.csv --isolated p.xy").code == 2);
    CHECK(folder.rbpa("shape p.xy --alpha 1 -o s.csv --isolated none/i.csv").code == 1);
    CHECK(folder.names() == std::vector<std::string>{"p.xy"});
  }
}
