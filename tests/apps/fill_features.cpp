// `rbpa fill` of several features: shared edges, invalid features, properties of triangles.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/vtu_arrays.h"

using namespace apps_test;
using nlohmann::json;

namespace {

std::string feature(const std::string& properties, const std::string& ring) {
  return R"({"type": "Feature", "properties": )" + properties +
         R"(, "geometry": {"type": "Polygon", "coordinates": [)" + ring + "]}}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text;
  for (const std::string& one : features) text += (text.empty() ? "" : ",\n") + one;
  return R"({"type": "FeatureCollection", "features": [)" + text + "]}";
}

/// Three parcels, with a repeated vertex and one in the middle of an edge.
std::vector<std::string> parcels() {
  return {
      feature(R"({"height": 3, "name": "a", "zone": {"n": 9}, "list": [5]})", "[[0,0],[4,0],[4,0],[4,3],[0,3],[0,0]]"),
      feature(R"({"feature": 7, "height": 4.5})", "[[4,0],[8,0],[8,3],[4,3],[4,0]]"),
      feature("null", "[[0,3],[4,3],[6,3],[8,3],[8,6],[0,6],[0,3]]")};
}
const std::string bow = feature(R"({"height": 1})", "[[10,0],[12,2],[12,0],[10,2],[10,0]]");

}  // namespace

TEST_SUITE("fill") {
  TEST_CASE("parcels that share edges become one mesh, and each triangle has the numbers of its feature") {
    const Folder folder("p.json", collection(parcels()));
    const Outcome outcome = folder.rbpa("fill p.json --size 1 -o p.vtu -o p.ply --stats s.json", 0);
    CHECK(outcome.err.starts_with("rbpa: 3 polygons with 0 holes, area 48, "));
    const json stats = json::parse(folder.content("s.json"));
    CHECK(stats["features"] == 3);
    CHECK(stats["invalid_features"] == 0);
    CHECK(stats["boundary_curves"] == 1);
    CHECK(stats["components"] == 1);
    const json topology = json::parse(folder.meshtopo("p.ply --json").out);
    CHECK(topology["defects"].empty());
    CHECK(topology["boundary_curves"] == 1);
    const std::string vtu = folder.content("p.vtu");
    const auto features = array_of<std::uint32_t>(vtu, "feature");
    const auto heights = array_of<double>(vtu, "height"), sevens = array_of<double>(vtu, "feature_2");
    REQUIRE(features.size() == stats["triangles"].get<std::size_t>());
    REQUIRE(heights.size() == features.size());
    REQUIRE(sevens.size() == features.size());
    std::array<std::size_t, 3> count{};
    for (std::size_t t = 0; t < features.size(); ++t) {
      REQUIRE(features[t] < 3);
      ++count[features[t]];
      CHECK((features[t] == 0 ? heights[t] == 3 : features[t] == 1 ? heights[t] == 4.5 : std::isnan(heights[t])));
      CHECK((features[t] == 1 ? sevens[t] == 7 : std::isnan(sevens[t])));
    }
    for (const std::size_t n : count) CHECK(n > 5);
    for (const std::string name : {"name", "zone", "n", "list"}) CHECK(array_of<double>(vtu, name).empty());
    CHECK(
        contains(folder.content("p.ply"), "property list uchar int vertex_indices\nproperty uint feature\nend_header"));
  }

  TEST_CASE("names of properties are XML in a .vtu: control characters are spaces, and signs are entities") {
    const Folder folder(
        "p.json",
        collection({feature(R"({"a>b<c&d\"e": 1.5, "tab\tand\u0001": 2.5})", "[[0,0],[1,0],[1,1],[0,1],[0,0]]")}));
    REQUIRE(folder.rbpa("fill p.json --size 1 -o p.vtu -q").code == 0);
    const std::string vtu = folder.content("p.vtu"), head = vtu.substr(0, vtu.find("<AppendedData"));
    for (const double value : array_of<double>(vtu, "a&gt;b&lt;c&amp;d&quot;e")) CHECK(value == 1.5);
    for (const double value : array_of<double>(vtu, "tab and ")) CHECK(value == 2.5);
    const std::size_t triangles = array_of<std::uint32_t>(vtu, "feature").size();
    CHECK(triangles > 0);
    CHECK(array_of<double>(vtu, "a&gt;b&lt;c&amp;d&quot;e").size() == triangles);
    CHECK(array_of<double>(vtu, "tab and ").size() == triangles);
    CHECK(std::all_of(head.begin(), head.end(), [](char c) { return c == '\n' || c >= ' '; }));
  }

  TEST_CASE("a feature that is not valid is named; --skip-invalid leaves it out and counts it") {
    const Folder folder;
    std::vector<std::string> features = parcels();
    features.insert(features.begin() + 1, bow);
    folder.file("p.json", collection(features));
    const std::string why =
        "feature 1: the edge from vertex 0 (10, 0) to vertex 1 (12, 2) of the shell of polygon 0 crosses the edge from "
        "vertex 2 (12, 0) to vertex 3 (10, 2) of the shell of polygon 0; expected rings that meet in single points at "
        "most";
    refuses(folder, "fill p.json --size 1 -o p.vtu", 3, "p.json: " + why + " (--skip-invalid leaves it out)");
    CHECK_FALSE(folder.has("p.vtu"));
    const Outcome skipped = folder.rbpa("fill p.json --size 1 -o p.vtu --skip-invalid --stats s.json", 0);
    CHECK(skipped.err.starts_with("rbpa: p.json: 1 feature of 4 is left out: " + why +
                                  "\nrbpa: 3 polygons with 0 holes, 1 invalid feature left out, area 48, "));
    CHECK(json::parse(folder.content("s.json"))["invalid_features"] == 1);
    for (const std::uint32_t i : array_of<std::uint32_t>(folder.content("p.vtu"), "feature")) CHECK((i != 1 && i < 4));
    folder.file("bow.json", bow);
    says(folder, "fill bow.json --size 1 -o b.ply --skip-invalid", 0, "there is no triangle");
  }

  TEST_CASE("each geometry of a collection is checked by itself, and features may overlap") {
    const Folder folder;
    const std::string square = "((0 0, 2 0, 2 2, 0 2, 0 0))", other = "((1 1, 3 1, 3 3, 1 3, 1 1))";
    folder.file("c.wkt", "GEOMETRYCOLLECTION (POLYGON " + square + ", POLYGON " + other + ")\nPOLYGON EMPTY\nPOLYGON " +
                             square + "\n");
    REQUIRE(folder.rbpa("fill c.wkt --size inf -o c.vtu -q").code == 0);
    const auto features = array_of<std::uint32_t>(folder.content("c.vtu"), "feature");
    CHECK(std::vector<std::size_t>{4, 0, 2} ==
          std::vector<std::size_t>{static_cast<std::size_t>(std::count(features.begin(), features.end(), 0U)),
                                   static_cast<std::size_t>(std::count(features.begin(), features.end(), 1U)),
                                   static_cast<std::size_t>(std::count(features.begin(), features.end(), 2U))});
    folder.file("m.wkt", "POLYGON " + square + "\nMULTIPOLYGON (" + square + ", " + other + ")");
    CHECK(folder.rbpa("fill m.wkt --size inf -o m.vtu", 3).err.starts_with("rbpa: m.wkt: feature 1: "));
  }
}
