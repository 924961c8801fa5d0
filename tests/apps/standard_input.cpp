// The format of standard input by its content; the place of an error in GeoJSON.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/failure.h"
#include "io/polygon/read_geojson.h"
#include "io/text/signature.h"
#include "support/gzip.h"
#include "support/las_file.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using namespace rbpa::app;

namespace {

std::string las() {
  LasFile file;
  for (int i = 0; i < 5; ++i) file.points.push_back({.x = i * i, .y = i, .z = 7 * i % 3});
  return bytes_of(file);
}

const std::string features =
    "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"g\":\"a\"},\"geometry\":{"
    "\"type\":\"MultiPoint\",\"coordinates\":[[0,0],[1,0],[0,1]]}}]}\n";
const std::string square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n";
const std::string off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string refusal(const std::string& text, bool polygons = false) {
  return rbpa_test::refusal_of<BadInput>([&] {
    polygons ? static_cast<void>(read_geojson_polygons(text, "g"))
             : static_cast<void>(read_geojson_points(text, "g", false));
  });
}

}  // namespace

TEST_SUITE("standard input") {
  TEST_CASE("points have the format of their content, compressed or not, with options of that format") {
    const Folder folder;
    REQUIRE(folder.file("t.off", off).size() > 0);
    REQUIRE(folder.meshtopo("t.off --repair t.ply --quiet").code == 0);
    REQUIRE(folder.meshtopo("t.off --repair t.obj --quiet").code == 0);
    REQUIRE(folder.rbpa("mesh t.off --alpha inf -o t.png -q").code == 0);
    const std::vector<std::pair<std::string, std::string>> plane = {{"p.las", las()},
                                                                    {"p.geojson", features},
                                                                    {"p.wkt", "MULTIPOINT (0 0, 1 0, 0 1)\n"},
                                                                    {"p.xy", "0 0\n1 0\n0 1\n"},
                                                                    {"p.csv", "name;lon;lat\na, b;0;0\nc;1;0\nd;0;1\n"},
                                                                    {"p.off", off},
                                                                    {"p.ply", folder.content("t.ply")},
                                                                    {"p.png", folder.content("t.png")},
                                                                    {"p.pgm", "P2\n2 2\n1\n0 1\n1 0\n"}};
    for (const auto& [name, bytes] : plane) {
      const auto& shown_name = name;
      CAPTURE(shown_name);
      folder.file(name, bytes);
      folder.file(name + ".gz", compressed(bytes));
      const Outcome by_name = folder.rbpa("info " + name, 0);
      for (const std::string& input : {name, name + ".gz"}) {
        CHECK(folder.rbpa("info - < " + input).out == by_name.out);
        CHECK(folder.run("/bin/sh", "-c 'cat " + input + " | " RBPA_PROGRAM " info -'").out == by_name.out);
      }
    }
    CHECK(folder.rbpa("info - --where 'classification == 0' < p.las").code == 0);
    CHECK(folder.rbpa("shape - --group-by g --alpha inf -o g.geojson < p.geojson").code == 0);
    CHECK(contains(folder.content("g.geojson"), "\"group\":\"a\""));
    refuses(folder, "info - --columns 1,2 < p.las", 2,
            "--columns: found standard input in a format with fixed columns, expected text");
    refuses(folder, "info - --where 'a == 1' < p.wkt", 2,
            "--where: found standard input in a format without fields, expected " + with_fields(Use::points));
    const Outcome unknown = folder.rbpa("info - --where 'a == 1' < p.las", 3);
    CHECK(unknown.err.starts_with("rbpa: standard input: found point format 0 of LAS 1.2 with x, y, z, intensity, "));
    CHECK(unknown.err.ends_with(", point_source_id, expected one with a, as --where requires\n"));
    refuses(folder, "info - --where \"x == 'a'\" < p.las", 2,
            "--where: found the text 'a', expected numbers, as the fields of standard input have no texts");
    refuses(folder, "info - --vertices < p.las", 2,
            "--vertices: found standard input in a format without lines and polygons, expected points in the plane in "
            "one of " +
                endings(Use::points, has_lines));
  }

  TEST_CASE("points in space, meshes and polygons have the format of their content; an unknown one is refused") {
    const Folder folder("m.off", off);
    for (const std::string ending : {"ply", "obj", "stl"})
      REQUIRE(folder.meshtopo("m.off --repair m." + ending + " --quiet").code == 0);
    for (const std::string name : {"m.off", "m.ply", "m.obj", "m.stl"}) {
      CAPTURE(name);
      CHECK(folder.meshtopo("- < " + name).out == folder.meshtopo(name).out);
      if (name == "m.stl") continue;
      says(folder, "solid - --alpha inf -o a.npy < " + name, 0, "1 tetrahedron");
    }
    folder.file("a.pdb",
                "HEADER\nATOM      1  C   UNK A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                "ATOM      2  C   UNK A   1       1.000   0.000   0.000  1.00  0.00           C\n"
                "ATOM      3  C   UNK A   1       0.000   1.000   0.000  1.00  0.00           C\n"
                "ATOM      4  C   UNK A   1       0.000   0.000   1.000  1.00  0.00           C\n");
    folder.file("a.xyz", "4\n\nC 0 0 0\nC 1 0 0\nC 0 1 0\nC 0 0 1\n");
    folder.file("a.las", las());
    for (const std::string name : {"a.pdb", "a.xyz", "a.las"})
      CHECK(folder.rbpa("solid - --alpha inf -o a.npy < " + name).code == 0);
    folder.file("p.wkt", square);
    CHECK(folder.rbpa("fill - --size 1 -o f.off < p.wkt").code == 0);
    folder.file("p.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 1 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    CHECK(folder.rbpa("fill - --size 1 -o f.off < p.poly").err ==
          "rbpa: standard input: found content of an unknown format, expected one of geojson, json, wkt, ewkt, poly "
          "(name the format with --format)\n");
    const Outcome atoms = folder.rbpa("info - < a.pdb", 3);
    CHECK(atoms.err.starts_with("rbpa: standard input: found the content of a file .pdb, expected one of xy, txt"));
    CHECK(folder.meshtopo("- < a.xyz").code == 3);
    CHECK(ending_of_content(std::string("SQLite format 3\0", 16)) == "gpkg");
    CHECK(ending_of_content("v x y z\n1 2 3 4\n").empty());
    CHECK(ending_of_content("TITLE x y\n1 2\n").empty());
  }

  TEST_CASE("an error in GeoJSON is named by the number and id of the feature") {
    const auto feature = [](const std::string& before, const std::string& coordinates, const std::string& behind) {
      return "{\"type\":\"Feature\"," + before +
             "\"properties\":{\"id\":9},\"geometry\":{\"type\":\"Point\",\"coordinates\":" + coordinates + "}" +
             behind + "}";
    };
    const std::string good = feature("\"id\":0,", "[1,2]", ""), wrong = ": found null, expected a list of coordinates";
    const auto collection = [&](const std::string& last) {
      return "{\"type\":\"FeatureCollection\",\"features\":[" + good + "," + good + "," + last + "]}";
    };
    CHECK(refusal(collection(feature("\"id\":700,", "[null]", ""))) == "g:1: feature 2 (id 700)" + wrong);
    CHECK(refusal(collection(feature("", "[null]", ",\"id\":\"a\""))) == "g:1: feature 2 (id \"a\")" + wrong);
    CHECK(refusal(collection(feature("", "[null]", ""))) == "g:1: feature 2" + wrong);
    CHECK(refusal(collection(feature("\"id\":5,", "[1]", "")))
              .starts_with("g:1: feature 2 (id 5): found a position of one number"));
    CHECK(refusal(collection(feature("\"id\":5,", "[1,2,]", ""))).starts_with("g:1: feature 2 (id 5): found '2,]'"));
    CHECK(refusal(collection(feature("\"id\":5,", "[1,2", ""))).starts_with("g:1: feature 2 (id 5): found '2}'"));
    CHECK(refusal(collection(feature("\"id\":5,", "[1,2]", "")), true)
              .starts_with("g:1: feature 0 (id 0): found a Point"));
    CHECK(refusal(good + "\n" + feature("\"id\":1,", "[null]", "") + "\n") == "g:2: feature 1 (id 1)" + wrong);
    CHECK(refusal("{\"features\":[" + feature("\"id\":3,", "[[]]", "") + "],\"type\":\"FeatureCollection\"}") == "");
    CHECK(refusal("{\"type\":\"Point\",\"coordinates\":[null]}") == "g:1" + wrong);
    CHECK(refusal("[1]") == "g:1: found an array, expected a GeoJSON object");
    std::string thousand;
    for (int i = 0; i < 1000; ++i)
      thousand +=
          (i == 0 ? "" : ", ") + feature("\"id\": " + std::to_string(i) + ",", i == 700 ? "null" : "[0, 1]", "");
    CHECK(refusal("{\"type\": \"FeatureCollection\", \"features\": [" + thousand + "]}") ==
          "g:1: feature 700 (id 700): found null, expected a list of coordinates");
  }
}
