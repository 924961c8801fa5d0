// Points in space from files: each format against the same points in another, and byte by byte.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/las_fields.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/las_file.h"
#include "support/mesh_files.h"
#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;
using namespace rbpa::app;
using rbpa::Point3;
using Places = std::vector<Point3>;
using Colors = std::vector<std::array<std::uint8_t, 3>>;

namespace {

SpacePoints read(const std::string& bytes, Format format, const std::string& columns = "") {
  CloudRequest choice;
  if (!columns.empty()) choice.columns = parse_space_columns(columns);
  return space_points_in(bytes, "p", format, choice);
}

SpacePoints table(const std::string& text, const std::string& columns = "") {
  return read(text, Format::text, columns);
}

const Places points = {{0.5, -1, 2}, {3, 4e-3, 1e6}};
const Places normals = {{0, 0, 2}, {-1, 0.25, 0}};
const Colors colors = {{1, 2, 255}, {128, 0, 7}};

void is(const SpacePoints& file, const Places& with_normals = {}, const Colors& with_colors = {}) {
  CHECK(file.points == points);
  CHECK(file.normals == with_normals);
  CHECK(file.colors == with_colors);
}

template <typename T>
std::string raw(T value, std::endian order = std::endian::little) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string ply_head(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment of two\nelement tag 1\nproperty short t\nelement vertex 2\nproperty double y\nproperty float "
         "nx\n"
         "property double x\nproperty uchar red\nproperty double ny\nproperty uchar green\nproperty uchar blue\n"
         "property double z\nproperty short q\nproperty double nz\nend_header\n";
}

std::string ply_binary_of(std::endian order) {
  std::string bytes = ply_head(order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
  bytes += raw(std::int16_t{9}, order);
  for (std::size_t i = 0; i < 2; ++i) {
    const Point3 p = points[i], n = normals[i];
    const auto c = colors[i];
    bytes += raw(p.y, order) + raw(static_cast<float>(n.x), order) + raw(p.x, order) + raw(c[0]) + raw(n.y, order) +
             raw(c[1]) + raw(c[2]) + raw(p.z, order) + raw(std::int16_t{-1}, order) + raw(n.z, order);
  }
  return bytes;
}

std::string npy(const std::string& description, const std::string& data) {
  return npy_file("{" + description + "}", data);
}

std::string pcd_head(const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb _ normal_x normal_y normal_z\n"
         "SIZE 8 8 8 4 1 4 4 8\nTYPE F F F U U F F F\nCOUNT 1 1 1 1 3 1 1 1\nWIDTH 2\nHEIGHT 1\n"
         "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " +
         data + "\n";
}

std::uint32_t compressed(const std::array<std::uint8_t, 3>& c) {
  return 0xff000000U | static_cast<std::uint32_t>(c[0]) << 16U | static_cast<std::uint32_t>(c[1]) << 8U | c[2];
}

std::string pcd_binary() {
  std::string bytes = pcd_head("binary");
  for (std::size_t i = 0; i < 2; ++i) {
    const Point3 p = points[i], n = normals[i];
    bytes += raw(p.x) + raw(p.y) + raw(p.z) + raw(compressed(colors[i])) + "abc" + raw(static_cast<float>(n.x)) +
             raw(static_cast<float>(n.y)) + raw(n.z);
  }
  return bytes;
}

}  // namespace

TEST_SUITE("points of space") {
  TEST_CASE("a name and an ending give a format") {
    CHECK(find_format(Use::space, "XYZ") == Format::text);
    CHECK(find_format(Use::space, "csv") == Format::text);
    CHECK(find_format(Use::space, "pcd") == Format::pcd);
    CHECK_FALSE(find_format(Use::space, "stl").has_value());
    CHECK(endings(Use::mesh) == "off, ply, obj, stl");
    CHECK(endings(Use::voids) == "obj, json, csv");
    CHECK(is_for(Use::full, Format::npy));
    CHECK_FALSE(is_for(Use::full, Format::off));
    CHECK(!contains(with_fields(Use::points), "pcd"));  // verbs of the plane do not read it
    CHECK(contains(with_fields(Use::space), "pcd, pdb, ply, pqr or text"));
  }

  TEST_CASE("tables have 3 or 6 columns, with every separator, comments, quotes and a header") {
    is(table("0.5 -1 2\n3 4e-3 1e6\n"));
    is(table("\xEF\xBB\xBF# said\n\n 0.5   -1  2 # first\r\n3 +.004 1e6"));
    is(table("0.5,-1,2\n\"3\", 4e-3 ,1e6\n"));
    is(table("sep=;\n0.5;-1;2\n3;4e-3;1e6\n"));
    is(table("0.5 -1 2 0 0 2\n3 4e-3 1e6 -1 .25 0\n"), normals);
    is(table("a,b,c\n0.5,-1,2\n3,4e-3,1e6\n"));
    is(table("x y z nx ny nz\n0.5 -1 2 0 0 2\n3 4e-3 1e6 -1 .25 0\n"), normals);
  }

  TEST_CASE("a header names coordinates and normals, in any order") {
    const SpacePoints file =
        table("id,Normal_Z,Y,red,Z,X,normal_x,normal_y\n7,2,-1,NA,2,0.5,0,0\n8,0,4e-3,text,1e6,3,-1,0.25\n");
    is(file, normals);
    REQUIRE(file.warnings.size() == 1);
    CHECK(file.warnings[0] ==
          "the columns 'X', 'Y', 'Z', 'normal_x', 'normal_y', 'Normal_Z' are read, as the header says (--columns "
          "chooses others)");
    is(table("x,y,z,a,b,c\n0.5,-1,2,0,0,0\n3,4e-3,1e6,1,2,3\n"));  // six, and no normals
    is(table("easting,northing,height\n0.5,-1,2\n3,4e-3,1e6\n"));
  }

  TEST_CASE("--columns chooses by number or name") {
    is(table("9 2 -1 0.5\n9 1e6 4e-3 3\n", "4,3,2"));
    is(table("h,b,a,n\n2,-1,0.5,9\n1e6,4e-3,3,9\n", "a,B, h"));
    is(table("h,2005,2006\n0.5,-1,2\n3,4e-3,1e6\n", "h,2,3"));  // the first line is a header, as one is named
    is(table("0.5 -1 2 2 0 0\n3 4e-3 1e6 0 .25 -1\n", "1,2,3,6,5,4"), {{0, 0, 2}, {-1, .25, 0}});
  }

  TEST_CASE("a header names colors, in any order, with normals or without") {
    for (const std::string names : {"r,g,b", "red,green,blue", "R,G,B", "Red,Green,Blue"}) {
      CAPTURE(names);
      is(table("x,y,z," + names + "\n0.5,-1,2,1,2,255\n3,4e-3,1e6,128,0,7\n"), {}, colors);
      is(table("x,y,z,nx,ny,nz," + names + "\n0.5,-1,2,0,0,2,1,2,255\n3,4e-3,1e6,-1,.25,0,128,0,7\n"), normals, colors);
      is(table("x,y,z," + names + "\n0.5,-1,2,1,2,255\n3,4e-3,1e6,128,0,7\n", "x,y,z"), {}, colors);
    }
    is(table("blue z green n y red x\n255 2 2 q -1 1 0.5\n7 1e6 0 q 4e-3 128 3\n"), {}, colors);
    // Colors of 16 bits, and from 0 to 1.
    is(table("x,y,z,r,g,b\n0.5,-1,2,256,767,65535\n3,4e-3,1e6,32768,255,1792\n"), {}, colors);
    CHECK(table("x,y,z,r,g,b\n0,0,0,1,0.5,0\n").colors == Colors{{255, 128, 0}});
    // Colors in another form, or incomplete.
    CHECK(table("x,y,z,r,g,b\n1,1,1,1,2,3\n", "x,y,z,r,g,b").normals == Places{{1, 2, 3}});
    CHECK(table("x,y,z,r,g\n1,1,1,1,2\n").colors.empty());
    const SpacePoints partly = table("x,y,z,r,g,b\n1,1,1,1,2,3\n1,2,3,NA,3,4\n");
    CHECK(partly.colors.empty());
    CHECK(partly.points.size() == 2);
    CHECK(partly.warnings == std::vector<std::string>{"colors are left out, as line 3 has none"});
  }

  TEST_CASE("six unnamed columns have colors if the last three are whole numbers, else normals, with a warning") {
    const std::string as_colors =
        "columns 4 to 6 are read as colors, as they are whole numbers (--columns 1,2,3,4,5,6 reads normals)";
    const std::string as_normals = "columns 4 to 6 are read as normals (a header 'x y z r g b' makes them colors)";
    const SpacePoints with_colors = table("0.5 -1 2 1 2 255\n3 4e-3 1e6 128 0 7\n");
    is(with_colors, {}, colors);
    CHECK(with_colors.warnings == std::vector<std::string>{as_colors});
    is(table("0.5 -1 2 256 767 65535\n3 4e-3 1e6 32768 255 1792\n"), {}, colors);
    CHECK(table("1 2 3 0 0 0\n1 2 4 0 2 0\n").colors == Colors{{0, 0, 0}, {0, 2, 0}});
    const SpacePoints with_normals = table("0.5 -1 2 0 0 2\n3 4e-3 1e6 -1 .25 0\n");
    is(with_normals, normals);
    CHECK(with_normals.warnings == std::vector<std::string>{as_normals});
    // The last line decides as the first does: a fraction, a number below 0, one too great, none above 1.
    for (const std::string last : {"1 0.5 0", "-1 0 0", "65536 0 0", "1 0 1"}) {
      CAPTURE(last);
      const std::string before = last == "1 0 1" ? "1 2 3 1 0 0\n" : "1 2 3 7 8 9\n";
      const SpacePoints file = table(before + "4 5 6 " + last + "\n");
      CHECK(file.colors.empty());
      CHECK(file.normals.size() == 2);
      CHECK(file.warnings == std::vector<std::string>{as_normals});
    }
    // A normal without a direction is refused wherever normals are recognized, or left out.
    const std::string zero = "1 2 3 0 0 0\n1 2 4 0.5 2 0\n";
    CHECK_THROWS_WITH_AS(table(zero), doctest::Contains("p:1: found a normal of length 0"), BadInput);
    CloudRequest choice{.skip_invalid = true};
    const SpacePoints rest = space_points_in(zero, "p", Format::text, choice);
    CHECK(rest.points == Places{{1, 2, 4}});
    CHECK(rest.normals == Places{{0.5, 2, 0}});
    CHECK(rest.warnings.size() == 2);
    CHECK(table("0 0 1 0 0 2\n", "1,2,3,4,5,6").warnings.empty());
  }

  TEST_CASE("longitudes, latitudes and heights are points in space, with a warning") {
    const SpacePoints file = table("height,lat,lon\n100,60,5\n110,60,6\n");
    CHECK(file.points == Places{{5, 60, 100}, {6, 60, 110}});
    REQUIRE(file.warnings.size() == 2);
    CHECK(file.warnings[1] ==
          "x and y are degrees and z is not, which distorts balls; a degree of longitude is as long as 0.50 degrees of "
          "latitude there; project them first, to UTM zone 31N (EPSG:32631), for example");
    CHECK(table("x,y,z\n5,60,100\n").warnings.empty());
    LasFile las{.scale = {1, 1, 1}, .points = {{.x = 5, .y = 60, .z = 100}}};
    las.records = {{"LASF_Projection", 34735,
                    little(1, 2) + little(1, 2) + little(0, 2) + little(2, 2) + little(1024, 2) + little(0, 2) +
                        little(1, 2) + little(2, 2) + little(2048, 2) + little(0, 2) + little(1, 2) + little(4326, 2)}};
    const SpacePoints of_las = read(bytes_of(las), Format::las);
    REQUIRE(of_las.warnings.size() == 1);
    CHECK(of_las.warnings[0].starts_with("x and y are degrees"));
  }

  TEST_CASE("a decimal comma is read") {
    const SpacePoints file = table("0,5;-1;2\n3;0,004;1e6\n");
    is(file);
    CHECK(file.warnings == std::vector<std::string>{"the decimal sign is a comma: 0,5 is read as 0.5"});
    is(table("0,5 -1 2\n3 0,004 1e6\n"));
  }

  TEST_CASE("PLY of every kind is read, with properties in any order, and lists and other elements between") {
    std::string text = ply_head("ascii") + "9\n-1 0 0.5 1 0 2 255 2 5 2\n4e-3 -1 3 128 0.25 0 7 1e6 5 0\n";
    is(read(text, Format::ply), normals, colors);
    is(read(ply_binary_of(std::endian::little), Format::ply), normals, colors);
    is(read(ply_binary_of(std::endian::big), Format::ply), normals, colors);
    for (const std::string& bytes : {pyramid_ply, ply_binary(std::endian::little), ply_binary(std::endian::big)}) {
      const SpacePoints file = read(bytes, Format::ply);
      REQUIRE(file.points.size() == pyramid_positions.size());
      for (std::size_t i = 0; i < file.points.size(); ++i)
        CHECK(file.points[i] == Point3{pyramid_positions[i][0], pyramid_positions[i][1], pyramid_positions[i][2]});
    }
  }

  TEST_CASE("incomplete normals and colors of PLY are left out, with a warning") {
    const SpacePoints file = read(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty float "
        "nx\n"
        "property float ny\nproperty float red\nproperty float green\nproperty float blue\nend_header\n"
        "0.5 -1 2 0 0 1 1 1\n3 4e-3 1e6 0 0 1 1 1\n",
        Format::ply);
    is(file);
    CHECK(file.warnings ==
          std::vector<std::string>{"normals are left out, as not all of nx, ny and nz are there",
                                   "colors are left out, as red, green and blue are not three of type uchar"});
  }

  TEST_CASE("OFF has normals with the prefix N and colors with the prefix C, and nothing else") {
    is(read("OFF\n2 1 0\n0.5 -1 2 9 9 9\n3 4e-3 1e6\n3 0 1 0\n", Format::off));
    is(read("NOFF\n2 0 0\n0.5 -1 2 0 0 2\n3 4e-3 1e6 -1 .25 0\n", Format::off), normals);
    is(read("STCNOFF 2 0 0\n0.5 -1 2 0 0 2 1 2 255 1 0 0\n3 4e-3 1e6 -1 .25 0 128 0 7 1 0 1\n", Format::off), normals,
       colors);
    is(read("COFF\n2 0 0\n0.5 -1 2 1 2 255 # red\n3 4e-3 1e6 128 0 7 255\n", Format::off), {}, colors);
    is(read("COFF\n2 0 0\n0.5 -1 2 1 1 1 1\n3 4e-3 1e6 0 0.5 1 1\n", Format::off), {},
       {{255, 255, 255}, {0, 128, 255}});
  }

  TEST_CASE("OBJ has colors after its vertices, from 0 to 1, or to 255 if one is greater than 1") {
    const auto with = [](const std::string& first, const std::string& second) {
      return read("v 0.5 -1 2 " + first + "\nvn 0 0 2\nv 3 4e-3 \\\n1e6 " + second + "\nvn -1 .25 0\n", Format::obj);
    };
    is(with("1 2 255", "128 0 7 # said"), normals, colors);
    is(with(".0039 0.0078431 1 1", "0.50196 0 0.027451"), normals, colors);
    is(with("1 1 1", "0 1 0"), normals, {{255, 255, 255}, {0, 255, 0}});
    CHECK(with("1 2 255", "128 0 7").warnings.empty());
    // A fourth number is a weight.
    is(with("1", "1"), normals);
    CHECK(with("", "1").warnings.empty());
  }

  TEST_CASE("incomplete or wrong colors of text are left out, with a warning") {
    const auto says = [](const std::string& text, Format format, const std::string& why) {
      const SpacePoints file = read(text, format);
      is(file);
      CHECK(file.warnings == std::vector<std::string>{"colors are left out, as " + why});
    };
    const std::string first = "v 0.5 -1 2", second = "\nv 3 4e-3 1e6";
    says(first + " 1 1 1" + second + " 1\n", Format::obj, "line 2 has none");
    CHECK_THROWS_WITH_AS(
        read(first + " 1 1 x" + second + " 1 1 1\n", Format::obj),
        "p:1: found 'x' after a vertex, expected at most 5 numbers after z, a weight and a color (one vertex a line)",
        BadInput);
    says(first + " 0 0 0" + second + " 1 256 1\n", Format::obj,
         "line 2 has a channel of '256', and not from 0 to 1 or to 255");
    says(first + " 0 0 -0.1" + second + " 1 1 1\n", Format::obj,
         "line 1 has a channel of '-0.1', and not from 0 to 1 or to 255");
    says("COFF\n2 0 0\n0.5 -1 2\n3 4e-3 1e6\n", Format::off, "line 3 has none");
    CHECK(read("COFF\n0 0 0\n", Format::off).warnings.empty());
  }

  TEST_CASE("normals of OBJ are those that faces give, else those in order") {
    const std::string v = "v 0.5 -1 2\nv 3 4e-3 \\\n1e6\n", n = "vn 0 0 2\nvn -1 .25 0\n";
    is(read(v, Format::obj));
    is(read(v + n, Format::obj), normals);
    is(read(v + n + "f 1 2 1\n", Format::obj), normals);  // the face names no normal
    is(read(v + "vn -1 .25 0\nvn 0 0 2\nf 1//2 2//1 1//2\n", Format::obj), normals);
    is(read("f 1/7/2 2//1\n" + v + "vn -1 .25 0\nvn 0 0 2\nf -2//-1 2/1 1\n", Format::obj), normals);
    is(read(v + "vn 9 9 9\n" + n + "f 1//-2 2//-1 1//-2\n", Format::obj), normals);
    is(read(v + "vn 0 0 2\nvn 0 0 2\nvn -1 .25 0\nf 1//1 2//3 1//2\n", Format::obj), normals);  // equal ones
  }

  TEST_CASE("OBJ without one normal for each vertex has none, with a warning") {
    const std::string v = "v 0.5 -1 2\nv 3 4e-3 1e6\n", n = "vn 0 0 2\nvn -1 .25 0\n";
    const auto says = [&](const std::string& text, const std::string& why) {
      const SpacePoints file = read(v + text, Format::obj);
      is(file);
      CHECK(file.warnings == std::vector<std::string>{"normals are left out: " + why});
    };
    says("vn 0 0 1\n", "1 normal for 2 vertices, and no face says which belongs to which");
    says(n + n, "4 normals for 2 vertices, and no face says which belongs to which");
    says(n + "f 1//1 2//2 1//2\n", "vertex 1 has different normals in the faces around it, line 5");
    says(n + "f 1//1 2 1//1\n", "no face gives a normal to vertex 2");
  }

  TEST_CASE("PCD is read as text and binary, with other fields between") {
    const auto text = [](const std::string& first, const std::string& second) {
      return pcd_head("ascii") + "0.5 -1 2 " + first + " 1 2 3 0 0 2\n3 4e-3 1e6 " + second + " 1 2 3 -1 .25 0\n";
    };
    is(read(text(std::to_string(compressed(colors[0])), std::to_string(compressed(colors[1]))), Format::pcd), normals,
       colors);
    is(read(pcd_binary(), Format::pcd), normals, colors);
    is(read("VERSION .5\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 2\nDATA ascii\n0.5 -1 2\n3 4e-3 1e6\n",
            Format::pcd));
  }

  TEST_CASE("a color of PCD may be in the bits of a float") {
    const float bits = std::bit_cast<float>(compressed(colors[0]) & 0xffffffU);
    const SpacePoints file = read(
        "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
        "DATA binary\n" +
            raw(1.0F) + raw(2.0F) + raw(3.0F) + raw(bits),
        Format::pcd);
    CHECK(file.colors == Colors{colors[0]});
    const SpacePoints text = read(
        "FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n"
        "1 2 3 4.2108e+06\n",
        Format::pcd);
    CHECK(text.colors == Colors{{0x80, 0x80, 0xe0}});  // the float 4.2108e6 is 4a8080e0
  }

  TEST_CASE("arrays of NumPy have 3 or 6 columns, rows or columns first") {
    std::string rows, columns;
    for (std::size_t i = 0; i < 2; ++i)
      for (const Point3& p : {points[i], normals[i]}) rows += raw(p.x) + raw(p.y) + raw(p.z);
    for (const Places& places : {points, normals})
      for (const auto axis : {&Point3::x, &Point3::y, &Point3::z})
        for (const Point3& p : places) columns += raw(p.*axis);
    const std::string f8 = "'descr': '<f8', 'shape': ";
    is(read(npy(f8 + "(2, 6), 'fortran_order': False", rows), Format::npy), normals);
    is(read(npy(f8 + "(2, 6), 'fortran_order': True", columns), Format::npy), normals);
    std::string shorts;
    for (const int value : {1, -2, 3}) shorts += raw(static_cast<std::int16_t>(value), std::endian::big);
    CHECK(read(npy("'descr': '>i2', 'shape': (1, 3), 'fortran_order': False", shorts), Format::npy).points ==
          Places{{1, -2, 3}});
  }

  TEST_CASE("LAS of all versions has x, y and z by its scales, of the points that --where takes") {
    for (unsigned minor = 0; minor <= 4; ++minor) {
      LasFile file{.minor = minor};
      file.scale[2] = 0.5;
      file.offset[2] = 100;
      file.points = {{.x = 150, .y = -7, .z = 3}, {.x = 1, .y = 2, .z = -400, .classification = 2}};
      CHECK(read(bytes_of(file), Format::las).points == Places{{1.5, -0.07, 101.5}, {0.01, 0.02, -100}});
      CloudRequest choice;
      choice.where = Condition("classification == 2", names_of_las_fields());
      const SpacePoints some = space_points_in(bytes_of(file), "p", Format::las, choice);
      CHECK(some.points == Places{{0.01, 0.02, -100}});
      CHECK(some.warnings == std::vector<std::string>{"--where selects 1 of 2 points"});
    }
  }

  TEST_CASE("LAS has the colors of every format with any, of 16 or 8 bits; all black is none") {
    for (unsigned format = 0; format <= 10; ++format) {
      CAPTURE(format);
      LasFile file{.minor = 4, .format = format};
      file.points = {{.red = 0x0123, .green = 0x02ff, .blue = 0xffff},
                     {.classification = 1, .red = 9, .green = 9, .blue = 9},
                     {.red = 0x8000, .green = 0, .blue = 0x0700}};
      const bool has = format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10;
      CloudRequest choice;
      choice.where = Condition("classification == 0", names_of_las_fields());
      CHECK(space_points_in(bytes_of(file), "p", Format::las, choice).colors == (has ? colors : Colors{}));
      file.points = {{.red = 1, .green = 2, .blue = 255}, {.red = 128, .blue = 7}};
      CHECK(read(bytes_of(file), Format::las).colors == (has ? colors : Colors{}));
      file.points = {{}, {}};
      CHECK(read(bytes_of(file), Format::las).colors.empty());
    }
  }

  TEST_CASE("lines that are not points are left out and counted with --skip-invalid") {
    const auto skipping = [](const std::string& text) {
      return space_points_in(text, "p", Format::text, {.skip_invalid = true});
    };
    const SpacePoints bare = skipping("x,y,z\nNA,NA,NA\n0.5,-1,2\n1,2\n3,4,1e999\n3,4e-3,1e6\n,,\n1,2,3,4\n");
    is(bare);
    CHECK(bare.warnings ==
          std::vector<std::string>{"4 lines are left out: the first is p:2: found 'NA', expected a number"});
    // A point without its normal is left out.
    const SpacePoints file = skipping("0.5 -1 2 0 0 2\n7 7 7 0 -0 0\n7 7 7 0 0 nan\n3 4e-3 1e6 -1 .25 0\n");
    is(file, normals);
    CHECK(file.warnings ==
          std::vector<std::string>{
              "columns 4 to 6 are read as normals (a header 'x y z r g b' makes them colors)",
              "2 lines are left out: the first is p:2: found a normal of length 0, expected one of another length"});
    CHECK(skipping("1 2 3\n").warnings.empty());
    CHECK_THROWS_WITH_AS(
        skipping("x,y,z\n1,2,NA\n"),
        "p: found 1 line and no point, expected at least one point (p:2: found 'NA', expected a number)", BadInput);
  }

  TEST_CASE("--where takes lines of a table by columns that its header names") {
    const auto where = [](const std::string& text, const std::string& condition, bool skip = false) {
      CloudRequest choice{.skip_invalid = skip};
      choice.where = Condition(condition, names_of_columns());
      return space_points_in(text, "p", Format::text, choice);
    };
    const std::string text = "x;y;z;class\n9;9;9;2\n0,5;-1;2;6\nNA;9;9;5\n3;0,004;1e6;6\n";
    const SpacePoints file = where(text, "class == 6");
    is(file);
    CHECK(file.warnings.back() == "--where selects 2 of 4 lines");
    is(where("z,nx,ny,nz,y,x\n2,0,0,2,-1,0.5\n9,1,1,1,9,9\n1e6,-1,.25,0,4e-3,3\n", "x < 9"), normals);
    CHECK(where(text, "class == 7").points.empty());
    const SpacePoints both = where("x,y,z,n\n0.5,-1,2,1\n9,NA,9,1\n9,9,9,NA\n9,9,9,0\n3,4e-3,1e6,1\n", "n == 1", true);
    is(both);
    CHECK(both.warnings.size() == 2);
    CHECK(both.warnings[0] == "--where selects 3 of 4 lines");  // the point of one of them is none
    CHECK(both.warnings[1] == "2 lines are left out: the first is p:3: found 'NA', expected a number");
    CHECK_THROWS_WITH_AS(where("1 2 3\n", "n == 1"),
                         "p: found no header line, expected one with the names that --where requires", BadInput);
    CHECK_THROWS_WITH_AS(where("x,y,z\n1,2,3\n", "n == 1"), "p:1: found 'x,y,z', expected a header with a column 'n'",
                         BadInput);
    CHECK_THROWS_WITH_AS(where("x,y,z,n\n1,2,3,NA\n", "n == 1"),
                         "p:2: found 'NA', expected a number, as --where compares the column with numbers (== \"...\" "
                         "compares it with a text)",
                         BadInput);
  }

  TEST_CASE("--where takes vertices of PLY by their properties, and points of PCD by their fields") {
    const auto where = [](const std::string& condition) {
      return CloudRequest{.where = Condition(condition, names_of_properties())};
    };
    const std::string head =
        "element vertex 3\nproperty double x\nproperty double y\nproperty double z\nproperty short class\nend_header\n";
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + head;
    for (const auto& [z, kind] : {std::pair(2.0, 2), {__builtin_nan(""), 3}, {7.0, 2}})
      for (const std::string& bytes : {std::string(16, '\0'), std::string(reinterpret_cast<const char*>(&z), 8),
                                       std::string(1, static_cast<char>(kind)), std::string(1, '\0')})
        binary += bytes;
    const Places selected{{0, 0, 2}, {0, 0, 7}};
    const SpacePoints of_binary = space_points_in(binary, "p", Format::ply, where("class == 2"));
    CHECK(of_binary.points == selected);
    CHECK(of_binary.warnings == std::vector<std::string>{"--where selects 2 of 3 points"});
    const std::string text = "ply\nformat ascii 1.0\n" + head + "0 0 2 2\n0 0 3 3\n0 0 7 2\n";
    CHECK(space_points_in(text, "p", Format::ply, where("class < 3 and x == 0")).points == selected);
    CHECK(points_in(text, "p", {.format = Format::ply, .where = where("not class == 3").where}).points ==
          std::vector<rbpa::Point>{{0, 0}, {0, 0}});
    CHECK_THROWS_WITH_AS(space_points_in(text, "p", Format::ply, where("kind == 1")),
                         "p: found no field 'kind' of numbers, expected one, as --where requires", BadInput);
    const std::string pcd =
        "FIELDS x y z class\nSIZE 4 4 4 1\nTYPE F F F U\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ascii\n"
        "0 0 2 2\n0 0 3 3\n0 0 7 2\n";
    CHECK(space_points_in(pcd, "p", Format::pcd, where("class == 2")).points == selected);
    CHECK(space_points_in(pcd, "p", Format::pcd, where("class == 9")).points.empty());
    CHECK_THROWS_WITH_AS(space_points_in(pcd, "p", Format::pcd, where("kind == 1")),
                         "p: found no field 'kind' of numbers, expected one, as --where requires", BadInput);
  }

  TEST_CASE("a selected point has an index below no_index") {
    CloudBlock block;
    block.index = {7, 4294967294};
    std::vector<std::uint32_t> index;
    append_index(block, index);
    CHECK(index == std::vector<std::uint32_t>{7, 4294967294});
    for (const std::uint64_t beyond : std::vector<std::uint64_t>{4294967295, 4294967296, 9000000000}) {
      block.index = {beyond};
      CHECK_THROWS_WITH_AS(
          append_index(block, index),
          ("POINTS: found a selected point that is number " + std::to_string(beyond) +
           " of the file, from 0, expected fewer than 2^32 - 1 points before it (rbpa stream reads more)")
              .c_str(),
          BadInput);
    }
  }

  TEST_CASE("a path is read, compressed or not") {
    const Folder folder;
    is(read_space_points(folder.file("p.xyz", "0.5 -1 2\n3 4e-3 1e6\n"), Format::text));
    REQUIRE(folder.run("gzip", "p.xyz").code == 0);
    is(read_space_points(folder.path("p.xyz.gz"), Format::text));
  }
}
