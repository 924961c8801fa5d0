// `rbpa grid`: rasters and contour lines of heights, and wrong calls.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "support/program.h"

using namespace apps_test;
using Json = nlohmann::json;

namespace {

/// Returns lines "x,y,z,d" of n × n places on a grid of pitch 2, with z = 3 x − y and d = x² + y.
std::string plane_of(int n, const std::string& header = "x,y,z,d\n") {
  std::string text = header;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const int x = 2 * i, y = 2 * k;
      for (const int number : {x, y, 3 * x - y}) text += std::to_string(number) + ",";
      text += std::to_string(x * x + y) + "\n";
    }
  return text;
}

}  // namespace

TEST_SUITE("grid") {
  TEST_CASE("the raster of a plane is the plane, as an ESRI grid and as an array, top row first") {
    const Folder folder("p.csv", plane_of(3));
    const Outcome outcome = folder.rbpa("grid p.csv --cell 2 -o g.asc -o g.npy");
    CHECK(outcome.err == "rbpa: 9 points, 2 x 2 cells, 4 with a value -> g.asc, g.npy\n");
    CHECK(folder.content("g.asc") ==
          "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9999\n0 6\n2 8\n");
    const std::string array = folder.content("g.npy");
    REQUIRE(array.size() == 128 + 4 * sizeof(double));
    CHECK(contains(array, "'descr': '<f8', 'fortran_order': False, 'shape': (2, 2)"));
    double cells[4];
    std::memcpy(cells, array.data() + 128, sizeof cells);
    for (int i = 0; i < 4; ++i) CHECK(cells[i] == 2 * (i / 2) + 6 * (i % 2));
    // Another column, another method, the box of a tile, more cells than the hull has.
    CHECK(folder.rbpa("grid p.csv --cell 2 --value d -o - --output-format asc -q").out.ends_with("\n5 13\n3 11\n"));
    CHECK(folder.rbpa("grid p.csv --cell 1 --method natural --extent 1,1,3,2 -o - --output-format asc -q")
              .out.ends_with("ncols 2\nnrows 1\nxllcorner 1\nyllcorner 1\ncellsize 1\nNODATA_value -9999\n3 6\n"));
    CHECK(
        folder.rbpa("grid p.csv --cell 2 --extent=-1,0,1,1 -o - --output-format asc -q").out.ends_with("\n-9999 2\n"));
    CHECK(folder.rbpa("grid p.csv --cell 100 -o - --output-format asc -q").out.ends_with("\n-9999\n"));
  }

  TEST_CASE("gaps stay open with --alpha, and a value as low as -9999 gets another NODATA_value") {
    const Folder folder("gap.csv", "x,y,z\n0,0,1\n0,2,1\n2,0,1\n2,2,1\n8,0,-9999\n8,2,-9999\n10,0,-9999\n10,2,-9999\n");
    const std::string call = "grid gap.csv --cell 2 -q -o - --output-format asc";
    CHECK(folder.rbpa(call + " --alpha 1.5").out.ends_with("NODATA_value -1e+300\n1 -1e+300 -1e+300 -1e+300 -9999\n"));
    CHECK(contains(folder.rbpa(call).out, "-1e+300\n1 "));
    CHECK(folder.rbpa(call).out.find(" -1e+300") == folder.rbpa(call).out.rfind(" -1e+300"));  // in the header alone
    CHECK(contains(folder.rbpa("grid gap.csv --cell 2 --alpha plateau -o g.asc").err, ", alpha plateau = "));
  }

  TEST_CASE("a raster as text, which cannot name the system of --crs, comes with a warning") {
    const Folder folder("p.csv", plane_of(3));
    const std::string call = "grid p.csv --cell 1 -o g.asc -o g.npy";
    CHECK(contains(folder.rbpa(call + " --crs EPSG:28992").err,
                   "rbpa: g.asc does not name EPSG:28992 (gdal_translate -a_srs EPSG:28992 does)\n"));
    CHECK(!contains(folder.rbpa(call).err, "does not name"));
  }

  TEST_CASE("contour lines are LineStrings with their heights, one MULTILINESTRING Z, or a picture") {
    const Folder folder("p.csv", plane_of(3));
    CHECK(folder.rbpa("grid p.csv --contours 9,3,9 --crs EPSG:28992 -o l.geojson -o l.wkt -o l.svg -o l.png")
              .err.ends_with(
                  "\nrbpa: 9 points, 2 contour lines at 2 heights -> l.geojson, l.wkt, l.svg, l.png, l.pgw\n"));
    CHECK(folder.content("l.wkt") ==
          "MULTILINESTRING Z ((2.3333333333333335 4 3,2.25 3.75 3,2 3 3,1.75 2.25 3,1.6666666666666667 2 3,1.25 0.75 "
          "3,1 0 3),(4 3 9,3.75 2.25 9,3.666666666666667 2 9,3.25 0.75 9,3 0 9))\n");
    const Json json = Json::parse(folder.content("l.geojson"));
    CHECK(json["crs"]["properties"]["name"] == "urn:ogc:def:crs:EPSG::28992");
    REQUIRE(json["features"].size() == 2);
    for (const Json& line : json["features"]) {
      CHECK(line["geometry"]["type"] == "LineString");
      CHECK(line["properties"]["closed"] == false);
      for (const Json& at : line["geometry"]["coordinates"])
        CHECK(3 * at[0].get<double>() - at[1].get<double>() == doctest::Approx(line["properties"]["height"]));
    }
    CHECK(contains(folder.content("l.svg"), "<path id=\"dangling\""));
    folder.file("peak.csv", "x,y,z\n0,0,0\n4,0,0\n4,4,0\n0,4,0\n2,2,10\n");
    const Json ring = Json::parse(folder.rbpa("grid peak.csv --contours every:5 -o - --output-format geojson -q").out);
    REQUIRE(ring["features"].size() == 1);  // at 5; at 10 the line is a point
    CHECK(ring["features"][0]["properties"] == Json{{"height", 5}, {"closed", true}});
    CHECK(ring["features"][0]["geometry"]["coordinates"] == Json{{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}});
    CHECK(folder.rbpa("grid peak.csv --contours 70 -o - --output-format wkt -q").out == "MULTILINESTRING Z EMPTY\n");
  }

  TEST_CASE("points in any order and any number of threads have the same files") {
    const Folder folder;
    std::string forward, backward;
    for (int i = 0; i < 12000; ++i) {
      const double x = std::fmod(i * 0.7548776662, 1) * 300, y = std::fmod(i * 0.5698402910, 1) * 200;
      std::ostringstream line;
      line << x << " " << y << " " << std::sin(x) + y << "\n";
      forward += line.str();
      backward = line.str() + backward;
    }
    folder.file("f.xyz", forward);
    folder.file("b.xyz", backward);
    for (const std::string method : {"linear", "natural"}) {
      const std::string options = " --method " + method + " --cell 1 --alpha 3 --contours every:10 ";
      folder.rbpa("grid f.xyz" + options + "-o 1.asc -o 1.wkt --threads 1 -q");
      folder.rbpa("grid b.xyz" + options + "-o 2.asc -o 2.wkt --threads 2 -q");
      folder.rbpa("grid b.xyz" + options + "-o 7.asc -o 7.wkt --threads 7 -q");
      REQUIRE(folder.content("1.asc").size() > 60000);
      for (const std::string other : {"2", "7"}) {
        CHECK(folder.content(other + ".asc") == folder.content("1.asc"));
        CHECK(folder.content(other + ".wkt") == folder.content("1.wkt"));
      }
    }
  }

  TEST_CASE("points without a triangle have a raster without values, and no lines") {
    const Folder folder({{"line.xyz", "0.5 0.5 1\n1.5 1.5 2\n2.5 2.5 3\n"}, {"one.xyz", "0.5 0.5 1\n"}});
    CHECK(folder.rbpa("grid line.xyz --cell 1.5 -o - --output-format asc -q")
              .out.ends_with("\n-9999 -9999\n-9999 -9999\n"));
    CHECK(folder.rbpa("grid one.xyz --cell 1 -o - --output-format asc -q").out.ends_with("\n-9999\n"));
    CHECK(folder.rbpa("grid line.xyz --contours every:1 -o - --output-format wkt -q").out ==
          "MULTILINESTRING Z EMPTY\n");
  }

  TEST_CASE("a result without content is written, and its reason is said, also with -q") {
    const Folder folder({{"line.xyz", "0 0 1\n1 1 2\n2 2 3\n"},
                         {"p.xyz", "0 0 1\n1 0 2\n0 1 3\n"},
                         {"none.wkt", "MULTIPOINT EMPTY\n"}});
    const std::pair<std::string, std::string> calls[] = {
        {"line.xyz --cell 1 -o o.asc", "no cell has a value: all points are collinear"},
        {"none.wkt --cell 1 -o o.asc", "no cell has a value: fewer than three distinct points (0)"},
        {"p.xyz --cell 1 --extent 5,5,6,6 -o o.asc", "no cell has a value: the center of no cell is in a triangle"},
        {"p.xyz --cell 1 --alpha 0.1 -o o.asc",
         "no cell has a value: the center of no cell is in a triangle of circumradius <= 0.1"},
        {"p.xyz --contours 7,8 -o o.wkt",
         "there is no contour line: no height of --contours is above the lowest, 1, and up to the highest, 3"},
        {"line.xyz --contours 2 -o o.wkt", "there is no contour line: all points are collinear"},
        {"p.xyz --contours 2 --alpha 0.1 -o o.wkt",
         "there is no contour line: no triangle of circumradius <= 0.1 reaches a height"},
        {"none.wkt --contours 2 -o o.wkt", "there is no contour line: there is no point"}};
    for (const auto& [call, reason] : calls) {
      const std::string arguments = "grid " + call + " -q";
      CAPTURE(arguments);
      CHECK(folder.rbpa(arguments, 0).err == "rbpa: " + reason + "\n");
    }
    CHECK(folder.rbpa("grid p.xyz --cell 1 --contours 2 -o o.asc -o o.wkt -q", 0).err.empty());
  }

  TEST_CASE("of several heights at one place the lowest counts, in any order of the file, and a warning counts them") {
    const std::string a = "0 0 5\n0 0 1\n4 0 2\n4 0 2\n0 4 3\n4 4 4\n0 4 9\n0 0 7\n";
    const std::string b = "0 0 7\n0 4 9\n4 4 4\n0 4 3\n4 0 2\n4 0 2\n0 0 1\n0 0 5\n";
    const Folder folder({{"a.xyz", a}, {"b.xyz", b}, {"lines.wkt", "LINESTRING (0 0, 4 4)\n"}});
    for (const std::string run :
         {"--cell 1 -o X.asc", "--contours 2.5 -o X.wkt", "--cell 1 --segments lines.wkt -o X.asc"}) {
      CAPTURE(run);
      for (const std::string name : {"a", "b"}) {
        std::string arguments = run;
        arguments.replace(arguments.find('X'), 1, name);
        CHECK(contains(folder.rbpa("grid " + name + ".xyz " + arguments, 0).err,
                       name + ".xyz: 2 places have points of several heights: the lowest counts\n"));
      }
      const std::string ending = run.substr(run.rfind('.'));
      CHECK(folder.content("a" + ending) == folder.content("b" + ending));
    }
    for (const std::string grouped : {"", " --group-by g"}) {
      folder.file("a.csv", "x,y,z,g\n0,0,5,1\n0,0,1,1\n4,0,2,1\n0,4,3,1\n");
      folder.file("b.csv", "x,y,z,g\n0,0,1,1\n0,0,5,1\n4,0,2,1\n0,4,3,1\n");
      for (const std::string name : {"a", "b"})
        CHECK(contains(folder.rbpa("mesh " + name + ".csv --alpha inf --compact -o " + name + ".obj" + grouped, 0).err,
                       "1 place has points of several heights: the lowest counts\n"));
      CHECK(contains(folder.content("a.obj"), "v 0 0 1\n"));
      CHECK(folder.content("a.obj") == folder.content("b.obj"));
    }
    folder.file("apart.csv", "x,y,z,g\n0,0,5,1\n1,0,5,1\n0,1,5,1\n0,0,1,2\n1,0,1,2\n0,1,1,2\n");
    CHECK(!contains(folder.rbpa("mesh apart.csv --alpha inf --group-by g -o o.obj", 0).err, "several heights"));
  }

  TEST_CASE("wrong calls and values are refused, and nothing is written") {
    const Folder folder({{"p.csv", plane_of(3)},
                         {"missing.csv", "x,y,z,d\n0,0,1,2\n1,1,,3\n1,0,4,nan\n"},
                         {"flat.csv", "x,y,name\n0,0,a\n1,1,b\n0,1,c\n"}});
    const std::pair<const char*, const char*> calls[] = {
        {"p.csv -o o.asc", "o.asc requires --cell"},
        {"p.csv --cell 1 -o o.asc -o o.wkt", "o.wkt requires --contours"},
        {"p.csv --cell 1 -o o.wkt --contours 1", "--cell requires an OUT in one of asc, npy"},
        {"p.csv --cell 1 -o o.asc --contours 1", "--contours requires an OUT in one of geojson, json, wkt, svg, png"},
        {"p.csv --extent 0,0,1,1 --contours 1 -o o.wkt", "--extent requires --cell"},
        {"p.csv --extent 0,0,1 --cell 1 -o o.asc", "--extent: found 3 numbers"},
        {"p.csv --extent 2,0,1,1 --cell 1 -o o.asc", "--extent: found 2 above 1"},
        {"p.csv --cell 0 -o o.asc", "--cell: found '0', expected a size above 0"},
        {"p.csv --cell nan -o o.asc", "--cell: found 'nan'"},
        {"p.csv --cell inf -o o.asc", "--cell: found 'inf'"},
        {"p.csv --cell 1e-5 -o o.asc", "--cell: found 1e-05, which makes 4e+05 columns and 4e+05 rows here"},
        {"p.csv --cell 1e-300 -o o.asc", "--cell: found 1e-300, which makes"},
        {"p.csv --cell 1 --method cubic -o o.asc", "--method: found 'cubic', expected linear or natural"},
        {"p.csv --cell 1 --alpha 0 -o o.asc", "--alpha: found '0'"},
        {"p.csv --contours every:0 -o o.wkt", "--contours: found '0', expected every:STEP, above 0"},
        {"p.csv --contours 1,,2 -o o.wkt", "--contours: found '', expected heights with commas between them"},
        {"p.csv --contours every:1e-9 -o o.wkt", "--contours every:1e-9: found 1e-09, which makes"},
        {"p.csv --cell 1 -o o.tif", "o.tif: found the ending 'tif', expected one of asc, npy, geojson"},
        {"missing.csv --cell 1 -o o.asc", "missing.csv: found point 1, counted from 0, without a finite value of 'z'"},
        {"missing.csv --value d --cell 1 -o o.asc", "found point 2, counted from 0, without a finite value of 'd'"},
        {"missing.csv --where \"x > 0\" --value z --cell 1 -o o.asc",
         "found point 1, counted from 0, without a finite"},
        {"flat.csv --cell 1 -o o.asc", "flat.csv: found points without z, expected heights"},
        {"flat.csv --value name --cell 1 -o o.asc", "flat.csv: found texts in column 'name', expected numbers"},
        {"flat.csv --value depth --cell 1 -o o.asc", "no field 'depth' beside the coordinates"},
        {"p.csv --cell 1 -o none/o.asc", "none/o.asc"},
        {"p.csv --cell 1 -o o.asc -o none/o.npy", "none/o.npy"}};
    for (const auto& row : calls) {
      const std::string call = row.first, message = row.second;
      CAPTURE(call);
      const Outcome outcome = folder.rbpa("grid " + call);
      CAPTURE(outcome.err);
      CHECK(outcome.code != 0);
      CHECK(contains(outcome.err, message));
      for (const char* file : {"o.asc", "o.wkt", "o.npy"}) CHECK(!folder.has(file));
    }
    CHECK(folder.names().size() == 3);
  }
}
