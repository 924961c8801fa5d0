// The first lines of a table: a header, numbers in other notation, a count, comments with names, atoms.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/cloud/point_blocks.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "io/text/fields.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using rbpa::Point;
using rbpa::Point3;
using namespace rbpa::app;

namespace {

using Points = std::vector<Point>;
using Places = std::vector<Point3>;

PointFile plane(const std::string& text, const PointSource& source = {}, const std::string& name = "t.txt") {
  return points_in(text, name, source);
}
SpacePoints space(const std::string& text, const CloudRequest& request = {}, Format format = Format::text,
                  const std::string& name = "t.txt") {
  return space_points_in(text, name, format, request);
}

template <typename Read>
std::string refusal(const Read& read) {
  return rbpa_test::refusal_of<BadInput>(read);
}

const std::string lines = "0 0 1\n1 0 2\n0 1 3\n";
const Points points = {{0, 0}, {1, 0}, {0, 1}};
const Places places = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}};

CloudRequest where(const std::string& condition) { return {.where = Condition(condition, names_of_columns())}; }

}  // namespace

TEST_SUITE("first lines") {
  TEST_CASE("text that is nearly a number is not a name") {
    for (const std::string field : {"1", "-1.5", "1.0D0",
                                    "\xE2\x88\x92"
                                    "1",
                                    "12o", "1..2", "1'000", "<0.5", "+3x", ".5.", "(1"})
      CHECK(is_nearly_number(field));
    for (const std::string field : {"x", "", "x1", "lon", "d1", "e2", "_1", "-", "NA", "x-2", "\xC3\xA9tage"})
      CHECK_FALSE(is_nearly_number(field));
  }

  TEST_CASE("a first line with text that is nearly a number is read, or refused as in any other line") {
    struct Line {
      std::string text, found;  ///< the refused text; empty if the line is read
      Point point = {};
      std::string way = skipping_hint;
    };
    const Line first[] = {{"1.0D0 2.0D0", "", {1, 2}},
                          {"1.5d+2 -2.5D-1", "", {150, -0.25}},
                          {"\xE2\x88\x92"
                           "1 \xE2\x88\x92"
                           "2",
                           "",
                           {-1, -2}},
                          {"\xE2\x88\x92"
                           "1.5e\xE2\x88\x92"
                           "3 2",
                           "",
                           {-1.5e-3, 2}},
                          {"1..2 3..4", "1..2"},
                          {"12o 13o", "12o"},
                          {"O 0", "O"},
                          {"\xE2\x80\x93"
                           "1 \xE2\x80\x93"
                           "2",
                           "\xE2\x80\x93"
                           "1"},
                          {"1'000 2'000",
                           "1'000",
                           {},
                           " without signs between thousands, 1000 (export the table with cells in a plain format)"},
                          {"<1 <2", "<1"},
                          {"0x1F 0x2F", "0x1F"},
                          {"1_0 2_0", "1_0"}};
    for (const Line& line : first) {
      CAPTURE(line.text);
      for (const bool is_first : {true, false}) {
        const std::string text = is_first ? line.text + "\n1 0\n0 1\n" : "1 0\n" + line.text + "\n0 1\n";
        if (line.found.empty()) {
          CHECK(plane(text).points[is_first ? 0 : 1] == line.point);
          CHECK(plane(text).points.size() == 3);
        } else {
          CHECK(refusal([&] { plane(text); }) == std::string("t.txt:") + (is_first ? "1" : "2") + ": found '" +
                                                     line.found + "', expected a number" + line.way);
        }
      }
    }
    CHECK(plane("1,0D0;2\n1,5;2\n").points == Points{{1, 2}, {1.5, 2}});
    CHECK(space("1.0D0 2.0D0 3.0D0\n" + lines).points.size() == 4);
    CHECK(refusal([] { space("1..0 2..0 3..0\n" + lines); }).starts_with("t.txt:1: found '1..0'"));
    CHECK(refusal([] { plane("a b 3\n0 0 1\n"); }).starts_with("t.txt:1: found 'a b 3', expected known names"));
    CHECK(refusal([] { plane("a b 3.5\n0 0 1\n"); }).starts_with("t.txt:1: found 'a', expected a number"));
  }

  TEST_CASE("names are names, whatever they look like") {
    for (const std::string header : {"x y", "a b", "x1 y1", "d1 d2", "lon lat", "a_b c-d", "-x -y"})
      CHECK(plane(header + "\n0 0\n1 0\n0 1\n").points == points);
    CHECK(plane("id,lon,lat,2m_temperature,2015\n7,0,0,1,2\n7,1,0,1,2\n7,0,1,1,2\n").points == points);
    CHECK(plane("0,0,E,N\n1,0,E,N\n0,1,E,N\n").points == points);  // directions, and no names
    CHECK(space("x,y,z,2015\n0,0,1,9\n1,0,2,9\n0,1,3,9\n").points == places);
  }

  TEST_CASE("other formats read a D and the sign too") {
    const std::string minus = "\xE2\x88\x92";
    CHECK(space("OFF\n3 0 0\n0 0 1.0D0\n1 0 2\n0 1 3\n", {}, Format::off).points == places);
    CHECK(space("v 0 0 1.0D+0\nv 1 0 2\nv 0 1 3\n", {}, Format::obj).points == places);
    CHECK(plane("MULTIPOINT (1.0D0 " + minus + "2, 3 4)", {.format = Format::wkt}).points == Points{{1, -2}, {3, 4}});
    CHECK(refusal([] { plane("POINT (1.0X0 2)", {.format = Format::wkt}); }) ==
          "t.txt:1: found 'X0 2)', expected a blank, ',' or ')' after a number");
  }

  TEST_CASE("a header of --size-at has nothing that is nearly a number") {
    const Folder folder("s.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    const auto run = [&](const std::string& text) {
      folder.file("t.size", text);
      return folder.rbpa("fill s.poly --size 1 --size-at t.size -o m.off");
    };
    CHECK(run("x y size\n0 0 0.05\n1 1 0.5\n").code == 0);
    const std::string whole = folder.content("m.off");
    CHECK(run("0 0 5.0D-2\n1 1 0.5\n").code == 0);
    CHECK(folder.content("m.off") == whole);
    const Outcome typo = run("O 0 0.05\n1 1 0.5\n");
    CHECK(typo.code == 3);
    CHECK(typo.err == "rbpa: t.size:1: found 'O', expected a number\n");
  }

  TEST_CASE("a line with one whole number before lines with more is how many follow, behind a header too") {
    for (const std::string before :
         {"3\n", "x y z\n3\n", "# x y z\n3\n", "// made\n// X Y Z\n3\n", "//X Y Z\n\n3\n\n"}) {
      CAPTURE(before);
      CHECK(plane(before + lines).points == points);
      CHECK(space(before + lines).points == places);
      CHECK(space(before + lines, {}, Format::pts).points == places);
      CHECK(plane(before + lines, {.skip_invalid = true}).points == points);
      CHECK(space(before + lines, {.skip_invalid = true}).points == places);
    }
    CHECK(refusal([] { plane("4\n" + lines); }) ==
          "t.txt: found 3 lines of points, expected 4 as line 1 says (--skip-invalid reads what is there)");
    CHECK(refusal([] { plane("x y z\n2\n" + lines); }) ==
          "t.txt: found 3 lines of points, expected 2 as line 2 says (--skip-invalid reads what is there)");
    CHECK(refusal([] { plane("3\n"); }).starts_with("t.txt:1: found 1 column"));
    CHECK(refusal([] { plane("1\n2\n3\n"); }).starts_with("t.txt:1: found 1 column"));
  }

  TEST_CASE("comments that name columns, such as CloudCompare's, are headers") {
    const std::string two = "7 0 0 1 0 0 1\n8 1 0 2 0 0 1\n";
    for (const std::string mark : {"#", "# ", "//", "// "})
      for (const std::string count : {"", "2\n"}) {
        const std::string text = mark + "Class X Y Z Nx Ny Nz\n" + count + two;
        CAPTURE(text);
        CHECK(space(text).points == Places{{0, 0, 1}, {1, 0, 2}});
        CHECK(space(text).normals == Places{{0, 0, 1}, {0, 0, 1}});
        CHECK(space(text, where("class == 8")).points == Places{{1, 0, 2}});
        CHECK(space(text, {.columns = parse_space_columns("X,Y,Z")}).points == Places{{0, 0, 1}, {1, 0, 2}});
        CHECK(space(text, {}, Format::pts).normals.size() == 2);
        CHECK(plane(text).points == Points{{0, 0}, {1, 0}});
        CHECK(plane(text).heights.differ());
        CHECK(plane(text, {.columns = parse_columns("Y,X")}).points == Points{{0, 0}, {0, 1}});
      }
    CHECK(plane("//lon;lat\n0;0\n1;0\n0;1\n").degrees);
    CHECK(plane("// y x\n0 0\n1 0\n0 1\n").points == Points{{0, 0}, {0, 1}, {1, 0}});
    CHECK(plane("0 0\n// 5 5\n1 0\n  // x\n0 1\n").points == points);
  }

  TEST_CASE("--skip-invalid skips anything in the first lines") {
    for (const std::string junk : {"4", "// names", "my cloud", "made by a b c d e", "1 2", "1 2 3 4 5 6 7", "x",
                                   "NaN NaN NaN", "a;b;c;d", "\"open", "1,2,3,4 5"}) {
      CAPTURE(junk);
      for (const std::string header : {"", "x y z\n"}) {
        CAPTURE(header);
        CHECK(plane(junk + "\n" + header + lines, {.skip_invalid = true}).points == points);
        CHECK(space(junk + "\n" + header + lines, {.skip_invalid = true}).points == places);
        if (!header.empty()) {
          CHECK(plane(header + junk + "\n" + lines, {.skip_invalid = true}).points == points);
          CHECK(space(header + junk + "\n" + lines, {.skip_invalid = true}).points == places);
        }
      }
    }
    const PointFile file = plane("x,y,z\n4\n0,0,1\n1,0,2\n0,1,3\n", {.skip_invalid = true});
    CHECK(file.points == points);
    CHECK(file.warnings ==
          std::vector<std::string>{"1 line is left out: t.txt:2: found 1 column ('4'), expected 3 as in line 1"});
    CHECK(plane("junk\nlat,lon\n0,0\n0,1\n1,0\n", {.columns = parse_columns("lon,lat"), .skip_invalid = true}).points ==
          points);
    CHECK(refusal([] { plane("a\nb\n", {.skip_invalid = true}); }) ==
          "t.txt: found 2 lines and no point, expected at least one point (t.txt:1: found 'a', expected two numbers)");
  }

  TEST_CASE("a header alone is refused in every table, unless a line says that there are no points") {
    struct Table {
      std::string header, found;
      Format format = Format::text;
    };
    const std::string line = R"({"type": "FeatureCollection", "features": []})";
    for (const Table& table : std::vector<Table>{{"x y z", "x y z"},
                                                 {"x,y,z\n\n# a comment", "x,y,z"},
                                                 {"\n// a comment\na;b;c", "a;b;c"},
                                                 {"sep=;\nx;y;z", "x;y;z"},
                                                 {"x y z nx ny nz", "x y z nx ny nz", Format::xyzn},
                                                 {"x y z r g b", "x y z r g b", Format::xyzrgb},
                                                 {"x y z intensity", "x y z intensity", Format::pts}}) {
      CAPTURE(table.header);
      const std::string at = table.header == table.found || table.header.starts_with("x,") ? "t.txt:1"
                             : table.header.starts_with("sep")                             ? "t.txt:2"
                                                                                           : "t.txt:3";
      const std::string expected = at + ": found '" + table.found + "' and no line after it" +
                                   (table.header.ends_with("comment") ? " but comments" : "") +
                                   ", expected lines of points after a header";
      CHECK(refusal([&] { plane(table.header + "\n", {.format = table.format}); }) == expected);
      CHECK(refusal([&] { plane(table.header, {.format = table.format}); }) == expected);
      CHECK(refusal([&] { space(table.header + "\n", {}, table.format); }) == expected);
      CHECK(refusal([&] { plane(table.header + "\n", {.format = table.format, .skip_invalid = true}); }) == expected);
    }
    CHECK(plane("x y z intensity\n0\n", {.format = Format::pts}).points.empty());
    CHECK(refusal([&] { plane(line + "\n"); }) ==
          "t.txt: found JSON, expected a table (--format geojson reads GeoJSON)");
    CHECK(refusal([&] { plane("geometry\n"); }).starts_with("t.txt:1: found 'geometry' and no line after it"));
    CHECK(
        refusal([] { plane("# x y\n// 3 4\n"); }) ==
        "t.txt: found 2 comments and no point, expected points (quotes around the first field of a line make it one)");
    const Folder folder("j.xy", line + "\n");
    CHECK(folder.rbpa("info - --format xy < j.xy").code == 3);
  }

  TEST_CASE("a column of geometries has any name, or none") {
    for (const std::string header : {"", "device,position,time\n"}) {
      const std::string text =
          header + "DT0.Position,POINT (0 0),2019-07-30 18:00:50\na,POINT (1 0),b\nc,\"POINT (0 1)\",d\n";
      CHECK(plane(text).points == points);
      CHECK(plane(text, {.columns = parse_columns("2")}).points == points);
    }
    const std::string text = "a,b,p\n7,8,POINT (0 0)\n7,8,POINT (1 0)\n7,8,POINT (0 1)\n";
    CHECK(plane(text, {.columns = parse_columns("p")}).points == points);
    CHECK(plane(text, {.columns = parse_columns("a,b")}).points == Points{{7, 8}, {7, 8}, {7, 8}});
    CHECK(plane("lon,lat,p\n0,0,POINT (9 9)\n1,0,POINT (9 9)\n0,1,POINT (9 9)\n").points == points);
    CHECK(refusal([&] { plane(text, {.columns = parse_columns("a")}); }) ==
          "t.txt:2: found '7', expected a geometry, such as 'POINT (1 2)' (--columns X,Y takes two columns)");
  }

  TEST_CASE("files of atoms have a count, a comment, and lines of element and x y z") {
    const std::vector<std::string> elements = {"C", "Cl", "6", "C1", "Fe+3"};
    for (const std::string& element : elements)
      for (const std::string comment : {"", "comment here", "1 2 3", "# none", "0 1",
                                        "Lattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3 pbc=\"F F F\""})
        for (const std::string more : {"", " 0.5", " 1 2 3"}) {
          std::string text = "3\n" + comment + "\n";
          for (const Point3& p : places)
            text += element + "  " + std::to_string(p.x) + "\t" + std::to_string(p.y) + " " + std::to_string(p.z) +
                    more + "\n";
          CAPTURE(text);
          CHECK(space(text, {}, Format::text, "m.xyz").points == places);
          CHECK(plane(text, {}, "m.xyz").points == points);
          CHECK(plane(text, {}, "m.xyz").heights.differ());
          if (element != "6") CHECK(space(text, where("element == '" + element + "'")).points == places);
        }
    const std::string moved = "Properties=id:I:1:pos:R:3:species:S:1:force:R:3\n";
    CHECK(
        space("2\n" + moved + "1 0 0 1 C 7 8 9\n2 1 0 2 N 7 8 9\n", where("element == 'N' and force_2 == 8")).points ==
        Places{{1, 0, 2}});
    CHECK(refusal([] { space("3\n\nC 0 0 1\nC 1 0 2\n"); }) ==
          "t.txt: found 2 lines of points, expected 3 as line 1 says (--skip-invalid reads what is there)");
    CHECK(refusal([] { space("1\n\nC 0 0 1\nC 1 0 2\n"); }) ==
          "t.txt:4: found 'C 1 0 2' after the last atom, expected the end of the file or the next frame, as line 1 "
          "counts 1 atom (--skip-invalid leaves out the rest)");
    const SpacePoints frames = space("1\nfirst\nC 0 0 1\n1\nsecond\nC 1 0 2\n");
    CHECK(frames.points == Places{{0, 0, 1}});
    CHECK(frames.warnings ==
          std::vector<std::string>{
              "the atoms are the 1 that line 1 counts, of the first frame; what follows them is left out"});
    // A count before x, y, z and an intensity is not a number of atoms.
    CHECK(plane("2\n10.5 0 1 5\n1 0 2 5\n", {}, "m.xyz").points == Points{{10.5, 0}, {1, 0}});
    // Without a sign that these are atoms, numbers of elements are not coordinates.
    const std::string bare = "6 0.5 0 1\n7 1 0 2\n8 0 1.5 3\n";
    CHECK(contains(refusal([&] { plane(bare, {}, "m.xyz"); }), "--columns 2,3 reads atoms"));
    CHECK(contains(refusal([&] { space(bare, {}, Format::text, "m.xyz"); }), "--columns 2,3,4 reads atoms"));
    CHECK(plane(bare, {}, "m.csv").points.size() == 3);
    CHECK(plane(bare, {.columns = parse_columns("2,3")}, "m.xyz").points[0] == Point{0.5, 0});
  }

  TEST_CASE("files read by pieces begin as files in memory do") {
    const Folder folder;
    std::string many;
    for (int i = 0; i < 200000; ++i) many += "C " + std::to_string(i) + " 1 2\n";
    std::string table = "//X Y Z name\n200000\n";
    for (int i = 0; i < 200000; ++i) table += std::to_string(i) + " 1 2 C\n";
    for (const std::string& path : {folder.file("m.xyz", "200000\n\n" + many), folder.file("t.txt", table)}) {
      const PointFile whole = read_points({.path = path});
      const auto blocks = open_point_blocks({.path = path});
      Points all, block;
      while (blocks->next(block)) all.insert(all.end(), block.begin(), block.end());
      CHECK(all == whole.points);
      CHECK(all.size() == 200000);
      CHECK(blocks->about().warnings == whole.warnings);
    }
  }
}
