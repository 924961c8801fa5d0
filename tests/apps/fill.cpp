// `rbpa fill`: formats of polygons, outputs, wrong usage, bad input, signals, progress.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/child.h"
#include "support/gdal_endings.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

constexpr const char* plate_wkt = "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))\n";
constexpr const char* plate_json =
    R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",
"coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]}}]})";
constexpr const char* plate_poly =
    "# a plate with a hole\n8 2 1 1\n1 0 0 7.5 1\n2 4 0 7.5 1\n3 4 3 7.5 1\n4 0 3 7.5 1 # attributes and markers\n"
    "5 1 1 0 2\n6 2 1 0 2\n7 2 2 0 2\n8 1 2 0 2\n\n8 1\n1 3 2 1\n2 1 2 1\n3 3 4 1\n4 4 1 1\n5 5 6 2\n6 7 6 2\n7 7 8 2\n"
    "8 8 5 2\n1\n1 1.5 1.5\n1\n1 0.5 0.5 1 0.1\n";

struct Off {
  std::vector<std::vector<double>> points;
  std::vector<std::vector<std::size_t>> faces;
};
Off read_off(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0;
  in >> word >> points >> faces >> edges;
  Off off{.points = std::vector(points, std::vector<double>(3)),
          .faces = std::vector(faces, std::vector<std::size_t>(3))};
  for (auto& p : off.points)
    for (double& x : p) in >> x;
  for (auto& f : off.faces) {
    in >> edges;
    CHECK(edges == 3);
    for (std::size_t& i : f) in >> i;
  }
  CHECK(in);
  return off;
}

double area_of(const Off& off) {
  double twice = 0;
  for (const auto& f : off.faces) {
    const auto &a = off.points[f[0]], &b = off.points[f[1]], &c = off.points[f[2]];
    twice += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  return twice / 2;
}

}  // namespace

