// Tables of points in space whose columns are known without a header: by the ending, or by a comment.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using namespace rbpa::app;
using rbpa::Point3;
using Places = std::vector<Point3>;
using Colors = std::vector<std::array<std::uint8_t, 3>>;
using Warnings = std::vector<std::string>;

namespace {

SpacePoints read(const std::string& bytes, Format format, CloudRequest request = {}) {
  return space_points_in(bytes, "p", format, request);
}

std::string refusal(const std::string& bytes, Format format, const CloudRequest& request = {}) {
  return rbpa_test::refusal_of<BadInput>([&] { read(bytes, format, request); });
}

const Places points = {{0.5, -1, 2}, {3, 4e-3, 1e6}};
const Colors colors = {{1, 2, 255}, {128, 0, 7}};

void is(const SpacePoints& file, const Places& normals = {}, const Colors& with_colors = {},
        const Warnings& warnings = {}) {
  CHECK(file.points == points);
  CHECK(file.normals == normals);
  CHECK(file.colors == with_colors);
  CHECK(file.warnings == warnings);
}

}  // namespace

TEST_SUITE("tables of space") {
  TEST_CASE("pts may have the number of points first, and intensities and colors after x, y, z") {
    for (const std::string count : {"", "2\n", "# said\n 2 \r\n\n"}) {
      CAPTURE(count);
      is(read(count + "0.5 -1 2\n3 4e-3 1e6\n", Format::pts));
      is(read(count + "0.5 -1 2 -2048\n3 4e-3 1e6 2047\n", Format::pts));
      is(read(count + "0.5 -1 2 1 2 255\n3 4e-3 1e6 128 0 7", Format::pts), {}, colors);
      is(read(count + "0.5 -1 2 -7 1 2 255\n3 4e-3 1e6 0.25 128 0 7\n", Format::pts), {}, colors);
      is(read(count + "0.5,-1,2,-7,1,2,255\n3,4e-3,1e6,0.25,128,0,7\n", Format::pts), {}, colors);
    }
    CHECK(read("0\n", Format::pts).points.empty());
    // If a header names columns, these count.
    is(read("2\nx y z nx ny nz\n0.5 -1 2 0 0 1\n3 4e-3 1e6 0 1 0\n", Format::pts), {{0, 0, 1}, {0, 1, 0}});
    is(read("2\n9 0.5 -1 2\n9 3 4e-3 1e6\n", Format::pts, {.columns = parse_space_columns("2,3,4")}));
  }

  TEST_CASE("pts has exactly the points that the first line counts, unless invalid ones are skipped") {
    const std::string one = "0.5 -1 2 1\n", two = one + "3 4e-3 1e6 1\n", way = " (--skip-invalid reads what is there)";
    CHECK(refusal("2\n" + one, Format::pts) == "p: found 1 line of points, expected 2 as line 1 says" + way);
    CHECK(refusal("# a\n\n1\n" + two, Format::pts) == "p: found 2 lines of points, expected 1 as line 3 says" + way);
    CHECK(refusal("3\n", Format::pts) == "p: found 0 lines of points, expected 3 as line 1 says" + way);
    CHECK(refusal("18446744073709551615\n" + one, Format::pts) ==
          "p: found 1 line of points, expected 18446744073709551615 as line 1 says" + way);
    const CloudRequest skip{.skip_invalid = true};
    is(read("3\n" + two, Format::pts, skip), {}, {}, {"there are 2 lines of points, and not 3 as line 1 says"});
    is(read("3\n" + one + "1 x 2 1\n3 4e-3 1e6 1\n", Format::pts, skip), {}, {},
       {"1 line is left out: p:3: found 'x', expected a number"});
    // Points that --where leaves out count as well.
    const CloudRequest bright{.where = Condition("intensity > 3", *fields_of(Format::pts))};
    const SpacePoints file = read("2\n0 0 0 3\n1 1 1 4\n", Format::pts, bright);
    CHECK(file.points == Places{{1, 1, 1}});
    CHECK(file.warnings == Warnings{"--where selects 1 of 2 lines"});
  }

  TEST_CASE("pts cut anywhere within its numbers is refused, or has whole points only") {
    const std::string whole = "3\n0.5 -1 2 7 1 2 255\n3 4 1 7 128 0 7\n5 6 7 8 9 10 11\n";
    for (std::size_t size = 1; size + 3 < whole.size(); ++size) {
      const std::string message = refusal(whole.substr(0, size), Format::pts);
      CAPTURE(size);
      CHECK(message.starts_with("p"));
      CHECK(message != "");
    }
  }

  TEST_CASE("pts with other numbers of columns is refused by its line") {
    const std::string wanted = ", expected 3, 4, 6 or 7: x, y, z, intensity, red, green, blue";
    CHECK(refusal("1\n0 0\n", Format::pts) == "p:2: found 2 columns ('0 0')" + wanted);
    CHECK(refusal("1\n0 0 0 0 0\n", Format::pts) == "p:2: found 5 columns ('0 0 0 0 0')" + wanted);
    CHECK(refusal("1.5\n0 0 0\n", Format::pts) == "p:1: found 1 column ('1.5')" + wanted + skipping_hint);
    CHECK(refusal("1\n2\n0 0 0\n", Format::pts) == "p:2: found 1 column ('2')" + wanted + skipping_hint);
    CHECK(refusal("2\n0 0 0\n1\n0 0 0\n", Format::pts) ==
          "p:3: found 1 column ('1'), expected 3 as in line 2" + skipping_hint);
  }

  TEST_CASE("xyzn has normals, also of whole numbers") {
    is(read("0.5 -1 2 0 0 2\n3 4e-3 1e6 128 0 7\n", Format::xyzn), {{0, 0, 2}, {128, 0, 7}});
    is(read("# x\n0.5,-1,2,0,0,2\n3,4e-3,1e6,-1,0.25,0\n", Format::xyzn), {{0, 0, 2}, {-1, .25, 0}});
    is(read("x y z nx ny nz\n0.5 -1 2 0 0 2\n3 4e-3 1e6 128 0 7\n", Format::xyzn), {{0, 0, 2}, {128, 0, 7}});
    CHECK(refusal("0 0 0\n", Format::xyzn) == "p:1: found 3 columns ('0 0 0'), expected 6: x, y, z, nx, ny, nz");
    CHECK(refusal("0 0 0 0 0 1\n0 0 0 0 0 0\n", Format::xyzn) ==
          "p:2: found a normal of length 0, expected one of another length (--skip-invalid leaves out lines that are "
          "not points)");
    CHECK(refusal("0 0 0 0 0 1\n0 0 0 0 0\n", Format::xyzn) ==
          "p:2: found 5 columns ('0 0 0 0 0'), expected 6 as in line 1" + skipping_hint);
  }

  TEST_CASE("xyzrgb has colors, from 0 to 1 as Open3D writes them, or to 255") {
    is(read("0.5 -1 2 1 2 255\n3 4e-3 1e6 128 0 7\n", Format::xyzrgb), {}, colors);
    is(read("0.5 -1 2 0.003922 0.007843 1.0\n3 4e-3 1e6 0.501961 0 0.027451\n", Format::xyzrgb), {}, colors);
    is(read("0.5 -1 2 0 0 0\n3 4e-3 1e6 1 1 1\n", Format::xyzrgb), {}, {{0, 0, 0}, {255, 255, 255}});
    is(read("0.5 -1 2 0 0 0\n3 4e-3 1e6 -1 1 1\n", Format::xyzrgb), {}, {},
       {"colors are left out, as line 2 has a channel of '-1', and not from 0 to 1 or to 65535"});
    is(read("0.5 -1 2 a b c\n3 4e-3 1e6 d e f\n", Format::xyzrgb), {}, {}, {"colors are left out, as line 1 has none"});
    CHECK(refusal("0 0 0\n", Format::xyzrgb) ==
          "p:1: found 3 columns ('0 0 0'), expected 6: x, y, z, red, green, blue");
  }

  TEST_CASE("in the plane these tables have x and y, with a warning that heights are left out") {
    for (const auto& [format, text] : {std::pair<Format, std::string>{Format::pts, "2\n0.5 -1 2 9\n3 4 5 9\n"},
                                       {Format::xyzn, "0.5 -1 2 0 0 1\n3 4 5 0 0 1\n"},
                                       {Format::xyzrgb, "0.5 -1 2 0 0 1\n3 4 5 0 0 1\n"}}) {
      const PointFile file = points_in(text, "p", {.format = format});
      CHECK(file.points == std::vector<rbpa::Point>{{0.5, -1}, {3, 4}});
      CHECK(file.heights.differ());
    }
    CHECK_THROWS_WITH_AS(points_in("3\n0 0 0\n", "p", {.format = Format::pts}),
                         "p: found 1 line of points, expected 3 as line 1 says (--skip-invalid reads what is there)",
                         BadInput);
  }

  TEST_CASE("a comment right before the numbers that contains x, y and z names all columns") {
    const std::string said = "' names the columns (--columns chooses others)";
    is(read("# x y z r g b\n0.5 -1 2 1 2 255\n3 4e-3 1e6 128 0 7\n", Format::text), {}, colors,
       {"the comment 'x y z r g b" + said});
    is(read("# by "
            "NumPy\n#nx,ny,nz,X,Y,Z,red,green,blue,Intensity\n0,0,1,0.5,-1,2,1,2,255,9\n0,1,0,3,4e-3,1e6,128,0,7,9\n",
            Format::text),
       {{0, 0, 1}, {0, 1, 0}}, colors, {"the comment 'nx,ny,nz,X,Y,Z,red,green,blue,Intensity" + said});
    const CloudRequest bright{.where = Condition("i > 3", *fields_of(Format::text))};
    const SpacePoints selected = read("# x y z i\n0 0 0 3\n1 1 1 4\n", Format::text, bright);
    CHECK(selected.points == Places{{1, 1, 1}});
    // A line with another number of names, farther off, or without x, y and z is a comment.
    is(read("# x y z\n0.5 -1 2 0 0 1\n3 4e-3 1e6 0 1 0\n", Format::text), {{0, 0, 1}, {0, 1, 0}}, {},
       {"columns 4 to 6 are read as normals (a header 'x y z r g b' makes them colors)"});
    is(read("# z y x\n\n0.5 -1 2\n3 4e-3 1e6\n", Format::text));
    is(read("# a b c\n0.5 -1 2\n3 4e-3 1e6\n", Format::text));
    is(read("# z y x\n2 -1 0.5\n1e6 4e-3 3\n", Format::text), {}, {}, {"the comment 'z y x" + said});
    is(read(" # z y x \r\n  2 -1 0.5\n1e6 4e-3 3\n", Format::text), {}, {}, {"the comment 'z y x" + said});
    is(read("# z y x\n0.5 -1 2\n3 4e-3 1e6\n", Format::text, {.columns = parse_space_columns("1,2,3")}));
    is(read("# z y x\nx y z\n0.5 -1 2\n3 4e-3 1e6\n", Format::text));  // a header is nearer
  }

  TEST_CASE("headers of other programs are read") {
    // CloudCompare: a header after two slashes, and names of its own for fractions of colors.
    is(read("//X Y Z R G B Nx Ny Nz\n0.5 -1 2 1 2 255 0 0 1\n3 4e-3 1e6 128 0 7 0 1 0\n", Format::text),
       {{0, 0, 1}, {0, 1, 0}}, colors,
       {"the comment 'X Y Z R G B Nx Ny Nz' names the columns (--columns chooses others)"});
    is(read("//X,Y,Z,Rf,Gf,Bf\n0.5,-1,2,0.003922,0.007843,1\n3,4e-3,1e6,0.501961,0,0.027451\n", Format::text), {},
       colors, {"the comment 'X,Y,Z,Rf,Gf,Bf' names the columns (--columns chooses others)"});
    is(read("x;y;z;intensity;Red;Green;Blue\n0.5;-1;2;9;1;2;255\n3;4e-3;1e6;9;128;0;7\n", Format::text), {}, colors);
    is(read("X,Y,Z,diffuse_red,diffuse_green,diffuse_blue\n0.5,-1,2,1,2,255\n3,4e-3,1e6,128,0,7\n", Format::text), {},
       colors);
    is(read("\"x\",\"y\",\"z\",\"normal_x\",\"normal_y\",\"normal_z\"\n0.5,-1,2,0,0,1\n3,4e-3,1e6,0,1,0\n",
            Format::text),
       {{0, 0, 1}, {0, 1, 0}});
  }

  TEST_CASE("the program reads these tables by their endings, compressed, or from standard input") {
    const Folder folder;
    const std::string four = "0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n";
    folder.file("p.pts", "4\n" + four);
    CHECK(contains(folder.rbpa("surface p.pts --radius 1 --viewpoint 0,0,9 -o a.off").err, "2 triangles"));
    REQUIRE(folder.run("gzip", "-k p.pts").code == 0);
    CHECK(folder.rbpa("surface p.pts.gz --radius 1 --viewpoint 0,0,9 -o b.off -q").code == 0);
    CHECK(folder.content("a.off") == folder.content("b.off"));
    CHECK(folder.rbpa("mesh p.pts --alpha 1 -o m.npy").code == 0);
    folder.file("p.xyzn", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n");
    CHECK(contains(folder.rbpa("surface p.xyzn --radius 1 -o c.off").err, "normals of the file"));
    folder.file("p.xyzrgb", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n");
    CHECK(contains(folder.rbpa("surface p.xyzrgb --radius 1 -o c.ply").err, "normals estimated"));
    CHECK(contains(folder.content("c.ply"), "property uchar red"));
    refuses(folder, "surface p.pts --format xyzn --radius 1 -o c.off", 3,
            "p.pts:1: found 1 column ('4'), expected 6: x, y, z, nx, ny, nz");
  }
}
