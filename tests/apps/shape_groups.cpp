// `rbpa shape --group-by`: a shape for each group of the points.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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

void refuses(const Folder& folder, const std::string& arguments, const std::string& message, int code) {
  const Outcome outcome = folder.rbpa("shape " + arguments);
  CHECK(outcome.code == code);
  CHECK(outcome.err == "rbpa: " + message + "\n");
}

}  // namespace

TEST_SUITE("shape groups") {
  TEST_CASE("GeoJSON has a feature for each group, and CSV a line; what has no polygon says why") {
    const Folder folder;
    folder.file("p.csv", fixes);
    const Outcome outcome = folder.rbpa("shape p.csv --group-by animal --alpha auto -o s.geojson -o s.csv -o s.svg");
    CHECK(outcome.code == 0);
    CHECK(outcome.err ==
          "rbpa: p.csv: 1 point without a group\n"
          "rbpa: p.csv: 1 group without a polygon: 'bear', fewer than three distinct points (1)\n"
          "rbpa: 8 points, 3 groups, 2 polygons, area 1.5 -> s.geojson, s.csv, s.svg\n");
    CHECK(
        folder.content("s.geojson") ==
        "{\"type\":\"FeatureCollection\",\"features\":[\n"
        "{\"type\":\"Feature\",\"properties\":{\"group\":\"bear\",\"points\":1,\"alpha\":null,\"area\":0,\"perimeter\":"
        "0,"
        "\"polygons\":0,\"problem\":\"fewer than three distinct points (1)\"},"
        "\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[]}},\n"
        "{\"type\":\"Feature\",\"properties\":{\"group\":\"lynx\",\"points\":3,\"alpha\":1.118033988749895,\"area\":1,"
        "\"perimeter\":5.23606797749979,\"polygons\":1},"
        "\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[[[[5,5],[6,5],[5,7],[5,5]]]]}},\n"
        "{\"type\":\"Feature\",\"properties\":{\"group\":\"wolf, grey\",\"points\":3,\"alpha\":0.7071067811865476,"
        "\"area\":0.5,\"perimeter\":3.414213562373095,\"polygons\":1},"
        "\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[[[[0,0],[1,0],[0,1],[0,0]]]]}}\n]}\n");
    CHECK(folder.content("s.csv") ==
          "group,points,alpha,area,perimeter,polygons,problem,geometry\n"
          "bear,1,,0,0,0,\"fewer than three distinct points (1)\",MULTIPOLYGON EMPTY\n"
          "lynx,3,1.118033988749895,1,5.23606797749979,1,,\"MULTIPOLYGON (((5 5, 6 5, 5 7, 5 5)))\"\n"
          "\"wolf, grey\",3,0.7071067811865476,0.5,3.414213562373095,1,,\"MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))\"\n");
    CHECK(folder.content("s.svg").find("<svg") != std::string::npos);
  }

  TEST_CASE("numbers go in their order, with a condition on the same column") {
    const Folder folder;
    folder.file("p.csv", fixes);
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

  TEST_CASE(
      "a group is the shape of its points, by every rule, in any order of the points and with any number of threads") {
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
    const Folder folder;
    folder.file("p.ply",
                "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                "property float class\nend_header\n0 0 0 2.5\n1 0 0 2.5\n0 1 0 2.5\n7 7 0 -1\n8 7 0 -1\n7 8 0 -1\n");
    REQUIRE(folder.rbpa("shape p.ply --group-by class --alpha 1 -o s.geojson -q").code == 0);
    const json found = properties(folder.content("s.geojson"));
    REQUIRE(found.size() == 2);
    CHECK(found[0]["group"] == -1);
    CHECK(found[1]["group"] == 2.5);
    CHECK(found[1]["area"] == 0.5);
    refuses(folder, "p.ply --group-by kind --alpha 1 -o s.geojson",
            "p.ply:3: found vertices without 'kind', expected a number property of that name, as --group-by asks", 3);
  }

  TEST_CASE("what cannot be grouped is refused before anything is written") {
    const Folder folder;
    folder.file("p.csv", fixes);
    folder.file("p.xy", "0 0\n1 0\n0 1\n");
    refuses(folder, "p.csv --group-by herd --alpha 1 -o s.csv",
            "p.csv:1: found 'x,y,animal,id', expected a header with a column 'herd'", 3);
    refuses(folder, "p.xy --group-by a --alpha 1 -o s.csv",
            "p.xy: found no header line, expected one with the names that --group-by asks for", 3);
    refuses(folder, "p.csv --group-by animal --alpha 1 -o s.wkt",
            "--group-by: found s.wkt, expected geojson, csv, svg or png", 2);
    refuses(folder, "p.csv --group-by animal --alpha 1 -o s.csv --isolated i.csv",
            "--isolated: found --group-by as well, expected one of the two", 2);
    refuses(folder, "p.csv --group-by animal --alpha 1 -o s.csv --stats t.json",
            "--stats: found --group-by as well, expected one of the two", 2);
    refuses(folder, "p.npy --group-by animal --alpha 1 -o s.csv",
            "--group-by: found a format without fields beside the points, expected las, ply or text", 2);
    CHECK(folder.names() == std::vector<std::string>{"p.csv", "p.xy"});
  }

  TEST_CASE("a table without points has no groups, and texts of any bytes are names") {
    const Folder folder;
    folder.file("p.csv", "x,y,g\n");
    CHECK(folder.rbpa("shape p.csv --group-by g --alpha 1 -o s.csv -q").code == 0);
    CHECK(folder.content("s.csv") == "group,points,alpha,area,perimeter,polygons,problem,geometry\n");
    folder.file("l.csv", "x,y,g\n0,0,K\xf6ln\n1,0,K\xf6ln\n0,1,K\xf6ln\n3,3,\"a \"\"b\"\"\"\n");
    REQUIRE(folder.rbpa("shape l.csv --group-by g --alpha 1 -o s.geojson -o s.csv -q").code == 0);
    CHECK(properties(folder.content("s.geojson"))[0]["group"] == "K\xef\xbf\xbdln");
    CHECK(folder.content("s.csv").find("\nK\xf6ln,3,1,") != std::string::npos);
  }
}
