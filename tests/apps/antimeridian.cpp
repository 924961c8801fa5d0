// GeoJSON around longitude 180 (RFC 7946, 3.1.9): polygons are cut there, with longitudes from -180 to 180, valid, and
// without loss.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

/// Returns points around the antimeridian, a quarter of a degree apart, with a hole on it and one west of it, and an
/// isolated point on each side.
std::string ring_shaped(const std::string& header, bool shifted) {
  std::string text = header;
  const auto add = [&](double x, double y) {
    const double longitude = !shifted && x > 180 ? x - 360 : x;
    text += nlohmann::json(longitude).dump() + "," + nlohmann::json(y).dump() +
            (!contains(header, "name") ? ""
             : y < 2                   ? ",south"
                                       : ",north") +
            "\n";
  };
  for (double x = 176; x <= 184; x += 0.25)
    for (double y = 0; y <= 4; y += 0.25) {
      const bool on_it = std::abs(x - 180.1) < 1 && std::abs(y - 2) < 0.6,
                 west = std::abs(x - 177.5) < 0.4 && std::abs(y - 2) < 0.4;
      if (!on_it && !west) add(x, y);
    }
  add(170, 2);
  add(190, 2);
  return text;
}

void for_each_position(const Json& value, const std::function<void(const Json&)>& visit) {
  if (value.is_array() && !value.empty() && value.front().is_number()) return visit(value);
  for (const Json& inner : value) for_each_position(inner, visit);
}

struct Seen {
  double least = 1000, greatest = -1000;
  std::size_t features = 0, parts = 0, holes = 0;
  std::set<std::string> types;
};

Seen look(const Folder& folder, const std::string& name) {
  Seen seen;
  const Json file = Json::parse(folder.content(name));
  for (const Json& feature : file.at("features")) {
    const Json& geometry = feature.at("geometry");
    const std::string type = geometry.at("type");
    ++seen.features;
    seen.types.insert(type);
    for_each_position(geometry.at("coordinates"), [&](const Json& p) {
      seen.least = std::min(seen.least, p[0].get<double>());
      seen.greatest = std::max(seen.greatest, p[0].get<double>());
    });
    if (type == "Polygon") {
      ++seen.parts;
      seen.holes += geometry.at("coordinates").size() - 1;
    }
    if (type == "MultiPolygon")
      for (const Json& part : geometry.at("coordinates")) {
        ++seen.parts;
        seen.holes += part.size() - 1;
      }
  }
  return seen;
}

/// Returns the area of polygons that `rbpa fill` accepts, that is, of valid ones.
double valid_area(const Folder& folder, const std::string& name) {
  const Outcome filled = folder.rbpa("fill " + name + " --size inf --stats s.json -q", 0);
  CHECK(filled.err == "");
  return filled.code == 0 ? Json::parse(folder.content("s.json")).at("area").get<double>() : -1;
}

}  // namespace

