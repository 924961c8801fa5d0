// `rbpa shape --group-by`: a shape for each group of the points.
#include <doctest/doctest.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/cloud/cloud.h"
#include "support/gdal_endings.h"
#include "support/las_file.h"
#include "support/program.h"
#include "support/random.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// A triangle of wolves, a triangle of lynxes, a lonely bear, and a fix of nobody.
constexpr const char* fixes =
    "x,y,animal,id\n0,0,\"wolf, grey\",1\n5,5,lynx,1\n1,0,\"wolf, grey\",2\n6,5,lynx,2\n0,1,\"wolf, grey\",10\n"
    "5,7,lynx,10\n8,8,bear,1\n9,9,,2\n";

json properties(const std::string& geojson) {
  const json all = json::parse(geojson);
  json found = json::array();
  for (const json& feature : all["features"]) found.push_back(feature["properties"]);
  return found;
}

}  // namespace

TEST_SUITE("shape groups") {
  TEST_CASE("GeoJSON has a feature for each group, and CSV a line; a group without a polygon has the reason") {
    const Folder folder("p.csv", fixes);
    const Outcome outcome = folder.rbpa("shape p.csv --group-by animal --alpha auto -o s.geojson -o s.csv -o s.svg", 0);
    CHECK(outcome.err ==
          "rbpa: p.csv: 1 point without a group\n"
          "rbpa: p.csv: 1 group without a polygon: 'bear', fewer than three distinct points (1)\n"
          "rbpa: 8 points, 3 groups, 2 polygons, area 1.5 -> s.geojson, s.csv, s.svg\n");
    CHECK(folder.content("s.geojson") ==
          "{\"type\":\"FeatureCollection\",\"features\":[\n"
          "{\"type\":\"Feature\",\"properties\":{\"group\":\"bear\",\"points\":1,\"alpha\":null,\"area\":0,"
          "\"perimeter\":0,\"polygons\":0,\"problem\":\"fewer than three distinct points "
          "(1)\"},\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[]}},\n"
          "{\"type\":\"Feature\",\"properties\":{\"group\":\"lynx\",\"points\":3,\"alpha\":1.118033988749895,\"area\":"
          "1,\"perimeter\":5.23606797749979,\"polygons\":1},\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[[["
          "[5,5],[6,5],[5,7],[5,5]]]]}},\n"
          "{\"type\":\"Feature\",\"properties\":{\"group\":\"wolf, "
          "grey\",\"points\":3,\"alpha\":0.7071067811865476,\"area\":0.5,\"perimeter\":3.414213562373095,\"polygons\":"
          "1},\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[[[[0,0],[1,0],[0,1],[0,0]]]]}}\n]}\n");
    CHECK(folder.content("s.csv") ==
          "group,points,alpha,area,perimeter,polygons,problem,geometry\n"
          "bear,1,,0,0,0,\"fewer than three distinct points (1)\",MULTIPOLYGON EMPTY\n"
          "lynx,3,1.118033988749895,1,5.23606797749979,1,,\"MULTIPOLYGON (((5 5, 6 5, 5 7, 5 5)))\"\n"
          "\"wolf, grey\",3,0.7071067811865476,0.5,3.414213562373095,1,,\"MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))\"\n");
    CHECK(contains(folder.content("s.svg"), "<svg"));
  }

  TEST_CASE("groups of numbers are in numerical order, also with a condition on the same column") {
    const Folder folder("p.csv", fixes);
    REQUIRE(folder.rbpa("shape p.csv --group-by id --alpha inf -o s.geojson -q").code == 0);
    json found = properties(folder.content("s.geojson"));
    REQUIRE(found.size() == 3);
    CHECK(found[0]["group"] == 1);
    CHECK(found[1]["group"] == 2);
    CHECK(found[2]["group"] == 10);
    CHECK(found[1]["area"] == 2.5);
    REQUIRE(
        folder.rbpa("shape p.csv --group-by id --where \"id > 1 and animal != ''\" --alpha inf -o s.geojson -q").code ==
        0);
    found = properties(folder.content("s.geojson"));
    REQUIRE(found.size() == 2);
    CHECK(found[0]["group"] == 2);
    CHECK(found[0]["points"] == 2);
    CHECK(found[1]["points"] == 2);
  }

  TEST_CASE("a group is the shape of its points alone, by every rule, in any order and with any number of threads") {
    const Folder folder;
    rbpa_test::Random random(3);
    std::vector<std::string> lines;
    for (int i = 0; i < 3000; ++i)
      lines.push_back(std::to_string(random.integer(0, 900)) + "," + std::to_string(random.integer(0, 900)) + ",g" +
                      std::to_string(random.below(7)) + "\n");
    const auto table = [&] {
      std::string text = "x,y,group\n";
      for (const std::string& line : lines) text += line;
      return text;
    };
    folder.file("p.csv", table());
    random.shuffle(lines);
    folder.file("shuffled.csv", table());
    for (const std::string rule : {"--alpha 20", "--alpha auto --cover 0.9", "--alpha min", "--alpha plateau",
                                   "--alpha 30 --min-hole-area inf --min-part-area 50"}) {
      CAPTURE(rule);
      REQUIRE(folder.rbpa("shape p.csv --group-by group " + rule + " -o all.csv -o all.geojson -q").code == 0);
      const std::string all = folder.content("all.csv");
      REQUIRE(folder.rbpa("shape shuffled.csv --threads 1 --group-by group " + rule + " -o again.csv -q").code == 0);
      CHECK(folder.content("again.csv") == all);
      for (const std::string group : {"g0", "g5"}) {
        REQUIRE(folder.rbpa("shape p.csv --where \"group == '" + group + "'\" " + rule + " -o one.wkt -q").code == 0);
        std::string alone = folder.content("one.wkt");
        alone.pop_back();
        const std::size_t line = all.find("\n" + group + ",");
        REQUIRE(line != std::string::npos);
        const std::size_t geometry = all.find("MULTIPOLYGON", line);
        CHECK(all.substr(geometry, alone.size()) == alone);
      }
    }
  }

  TEST_CASE("fields of other formats are numbers") {
    const Folder folder(
        "p.ply",
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "property float class\nend_header\n0 0 0 2.5\n1 0 0 2.5\n0 1 0 2.5\n7 7 0 -1\n8 7 0 -1\n7 8 0 -1\n");
    REQUIRE(folder.rbpa("shape p.ply --group-by class --alpha 1 -o s.geojson -q").code == 0);
    const json found = properties(folder.content("s.geojson"));
    REQUIRE(found.size() == 2);
    CHECK(found[0]["group"] == -1);
    CHECK(found[1]["group"] == 2.5);
    CHECK(found[1]["area"] == 0.5);
    refuses(folder, "shape p.ply --group-by kind --alpha 1 -o s.geojson", 3,
            "p.ply: found no field 'kind' of numbers, expected one, as --group-by requires");
  }

  TEST_CASE("formats that cannot be grouped are refused before anything is written") {
    const Folder folder({{"p.csv", fixes}, {"p.xy", "0 0\n1 0\n0 1\n"}});
    refuses(folder, "shape p.csv --group-by herd --alpha 1 -o s.csv", 3,
            "p.csv:1: found 'x,y,animal,id', expected a header with a column 'herd'");
    refuses(folder, "shape p.xy --group-by a --alpha 1 -o s.csv", 3,
            "p.xy: found no header line, expected one with the names that --group-by requires");
    refuses(folder, "shape p.csv --group-by animal --alpha 1 -o s.wkt", 2,
            "--group-by: found s.wkt, whose format has no groups, expected one of geojson, json, csv, svg, png" +
                gdal_endings());
    refuses(folder, "shape p.csv --group-by animal --alpha 1 -o s.csv --isolated i.csv", 2,
            "--isolated cannot be combined with --group-by or --group-by-file");
    refuses(folder, "shape p.npy --group-by animal --alpha 1 -o s.csv", 2,
            "--group-by: found a format without fields, expected " + rbpa::app::with_fields(rbpa::app::Use::points));
    CHECK(folder.names() == std::vector<std::string>{"p.csv", "p.xy"});
  }

  TEST_CASE("a table without points has no groups, and texts of any bytes are names") {
    const Folder folder("p.csv", "# x,y,g\n");
    CHECK(folder.rbpa("shape p.csv --group-by g --alpha 1 -o s.csv -q").code == 0);
    CHECK(folder.content("s.csv") == "group,points,alpha,area,perimeter,polygons,problem,geometry\n");
    folder.file("l.csv", "x,y,g\n0,0,K\xf6ln\n1,0,K\xf6ln\n0,1,K\xf6ln\n3,3,\"a \"\"b\"\"\"\n");
    REQUIRE(folder.rbpa("shape l.csv --group-by g --alpha 1 -o s.geojson -o s.csv -q").code == 0);
    CHECK(properties(folder.content("s.geojson"))[0]["group"] == "K\xc3\xb6ln");  // Windows-1252
    CHECK(contains(folder.content("s.csv"), "\nK\xc3\xb6ln,3,1,"));
  }

  TEST_CASE(
      "a property of GeoJSON Features is a key: a text, a number, true or false; without one, or with null, a point is "
      "in no group") {
    const Folder folder;
    const auto feature = [](const std::string& properties, const std::string& points) {
      return "{\"type\":\"Feature\",\"properties\":" + properties +
             ",\"geometry\":{\"type\":\"MultiPoint\",\"coordinates\":" + points + "}}";
    };
    folder.file("p.geojson", "{\"type\":\"FeatureCollection\",\"features\":[" +
                                 feature(R"({"k":"Zo\u00eb \"x\"","r":1,"j":{"k":"inner"}})", "[[0,0],[1,0],[0,1]]") +
                                 "," + feature(R"({"k":5})", "[[4,4],[5,4],[4,5]]") + "," +
                                 feature(R"({"k":5.0})", "[[5,5]]") + "," + feature("null", "[[8,8]]") + "," +
                                 feature(R"({"k":null})", "[[8,9]]") + "," + feature(R"({"k":""})", "[[9,9]]") + "," +
                                 feature(R"({"k":true})", "[[9,8]]") +
                                 ",{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[7,7]},"
                                 "\"properties\":{\"k\":5}}]}");
    says(folder, "shape p.geojson --group-by k --alpha inf -o s.geojson", 0, "3 points without a group");
    const json found = properties(folder.content("s.geojson"));
    REQUIRE(found.size() == 3);
    CHECK(found[0]["group"] == "5");  // there are texts: no number
    CHECK(found[0]["points"] == 5);
    CHECK(found[1]["group"] == "Zo\u00eb \"x\"");
    CHECK(found[1]["area"] == 0.5);
    CHECK(found[2]["group"] == "true");
    REQUIRE(folder.rbpa("shape p.geojson --group-by k --alpha column:r -o r.geojson -q").code == 0);
    const json with_radii = properties(folder.content("r.geojson"));
    CHECK(with_radii[0]["problem"] == "column 'r' has no radius above 0 for point 3");
    CHECK(with_radii[1]["alpha"] == 1);
    // Geometries outside of Features are in no group, before and after a Feature.
    folder.file("m.geojson", "{\"type\":\"Point\",\"coordinates\":[9,9]}\n" +
                                 feature(R"({"k":1})", "[[0,0],[1,0],[0,1]]") +
                                 "\n{\"type\":\"Point\",\"coordinates\":[9,9]}\n");
    REQUIRE(folder.rbpa("shape m.geojson --group-by k --alpha inf -o m.out.geojson -q").code == 0);
    CHECK(properties(folder.content("m.out.geojson"))[0]["points"] == 3);
    folder.file("n.geojson", "{\"type\":\"FeatureCollection\",\"features\":[" + feature(R"({"k":10})", "[[0,0]]") +
                                 "," + feature(R"({"k":9})", "[[1,1]]") + "]}");
    REQUIRE(folder.rbpa("shape n.geojson --group-by k --alpha 1 -o n.out.geojson -q").code == 0);
    CHECK(properties(folder.content("n.out.geojson"))[0]["group"] == 9);
    refuses(folder, "shape n.geojson --group-by kind --alpha 1 -o s.csv", 3,
            "n.geojson: found no Feature with a property 'kind', expected at least one, as --group-by requires");
    CHECK(contains(folder.rbpa("shape n.geojson --group-by k --where \"k > 9\" --alpha 1 -o s.csv").err,
                   "selects 1 of 2 features"));
    folder.file("l.geojson", feature(R"({"k":[1]})", "[[0,0]]"));
    refuses(folder, "shape l.geojson --group-by k --alpha 1 -o s.csv", 3,
            "l.geojson:1: found a list as property 'k', expected a text or a number, as --group-by requires");
  }

  TEST_CASE("names are numbers only if JSON reads each of them as itself") {
    const Folder folder;
    const auto kind_of = [&](const std::string& a, const std::string& b) {
      folder.file("k.csv", "x,y,g\n0,0," + a + "\n1,1," + b + "\n");
      REQUIRE(folder.rbpa("shape k.csv --group-by g --alpha 1 -o k.geojson -q").code == 0);
      const json found = properties(folder.content("k.geojson"));
      return std::string(found[0]["group"].type_name()) + " " + found[0]["group"].dump() + " " +
             found[1]["group"].dump();
    };
    CHECK(kind_of("10", "9") == "number 9 10");
    CHECK(kind_of("1.5", "-2e3") == "number -2000.0 1.5");
    CHECK(kind_of("007", "08") == "string \"007\" \"08\"");
    CHECK(kind_of("1", "1.0") == "string \"1\" \"1.0\"");
    CHECK(kind_of("+1", "2") == "string \"+1\" \"2\"");
    CHECK(kind_of(".5", "2") == "string \".5\" \"2\"");
    CHECK(kind_of("5.", "2") == "string \"2\" \"5.\"");
    CHECK(kind_of("inf", "2") == "string \"2\" \"inf\"");
    CHECK(kind_of("9007199254740993", "2") == "string \"2\" \"9007199254740993\"");
  }

  TEST_CASE("each of several files is a group, or has points of the groups of a column") {
    const Folder folder({{"b.csv", "x,y,animal\n0,0,ox\n1,0,ox\n"},
                         {"a.csv", "x,y,animal\n0,1,ox\n5,5,elk\n6,5,elk\n5,6,elk\n"},
                         {"empty.csv", "# x,y,animal\n"}});
    Outcome outcome = folder.rbpa("shape b.csv a.csv empty.csv --group-by-file --alpha inf -o s.csv");
    CHECK(outcome.err ==
          "rbpa: 3 files: 2 groups without a polygon: the first is 'b.csv', fewer than three distinct points (2)\n"
          "rbpa: 6 points, 3 groups, 1 polygon, area 5 -> s.csv\n");
    CHECK(contains(folder.content("s.csv"), "\nempty.csv,0,inf,0,0,0,\"no points\",MULTIPOLYGON EMPTY\n"));
    REQUIRE(folder.rbpa("shape b.csv a.csv --group-by animal --alpha inf -o g.csv -q").code == 0);
    CHECK(folder.content("g.csv") ==
          "group,points,alpha,area,perimeter,polygons,problem,geometry\n"
          "elk,3,inf,0.5,3.414213562373095,1,,\"MULTIPOLYGON (((5 5, 6 5, 5 6, 5 5)))\"\n"
          "ox,3,inf,0.5,3.414213562373095,1,,\"MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))\"\n");
    refuses(folder, "shape b.csv a.csv --alpha 1 -o s.csv", 2,
            "POINTS: found 2 files, the last 'a.csv', expected one, or --group-by-file (each is a group), or "
            "--group-by COLUMN (-o OUT names a file to write; a list such as X,Y has no blanks)");
    refuses(folder, "shape b.csv a.csv --group-by-file --group-by animal --alpha 1 -o s.csv", 2,
            "--group-by-file cannot be combined with --group-by");
    refuses(folder, "shape b.csv a.csv --group-by-file --alpha 1 -o a.csv", 2,
            "a.csv: found the file of points, expected another file to write to");
    folder.file("c.geojson", "{\"type\":\"Point\",\"coordinates\":[1,1]}");
    outcome = folder.rbpa("shape a.csv c.geojson --group-by-file --alpha 1 -o s.csv -q", 3);
    CHECK(outcome.err ==
          "rbpa: c.geojson: found points in EPSG:4326, which GeoJSON without a crs member means, expected no system, "
          "as in a.csv (--crs EPSG:4326 applies to all)\n");
  }

  TEST_CASE("groups by several columns are those by one column of all values, in the order of the columns") {
    const Folder folder;
    rbpa_test::Random random(5);
    const std::vector<std::string> kinds = {"oak", "\"elm, \"\"wych\"\"\"", "", "1"};
    std::string points = "x,y,kind,\"age, years\",both\n";
    for (int i = 0; i < 400; ++i) {
      const std::string kind = kinds[random.below(4)],
                        age = random.below(9) == 0 ? "" : std::to_string(random.below(12));
      const std::string plain = kind.front() == '"' ? "elm" : kind;
      points += std::to_string(random.below(100)) + "," + std::to_string(random.below(100)) + "," + kind + "," + age +
                "," + (kind.empty() || age.empty() ? "" : plain + " " + (age.size() == 1 ? "0" : "") + age) + "\n";
    }
    folder.file("p.csv", points);
    const auto made = [&](const std::string& by) {
      return json::parse(folder.rbpa("shape p.csv --group-by '" + by + "' --alpha auto -o - --output-format geojson", 0)
                             .out)["features"];
    };
    const json by_one = made("both"), by_two = made("kind,\"age, years\""), exchanged = made("\"age, years\",kind");
    REQUIRE(by_two.size() == 36);
    REQUIRE(by_one.size() == 36);
    REQUIRE(exchanged.size() == 36);
    for (std::size_t g = 0; g < 36; ++g) {
      // Texts are in the order of their bytes, numbers in that of their values.
      const std::size_t kind = g / 12, age = g % 12;
      const json& one = by_one[g];
      for (json two : {by_two[g], exchanged[3 * age + kind]}) {
        json& properties = two["properties"];
        CHECK(properties["kind"] == std::array{"1", "elm, \"wych\"", "oak"}[kind]);
        CHECK(properties["age, years"] == age);
        properties.erase("kind");
        properties.erase("age, years");
        properties["group"] = one["properties"]["group"];
        CHECK(two == one);
      }
    }
    CHECK(by_two[13]["properties"]["group"] == "\"elm, \"\"wych\"\"\",1");
    CHECK(exchanged[4]["properties"]["group"] == "1,\"elm, \"\"wych\"\"\"");
    const json infos = json::parse(folder.rbpa("info p.csv --group-by kind,both --json -q").out);
    REQUIRE(infos.size() == 36);
    CHECK(infos[35]["group"] == "oak,\"oak 11\"");
    REQUIRE(folder.rbpa("shape p.csv --group-by kind,both --alpha auto -o s.csv -q").code == 0);
    CHECK(folder.content("s.csv").starts_with(
        "group,points,alpha,area,perimeter,polygons,problem,geometry,kind,both\n\"1,\"\"1 00\"\"\","));
  }

  TEST_CASE("several columns may be fields of LAS and properties of GeoJSON, and each must be there, once") {
    const Folder folder;
    LasFile las;
    for (int i = 0; i < 12; ++i)
      las.points.push_back({.x = i % 3,
                            .y = i * i,
                            .classification = static_cast<unsigned>(i) % 2,
                            .source = static_cast<unsigned>(i) / 6 + 9});
    folder.file("p.las", bytes_of(las));
    CHECK(json::parse(folder.rbpa("info p.las --group-by point_source_id,class --json -q").out)[2]["group"] == "10,0");
    folder.file("p.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"a":"10","b":10},"geometry":{"type":"Point","coordinates":[0,0]}},
{"type":"Feature","properties":{"a":"9","b":9},"geometry":{"type":"Point","coordinates":[1,0]}},
{"type":"Feature","properties":{"a":"9","b":10},"geometry":{"type":"Point","coordinates":[0,1]}}]})");
    REQUIRE(folder.rbpa("shape p.geojson --group-by a,b --alpha 1 -o s.geojson -q").code == 0);
    const json found = properties(folder.content("s.geojson"));  // texts "10" < "9", but numbers 9 < 10
    for (std::size_t g = 0; g < 3; ++g) CHECK(found[g]["group"] == std::array{"10,10", "9,9", "9,10"}[g]);
    CHECK(found[1]["a"] == "9");
    CHECK(found[1]["b"] == 9);
    folder.file("p.csv", "x,y,points,b\n0,0,1,2\n0,1,1,2\n1,0,1,2\n");
    REQUIRE(folder.rbpa("shape p.csv --group-by points,b --alpha 1 -o s.geojson -q").code == 0);
    CHECK(properties(folder.content("s.geojson"))[0]["points_2"] == 1);
    refuses(folder, "shape p.csv --group-by b,points,b --alpha 1 -o s.csv", 2,
            "--group-by: found 'b' twice, expected once");
    refuses(folder, "shape p.csv --group-by b,,points --alpha 1 -o s.csv", 2,
            "--group-by: found '', expected the name of a column (in double quotes unless it is a word other than and, "
            "or, not, in)");
    // Quotes are as in CSV.
    folder.file("q.csv", "x,y,\"a,\"\"b\"\"\",c\n0,0,1,2\n0,1,1,2\n1,0,1,2\n");
    REQUIRE(folder.rbpa("shape q.csv --group-by '\"a,\"\"b\"\"\",c' --alpha 1 -o s.geojson -q").code == 0);
    CHECK(properties(folder.content("s.geojson"))[0]["a,\"b\""] == 1);
    for (const std::string list : {"\"a,c", "\"a\"b,c", "a\"b,c\"", "\"a\"b\",c", "\"\",c"})
      CHECK(folder.rbpa("shape q.csv --group-by '" + list + "' --alpha 1 -o s.csv").code == 2);
    refuses(folder, "shape p.csv --group-by b,c --alpha 1 -o s.csv", 3,
            "p.csv:1: found 'x,y,points,b', expected a header with a column 'c'");
  }

  TEST_CASE("a column of radii gives one for each group, or a problem of the group; --stats counts groups") {
    const Folder folder(
        "p.csv",
        "x,y,g,r\n0,0,a,1\n1,0,a,1.0\n0,1,a,1\n5,5,b,1\n6,5,b,2\n5,6,b,1\n0,0,c,0.5\n1,0,c,.5\n0,1,c,0.5\n"
        "0,0,d,\n1,0,d,\n0,0,e,inf\n1,0,e,inf\n0,9,e,inf\n0,0,f,-1\n,,,\n");
    REQUIRE(folder.rbpa("shape p.csv --skip-invalid --group-by g --alpha column:r -o s.csv --stats t.json -q").code ==
            0);
    CHECK(folder.content("s.csv") ==
          "group,points,alpha,area,perimeter,polygons,problem,geometry\n"
          "a,3,1,0.5,3.414213562373095,1,,\"MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))\"\n"
          "b,3,,0,0,0,\"column 'r' has the radii 1 and 2, expected one\",MULTIPOLYGON EMPTY\n"
          "c,3,0.5,0,0,0,\"no triangle has circumradius <= 0.5\",MULTIPOLYGON EMPTY\n"
          "d,2,,0,0,0,\"column 'r' has no radius above 0 for point 9\",MULTIPOLYGON EMPTY\n"
          "e,3,inf,4.5,19.055385138137417,1,,\"MULTIPOLYGON (((0 0, 1 0, 0 9, 0 0)))\"\n"
          "f,1,,0,0,0,\"column 'r' has no radius above 0 for point 14\",MULTIPOLYGON EMPTY\n");
    const json stats = json::parse(folder.content("t.json"));
    CHECK(stats["groups"] == 6);
    CHECK(stats["groups_without_polygon"] == 4);
    CHECK(stats["points"] == 15);
    CHECK(stats["triangles"] == 2);
    CHECK(stats["polygons"] == 2);
    CHECK(stats["area"] == 5);
    CHECK(stats["distinct"].is_null());
    CHECK(stats["alpha_rule"] == "column:r");
    CHECK(stats["seconds"]["build"] > 0);
    const std::string rules = "a radius (a number > 0, or inf), auto, min, plateau or plateau:K";
    refuses(folder, "shape p.csv --alpha column:r -o x.csv", 2,
            "--alpha: found 'column:r', expected " + rules +
                " (column:NAME applies only to groups, as in rbpa shape --group-by)");
    refuses(folder, "shape p.csv --group-by g --alpha column: -o x.csv", 2,
            "--alpha column: found '', expected the name of a column (in double quotes unless it is a word other than "
            "and, or, not, in)");
    refuses(folder, "shape p.csv --group-by g --alpha column:q -o x.csv", 3,
            "p.csv:1: found 'x,y,g,r', expected a header with a column 'q'");
  }

  TEST_CASE("info and alpha of groups are those of their points alone") {
    const Folder folder("p.csv", fixes);
    const auto last = [&](const std::string& arguments) { return folder.rbpa(arguments).out; };
    const json infos = json::parse(last("info p.csv --group-by animal --json -q"));
    REQUIRE(infos.size() == 3);
    for (const json& group : infos) {
      const std::string name = group["group"];
      json alone = json::parse(last("info p.csv --json -q --where \"animal == '" + name + "'\""));
      alone["group"] = name;
      CHECK(group == alone);
    }
    CHECK(contains(last("info p.csv --group-by animal -q"), "        3         3     0.5774  0 .. 1 "));
    const json radii = json::parse(last("alpha p.csv --group-by animal --json -q"));
    REQUIRE(radii.size() == 3);
    for (const json& group : radii) {
      const json alone =
          json::parse(last("alpha p.csv --json -q --where \"animal == '" + group["group"].get<std::string>() + "'\""));
      CHECK(group["auto"] == alone["auto"]);
      CHECK(group["min"] == alone["min"]);
      CHECK(group["recommended"] == alone["recommended"]);
      CHECK(group["plateau"] == (alone["plateaus"].empty() ? json() : alone["plateaus"][0]["alpha"]));
    }
    CHECK(radii[0]["problem"] == "fewer than three distinct points");
    CHECK(last("alpha p.csv --group-by animal --csv -q")
              .starts_with("group,points,distinct,min,auto,plateau,recommended,problem\n"
                           "bear,1,1,,,,,\"fewer than three distinct points\"\nlynx,3,3,1.118033988749895,"));
    CHECK(contains(last("alpha p.csv --group-by animal -q"), "  wolf, grey\n"));
    CHECK(folder.rbpa("alpha p.csv --group-by animal --persistence").code == 2);
  }

  TEST_CASE("pictures have a color for each group, and show both where groups overlap") {
    const Folder folder;
    std::string points = "x,y,g\n";
    constexpr int groups = 24;
    for (int g = 0; g < groups; ++g)
      for (const auto& [x, y] : {std::pair(0, 0), {40, 0}, {0, 40}, {40, 40}})
        points += std::to_string(50 * (g % 6) + x) + "," + std::to_string(50 * (g / 6) + y) + ",g" +
                  std::to_string(g + 10) + "\n";
    folder.file("p.csv", points);
    REQUIRE(folder.rbpa("shape p.csv --columns x,y --group-by g --alpha 40 -o g.svg -o g.png -q").code == 0);
    const std::string svg = folder.content("g.svg");
    std::set<std::string> fills;
    for (std::size_t at = 0, g = 0; (at = svg.find("<path id=\"group-", at)) != std::string::npos; ++at, ++g) {
      const std::size_t fill = svg.find("fill=\"#", at) + 6;
      fills.insert(svg.substr(fill, 7));
      CHECK(svg.find("<title>g" + std::to_string(g + 10) + "</title>", at) < svg.find("</path>", at));
    }
    CHECK(fills.size() == groups);
    // The colors of the picture that cover much of it, but for the background.
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&image, folder.path("g.png").c_str()) != 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
    REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
    const auto common_colors = [](const std::vector<unsigned char>& rgb) {
      std::map<std::array<unsigned char, 3>, std::size_t> count;
      for (std::size_t i = 0; i < rgb.size(); i += 3) ++count[{rgb[i], rgb[i + 1], rgb[i + 2]}];
      return std::count_if(count.begin(), count.end(), [&](const auto& c) { return c.second > rgb.size() / 3 / 100; });
    };
    CHECK(common_colors(pixels) == groups + 1);

    folder.file("two.csv", "x,y,g\n0,0,a\n40,0,a\n0,40,a\n40,40,a\n20,20,b\n60,20,b\n20,60,b\n60,60,b\n");
    REQUIRE(folder.rbpa("shape two.csv --columns x,y --group-by g --alpha 40 -o t.png -q").code == 0);
    png_image two{};
    two.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&two, folder.path("t.png").c_str()) != 0);
    two.format = PNG_FORMAT_RGB;
    pixels.resize(PNG_IMAGE_SIZE(two));
    REQUIRE(png_image_finish_read(&two, nullptr, pixels.data(), 0, nullptr) != 0);
    CHECK(common_colors(pixels) == 4);  // the background, either alone, and both
  }

  TEST_CASE("a key with the name of a summary gets another name") {
    const Folder folder("p.csv", "x,y,n,n_mean,m\n0,0,1,3,4\n4,0,1,3,4\n0,4,1,3,4\n");
    REQUIRE(folder.rbpa("shape p.csv --group-by n_mean,m --summarize n:mean --alpha inf -q -o g.csv").code == 0);
    CHECK(contains(folder.content("g.csv"), ",n_mean_2,m,n_mean"));
  }
}