TEST_SUITE("fill") {
  TEST_CASE("the same polygon from each format gives the same bytes") {
    const Folder folder;
    folder.file("p.wkt", plate_wkt);
    folder.file("p.json", plate_json);
    folder.file("p.poly", plate_poly);
    folder.file("multi.wkt",
                "SRID=3857;MULTIPOLYGON M (((0 0 5, 4 0 5, 4 3 5, 0 3 5, 0 0 5), (1 1 5, 2 1 5, 2 2 5, 1 2 5)))");
    folder.file(
        "collection.json",
        R"({"type": "GeometryCollection", "geometries": [{"coordinates": [[[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]],
                [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]], []], "type": "MultiPolygon"}]})");
    REQUIRE(folder.rbpa("fill p.wkt --size 0.3 -o p.off -q").code == 0);
    const Off off = read_off(folder.content("p.off"));
    CHECK(area_of(off) == doctest::Approx(11));
    CHECK(off.points[5] == std::vector<double>{2, 1, 0});
    for (const std::string name : {"p.json", "p.poly", "multi.wkt", "collection.json"}) {
      CAPTURE(name);
      CHECK(folder.rbpa("fill " + name + " --size 0.3 -o - --output-format off -q", 0).out == folder.content("p.off"));
    }
    folder.run("gzip", "-k p.poly");
    CHECK(folder.rbpa("fill p.poly.gz --size 0.3 -o - --output-format off -q").out == folder.content("p.off"));
    CHECK(folder.run("sh", "-c '" RBPA_PROGRAM " fill - --format wkt --size 0.3 -o - --output-format off -q < p.wkt'")
              .out == folder.content("p.off"));
    CHECK(folder.rbpa("fill p.wkt --size 0.3 -o - --output-format off -q").out == folder.content("p.off"));
  }

  TEST_CASE("every format is written, with a summary and statistics") {
    const Folder folder("p.wkt", plate_wkt);
    const Outcome outcome = folder.rbpa(
        "fill p.wkt --size 0.5 -o p.off -o p.ply -o p.obj -o p.vtu -o p.npy -o p.svg -o p.png --stats stats.json", 0);
    const json stats = json::parse(folder.content("stats.json"));
    const Off off = read_off(folder.content("p.off"));
    CHECK(outcome.err == "rbpa: 1 polygon with 1 hole, area 11, " + std::to_string(off.faces.size()) +
                             " triangles on " + std::to_string(off.points.size()) +
                             " points -> p.off, p.ply, p.obj, p.vtu, p.npy, p.svg, p.png\n");
    CHECK(stats["points"] == 8);
    CHECK(stats["triangles"] == off.faces.size());
    CHECK(stats["points_on_boundary"].get<std::size_t>() + stats["points_inside"].get<std::size_t>() + 8 ==
          off.points.size());
    CHECK(stats["boundary_curves"] == 2);
    CHECK(stats["holes"] == 1);
    CHECK(stats["polygons"] == 1);
    CHECK(stats["polygon_holes"] == 1);
    CHECK(stats["area"] == 11.0);
    CHECK(stats["perimeter"] == 18.0);
    CHECK(stats["method"] == "fill");
    CHECK(stats["retreats"] == 0);
    for (const std::string name : {"p.off", "p.ply", "p.obj"}) {
      const json topology = json::parse(folder.meshtopo(name + " --json").out);
      CHECK(topology["betti"] == json::parse("[1, 1, 0]"));
      CHECK(topology["defects"].empty());
      CHECK(topology["faces"] == off.faces.size());
    }
    CHECK(contains(folder.content("p.svg"), "<path"));
    CHECK(folder.content("p.png").substr(1, 3) == "PNG");
  }

  TEST_CASE("edges are kept, graded, and sized at points as the options say") {
    const Folder folder({{"p.wkt", "POLYGON ((0 0, 1 0, 1 1, 0.02 1, 0 1))"},
                         {"sizes.txt", "x,y,size\n# near a corner\n1, 0; 0.02\n\n0.5 0.5\t0.6\n"}});
    const auto faces = [&](const std::string& options) {
      const Outcome outcome = folder.rbpa("fill p.wkt -o - --output-format off -q " + options, 0);
      CHECK(outcome.err.empty());
      const Off off = read_off(outcome.out);
      CHECK(area_of(off) == doctest::Approx(1));
      return off.faces.size();
    };
    const std::size_t constant = faces("--size 0.2");
    CHECK(faces("--size 0.2 --grade 0.2") > constant + 50);
    const std::size_t at_points = faces("--size 0.2 --size-at sizes.txt");
    CHECK(at_points > constant + 30);
    CHECK(faces("--size 0.2 --size-at sizes.txt --grade 0.6") < at_points);
    CHECK(faces("--size 5 --keep-boundary") == 3);
    CHECK(faces("--size 5") == 3);
  }

  TEST_CASE("invalid polygons are refused with the place") {
    const Folder folder;
    const std::string expected = "; expected rings that meet in single points at most";
    folder.file("bow.wkt", "POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))");
    refuses(folder, "fill bow.wkt --size 1 -o m.off", 3,
            "bow.wkt: the edge from vertex 0 (0, 0) to vertex 1 (2, 2) of the shell of polygon 0 crosses the edge from "
            "vertex 2 (2, 0) to vertex 3 (0, 2) of the shell of polygon 0" +
                expected);
    folder.file("touch.json",
                R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]], [[0,2],[2,1],[2,3],[0,2]]]})");
    CHECK(folder.rbpa("fill touch.json --size 1 -o - --output-format off -q").code == 0);  // valid
    folder.file("outside.wkt", "POLYGON((0 0, 1 0, 0 1), (5 5, 6 5, 5 6))");
    refuses(folder, "fill outside.wkt --size 1 -o m.off", 3,
            "outside.wkt: hole 0 of polygon 0 at (5, 5): found it in no ring, expected it in the shell of its polygon");
    folder.file("points.wkt", "POLYGON((0 0, 1 0, 0 1))\nLINESTRING(0 0, 1 1)");
    refuses(folder, "fill points.wkt --size 1 -o m.off", 3,
            "points.wkt:2: found LINESTRING, expected POLYGON or MULTIPOLYGON");
    folder.file("point.json", R"({"type": "Point", "coordinates": [1, 2]})");
    refuses(folder, "fill point.json --size 1 -o m.off", 3,
            "point.json:1: found a Point, expected Polygon or MultiPolygon");
    folder.file("nan.wkt", "POLYGON((0 0, 1 nan, 0 1))");
    CHECK(folder.rbpa("fill nan.wkt --size 1 -o m.off").code == 3);
    folder.file("empty.wkt", "");
    refuses(folder, "fill empty.wkt --size 1 -o m.off", 3, "empty.wkt: found an empty file, expected polygons");
    refuses(folder, "fill none.wkt --size 1 -o m.off", 3, "none.wkt: found no such file, expected a file of polygons");
    folder.file("p.wkt", plate_wkt);
    const Outcome many = folder.rbpa("fill p.wkt --size 1e-9 -o m.off", 3);
    CHECK(many.err.starts_with("rbpa: p.wkt: size: found 1e-09, at which about 254034"));  // other digits are rounded
    CHECK(many.err.ends_with(" triangles would be made, expected larger sizes: at most 5e+08 triangles\n"));
    CHECK_FALSE(folder.has("m.off"));
    // An empty input is an answer.
    folder.file("nothing.wkt", "POLYGON EMPTY");
    says(folder, "fill nothing.wkt --size 1 -o m.off", 0, "there is no triangle, as there is no polygon to fill");
  }

  TEST_CASE("rings of files of Triangle begin at any vertex") {
    const Folder folder;
    for (const std::string order : {"0 4 0\n1 0 0\n2 0 4\n", "0 0 4\n1 4 0\n2 0 0\n", "0 0 0\n1 0 4\n2 4 0\n"}) {
      CAPTURE(order);
      folder.file("t.poly", "3 2\n" + order + "3\n0 0 1\n0 1 2\n0 2 0\n0\n");
      const Outcome outcome = folder.rbpa("fill t.poly --size 9 -o t.off", 0);
      CHECK(outcome.err == "rbpa: 1 polygon with 0 holes, area 8, 1 triangle on 3 points -> t.off\n");
    }
  }

  TEST_CASE("invalid files of Triangle are refused with the line") {
    const Folder folder;
    const auto poly = [&](const std::string& text, const std::string& message) {
      folder.file("p.poly", text);
      refuses(folder, "fill p.poly --size 1 -o m.off", 3, "p.poly" + message);
    };
    const std::string vertices = "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n", ring = "3 0\n0 0 1\n1 1 2\n2 2 0\n";
    poly("0 2 0 0\n",
         ":1: found 0 vertices, which means that they are in a .node file, expected the vertices in this file");
    poly("3 3 0 0\n0 0 0 0\n", ":1: found dimension 3, expected 2");
    poly("3 2 0 0\n0 0 0\n1 1\n", ":3: found the end of the line, expected y of a vertex");
    poly("3 2 0 0\n0 0 0\n2 1 0\n", ":3: found vertex 2, expected vertex 1");
    poly("3 2 0 0\n0 0 nan\n", ":2: found 'nan', expected y of a vertex: a finite number");
    poly("9000000 2 0 0\n0 0 0\n", ":1: found '9000000', expected the number of vertices: a whole number from 0 to 6");
    poly(vertices, ":4: found the end of the file, expected the number of segments");
    poly(vertices + "1 0\n0 0 7\n", ":6: found '7', expected a vertex: a whole number from 0 to 2");
    poly(vertices + "1 0\n0 1 1\n", ":6: found a segment from a vertex to itself, expected two vertices");
    poly(vertices + "2 0\n0 0 1\n1 1 2\n0\n",
         ": found one segment at vertex 0, expected two or none, as segments must form closed rings");
    poly(vertices + "4 0\n0 0 1\n1 1 2\n2 2 0\n3 0 1\n",
         ":9: found a third segment at vertex 0, expected two, as segments must form closed rings (remove segments "
         "inside of polygons)");
    poly(vertices + ring + "1\n0 9 9\n",
         ": hole point 0 at (9, 9): found it in no hole, expected a ring around it within another");
    const std::string square =
        "7 2 0 0\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 1 1\n6 2 1\n7 1 2\n7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n"
        "5 5 6\n6 6 7\n7 7 5\n";
    poly(square + "0\n",
         ": the ring through (1, 1): found no hole point in this ring within another, expected one (lines inside of a "
         "polygon are not kept)");
  }

  TEST_CASE("wrong usage is refused") {
    const Folder folder({{"p.wkt", plate_wkt}, {"s.txt", "0 0 0.1\n"}});
    const std::string formats = "geojson, json, wkt, ewkt, poly";
    refuses(folder, "fill p.wkt -o m.off", 2,
            "--size is required: a length in units of the polygons, or inf (see rbpa fill --help)");
    refuses(folder, "fill p.wkt --size 0 -o m.off", 2,
            "--size: found '0', expected inf or a length in units of the polygons: a number above 0");
    refuses(folder, "fill p.wkt --size inf --grade 1 -o m.off", 2,
            "--size inf adds no point and cannot be combined with --grade");
    refuses(folder, "fill p.wkt --size 1 --grade x -o m.off", 2,
            "--grade: found 'x', expected how much sizes grow for each unit of distance: a number above 0");
    refuses(folder, "fill p.off --size 1 -o m.off", 2,
            "p.off: found the ending 'off', expected one of " + formats + ", or --format");
    refuses(folder, "fill p.wkt --format off --size 1 -o m.off", 2,
            "--format: found 'off', expected one of " + formats);
    refuses(folder, "fill - --size 1 -o m.off </dev/null", 3, "standard input: found an empty file, expected polygons");
    refuses(folder, "fill p.wkt --size 1", 2, "-o: found no OUT, expected at least one (or --stats FILE)");
    refuses(folder, "fill p.wkt --size 1 -o m.abc", 2,
            "m.abc: found the ending 'abc', expected one of off, ply, obj, npy, vtu, geojson, json, svg, png" +
                gdal_endings() + ", or --output-format");
    CHECK(folder.rbpa("fill p.wkt --size 1 --size-at s.txt -o s.txt --output-format off").code == 2);
    CHECK(folder.rbpa("fill p.wkt --size 1 -o p.wkt --output-format off").code == 2);
    CHECK(folder.rbpa("fill - --format wkt --size-at - --size 1 -o m.off").code == 2);
    folder.file("bad.txt", "0 0 0.1\n1 2\n");
    refuses(folder, "fill p.wkt --size 1 --size-at bad.txt -o m.off", 3,
            "bad.txt:2: found 2 values, expected three: x, y and size");
    folder.file("bad.txt", "0 0 0.1\n1 2 -3\n");
    refuses(folder, "fill p.wkt --size 1 --size-at bad.txt -o m.off", 3,
            "bad.txt:2: found the size -3, expected a size above 0");
    folder.file("bad.txt", "0 0 0.1\n1 b 3\n");
    refuses(folder, "fill p.wkt --size 1 --size-at bad.txt -o m.off", 3, "bad.txt:2: found 'b', expected a number");
    folder.file("bad.txt", "x y size\n");
    refuses(folder, "fill p.wkt --size 1 --size-at bad.txt -o m.off", 3,
            "bad.txt: found no size, expected lines of x, y and size");
  }

  TEST_CASE("a signal while triangles are made leaves nothing behind") {
    for (const int sig : {SIGINT, SIGTERM}) {
      const Folder folder;
      REQUIRE(mkfifo(folder.path("p.wkt").c_str(), 0600) == 0);
      Child child({RBPA_PROGRAM, "fill", folder.path("p.wkt"), "--size", "0.002", "-o", folder.path("m.off")});
      const int pipe = open(folder.path("p.wkt").c_str(), O_WRONLY);
      REQUIRE(pipe >= 0);
      const std::string text = plate_wkt;
      REQUIRE(write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
      close(pipe);
      usleep(200000);  // it would take much longer
      child.send(sig);
      CHECK(child.wait() == Ending{130, 0});
      CHECK(folder.names() == std::vector<std::string>{"p.wkt"});
    }
  }
}
