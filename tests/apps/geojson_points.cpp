// Points of GeoJSON: every geometry, with members in any order, and invalid files.
#include <doctest/doctest.h>

#include <bit>
#include <random>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/number.h"
#include "io/polygon/read_geojson.h"
#include "support/program.h"
#include "support/refusal_of.h"

using rbpa::Point;
using namespace apps_test;
using namespace rbpa::app;

namespace {

PointFile read(const std::string& text, bool vertices = false) {
  return read_geojson_points(text, "p.geojson", vertices);
}

std::string refusal(const std::string& text, bool vertices = true) {
  return rbpa_test::refusal_of<BadInput>([&] { read(text, vertices); });
}

std::string geometry(const std::string& type, const std::string& coordinates) {
  std::string text = R"({"type":")";
  text += type;
  text += R"(","coordinates":)";
  text += coordinates;
  return text += "}";
}

std::string features(const std::vector<std::string>& geometries, const std::string& member = "") {
  std::string text = R"({"type":"FeatureCollection",)";
  text += member;
  text += R"("features":[)";
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    text += R"({"type":"Feature","properties":{"coordinates":[7,7],"geometry":{"type":1}},"geometry":)";
    text += geometries[i];
    text += "}";
  }
  return text += "\n]}\n";
}

}  // namespace

