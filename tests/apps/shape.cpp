// `rbpa shape`: formats, filters, wrong usage, empty results.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/gdal_endings.h"
#include "support/pictures.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

const std::string data = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";

/// A triangle that touches another in a point, and a point far away.
constexpr const char* bow_tie = "-2 -1\n-2 1\n0 0\n2 -1\n2 1\n9 9\n";

/// The points of a picture as text: a part with a hole that has an island with a hole, which touches nothing.
std::string island() {
  std::string text;
  for (const rbpa::Point& p : rbpa_test::points_of({"#######",  //
                                                    "#.....#",  //
                                                    "#.###.#",  //
                                                    "#.#.#.#",  //
                                                    "#.###.#",  //
                                                    "#.....#",  //
                                                    "#######"}))
    text += std::to_string(p.x) + " " + std::to_string(p.y) + "\n";
  return text;
}

}  // namespace

TEST_SUITE("shape") {
  TEST_CASE("WKT is one multipolygon with closed rings and counter-clockwise shells") {
    const Folder folder("p.xy", bow_tie);
    const Outcome outcome = folder.rbpa("shape p.xy --alpha 1.25 -o - --output-format wkt -q", 0);
    CHECK(outcome.out == "MULTIPOLYGON (((-2 -1, 0 0, -2 1, -2 -1)), ((0 0, 2 -1, 2 1, 0 0)))\n");
    CHECK(outcome.err.empty());
  }

  TEST_CASE("GeoJSON has a feature for each polygon, with its area, perimeter and number of holes") {
    const Folder folder("p.xy", bow_tie);
    REQUIRE(folder.rbpa("shape p.xy --alpha 1.25 -o s.geojson -o s.json -q").code == 0);
    CHECK(folder.content("s.geojson") == folder.content("s.json"));
    const json all = json::parse(folder.content("s.geojson"));
    CHECK(all["type"] == "FeatureCollection");
    REQUIRE(all["features"].size() == 2);
    const json& first = all["features"][0];
    CHECK(first["type"] == "Feature");
    CHECK(first["properties"]["area"] == 2.0);
    CHECK(first["properties"]["perimeter"].get<double>() == doctest::Approx(2 + 2 * std::sqrt(5.0)));
    CHECK(first["properties"]["holes"] == 0);
    CHECK(first["geometry"] == json::parse(R"({"type": "Polygon", "coordinates": [[[-2,-1],[0,0],[-2,1],[-2,-1]]]})"));
  }

  TEST_CASE("holes run clockwise, and follow their shell") {
    const Folder folder("p.xy", island());
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 -o s.json -q").code == 0);
    const json features = json::parse(folder.content("s.json"))["features"];
    REQUIRE(features.size() == 2);
    for (const json& feature : features) {
      const json& rings = feature["geometry"]["coordinates"];
      REQUIRE(rings.size() == 2);
      CHECK(feature["properties"]["holes"] == 1);
      for (std::size_t r = 0; r < 2; ++r) {
        double twice = 0;
        for (std::size_t i = 1; i < rings[r].size(); ++i) {
          const json &a = rings[r][i - 1], &b = rings[r][i];
          twice += a[0].get<double>() * b[1].get<double>() - a[1].get<double>() * b[0].get<double>();
        }
        CHECK((twice > 0) == (r == 0));
        CHECK(rings[r].front() == rings[r].back());
      }
    }
  }

  TEST_CASE("filters fill holes with the islands in them, and drop parts") {
    const Folder folder("p.xy", island());
    const auto areas = [&](const std::string& filter) {
      const Outcome outcome = folder.rbpa("shape p.xy --alpha 1 -o - --output-format json -q " + filter, 0);
      std::vector<double> result;
      const json all = json::parse(outcome.out);
      for (const json& feature : all["features"]) result.push_back(feature["properties"]["area"]);
      return result;
    };
    CHECK(areas("") == std::vector<double>{96, 32});
    CHECK(areas("--min-hole-area 4.5") == std::vector<double>{96, 36});
    CHECK(areas("--min-hole-area inf") == std::vector<double>{196});
    CHECK(areas("--min-part-area 33") == std::vector<double>{96});
    CHECK(areas("--min-part-area 33 --min-hole-area 5") == std::vector<double>{96, 36});
  }

  TEST_CASE("statistics have polygons, their holes, area and perimeter, and agree with the mesh") {
    const Folder folder;
    REQUIRE(folder.rbpa("shape " + data + "--alpha 0.02 -o s.json --stats s -q").code == 0);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --stats m -q").code == 0);
    const json shape = json::parse(folder.content("s")), mesh = json::parse(folder.content("m"));
    CHECK(shape["polygons"] == mesh["solid_components"]);
    for (const char* key : {"points", "distinct", "isolated", "triangles", "edges", "holes", "alpha"})
      CHECK(shape[key] == mesh[key]);
    CHECK_FALSE(mesh.contains("polygons"));
    double area = 0, holes = 0;
    const json all = json::parse(folder.content("s.json"));
    for (const json& feature : all["features"]) {
      area += feature["properties"]["area"].get<double>();
      holes += feature["properties"]["holes"].get<double>();
    }
    CHECK(shape["area"].get<double>() == doctest::Approx(area).epsilon(1e-14));
    CHECK(shape["polygon_holes"] == holes);
    CHECK(shape["perimeter"] > 0);
  }

  TEST_CASE("pictures show the solid and its boundary, without inner edges") {
    const Folder folder("p.xy", island());
    REQUIRE(folder.rbpa("shape p.xy --alpha 1 -o s.svg -o s.png --width 200 -q").code == 0);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 -o m.svg --width 200 -q").code == 0);
    const std::string svg = folder.content("s.svg");
    CHECK(contains(svg, "width=\"200\""));
    CHECK(contains(svg, "id=\"solid\""));
    CHECK(svg.size() < folder.content("m.svg").size());
    CHECK(folder.content("s.png").substr(1, 3) == "PNG");
  }

  TEST_CASE("the order of the points changes no bytes") {
    const Folder folder(
        {{"p.xy", "0 0\n4 0\n4 4\n0 4\n9 9\n9 8\n8 8\n"}, {"q.xy", "8 8\n4 4\n9 8\n0 4\n9 9\n4 0\n0 0\n"}});
    for (const char* name : {"p", "q"})
      folder.rbpa("shape " + std::string(name) + ".xy --alpha 3 -q -o " + name + ".json -o " + name + ".wkt", 0);
    CHECK(folder.content("p.json") == folder.content("q.json"));
    CHECK(folder.content("p.wkt") == folder.content("q.wkt"));
  }

  TEST_CASE("coordinates are those of the input, to the last bit; areas beyond double are null") {
    const Folder folder("p.xy", "0.1 1e-310\n1e300 -1e300\n-0.30000000000000004 1.7976931348623157e308\n");
    REQUIRE(folder.rbpa("shape p.xy --alpha inf -o s.wkt -o s.json -q").code == 0);
    const std::string wkt = folder.content("s.wkt");
    for (const char* number : {"0.1 1e-310", "1e+300 -1e+300", "-0.30000000000000004 1.7976931348623157e+308"})
      CHECK(contains(wkt, number));
    CHECK(json::parse(folder.content("s.json"))["features"][0]["properties"]["area"].is_null());
  }

  TEST_CASE("an empty shape is reported, and the file is valid") {
    const Folder folder;
    const auto is_empty_because = [&](const std::string& points, const std::string& options,
                                      const std::string& reason) {
      folder.file("p.xy", points);
      const Outcome outcome = folder.rbpa("shape p.xy -o s.wkt -o s.json -o s.svg -o s.png -q " + options, 0);
      CHECK(outcome.err == "rbpa: the shape is empty: " + reason + "\n");
      CHECK(folder.content("s.wkt") == "MULTIPOLYGON EMPTY\n");
      CHECK(json::parse(folder.content("s.json")) == json::parse(R"({"type": "FeatureCollection", "features": []})"));
      CHECK(folder.has("s.svg"));
      CHECK(folder.has("s.png"));
    };
    is_empty_because("# none\n", "--alpha 1", "fewer than three distinct points (0)");
    is_empty_because("0 0\n1 1\n2 2\n", "--alpha inf", "all points are collinear");
    is_empty_because(corner, "--alpha 0.1", "no triangle has circumradius <= 0.1");
    is_empty_because(corner, "--alpha 1 --min-part-area 0.75", "no part has an area >= 0.75");
  }

  TEST_CASE("wrong usage is refused with option, value and what is expected, without a file") {
    const Folder folder("p.xy", corner);
    refuses(folder, "shape p.xy --alpha 0 -o s.wkt", 2,
            "--alpha: found '0', expected a radius (a number > 0, or inf), auto, min, plateau or plateau:K");
    refuses(folder, "shape p.xy --alpha 1 -o s.wkt --min-hole-area=-1", 2,
            "--min-hole-area: found '-1', expected an area: a number >= 0, or inf");
    refuses(folder, "shape p.xy --alpha 1 -o s.wkt --min-part-area nan", 2,
            "--min-part-area: found 'nan', expected an area: a number >= 0, or inf");
    refuses(folder, "shape p.xy --alpha 1 -o s.off", 2,
            "s.off: found the ending 'off', expected one of geojson, json, wkt, ewkt, csv, svg, png" + gdal_endings() +
                ", or --output-format");
    refuses(folder, "shape p.xy --alpha 1 -o s --output-format ply", 2,
            "--output-format: found 'ply', expected one of geojson, json, wkt, ewkt, csv, svg, png" + gdal_endings());
    refuses(folder, "shape p.xy --alpha 1 -o -", 2,
            "-o - requires --output-format: one of geojson, json, wkt, ewkt, csv, svg, png" + gdal_endings());
    refuses(folder, "shape p.xy --alpha 1", 2, "-o: found no OUT, expected at least one (or --stats FILE)");
    refuses(folder, "shape p.xy --alpha 1 -o s.png --width 1", 2,
            "--width: found '1', expected a whole number of pixels from 64 to 8192");
    CHECK(folder.rbpa("shape p.xy -o s.wkt").code == 2);
  }

  TEST_CASE("bad input leaves no file") {
    const Folder folder("p.xy", "0 0\n1 x\n");
    refuses(folder, "shape p.xy --alpha 1 -o s.wkt --stats s.json", 3,
            "p.xy:2: found 'x', expected a number" + skipping_hint);
    CHECK(folder.names().size() == 1);
  }

  TEST_CASE("a summary is printed on standard error unless quiet") {
    const Folder folder("p.xy", bow_tie);
    CHECK(folder.rbpa("shape p.xy --alpha 1.25 -o s.wkt").err ==
          "rbpa: 6 points, 2 polygons with 0 holes, area 4 -> s.wkt\n");
  }
}
