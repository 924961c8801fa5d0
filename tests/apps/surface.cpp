// `rbpa surface`: files, messages, wrong usage, bad input, a signal.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/formats.h"
#include "support/las_file.h"
#include "support/npy_file.h"
#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Returns a sphere of radius 1 without the part above `top`, each point with its normal.
std::string sphere(int count, double top = 2, bool normals = true) {
  std::string text;
  for (const rbpa::Point3& at : rbpa_test::spiral(count)) {
    const std::string p = rbpa_test::text_of(at);
    if (at.z <= top) text += p + (normals ? " " + p : std::string()) + "\n";
  }
  return text;
}

std::vector<std::uint32_t> indices_of(const std::string& npy) {
  const std::size_t begin = npy.find('\n') + 1;
  std::vector<std::uint32_t> values((npy.size() - begin) / 4);
  if (!values.empty()) std::memcpy(values.data(), npy.data() + begin, 4 * values.size());
  return values;
}

}  // namespace

TEST_SUITE("surface") {
  TEST_CASE("a sphere is closed in every format, and statistics are those of meshtopo") {
    const Folder folder("s.xyz", sphere(500));
    const Outcome outcome = folder.rbpa(
        "surface s.xyz --radius 0.3 -o m.ply -o m.off -o m.obj -o m.stl -o m.npy -o m.png --width 200 --stats s.json",
        0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err ==
          "rbpa: s.xyz: columns 4 to 6 are read as normals (a header 'x y z r g b' makes them colors)\n"
          "rbpa: 500 points, normals of the file, radius 0.3: 996 triangles, 1 component, 0 boundary curves, genus 0 "
          "-> m.ply, m.off, m.obj, m.stl, m.npy, m.png\n");
    for (const std::string name : {"m.ply", "m.off", "m.obj", "m.stl"}) {
      CAPTURE(name);
      const json topology = json::parse(folder.meshtopo(name + " --json").out);
      CHECK(topology["betti"] == json::parse("[1, 0, 1]"));
      CHECK(topology["defects"].empty());
      CHECK(topology["faces"] == 996);
    }
    const json stats = json::parse(folder.content("s.json"));
    CHECK(stats["vertices"] == 500);
    CHECK(stats["edges"] == 1494);
    CHECK(stats["unused"] == 0);
    CHECK(stats["normals"] == "file");
    CHECK(stats["radii"] == json::parse("[0.3]"));
    CHECK(stats["seconds"].size() == 4);
    const std::vector<std::uint32_t> rows = indices_of(folder.content("m.npy"));
    REQUIRE(rows.size() == 3 * 996);
    for (std::size_t i = 0; i < rows.size(); i += 3) {
      CHECK((rows[i] < rows[i + 1] && rows[i] < rows[i + 2]));
      if (i > 0) CHECK(std::lexicographical_compare(&rows[i - 3], &rows[i], &rows[i], &rows[i] + 3));
    }
    CHECK(folder.content("m.png").substr(1, 3) == "PNG");
    // Estimated normals of a sphere point outward as those of the file do.
    folder.file("bare.xyz", sphere(500, 2, false));
    CHECK(contains(folder.rbpa("surface bare.xyz --radius 0.3 -o e.npy --threads 1").err, "normals estimated"));
    CHECK(folder.content("e.npy") == folder.content("m.npy"));
  }

  TEST_CASE("a hole is reported, drawn as a polyline, and in JSON with its causes") {
    const Folder folder("s.xyz", sphere(500, 0.7));
    const Outcome outcome = folder.rbpa("surface s.xyz --radius 0.3 --holes h.obj --json", 0);
    const json report = json::parse(outcome.out);
    REQUIRE(report["holes"].size() == 1);
    const json& hole = report["holes"][0];
    CHECK(hole["length"].get<double>() > 4);
    CHECK(hole["length"].get<double>() < 6);
    CHECK(hole["points"] == hole["edges"].size());
    CHECK(report["boundary_curves"] == 1);
    CHECK(hole["edges"][0]["cause"] == "nothing_within_reach");
    CHECK(contains(outcome.err, "rbpa: hole of length "));
    CHECK(hole["kind"] == "hole");
    CHECK(report["curves"] == json::parse(R"({"rim": 0, "hole": 1, "island": 0})"));
    const std::string lines = folder.content("h.obj");
    std::string loop = "\ng hole\nl";
    for (const json& edge : hole["edges"]) loop += " " + std::to_string(edge["from"].get<int>() + 1);
    loop += " " + std::to_string(hole["edges"][0]["from"].get<int>() + 1) + "\n";
    CHECK(lines.ends_with(loop));
  }

  TEST_CASE("a line sums up the curves if there are more than are named: rims, holes, or both") {
    const Folder folder;
    std::string triangles, plate, sieve, line;
    for (int x = 0; x < 14; ++x)
      for (int y = 0; y < 14; ++y)
        if (x % 3 != 2 || x == 2 || y % 4 < 2) plate += std::to_string(x) + " " + std::to_string(y) + " 0 0 0 1\n";
    for (int k = 0; k < 7; ++k)
      for (const char* const rest : {" 0", " 1", ".5 .5"}) triangles += std::to_string(9 * k) + rest + " 0 0 0 1\n";
    std::istringstream lines(sphere(500));
    for (int i = 0; std::getline(lines, line); ++i)
      if (i % 60 != 30) sieve += line + "\n";
    for (const auto& row : std::initializer_list<std::array<std::string, 3>>{
             {triangles, "0.75", "all 7 rims of total length "},
             {sieve, "0.15", "all 8 holes of total length "},
             {plate, "0.75", "the 1 rim and 9 holes together, of total length "}}) {
      folder.file("p.xyz", row[0]);
      const Outcome outcome = folder.rbpa("surface p.xyz --radius " + row[1] + " -o m.ply");
      CAPTURE(outcome.err);
      CHECK(contains(outcome.err, "\nrbpa: " + row[2]));
    }
  }

  TEST_CASE("--stats and --json agree, and unused points are listed with their number") {
    const Folder folder("s.xyz", "9 9 9 0 0 1\n" + sphere(500, 0.7) + "5 5 5 0 0 1\n");
    const json report = json::parse(folder.rbpa("surface s.xyz --radius 0.3 --json --stats s.json", 0).out),
               stats = json::parse(folder.content("s.json"));
    std::size_t shared = 0;
    for (const auto& member : report.items())
      if (stats.contains(member.key())) {
        CAPTURE(member.key());
        CHECK(stats[member.key()] == member.value());
        ++shared;
      }
    CHECK(shared == 26);
    CHECK(report.size() == shared + 3);
    CHECK(report["unused"] == 2);
    const int last = report["points"].get<int>() - 1;
    CHECK(report["unused_points"] ==
          json({{{"point", 0}, {"cause", "no_ball_rests"}}, {{"point", last}, {"cause", "no_ball_rests"}}}));
    CHECK(report["holes"].size() == report["boundary_curves"]);
  }

  TEST_CASE("--where and --skip-invalid choose the points, of formats that allow it") {
    const Folder folder;
    const std::string sphere_of_file = sphere(500);
    std::string table = "x y z nx ny nz keep\n";
    for (std::size_t begin = 0; begin < sphere_of_file.size();) {
      const std::size_t end = sphere_of_file.find('\n', begin);
      table += sphere_of_file.substr(begin, end - begin) + " 1\n" + "0 0 0 0 0 1 0\nNA 0 0 0 0 1 1\n";
      begin = end + 1;
    }
    folder.file("s.xyz", sphere_of_file);
    folder.file("t.csv", table);
    CHECK(folder.rbpa("surface s.xyz --radius 0.3 -o s.npy").code == 0);
    const Outcome outcome = folder.rbpa("surface t.csv --radius 0.3 --where \"keep == 1\" --skip-invalid -o t.npy", 0);
    CHECK(outcome.err.starts_with(
        "rbpa: t.csv: --where selects 1000 of 1500 lines\n"
        "rbpa: t.csv: 500 lines are left out: the first is t.csv:4: found 'NA', expected a number\n"));
    // Triangles agree by the positions of their points in the table.
    std::vector<std::uint32_t> expected = npy_rows(folder.content("s.npy"));
    for (std::uint32_t& corner : expected) corner *= 3;
    CHECK(npy_rows(folder.content("t.npy")) == expected);

    LasFile las{.minor = 2, .format = 2};
    las.points = {{.x = 0}, {.x = 100}, {.y = 100}, {.x = 50, .y = 50, .z = 10, .classification = 7}};
    folder.file("p.las", bytes_of(las));
    CHECK(folder.rbpa("surface p.las --radius 1 --normals none --where \"not (classification == 7)\" -o l.npy").code ==
          0);
    CHECK(indices_of(folder.content("l.npy")) == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 1});
    CHECK(folder.rbpa("surface p.las --radius 1 --normals none -o l.npy").code == 0);
    CHECK(indices_of(folder.content("l.npy")).size() > 6);

    folder.file("p.off", "OFF\n1 0 0\n0 0 0\n");
    const std::string skipping = rbpa::app::readable(
        rbpa::app::Use::space, [](const rbpa::app::CloudFormat& reader) { return reader.skips_invalid; });
    for (const char* format : {"las", "npy", "off", "pcd", "ply", "text"}) CHECK(contains(skipping, format));
    folder.file("p.obj", "v 0 0 0\n");
    refuses(folder, "surface p.obj --radius 1 --skip-invalid -o m.off", 2,
            "--skip-invalid: found a format without points that can be left out, expected " + skipping);
    refuses(folder, "surface p.off --radius 1 --where \"z > 1\" -o m.off", 2,
            "--where: found a format without fields, expected " + rbpa::app::with_fields(rbpa::app::Use::space));
    // Messages are those of the other verbs.
    CHECK(folder.rbpa("surface p.las --radius 1 --where \"height > 1\" -o m.off").err ==
          folder.rbpa("info p.las --where \"height > 1\"").err);
    CHECK(folder.rbpa("surface p.las --radius 1 --where \"gps_time > 1\" -o m.off")
              .err.starts_with("rbpa: p.las: found point format 2 of LAS 1.2 with x, y, z, intensity, return_number"));
  }

  TEST_CASE("colors of a table are those of the surface") {
    const Folder folder("c.csv", "x,y,z,r,g,b\n0,0,0,255,0,1\n1,0,0,0,7,0\n0,1,0,3,4,5\n");
    CHECK(folder.rbpa("surface c.csv --radius 2 --normals none -o m.ply").code == 0);
    const std::string ply = folder.content("m.ply");
    CHECK(contains(ply, "property uchar red\nproperty uchar green\nproperty uchar blue\n"));
    CHECK(contains(ply, std::string("\xFF\0\x01", 3)));
    CHECK(contains(ply, std::string("\x03\x04\x05", 3)));
    const std::string run = "surface c.csv --radius 2 --normals none -o m.ply -o m.glb ";
    const std::string err = folder.rbpa(run + "-o m.obj -o m.off").err;
    for (const std::string name : {"m.obj", "m.off"})
      CHECK(contains(err, "rbpa: c.csv: colors are left out of " + name + " (.ply, .vtu and .glb have them)\n"));
    CHECK(!contains(folder.rbpa(run).err, "left out"));
  }

  TEST_CASE("without normals both sides are made, the outer one first") {
    const Folder folder("s.xyz", sphere(500));
    CHECK(folder.rbpa("surface s.xyz --radius 0.3 --normals none -o both.off -o b.npy -q").err.empty());
    CHECK(folder.rbpa("surface s.xyz --radius 0.3 -o one.off -q").code == 0);
    const std::string one = folder.content("one.off"), both = folder.content("both.off");
    // Vertices and then the outer triangles are those of the surface.
    const std::size_t rest = one.find('\n', 4), start = both.find('\n', 4);
    CHECK(both.substr(start, one.size() - rest) == one.substr(rest));
    CHECK(indices_of(folder.content("b.npy")).size() == 3 * 2 * 996);
  }

  TEST_CASE("normals, also those of the file, are turned toward a viewpoint, or around") {
    const Folder folder({{"bare.xyz", sphere(500, 2, false)}, {"own.xyz", sphere(500)}});
    for (const std::string points : {"bare.xyz", "own.xyz"}) {
      CAPTURE(points);
      const auto rows = [&](const std::string& options) {
        CHECK(folder.rbpa("surface " + points + " --radius 0.3 -o m.npy -q " + options).code == 0);
        return indices_of(folder.content("m.npy"));
      };
      const std::vector<std::uint32_t> outward = rows(""), inward = rows("--flip");
      CHECK(outward.size() == 3 * 996);
      CHECK(inward.size() == outward.size());
      CHECK(inward != outward);
      CHECK(rows("--viewpoint 0.1,0,-0.2") == inward);
      CHECK(rows("--viewpoint 0.1,0,-0.2 --flip") == outward);
    }
    // Fewer neighbors, and the normals of the file ignored.
    CHECK(contains(folder.rbpa("surface own.xyz --radius 0.3 --neighbors 8 -o m.npy").err, "normals estimated"));
  }

  TEST_CASE("wrong neighbors and viewpoints are refused without a file") {
    const Folder folder("p.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    for (const std::string text : {"1", "2.5", "1001", "x"})
      refuses(folder, "surface p.xyz --radius 1 -o m.off --neighbors " + text, 2,
              "--neighbors: found '" + text + "', expected a whole number of points from 2 to 1000");
    for (const std::string text : {"1,2", "1,2,3,4", "a,b,a", "1,2,inf"})
      refuses(
          folder, "surface p.xyz --radius 1 -o m.off --viewpoint " + text, 2,
          "--viewpoint: found '" + text + "', expected three coordinates, such as 0,0,1.5, or three names of columns");
    refuses(folder, "surface p.xyz --radius 1 -o m.off --normals none --flip", 2,
            "--normals none cannot be combined with --neighbors, --viewpoint or --flip, which change normals");
    refuses(folder, "surface p.xyz --radius 1 -o m.off --normals file --neighbors 8", 2,
            "--neighbors requires --normals estimate");
  }

  TEST_CASE("colors and normals stay with their vertices, and --compact drops the others") {
    const Folder folder(
        "p.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nend_header\n9 9 9 0 0 1 1 2 3\n0 0 0 0 0 1 4 5 6\n1 0 0 0 0 1 7 8 9\n0 1 0 0 0 1 "
        "10 11 12\n");
    CHECK(folder.rbpa("surface p.ply --radius 1 --compact -o c.ply -o c.npy -q").code == 0);
    const std::string ply = folder.content("c.ply");
    CHECK(contains(ply, "element vertex 3\n"));
    const std::size_t data = ply.find("end_header\n") + 11;
    CHECK(ply.size() == data + 3 * (6 * 8 + 3) + 13);
    CHECK(ply.substr(data + 48, 3) == "\x04\x05\x06");
    CHECK(indices_of(folder.content("c.npy")) == std::vector<std::uint32_t>{1, 2, 3});
  }

  TEST_CASE("an empty surface is an answer, with a radius that gives triangles") {
    const Folder folder("s.xyz", sphere(200));
    const Outcome empty = folder.rbpa("surface s.xyz --radius 0.001 -o m.off -q", 0);
    const std::string said = "rbpa: there is no triangle: with --radius ";
    REQUIRE(empty.err.starts_with(said));
    const std::string radius = empty.err.substr(said.size(), empty.err.find(' ', said.size()) - said.size());
    CHECK(folder.rbpa("surface s.xyz --radius " + radius + " -o m.off -q").err.empty());
    folder.file("line.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n");
    CHECK(folder.rbpa("surface line.xyz --radius auto -o m.off -q").err ==
          "rbpa: there is no triangle: all points are on a line\n");
    folder.file("two.xyz", "0 0 0\n1 1 1\n");
    CHECK(folder.rbpa("surface two.xyz --radius 1 -o m.off -q").err ==
          "rbpa: there is no triangle: fewer than three distinct points\n");
  }

  TEST_CASE("wrong usage is refused without a file") {
    const Folder folder("p.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    const std::string number = ", expected numbers above 0 with commas between them, or auto";
    refuses(folder, "surface p.xyz --radius 0 -o m.off", 2, "--radius: found '0'" + number);
    refuses(folder, "surface p.xyz --radius=-1 -o m.off", 2, "--radius: found '-1'" + number);
    refuses(folder, "surface p.xyz --radius 1,x -o m.off", 2, "--radius: found 'x'" + number);
    refuses(folder, "surface p.xyz --radius 1, -o m.off", 2, "--radius: found ''" + number);
    refuses(folder, "surface p.xyz --radius inf -o m.off", 2, "--radius: found 'inf'" + number);
    refuses(folder, "surface p.xyz --radius nan -o m.off", 2, "--radius: found 'nan'" + number);
    refuses(folder, "surface p.xyz --radius 2,1 -o m.off", 2, "--radius: found '1' after 2, expected ascending radii");
    refuses(folder, "surface p.xyz --radius 1,1 -o m.off", 2, "--radius: found '1' after 1, expected ascending radii");
    refuses(folder, "surface p.xyz --radius 1,2 --normals none -o m.off", 2,
            "--radius: found 2 numbers with --normals none, expected one radius");
    refuses(folder, "surface p.xyz --radius 1 --normals maybe -o m.off", 2,
            "--normals: found 'maybe', expected file, estimate or none");
    const std::string formats = ", expected one of off, ply, obj, stl, npy, glb, vtu, png, or --output-format";
    refuses(folder, "surface p.xyz --radius 1 -o m.wkt", 2, "m.wkt: found the ending 'wkt'" + formats);
    refuses(folder, "surface p.dat --radius 1 -o m.off", 2,
            "p.dat: found the ending 'dat', expected one of " + rbpa::app::endings(rbpa::app::Use::space) +
                ", or --format (--format txt if it is a table)");
    refuses(folder, "surface p.xyz --radius 1", 2, "-o: found no OUT, expected at least one (or --stats FILE)");
    refuses(folder, "surface p.xyz --radius 1 -o m.off --holes h.ply", 2,
            "--holes: found the ending 'ply', expected obj");
    refuses(folder, "surface p.xyz --radius 1 --normals none --holes h.obj", 2,
            "--holes cannot be combined with --normals none, whose triangles have no boundary");
    for (const std::string twice : {"-o m.off -o m.off", "-o m.obj --holes m.obj", "-o p.xyz --output-format off",
                                    "-o - --output-format off --json"}) {
      CAPTURE(twice);
      CHECK(folder.rbpa("surface p.xyz --radius 1 " + twice).code == 2);
    }
    CHECK(folder.names() == std::vector<std::string>{"p.xyz"});
  }

  TEST_CASE("bad input is refused without a file") {
    const Folder folder("p.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    refuses(folder, "surface p.xyz --radius 1 --normals file -o m.off", 3,
            "p.xyz: found no normals, expected a normal for each point (--normals estimate computes them, --normals "
            "none does without)");
    folder.file("far.xyz", "0 0 0\n1e60 0 0\n0 1e60 0\n");
    refuses(folder, "surface far.xyz --radius 1e60 -o m.stl -q", 3,
            "m.stl: found the coordinate 1e+60, expected at most 3.4e38 in size, as STL is in single precision (.ply "
            "keeps doubles)");
    refuses(folder, "surface none.xyz --radius 1 -o m.off", 3,
            "none.xyz: found no such file, expected a file of points");
    folder.file("plane.xyz", "0 0\n1 0\n");
    CHECK(folder.rbpa("surface plane.xyz --radius 1 -o m.off").code == 3);
  }
}