TEST_SUITE("GeoJSON in") {
  TEST_CASE("--crs refuses codes that EPSG cannot have") {
    const apps_test::Folder folder;
    folder.file("p.xy", apps_test::corner);
    for (const std::string code : {"99999999", "0", "1023", "32768", "99999999999999999999"})
      CHECK(folder.rbpa("info p.xy --crs EPSG:" + code).err ==
            "rbpa: --crs: found 'EPSG:" + code + "', expected a code as EPSG assigns them, from 1024 to 32767\n");
    CHECK(folder.rbpa("info p.xy --crs EPSG:1024").code == 0);
    CHECK(folder.rbpa("info p.xy --crs EPSG:32767").code == 0);
    CHECK(folder.rbpa("info p.xy --crs ESRI:102100").code == 0);
  }

  TEST_CASE("points are found anywhere in the file") {
    const std::vector<Point> expected = {{1, 2}, {-3.5, 400}};
    const std::string first = geometry("Point", "[1,2]"), second = geometry("Point", "[-3.5,4e2,9]");
    const std::string texts[] = {features({first, second}),
                                 features({geometry("MultiPoint", "[[1,2],[-3.5,400]]")}),
                                 geometry("MultiPoint", "[[1,2],[-3.5,400]]"),
                                 R"({"type":"GeometryCollection","geometries":[)" + first + "," + second + "]}",
                                 R"({"coordinates":[[1,2],[-3.5,400]],"type":"MultiPoint"})",
                                 R"({"features":[{"geometry":)" + first + R"(,"type":"Feature"},{"geometry":)" +
                                     second + R"(,"type":"Feature","bbox":[1,2,3,4]}],"type":"FeatureCollection"})",
                                 first + "\n" + second + "\n",
                                 "\x1E" + first + "\n\x1E" + second,
                                 "\xEF\xBB\xBF" + features({first, geometry("MultiPoint", "[]"), second}),
                                 R"({"type":"Feature","properties":null,"geometry":)" +
                                     geometry("MultiPoint", " [ [ 1 , 2 ] , [ -3.5 , 400 ] ] ") + "}"};
    for (const std::string& text : texts) {
      CAPTURE(text);
      CHECK(read(text).points == expected);
      CHECK(read(text, true).points == expected);
    }
  }

  TEST_CASE("vertices of lines and polygons are points; the closing point of a ring counts once") {
    const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const std::string& text :
         {geometry("LineString", "[[0,0],[1,0],[1,1],[0,1]]"), geometry("Polygon", "[[[0,0],[1,0],[1,1],[0,1],[0,0]]]"),
          geometry("Polygon", "[[[0,0],[1,0]],[[1,1],[0,1],[1,1]]]"),
          std::string(R"({"coordinates":[[[0,0],[1,0],[0,0]],[[1,1],[0,1],[1,1]]],"type":"Polygon"})"),
          geometry("MultiLineString", "[[[0,0],[1,0]],[[1,1],[0,1]]]"),
          geometry("MultiPolygon", "[[[[0,0],[1,0],[0,0]]],[],[[[1,1],[0,1],[1,1]]]]"),
          features({geometry("Polygon", "[[[0,0],[1,0],[0,0]]]"), geometry("Polygon", "[[[1,1],[0,1],[1,1]]]")})}) {
      CAPTURE(text);
      CHECK(read(text, true).points == square);
      CHECK(contains(refusal(text, false),
                     ", expected Point or MultiPoint (--vertices takes the vertices of lines and polygons)"));
    }
    CHECK(read(geometry("LineString", "[[0,0],[1,0],[0,0]]"), true).points.size() == 3);
    CHECK(read(geometry("Polygon", "[[[0,0],[0,0]],[[1,1]]]"), true).points == std::vector<Point>{{0, 0}, {1, 1}});
  }

  TEST_CASE("every double is read to the last bit") {
    std::mt19937_64 random(7);
    std::vector<Point> points = {{-0.0, 0.0}, {0.0, -0.0}, {9007199254740992.0, -9223372036854775808.0}, {1.5, -0.0}};
    std::string text =
        R"({"type":"MultiPoint","coordinates":[[-0,0],[0 , -0 ],[9007199254740992,-9223372036854775808],[1.5,-0.0])";
    while (points.size() < 2000) {
      const std::uint64_t x = random(), y = random();
      const Point p{std::bit_cast<double>(x), std::bit_cast<double>(y)};
      if (!rbpa::is_finite(p)) continue;
      points.push_back(p);
      text += ",[" + text_of(p.x) + "," + text_of(p.y) + "]";
    }
    const std::vector<Point> found = read(text + "]}").points;
    REQUIRE(found.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CAPTURE(i);
      CHECK(std::bit_cast<std::uint64_t>(found[i].x) == std::bit_cast<std::uint64_t>(points[i].x));
      CHECK(std::bit_cast<std::uint64_t>(found[i].y) == std::bit_cast<std::uint64_t>(points[i].y));
    }
  }

  TEST_CASE("coordinates are degrees of WGS 84 unless the file names another system") {
    const auto crs = [](const std::string& member) {
      const PointFile file = read(features({geometry("Point", "[1,2]")}, member));
      CHECK(file.points == std::vector<Point>{{1, 2}});
      return file.crs ? file.crs->text() : "none";
    };
    CHECK(crs("") == "EPSG:4326");
    CHECK(crs(R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},)") == "OGC:CRS84");
    CHECK(crs(R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::28992"}},)") == "EPSG:28992");
    CHECK(crs(R"("crs":{"properties":{"name":"EPSG:28992"},"type":"name"},)") == "EPSG:28992");
    CHECK(crs(R"("crs":{"type":"EPSG","properties":{"code":31370}},)") == "EPSG:31370");
    CHECK(crs(R"("crs":null,)") == "none");
    CHECK(crs(R"("crs":{"type":"name","properties":{"name":"my yard"}},)") == "none");
    CHECK(read(features({}, R"("crs":{"type":"name","properties":{"name":"my yard"}},)")).warnings ==
          std::vector<std::string>{
              "the system of coordinates is 'my yard', which is not understood (--crs EPSG:CODE names it)"});
  }

  TEST_CASE("features without a geometry are counted") {
    const PointFile file = read(features({"null", geometry("Point", "[1,2]"), "null"}));
    CHECK(file.points == std::vector<Point>{{1, 2}});
    CHECK(file.warnings == std::vector<std::string>{"2 features without a geometry"});
  }

  TEST_CASE("invalid GeoJSON is refused by its line") {
    const std::string at_1 = "p.geojson:1: found ";
    CHECK(refusal("") == at_1 + "nothing but blanks, expected GeoJSON");
    CHECK(refusal(" \n ") == "p.geojson:2: found nothing but blanks, expected GeoJSON");
    CHECK(refusal("{\"type\":\"Point\",\n\"coordinates\":[1,]}") == "p.geojson:2: found '1,]', expected JSON");
    CHECK(refusal("{\"type\":\"Point\",\n\"coordinates\":[1,2]") ==
          "p.geojson:2: found the end of the file, expected JSON");
    CHECK(refusal(geometry("Point", "[1,1e999]")) ==
          at_1 + "'1e999', expected a number within the range of a double (up to 1.8e308)");
    CHECK(refusal(geometry("Point", "[1,NaN]")) == at_1 + "'1,N', expected JSON");
    CHECK(refusal("[1,2]") == at_1 + "an array, expected a GeoJSON object");
    CHECK(refusal("17") == at_1 + "a number, expected a GeoJSON object");
    CHECK(refusal("{}") ==
          at_1 + "an object without a type, expected one of GeoJSON, such as FeatureCollection or MultiPoint");
    CHECK(refusal(R"({"type":"Circle"})").starts_with(at_1 + "the type 'Circle', expected one of GeoJSON"));
    CHECK(refusal(R"({"type":"Topology","objects":{}})") ==
          at_1 + "TopoJSON, expected GeoJSON (ogr2ogr -f GeoJSON points.geojson FILE)");
    CHECK(refusal(R"({"type":"Point"})") == at_1 + "a Point without coordinates, expected coordinates");
    CHECK(refusal(R"({"type":7})") == at_1 + "a number, expected a type: a text");
    CHECK(refusal(R"({"type":"FeatureCollection","features":{}})") ==
          at_1 + "an object, expected a list of GeoJSON objects");
    CHECK(refusal(R"({"type":"FeatureCollection","features":[[]]})") ==
          at_1 + "an array, expected a list of GeoJSON objects");
    CHECK(refusal(R"({"type":"FeatureCollection","features":[null]})") ==
          at_1 + "null, expected a list of GeoJSON objects");
    CHECK(refusal(R"({"type":"Feature","geometry":[]})") == at_1 + "an array, expected a GeoJSON object");
    CHECK(refusal(R"({"type":"Feature","coordinates":[1,2]})") ==
          at_1 + "coordinates in a Feature, expected a geometry that has them");
    CHECK(refusal(R"({"type":"Point","coordinates":[1,2],"coordinates":[1,2]})") ==
          at_1 + "coordinates twice in an object, expected once");
    const std::string positions = ", expected positions of two numbers or more, such as [1, 2], and lists of them";
    CHECK(refusal(geometry("Point", "[1]")) == at_1 + "a position of one number" + positions);
    CHECK(refusal(geometry("Point", "1")) == at_1 + "a number in place of a list" + positions);
    CHECK(refusal(geometry("MultiPoint", "[1,[2,3]]")) == at_1 + "a list in a position" + positions);
    CHECK(refusal(geometry("MultiPoint", "[[1,2],[[2,3]]]")) ==
          at_1 + "positions nested at different depths" + positions);
    CHECK(refusal(geometry("MultiPoint", "[[[[[1,2]]]]]")) == at_1 + "lists nested five deep" + positions);
    CHECK(refusal(geometry("Point", "[\"1\",2]")) == at_1 + "'1', expected a list of coordinates");
    CHECK(refusal(geometry("Point", "{}")) == at_1 + "an object, expected a list of coordinates");
    CHECK(refusal(geometry("Point", "[[1,2]]")) ==
          at_1 + "coordinates nested 2 lists deep, expected 1, as those of a Point");
    CHECK(refusal(geometry("Polygon", "[[1,2]]")) ==
          at_1 + "coordinates nested 2 lists deep, expected 3, as those of a Polygon");
    // Endless brackets take no memory.
    CHECK(refusal(R"({"a":)" + std::string(1000000, '[')) == at_1 + "the end of the file, expected JSON");
  }

  TEST_CASE("the program reads GeoJSON files, also compressed, and reports the system") {
    const apps_test::Folder folder;
    folder.file("p.geojson", features({geometry("MultiPoint", "[[5,52],[5.5,52],[5,52.5]]")}));
    REQUIRE(folder.run("/bin/gzip", "-k p.geojson").code == 0);
    for (const std::string name : {"p.geojson", "p.geojson.gz"}) {
      const apps_test::Outcome outcome = folder.rbpa("info " + name);
      CHECK(outcome.out.starts_with(
          "points      3\ndistinct    3\nduplicates  0\ncrs         EPSG:4326\nbox         x 5 .. 5.5\n"));
      CHECK(contains(outcome.err, "a degree of longitude is as long as 0.61 to 0.62 degrees of latitude there"));
    }
    CHECK(folder.rbpa("info p.geojson --crs EPSG:28992").err ==
          "rbpa: p.geojson: GeoJSON without a crs member means EPSG:4326, but --crs EPSG:28992 overrides it\n");
    CHECK(folder.rbpa("info p.geojson --columns 1,2").err ==
          "rbpa: --columns: found a format with fixed columns, expected text\n");
  }

  TEST_CASE("properties are the columns of a table with the same values, in conditions, groups, boxes and lists") {
    const apps_test::Folder folder;
    std::mt19937 random(5);
    const std::vector<std::string> texts = {"oak", "elm", R"(\u00e9 \"x\")", "1.0"};
    const std::vector<std::string> quoted = {"oak", "elm", "\u00e9 \"\"x\"\"", "1.0"};
    std::string csv = "x,y,n,r,t,sparse\n", json = R"({"properties":{"n":3},"type":"FeatureCollection","features":[)";
    for (int i = 0; i < 300; ++i) {
      const std::string n = i == 7 ? "9007199254740993" : std::to_string(random() % 100);
      const std::string r = std::to_string(random() % 100) + ".25", x = std::to_string(random() % 20);
      const std::string y = std::to_string(random() % 20);
      const std::size_t t = random() % texts.size();
      const bool is_sparse = i < 5 || random() % 3 == 0;
      csv += x + "," + y + "," + n + "," + r + ",\"" + quoted[t] + "\"," + (is_sparse ? "" : "0.5") + "\n";
      json += std::string(i > 0 ? "," : "") + R"({"geometry":{"type":"Point","coordinates":[)" + x + "," + y +
              R"(]},"properties":{"n":)" + n + R"(,"r":)" + r + R"(,"list":[1,{"n":2}],"t":")" + texts[t] + "\"" +
              (is_sparse ? (i % 2 == 0 ? R"(,"sparse":null)" : "") : R"(,"sparse":0.5)") + R"(},"type":"Feature"})";
    }
    folder.file("p.csv", csv);
    folder.file("p.geojson", json + "]}");
    for (const std::string options :
         {"", "--where \"r > 40 and t != 'oak'\"", "--where \"t in ('elm', '1.0') or r < 9\"",
          "--where \"not t == 'elm'\"", "--bounds 3,3,9,12", "--bounds 3,3,9,12 --where \"r > 40\"", "--fields t,R",
          "--where \"r < 0\""}) {
      CAPTURE(options);
      const auto listed = [&](const std::string& name) {
        REQUIRE(folder.rbpa("shape " + name + " --alpha inf -q -o o.csv --isolated i.csv " + options).code == 0);
        return folder.content("o.csv") + folder.content("i.csv");
      };
      CHECK(listed("p.geojson") == listed("p.csv"));
    }
    for (const std::string options :
         {"--group-by t", "--group-by t --where \"r > 50\"", "--group-by t --alpha column:r"}) {
      CAPTURE(options);
      const auto groups = [&](const std::string& name) {
        const std::string alpha = !contains(options, "column") ? " --alpha 3" : "";
        REQUIRE(folder.rbpa("shape " + name + " -q -o g.csv --summarize n:max,r:mean " + options + alpha).code == 0);
        return folder.content("g.csv");
      };
      CHECK(groups("p.geojson") == groups("p.csv"));
    }
  }

  TEST_CASE("conditions on properties: true and false, missing ones, points in no Feature, and what is refused") {
    const std::string point = R"("geometry":{"type":"Point","coordinates":[1,2]}})";
    const auto feature = [&](const std::string& properties) {
      return R"({"type":"Feature","properties":)" + properties + "," + point;
    };
    const std::string lines = feature(R"({"a":1,"old":true})") + "\n" + R"({"type":"Point","coordinates":[7,7]})" +
                              "\n" + feature(R"({"a":null,"old":false})") + "\n" + feature(R"({"a":3,"text":"5"})") +
                              "\n" + feature("null");
    const auto selected = [](const std::string& text, const std::string& condition) {
      try {
        const Condition where(condition, names_of_columns());
        std::string indices;
        for (const std::uint32_t i : read_geojson_points(text, "p", false, where).index) indices += std::to_string(i);
        return indices;
      } catch (const BadInput& error) {
        return std::string(error.what());
      }
    };
    CHECK(selected(lines, "old") == "0");
    CHECK(selected(lines, "not old") == "1234");
    CHECK(selected(lines, "old == 'true' or old == 'false'") == "02");
    CHECK(selected(lines, "old == 1") == "0");
    CHECK(selected(lines, "a >= 0") == "03");
    CHECK(selected(lines, "not a >= 0") == "124");
    CHECK(selected(lines, "text == '5'") == "3");
    CHECK(selected(lines, "text == 5").starts_with("p:4: feature 2: found '5', expected a number, as --where"));
    CHECK(selected(lines, "b > 1") ==
          "p: found no Feature with a property 'b', expected at least one, as --where requires");
    CHECK(selected(feature(R"({"a":{"b":1}})"), "a > 1") ==
          "p:1: found an object as property 'a', expected a text or a number, as --where requires");
    CHECK(selected(feature(R"({"a":9007199254740993})"), "a > 1")
              .starts_with("p:1: found '9007199254740993', expected an "));
    // Coordinates before Features in one object.
    CHECK(refusal(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,0]]],"features":[)" + feature("{}") + "]}") ==
          "p.geojson:1: found an object in one with coordinates, expected a geometry that has coordinates alone");
  }
}
