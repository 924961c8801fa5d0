// Heights of triangulations: vertices keep z in every format that can contain it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/las_file.h"
#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

struct Place {
  double x, y, z;
  friend auto operator<=>(const Place&, const Place&) = default;
};
using Places = std::vector<Place>;

/// Four corners and a point in the middle, with different heights.
const Places given = {{0, 0, 1}, {4, 0, 2.5}, {4, 4, -3}, {0, 4, 8}, {1.5, 2, 0.25}};

std::string number(double value) { return Json(value).dump(); }
template <typename Line>
std::string lines(const Line& line) {
  std::string text;
  for (const Place& p : given) text += line(number(p.x), number(p.y), number(p.z)) + "\n";
  return text;
}

struct Input {
  std::string name, content;
};

std::string with_commas(std::string text) {
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::vector<Input> inputs() {
  const auto columns = [](const std::string& between) {
    return lines([&](auto x, auto y, auto z) { return x + between + y + between + z; });
  };
  LasFile las;
  std::string binary, npy, geojson = "{\"type\":\"MultiPoint\",\"coordinates\":[";
  for (const Place& p : given) {
    const auto scaled = [](double value) { return static_cast<std::int32_t>(std::lround(value * 100)); };
    las.points.push_back({.x = scaled(p.x), .y = scaled(p.y), .z = scaled(p.z)});
    binary += little(p.x) + little(p.z) + little(p.y);
    npy += little(p.x) + little(p.y) + little(p.z);
    geojson += (geojson.back() == '[' ? "[" : ",[") + number(p.x) + "," + number(p.y) + "," + number(p.z) + "]";
  }
  const std::string ply =
      " 1.0\nelement vertex 5\nproperty double x\nproperty double z\nproperty double y\nend_header\n";
  return {{"p.las", bytes_of(las)},
          {"p.csv", "x,y,z\n" + columns(",")},
          {"q.csv", "Elevation;x;y\n" + lines([](auto x, auto y, auto z) { return z + ";\"" + x + "\";" + y; })},
          {"c.csv", "x;y;z\n" + with_commas(columns(";"))},
          {"p.xyz", columns(" ")},
          {"p.txt", columns("\t")},
          {"p.pts", "5\n" + columns(" ")},
          {"p.off", "OFF\n5 0 0\n" + columns(" ")},
          {"a.ply", "ply\nformat ascii" + ply + lines([](auto x, auto y, auto z) { return x + " " + z + " " + y; })},
          {"b.ply", "ply\nformat binary_little_endian" + ply + binary},
          {"p.npy", npy_file("{'descr': '<f8', 'fortran_order': False, 'shape': (5, 3)}", npy)},
          {"p.geojson", geojson + "]}"},
          {"p.wkt", lines([](auto x, auto y, auto z) { return "POINT Z (" + x + " " + y + " " + z + ")"; })},
          {"w.csv",
           "id,geom\n" + lines([](auto x, auto y, auto z) { return "1,POINT Z (" + x + " " + y + " " + z + ")"; })}};
}

/// Returns the vertices of a mesh file: OFF, OBJ, our binary PLY or VTU, or GeoJSON.
Places vertices(const Folder& folder, const std::string& name) {
  Places places;
  const std::string content = folder.content(name);
  const auto words = [](const std::string& line) {
    std::vector<std::string> all = {""};
    for (const char c : line) c == ' ' ? all.emplace_back() : all.back() += c;
    return all;
  };
  if (name.ends_with(".geojson")) {
    const Json file = Json::parse(content);
    for (const Json& feature : file.at("features"))
      for (const Json& p : feature.at("geometry").at("coordinates")[0]) places.push_back({p[0], p[1], p.at(2)});
    return places;
  }
  if (name.ends_with(".ply") || name.ends_with(".vtu")) {
    const bool is_ply = name.ends_with(".ply");
    const std::string mark = is_ply ? "end_header\n" : "encoding=\"raw\">\n_",
                      count = is_ply ? "element vertex " : "NumberOfPoints=\"";
    const std::size_t n = std::stoul(content.substr(content.find(count) + count.size()));
    const char* at = content.data() + content.find(mark) + mark.size() + (is_ply ? 0 : 8);
    for (std::size_t i = 0; i < n; ++i, at += 24) {
      double p[3];
      std::copy_n(at, 24, reinterpret_cast<char*>(p));
      places.push_back({p[0], p[1], p[2]});
    }
    return places;
  }
  std::size_t left = 0;
  for (std::size_t begin = 0, number_of = 0; begin < content.size(); ++number_of) {
    const std::size_t end = content.find('\n', begin);
    const std::vector<std::string> of = words(content.substr(begin, end - begin));
    begin = end + 1;
    const std::size_t first = name.ends_with(".obj") ? 1 : 0;
    if (name.ends_with(".off") && number_of == 1) left = std::stoul(of[0]);
    const bool is_vertex = name.ends_with(".obj") ? of[0] == "v" : number_of > 1 && left > 0 && left-- > 0;
    if (is_vertex) places.push_back({std::stod(of[first]), std::stod(of[first + 1]), std::stod(of[first + 2])});
  }
  return places;
}

Places sorted(Places places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

const std::vector<std::string> writers = {"t.off", "t.obj", "t.ply", "t.vtu", "t.geojson"};
std::string all_writers() {
  std::string text;
  for (const std::string& name : writers) text += " -o " + name;
  return text;
}

}  // namespace

TEST_SUITE("heights of triangles") {
  TEST_CASE("every format with a third coordinate keeps it in every format with vertices") {
    for (const auto& [name, content] : inputs()) {
      const Folder folder;
      const auto& shown_name = name;
      CAPTURE(shown_name);
      folder.file(name, content);
      const Outcome outcome = folder.rbpa("mesh " + name + " --alpha inf --fields none" + all_writers(), 0);
      CHECK(!contains(outcome.err, "is not used"));
      CHECK(contains(outcome.err, "column 3 is read as z") == (name == "p.txt"));
      for (const std::string& writer : writers) {
        CAPTURE(writer);
        CHECK((writer == "t.geojson" ? sorted(vertices(folder, writer)) : vertices(folder, writer)) ==
              (writer == "t.geojson" ? sorted(given) : given));
      }
    }
  }

  TEST_CASE("groups, --compact, the full complex and files in groups keep heights; duplicates keep their own") {
    const Folder folder("p.csv",
                        "x,y,z,g\n9,9,7,b\n0,0,1,a\n1,0,2,a\n0,1,3,a\n0,0,50,a\n8,9,5,b\n9,8,6,b\n30,30,4,b\n");
    const Places all = {{9, 9, 7}, {0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {0, 0, 50}, {8, 9, 5}, {9, 8, 6}, {30, 30, 4}},
                 used = {{9, 9, 7}, {0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {8, 9, 5}, {9, 8, 6}};
    const auto made = [&](const std::string& arguments, const std::string& name) {
      REQUIRE(folder.rbpa("mesh p.csv --columns x,y --alpha 2 -q -o " + name + " " + arguments).code == 0);
      return vertices(folder, name);
    };
    for (const std::string name : {"t.obj", "t.ply", "t.vtu", "t.off"}) {
      CAPTURE(name);
      CHECK(made("--fields none", name) == all);
      CHECK(made("--fields none --method hrbpa --levels l.csv", name) == all);
      CHECK(made("--fields none --compact", name) == used);
      CHECK(made("--fields none --group-by g", name) == all);
      CHECK(made("--fields none --group-by g --compact", name) == used);
    }
    CHECK(made("--complex full", "f.obj") == all);
    CHECK(made("--complex full", "f.vtu") == all);
    CHECK(sorted(made("", "t.geojson")) == sorted(used));
    // Mesh a file with empty heights together with a file with heights.
    folder.file("flat.csv", "x,y,z\n20,0,\n21,0,\n20,1,\n");
    says(folder, "mesh p.csv flat.csv --columns x,y --alpha 2 --group-by-file -o j.obj", 0,
         "3 points have no z: 0 is written in its place\n");
    CHECK(vertices(folder, "j.obj").back() == Place{20, 1, 0});
    CHECK(vertices(folder, "j.obj").front() == all.front());
    REQUIRE(folder.rbpa("mesh p.csv --columns x,y --group-by g --alpha 2 -o g.geojson -q").code == 0);
    const Json features = Json::parse(folder.content("g.geojson")).at("features");
    REQUIRE(features.size() == 2);
    CHECK(features[0].at("properties").at("group") == "a");
    CHECK(features[1].at("properties") == Json::parse(R"({"number":2,"group":"b","points":4,"alpha":2,"area":0.5})"));
  }

  TEST_CASE("without heights z is 0, positions of GeoJSON have two numbers; pictures and arrays need none") {
    const Folder folder("p.xy", corner);
    REQUIRE(folder.rbpa("mesh p.xy --alpha 2 -o t.obj -o t.geojson -q").code == 0);
    CHECK(vertices(folder, "t.obj") == Places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(contains(folder.content("t.geojson"), "\"coordinates\":[[[0,0],[1,0],[0,1],[0,0]]]"));
    folder.file("p.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n");
    CHECK(contains(folder.rbpa("mesh p.csv --alpha 2 -o t.npy -o t.svg").err, "z of 3 points is not used"));
    CHECK(contains(folder.rbpa("shape p.csv --alpha 2 -o s.wkt").err, "z of 3 points is not used"));
    const std::string flat = "p.csv: meshes of tiles have z = 0 (rbpa mesh keeps heights";
    CHECK(contains(folder.rbpa("stream p.csv --alpha 2 -o 't*.ply'").err, flat));
    CHECK(!contains(folder.rbpa("stream p.csv --alpha 2 -o t.wkt").err, "z = 0"));
  }

  TEST_CASE("fill keeps heights of polygons, and new points lie on the surface between them") {
    const Folder folder;
    const std::string square = std::string(RBPA_TEST_DATA) + "/findings/gis_tin_z/z.geojson";
    REQUIRE(folder.rbpa("fill " + square + " --size inf -q" + all_writers()).code == 0);
    const Places corners = {{0, 0, 10}, {100, 0, 11}, {100, 60, 12}, {0, 60, 13}};
    for (const std::string& writer : writers) CHECK(sorted(vertices(folder, writer)) == sorted(corners));
    folder.file("plane.wkt", "POLYGON Z ((0 0 1, 8 0 17, 8 6 -1, 0 6 -17), (2 2 -1, 2 4 -7, 4 4 -3, 4 2 3))");
    for (const std::string options : {"--size 0.7", "--size 0.7 --keep-boundary", "--size 3"}) {
      REQUIRE(folder.rbpa("fill plane.wkt " + options + " -q -o t.ply").code == 0);
      const Places made = vertices(folder, "t.ply");
      CHECK(made.size() > 8);
      for (const Place& p : made) CHECK(p.z == doctest::Approx(1 + 2 * p.x - 3 * p.y));
    }
    folder.file("mixed.geojson", R"({"type":"Polygon","coordinates":[[[0,0,5],[4,0],[4,4,5],[0,4,5],[0,0,5]]]})");
    CHECK(contains(folder.rbpa("fill mixed.geojson --size inf -o t.obj").err,
                   "1 point has no z: 0 is written in its place"));
    folder.file("flat.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]})");
    REQUIRE(folder.rbpa("fill flat.geojson --size 1 -o t.obj -o t.geojson -q").code == 0);
    for (const Place& p : vertices(folder, "t.obj")) CHECK(p.z == 0);
    CHECK(Json::parse(folder.content("t.geojson")).at("features")[0].at("geometry").at("coordinates")[0][0].size() ==
          2);
  }
}
