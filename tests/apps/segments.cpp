// `--segments` of `rbpa mesh` and `rbpa grid`: lines that become edges, in every format of lines, and wrong calls.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

/// Five points of a roof: the ridge from (0, 2) to (8, 2) is 4 high, the eaves are at 0. A vertex at (4, 0) is no
/// corner of the roof.
constexpr const char* roof = "x,y,z\n0,0,0\n8,0,0\n8,4,0\n0,4,0\n4,0,0\n4,4,0\n";
constexpr const char* ridge = R"({"type":"LineString","coordinates":[[0,2,4],[8,2,4]]})";

/// Returns the lines that begin with "f " of an .obj, and the number of vertices.
std::pair<std::vector<std::string>, std::size_t> faces_of(const std::string& obj) {
  std::pair<std::vector<std::string>, std::size_t> found;
  for (std::size_t at = 0; at < obj.size();) {
    const std::size_t end = obj.find('\n', at);
    const std::string line = obj.substr(at, end - at);
    if (line.starts_with("f ")) found.first.push_back(line);
    found.second += line.starts_with("v ") ? 1U : 0U;
    at = end + 1;
  }
  return found;
}

}  // namespace

TEST_SUITE("segments") {
  TEST_CASE("a breakline becomes edges, its vertices are points with their heights, and heights break along it") {
    const Folder folder({{"roof.csv", roof}, {"ridge.geojson", ridge}});
    const Outcome outcome = folder.rbpa("mesh roof.csv --alpha inf --segments ridge.geojson -o tin.obj");
    CHECK(outcome.err == "rbpa: 8 points, 6 triangles, 0 isolated, 1 edge on segments -> tin.obj\n");
    const auto [faces, vertices] = faces_of(folder.content("tin.obj"));
    CHECK(faces.size() == 6);
    CHECK(vertices == 8);
    CHECK(contains(folder.content("tin.obj"), "v 8 2 4\n"));
    // Without the line, the triangles join the eaves; with it the ridge is a ridge.
    CHECK(folder.rbpa("grid roof.csv --cell 2 -o - --output-format asc -q").out.ends_with("\n0 0 0 0\n0 0 0 0\n"));
    CHECK(folder.rbpa("grid roof.csv --segments ridge.geojson --cell 2 -o - --output-format asc -q")
              .out.ends_with("\n2 2 2 2\n2 2 2 2\n"));
    CHECK(folder.rbpa("grid roof.csv --segments ridge.geojson --contours 2 -o - --output-format wkt -q").out ==
          "MULTILINESTRING Z ((0 1 2,2 1 2,6 1 2,8 1 2),(8 3 2,6 3 2,2 3 2,0 3 2))\n");
  }

  TEST_CASE("lines are read from every format that has them, and from standard input") {
    const Folder folder;
    folder.file("roof.csv", roof);
    folder.file("a.geojson", ridge);
    folder.file("b.wkt", "LINESTRING Z (0 2 4, 8 2 4)\n");
    folder.file("c.geojson",
                R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":)"
                R"("MultiLineString","coordinates":[[[0,2,4],[0,2,4],[8,2,4]]]}},{"type":"Feature","properties":{},)"
                R"("geometry":{"type":"Point","coordinates":[0,0,0]}}]})");
    const std::string call = "mesh roof.csv --alpha inf -q -o - --output-format obj --segments ";
    const auto expected = faces_of(folder.rbpa(call + "a.geojson").out).first;
    CHECK(expected.size() == 6);
    CHECK(faces_of(folder.rbpa(call + "b.wkt").out).first == expected);
    CHECK(faces_of(folder.rbpa(call + "- < b.wkt").out).first == expected);
    CHECK(faces_of(folder.rbpa(call + "c.geojson").out).first.size() == 6);
  }

  TEST_CASE("--inside keeps the triangles in closed lines, by the even-odd rule, and what is outside is isolated") {
    const Folder folder({{"p.xy", "-1 -1\n9 9\n4 4\n1 1\n"},
                         {"rings.wkt", "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (3 3, 5 3, 5 5, 3 5, 3 3))\n"}});
    CHECK(folder.rbpa("mesh p.xy --alpha inf --segments rings.wkt --inside -o m.geojson").err ==
          "rbpa: 12 points, 10 triangles, 3 isolated, 8 edges on segments -> m.geojson\n");
    double area = 0;
    const Json json = Json::parse(folder.content("m.geojson"));
    for (const Json& feature : json["features"]) {
      const Json& ring = feature["geometry"]["coordinates"][0];
      const auto at = [&](std::size_t i, std::size_t k) { return ring[i][k].get<double>(); };
      area += ((at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) - (at(1, 1) - at(0, 1)) * (at(2, 0) - at(0, 0))) / 2;
    }
    CHECK(area == 60);
  }

  TEST_CASE("lines that cross are refused with both places, or split, with the mean of both heights") {
    const Folder folder({{"p.csv", "x,y,z\n0,0,0\n4,0,0\n4,4,0\n0,4,0\n"},
                         {"x.wkt", "MULTILINESTRING Z ((0 0 0, 4 4 8), (0 4 2, 4 0 2))\n"}});
    const Outcome refused = folder.rbpa("mesh p.csv --alpha inf --segments x.wkt -o m.obj", 3);
    CHECK(refused.err ==
          "rbpa: x.wkt: segment 0 from (0, 0) to (4, 4) and segment 1 from (0, 4) to (4, 0): found a crossing, "
          "expected segments that meet in points (--split-crossings splits them)\n");
    CHECK(!folder.has("m.obj"));
    CHECK(folder.rbpa("mesh p.csv --alpha inf --segments x.wkt --split-crossings -o m.obj").err ==
          "rbpa: 9 points (4 duplicates), 4 triangles, 0 isolated, 4 edges on segments, 1 crossing split -> m.obj\n");
    CHECK(contains(folder.content("m.obj"), "v 2 2 3\n"));
  }

  TEST_CASE("a vertex without a height is put on the triangles of the points") {
    const Folder folder({{"p.csv", "x,y,z\n0,0,0\n4,0,4\n4,4,8\n0,4,4\n"}, {"flat.wkt", "LINESTRING (1 1, 3 2)\n"}});
    folder.rbpa("mesh p.csv --alpha inf --segments flat.wkt -q -o m.obj");
    CHECK(contains(folder.content("m.obj"), "v 1 1 2\nv 3 2 5\n"));
    // Outside of the triangles: (9, 9) is nearest to the corner (4, 4), and (2, -3) to the side at y = 0.
    folder.file("far.wkt", "LINESTRING (9 9, 1 1, 2 -3)\n");
    const Outcome far = folder.rbpa("mesh p.csv --alpha inf --segments far.wkt -o m.obj");
    CHECK(far.err == "rbpa: 7 points, 7 triangles, 0 isolated, 3 edges on segments -> m.obj\n");
    CHECK(contains(folder.content("m.obj"), "v 9 9 8\nv 1 1 2\nv 2 -3 2\n"));
    // Heights near the greatest double, at a crossing.
    folder.file("huge.wkt", "MULTILINESTRING Z ((0 0 1e308, 4 4 1e308), (0 4 1e308, 4 0 1e308))\n");
    folder.rbpa("mesh p.csv --alpha inf --segments huge.wkt --split-crossings -q -o m.obj");
    CHECK(contains(folder.content("m.obj"), "v 2 2 1e+308\n"));
  }

  TEST_CASE("lines are shifted like the points, and have the system that --crs says") {
    const Folder folder;
    folder.file("p.csv", "lon,lat\n179,0\n-179,0\n-179,2\n179,2\n");
    folder.file("l.geojson", R"({"type":"LineString","coordinates":[[179.5,0.5],[180,1],[-179.5,1.5]]})");
    folder.rbpa("mesh p.csv --shift-longitude --alpha inf --segments l.geojson -q -o m.obj");
    CHECK(contains(folder.content("m.obj"), "v 180.5 1.5 0\n"));
    folder.file("q.wkt", "SRID=28992;MULTIPOINT (0 0, 4 0, 4 4, 0 4)\n");
    folder.file("k.geojson", R"({"type":"LineString","coordinates":[[1,1],[3,2]]})");
    CHECK(folder.rbpa("mesh q.wkt --alpha inf --segments k.geojson -o m.obj")
              .err.ends_with("k.geojson: found points in EPSG:4326, which GeoJSON without a crs member means, expected "
                             "EPSG:28992, as in q.wkt (--crs EPSG:CODE applies to all)\n"));
    CHECK(folder.rbpa("mesh q.wkt --alpha inf --segments k.geojson --crs EPSG:28992 -o m.obj").code == 0);
  }

  TEST_CASE("input indices count points that are left out before the vertices of lines") {
    const Folder folder(
        {{"p.csv", "x,y,class\n9,9,1\n0,0,2\n4,0,2\n4,4,2\n0,4,2\n"}, {"line.wkt", "LINESTRING (0 0, 4 4)\n"}});
    folder.rbpa("mesh p.csv --where \"class == 2\" --alpha inf --segments line.wkt -q -o m.npy");
    const std::string array = folder.content("m.npy");
    CHECK(contains(array, "'shape': (2, 3)"));
    CHECK(folder.rbpa("mesh p.csv --alpha inf --segments line.wkt --stats s.json -q -o m.npy").code == 0);
    CHECK(Json::parse(folder.content("s.json"))["points"] == 7);
  }

  TEST_CASE("wrong calls are refused, and files without lines") {
    const Folder folder(
        {{"p.csv", roof}, {"line.wkt", "LINESTRING Z (0 2 4, 8 2 4)\n"}, {"points.wkt", "MULTIPOINT (0 2, 8 2)\n"}});
    const std::pair<const char*, const char*> calls[] = {
        {"mesh p.csv --alpha 3 --segments line.wkt -o m.obj", "--segments requires --alpha inf"},
        {"mesh p.csv --alpha inf --split-crossings -o m.obj", "--split-crossings requires --segments"},
        {"mesh p.csv --alpha inf --inside -o m.obj", "--inside requires --segments"},
        {"mesh p.csv --alpha inf --segments line.wkt --method hrbpa -o m.obj",
         "--method hrbpa cannot be combined with --segments"},
        {"mesh p.csv --alpha inf --segments line.wkt --complex full -o m.obj",
         "--complex full cannot be combined with --segments"},
        {"mesh p.csv --alpha inf --segments line.wkt --group-by z -o m.ply",
         "--segments cannot be combined with --group-by"},
        {"mesh p.csv --alpha inf --segments line.wkt -o line.wkt", "line.wkt"},
        {"mesh p.csv --alpha inf --segments scan.las -o m.obj",
         "--segments: found the ending 'las', expected one of geojson, json, wkt, ewkt"},
        {"mesh - --alpha inf --segments - -o m.obj", "--segments -: found POINTS on standard input as well"},
        {"grid p.csv --cell 1 --segments line.wkt --method natural -o g.asc",
         "--method natural cannot be combined with --segments"},
        {"grid p.csv --cell 1 --segments line.wkt --value y -o g.asc", "--value cannot be combined with --segments"},
    };
    for (const auto& each : calls) {
      const Outcome outcome = folder.rbpa(each.first);
      INFO(each.first);
      CHECK(outcome.code == 2);
      CHECK_MESSAGE(contains(outcome.err, each.second), outcome.err);
    }
    refuses(folder, "mesh p.csv --alpha inf --segments points.wkt -o m.obj", 3,
            "points.wkt: found no line, expected lines or polygons");
    CHECK(folder.rbpa("mesh p.csv --alpha inf --segments missing.wkt -o m.obj").code == 3);
  }
}