TEST_SUITE("antimeridian") {
  TEST_CASE("Fiji is two polygons, each within -180 to 180") {
    const Folder folder;
    const std::string file = std::string(RBPA_TEST_DATA) + "/findings/case_antimeridian_geojson/fiji.csv";
    REQUIRE(folder.rbpa("shape " + file + " --alpha 0.2 --shift-longitude -o o.geojson -q").code == 0);
    const Seen seen = look(folder, "o.geojson");
    CHECK(seen.features == 1);
    CHECK(seen.parts == 2);
    CHECK(seen.least == -180);
    CHECK(seen.greatest == 180);
    CHECK(valid_area(folder, "o.geojson") == 8);
    CHECK(Json::parse(folder.content("o.geojson")).at("features")[0].at("properties").at("area") == 8);
  }

  TEST_CASE("holes, groups, isolated points, streams, triangles and representatives are cut as well") {
    const Folder folder({{"p.csv", ring_shaped("lon,lat\n", false)},
                         {"g.csv", ring_shaped("lon,lat,name\n", false)},
                         {"east.csv", ring_shaped("lon,lat\n", true)}});
    REQUIRE(folder.rbpa("shape east.csv --alpha 0.2 -o o.wkt -q --stats t.json").code == 0);  // of which nothing is cut
    const double area = Json::parse(folder.content("t.json")).at("area");
    CHECK(contains(folder.content("o.wkt"), "184 4"));

    struct Run {
      std::string arguments, name;
      std::size_t features, parts, holes;
    };
    for (const auto& [arguments, name, features, parts, holes] : std::vector<Run>{
             {"shape p.csv --shift-longitude --alpha 0.2 -o o.geojson --isolated i.geojson", "o.geojson", 1, 2, 1},
             {"shape east.csv --alpha 0.2 -o o.geojson", "o.geojson", 1, 2, 1},
             {"shape east.csv --crs EPSG:4258 --alpha 0.2 -o o.geojson", "o.geojson", 1, 2, 1},
             {"shape east.csv --group-by-file --alpha 0.2 -o o.geojson", "o.geojson", 1, 2, 1},
             {"stream p.csv --shift-longitude --alpha 0.2 -o o.geojson", "o.geojson", 1, 2, 1}}) {
      const auto& shown_arguments = arguments;
      CAPTURE(shown_arguments);
      REQUIRE(folder.rbpa(arguments + " -q").code == 0);
      const Seen seen = look(folder, name);
      CHECK(seen.features == features);
      CHECK(seen.parts == parts);
      CHECK(seen.holes == holes);
      CHECK(seen.least == -180);
      CHECK(seen.greatest == 180);
      CHECK(valid_area(folder, name) == doctest::Approx(area).epsilon(1e-12));
    }
    const Seen isolated = look(folder, "i.geojson");
    CHECK(isolated.features == 2);
    CHECK(isolated.least == -170);
    CHECK(isolated.greatest == 170);

    REQUIRE(folder.rbpa("shape g.csv --shift-longitude --group-by name --alpha 0.2 -o g.geojson -q").code == 0);
    const Seen groups = look(folder, "g.geojson");
    CHECK(groups.features == 2);
    CHECK(groups.types == std::set<std::string>{"MultiPolygon"});
    CHECK(groups.least == -180);
    CHECK(groups.greatest == 180);
    CHECK(valid_area(folder, "g.geojson") > 20);

    REQUIRE(folder.rbpa("mesh p.csv --shift-longitude --alpha 0.2 -o t.geojson -o t.off -q").code == 0);
    const Seen triangles = look(folder, "t.geojson");
    CHECK(triangles.least == -180);
    CHECK(triangles.greatest == 180);
    CHECK(triangles.parts >= triangles.features);
    CHECK(valid_area(folder, "t.geojson") == doctest::Approx(area).epsilon(1e-12));

    REQUIRE(folder.rbpa("alpha p.csv --shift-longitude --representatives r.geojson -q").code == 0);
    const Seen pairs = look(folder, "r.geojson");
    CHECK(pairs.least >= -180);
    CHECK(pairs.greatest <= 180);
    CHECK(pairs.types.contains("MultiPolygon"));
  }

  TEST_CASE("triangles on both sides are cut, with the heights of the cut") {
    const Folder folder("p.csv", "lon,lat,z\n179,0,0\n181,0,10\n180,2,7\n");
    REQUIRE(folder.rbpa("mesh p.csv --alpha inf -o t.geojson -q").code == 0);
    const Json geometry = Json::parse(folder.content("t.geojson")).at("features")[0].at("geometry");
    CHECK(geometry == Json::parse(R"({"type":"MultiPolygon","coordinates":[
      [[[179,0,0],[180,0,5],[180,2,7],[179,0,0]]],[[[-180,0,5],[-179,0,10],[-180,2,7],[-180,0,5]]]]})"));
  }

  TEST_CASE("polygons are cut at -180 too, and are whole on one side of it or if not in degrees") {
    const Folder folder;
    const auto range = [&](const std::string& points, const std::string& options) {
      folder.file("p.csv", points);
      REQUIRE(folder.rbpa("shape p.csv --alpha 9 -q -o o.geojson" + options).code == 0);
      const Seen seen = look(folder, "o.geojson");
      return std::to_string(seen.parts) + ": " + std::to_string(static_cast<int>(seen.least)) + " " +
             std::to_string(static_cast<int>(seen.greatest));
    };
    CHECK(range("lon,lat\n-182,0\n-178,0\n-180,3\n", "") == "2: -180 180");
    CHECK(range("lon,lat\n-182,0\n-181,0\n-181,3\n", "") == "1: 178 179");
    CHECK(range("lon,lat\n182,0\n181,0\n181,3\n", "") == "1: -179 -178");
    CHECK(range("lon,lat\n180,0\n181,0\n181,3\n", "") == "1: -180 -179");
    CHECK(range("lon,lat\n180,0\n179,0\n179,3\n", "") == "1: 179 180");
    CHECK(range("x,y\n182,0\n178,0\n180,3\n", "") == "1: 178 182");
    CHECK(range("x,y\n182,0\n178,0\n180,3\n", " --crs EPSG:28992") == "1: 178 182");
    CHECK(range("x,y\n182,0\n178,0\n180,3\n", " --crs EPSG:4326") == "2: -180 180");
    CHECK(range("lon,lat\n400,0\n398,0\n400,3\n", "") == "1: 398 400");
  }
}
