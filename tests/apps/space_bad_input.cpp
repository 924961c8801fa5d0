// All kinds of bad files of points in space: the whole message.
#include <doctest/doctest.h>

#include <cstring>
#include <string>

#include "io/cloud/read_space_points.h"
#include "io/failure.h"
#include "support/las_file.h"
#include "support/npy_file.h"
#include "support/program.h"
#include "support/refusal_of.h"

using namespace apps_test;
using namespace rbpa::app;

namespace {

std::string refusal(const std::string& bytes, Format format, const std::string& columns = "") {
  return rbpa_test::refusal_of<BadInput, WrongUsage>([&] {
    CloudRequest choice;
    if (!columns.empty()) choice.columns = parse_space_columns(columns);
    space_points_in(bytes, "p", format, choice);
  });
}

std::string table(const std::string& text, const std::string& columns = "") {
  return refusal(text, Format::text, columns);
}
std::string ply(const std::string& vertices) {
  return refusal(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nend_header\n" +
          vertices,
      Format::ply);
}
std::string off(const std::string& text) { return refusal(text, Format::off); }
std::string obj(const std::string& text) { return refusal(text, Format::obj); }

/// Returns the file with one line of the header replaced.
std::string pcd(const std::string& data, const std::string& line = "", const std::string& replaced = "") {
  std::string text =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n";
  if (!line.empty()) text.replace(text.find(line), line.size(), replaced);
  return refusal(text + data, Format::pcd);
}

std::string npy(const std::string& shape, const std::string& data) {
  return refusal(npy_file("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + "}", data), Format::npy);
}

template <typename T>
std::string numbers(std::initializer_list<T> values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!bytes.empty()) std::memcpy(bytes.data(), std::data(values), bytes.size());
  return bytes;
}

const std::string& skip = skipping_hint;
const double no_number = __builtin_nan(""), inf = __builtin_inf();

}  // namespace

TEST_SUITE("bad points of space") {
  TEST_CASE("a missing file, a folder and an empty file are refused") {
    const Folder folder;
    CHECK_THROWS_WITH_AS(read_space_points(folder.path("none.xyz"), Format::text),
                         (folder.path("none.xyz") + ": found no such file, expected a file of points").c_str(),
                         BadInput);
    CHECK_THROWS_AS(read_space_points(folder.path(""), Format::ply), BadInput);
    for (const Format format : {Format::text, Format::ply, Format::off, Format::obj, Format::pcd, Format::npy,
                                Format::las, Format::pts, Format::xyzn, Format::xyzrgb})
      CHECK(refusal("", format) == "p: found an empty file, expected points");
  }

  TEST_CASE("a file of no known format is refused as any format") {
    const std::string text = "hello, world\n";
    CHECK(table(text) == "p:1: found 'hello, world', expected 3 or 6 numbers");
    CHECK(refusal(text, Format::ply) ==
          "p: found a first line 'hello, world', expected 'ply', the first line of every .ply file");
    CHECK(off(text) == "p:1: found 'hello,', expected OFF, COFF, NOFF or CNOFF");
    CHECK(obj(text) == "p: found no line 'v x y z', expected points");
    CHECK(refusal(text, Format::pcd) ==
          "p:1: found 'hello, world', expected a .pcd file, which begins with VERSION or FIELDS");
    CHECK(refusal("#\n", Format::pcd) ==
          "p: found no line that begins with FIELDS, expected the header of a .pcd file");
    CHECK(refusal(text, Format::npy) == "p: found 'hello,', expected an .npy file, which begins with '\\x93NUMPY'");
    CHECK(refusal(text, Format::las) == "p: found 'hell', expected a LAS file, which begins with 'LASF'");
  }

  TEST_CASE("a wrong number of columns is refused") {
    CHECK(table("0 0\n1 0\n") == "p:1: found 2 columns ('0 0'), expected 3 or 6");
    CHECK(table("0 0 0 1\n") ==
          "p:1: found 4 columns ('0 0 0 1'), expected 3 or 6 (--columns X,Y,Z chooses some of more)");
    CHECK(table("# x\n0 0 0\n1 0\n") == "p:3: found 2 columns ('1 0'), expected 3 as in line 2" + skip);
    CHECK(table("0 0 0\n1 0 0 0\n") == "p:2: found 4 columns ('1 0 0 0'), expected 3 as in line 1" + skip);
    CHECK(table("0,0,0,1,1,1\n1,0,0\n") == "p:2: found 3 columns ('1,0,0'), expected 6 as in line 1" + skip);
    CHECK(table("x,y,z\n1,0\n") == "p:2: found 2 columns ('1,0'), expected 3 as in line 1");
    CHECK(npy("(2, 2)", numbers({0., 0., 0., 0.})) == "p: found shape '(2, 2)', expected (n, 3) or (n, 6)");
    CHECK(npy("(1, 4)", numbers({0., 0., 0., 0.})) == "p: found shape '(1, 4)', expected (n, 3) or (n, 6)");
    CHECK(off("OFF\n2 0 0\n0 0 0\n1 0\n") == "p:4: found '1 0', expected one more number");
    CHECK(off("NOFF\n2 0 0\n0 0 0 0 0 1\n1 0 0\n") == "p:4: found '1 0 0', expected one more number");
    CHECK(obj("v 0 0\n") == "p:1: found 'v 0 0', expected one more number");
    CHECK(ply("0 0 0 0 0 1 1 1 1\n0 0 0 0 0 1 11111111 1\n") ==
          "p:15: found '11111111', expected a channel of a color: a whole number from 0 to 255");
    CHECK(ply("0 0 0 0 0 1 1 1 1\n0 0 0 0 0 1 11 256 1\n") ==
          "p:15: found '256', expected a channel of a color: a whole number from 0 to 255");
  }

  TEST_CASE("missing or repeated columns are refused") {
    CHECK(table("0 0 0\n", "1,2,4") ==
          "p:1: found 3 columns ('0 0 0'), expected at least 4 columns, as --columns requires");
    CHECK(table("a,b,c\n1,2,3\n", "a,b,d") == "p:1: found 'a,b,c', expected a header with a column 'd'");
    CHECK(table("# no line\n", "a,b,d") == "p: found no header line, expected one with the column names");
    CHECK(table("a,b,c,d\n1,2,3,4\n") ==
          "p:1: found 'a,b,c,d', expected a header with columns x, y and z (--columns X,Y,Z chooses others)");
    CHECK(table("a,b,c\n1,2,3\n", "a,b,2") ==
          "--columns: found 'b', the same column twice, expected different columns");
    CHECK(table("", "1,2,1") == "--columns: found '1,2,1', the same column twice, expected different columns");
    for (const std::string text : {"1,2", "1,2,3,4", "1,,3", "1,2,3,", "1,2,3,4,5,6,7"})
      CHECK(table("", text) ==
            "--columns: found '" + text + "', expected X,Y,Z or X,Y,Z,NX,NY,NZ (column numbers or names)");
    CHECK(table("", "1,2,0") == "--columns: found '0', expected a column number from 1 or a column name");
  }

  TEST_CASE("a field that is not a finite number is refused") {
    CHECK(table("0 0 0\n# x\n1 2 abc\n") == "p:3: found 'abc', expected a number" + skip);
    CHECK(table("0 0 0\n1 2 3x\n") == "p:2: found '3x', expected a number" + skip);
    CHECK(table("0 0 0\n1 nan 3\n") == "p:2: found 'nan', expected a finite number" + skip);
    CHECK(table("0 0 0\n1 2 -inf\n") == "p:2: found '-inf', expected a finite number" + skip);
    CHECK(table("0,0,0\n1,,3\n") == "p:2: found '', expected a number" + skip);
    CHECK(table("0 0 0\n1 2 1e999\n") ==
          "p:2: found '1e999', expected a number within the range of a double (up to 1.8e308; " + skip.substr(2));
    CHECK(table("0 0 0 0 0 1\n0 0 0 0 nan 1\n") == "p:2: found 'nan', expected a finite number" + skip);
    CHECK(table("0.5;1;2\n0,5;1;2\n") ==
          "p:2: found '0,5', expected a number with a decimal point, as in lines before (one decimal sign in all "
          "lines; " +
              skip.substr(2));
    CHECK(table("0,5;1;2\n0.5;1;2\n") ==
          "p:2: found '0.5', expected a number with a decimal comma, as in line 1 (one decimal sign in all lines; " +
              skip.substr(2));
    CHECK(off("OFF\n1 0 0\n0 inf 0\n") ==
          "p:3: found 'inf', expected a finite number (--skip-invalid leaves out such points)");
    CHECK(obj("v 0 0 nan\n") == "p:1: found 'nan', expected a finite number");
    CHECK(obj("v 0 0 0\nvn 0 nan 1\n") == "p:2: found 'nan', expected a finite number");
    CHECK(ply("0 0 0 0 0 1 1 1 1\n0 0 nan 0 0 1 1 1 1\n") ==
          "p:15: found 'nan', expected a finite number (--skip-invalid leaves out such points)");
    CHECK(ply("0 0 0 0 0 1 1 1 1\n0 0 0 0 0 1 1 1 1.5\n") ==
          "p:15: found '1.5', expected a channel of a color: a whole number from 0 to 255");
    CHECK(pcd(numbers({0.F, 0.F, 0.F, 0.F, 0.F, static_cast<float>(no_number)})) ==
          "p: point 1: found 'nan', expected a finite number (--skip-invalid leaves out such points)");
    CHECK(npy("(1, 3)", numbers({0., -inf, 0.})) ==
          "p: point 0: found '-inf', expected a finite number (--skip-invalid leaves out such points)");
    CHECK(npy("(1, 6)", numbers({0., 0., 0., no_number, 0., 0.})) ==
          "p: normal of point 0: found 'nan', expected a finite number (--skip-invalid leaves out such points)");
    CHECK(refusal("ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
                  "property double z\nend_header\n" +
                      numbers({0., 0., inf}),
                  Format::ply) ==
          "p: point 0: found 'inf', expected a finite number (--skip-invalid leaves out such points)");
  }

  TEST_CASE("the first normal that has no direction is named") {
    const std::string message = "p: normal of point 1: found '0 0 0', expected a vector of another length than 0";
    CHECK(table("0 0 0 0 0 1\n0 0 0 0 -0 0\n0 0 0 0 0 0\n") ==
          "p:2: found a normal of length 0, expected one of another length" + skip);
    CHECK(ply("0 0 0 0 0 1 1 1 1\n0 0 0 0 0 0 1 1 1\n") == message);
    CHECK(off("NOFF\n2 0 0\n0 0 0 0 1e-320 0\n1 0 0 0 0 0\n") == message);
    CHECK(obj("v 0 0 0\nv 0 0 0\nvn 1 0 0\nvn 0 0 0\n") == message);
    CHECK(npy("(2, 6)", numbers({0., 0., 0., 1., 0., 0., 0., 0., 0., 0., 0., 0.})) == message);
  }

  TEST_CASE("a file that ends too early is refused before memory is allocated") {
    CHECK(off("OFF\n2 0 0\n0 0 0\n# a comment that is long enough\n") ==
          "p: found 1 vertex line, expected 2 vertex lines as line 2 says");
    CHECK(off("OFF\n99999999999999 0 0\n0 0 0\n") ==
          "p: found 6 bytes of data, expected 99999999999999 vertex lines as line 2 says");
    CHECK(ply("0 0 0 0 0 1 1 1 1\n") == "p: found 18 bytes of data, expected 2 vertex elements as line 3 says");
    CHECK(npy("(99999999999999, 3)", numbers({0., 0., 0.})) ==
          "p: found 24 bytes of data, expected 99999999999999 rows of 24 bytes as the header says");
    for (const std::string count : {"2", "99999999999999", "18446744073709551615"})
      for (const std::string list : {"", "property list uchar int l\n"})
        CHECK(refusal("ply\nformat binary_big_endian 1.0\nelement vertex " + count +
                          "\nproperty float x\nproperty float y\nproperty float z\n" + list + "end_header\n" +
                          numbers({0.F, 0.F, 0.F, 0.F, 0.F}),
                      Format::ply) ==
              "p: found 20 bytes of data, expected " + count + " vertex elements as line 3 says");
    CHECK(refusal("ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                  "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                      numbers({0.F, 0.F, 0.F}) + "\x03xx",
                  Format::ply) == "p: found 0 whole face elements, expected 1 face element as line 7 says");
    CHECK(pcd(numbers({0.F, 0.F, 0.F, 0.F, 0.F})) == "p: found 20 bytes of data, expected 2 points as line 8 says");
    CHECK(pcd("", "WIDTH 2\nHEIGHT 1\nPOINTS 2", "POINTS 99999999999999") ==
          "p: found 0 bytes of data, expected 99999999999999 points as line 6 says");
    CHECK(pcd("0 0 0\n1 1\n", "DATA binary", "DATA ascii") ==
          "p: found 10 bytes of data, expected 2 points as line 8 says");
    CHECK(pcd("0 0 0\n# and more than enough\n", "DATA binary", "DATA ascii") ==
          "p: found 1 point, expected 2 points as line 8 says");
    CHECK(pcd("0 0 0\n1 100\n", "DATA binary", "DATA ascii") == "p:11: found '1 100', expected one more number");
    std::string names, sizes, types, counts;  // 16 thousand million numbers in each of no points
    for (int i = 0; i < 250000; ++i) {
      names += " a";
      sizes += " 4";
      types += " F";
      counts += " 65536";
    }
    CHECK(refusal("FIELDS x y z" + names + "\nSIZE 4 4 4" + sizes + "\nTYPE F F F" + types + "\nCOUNT 1 1 1" + counts +
                      "\nPOINTS 0\nDATA ascii\n",
                  Format::pcd) == "");
    std::string las = bytes_of({.points = {{.x = 1}, {.x = 2}}});
    las.resize(las.size() - 1);
    CHECK(refusal(las, Format::las) ==
          "p: found 1 whole record of 20 bytes, expected 2 as the header says (--skip-invalid reads those that are "
          "whole)");
  }

  TEST_CASE("an impossible header of PCD is refused") {
    CHECK(pcd("", "DATA binary", "DATA hex") == "p:9: found 'DATA hex', expected ascii, binary or binary_compressed");
    CHECK(pcd("", "DATA binary\n", "") == "p: found the end of the file in the header, expected DATA");
    CHECK(pcd(std::string(24, '\0'), "FIELDS x y z", "FIELDS x y h") ==
          "p: found points without 'z', expected the fields x, y and z");
    CHECK(pcd("", "FIELDS x y z", "FIELDS") == "p:2: found 'FIELDS', expected the names of fields");
    CHECK(pcd("", "SIZE 4 4 4", "SIZE 4 4") == "p: found 2 words after SIZE, expected 3, one for each of FIELDS");
    CHECK(pcd("", "TYPE F F F\n", "") == "p: found 0 words after TYPE, expected 3, one for each of FIELDS");
    CHECK(pcd("", "COUNT 1 1 1", "COUNT 1 1") == "p: found 2 words after COUNT, expected 3, one for each of FIELDS");
    CHECK(pcd("", "SIZE 4 4 4", "SIZE 4 4 3") ==
          "p: field z: found 'F 3', expected a type F, I or U and its size in bytes");
    for (const std::string count : {"-1", "65537", "18446744073709551615"})
      CHECK(pcd("", "COUNT 1 1 1", "COUNT 1 1 " + count) ==
            "p: field z: found a count of '" + count + "', expected one from 0 to 65536");
    CHECK(pcd(std::string(16, '\0'), "COUNT 1 1 1", "COUNT 1 1 0") ==
          "p: found points without 'z', expected the fields x, y and z");
    CHECK(pcd("", "POINTS 2", "POINTS 3") == "p: found 3 points, expected 2 times 1 as WIDTH and HEIGHT say");
    CHECK(pcd("", "WIDTH 2", "WIDTH two") == "p:6: found 'WIDTH two', expected a number of points");
    CHECK(pcd("", "WIDTH 2\nHEIGHT 1\nPOINTS 2\n", "") ==
          "p: found a header without POINTS, expected the number of points");
    CHECK(pcd("", "WIDTH 2\nHEIGHT 1\nPOINTS 2\n", "WIDTH 4294967296\nHEIGHT 4294967297\n") ==
          "p: found WIDTH and HEIGHT beyond any file, expected 4294967296 times 4294967297 as WIDTH and HEIGHT say");
    CHECK(pcd("", "HEIGHT 1", "DEPTH 1") ==
          "p:7: found 'DEPTH 1', expected one of VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, POINTS, VIEWPOINT "
          "and DATA");
    CHECK(refusal("FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nPOINTS 1\nDATA ascii\n0 0 0 4294967296\n",
                  Format::pcd) == "p:6: found '4294967296', expected a color of 4 bytes");
    CHECK(refusal("FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nPOINTS 1\nDATA ascii\n0 0 0 1e300\n", Format::pcd) ==
          "p:6: found '1e+300', expected a color of 4 bytes");
  }

  TEST_CASE("a missing normal or vertex that a face of OBJ names is refused") {
    const std::string v = "v 0 0 0\nvn 1 0 0\n";
    CHECK(obj(v + "f 1//2\n") == "p:3: found '2', expected a normal number from 1 to 1");
    CHECK(obj(v + "f 2//1\n") == "p:3: found '2', expected a vertex number from 1 to 1");
    CHECK(obj(v + "f 1//0\n") == "p:3: found '1//0', expected a normal number from 1, or from -1 to -1");
    CHECK(obj(v + "f -2//1\n") == "p:3: found '-2//1', expected a vertex number from 1, or from -1 to -1");
    CHECK(obj(v + "f 1//x\n") == "p:3: found '1//x', expected a normal number from 1, or from -1 to -1");
    CHECK(obj(v + "f //1\n") == "p:3: found '//1' in a face, expected numbers of vertices, and one face a line");
    CHECK(obj("f 1//1\nv 0 0 0\n") == "");  // no normals at all: nothing to be wrong about
  }

  TEST_CASE("scales and offsets of LAS that give no finite heights are refused") {
    LasFile file{.points = {{.x = 1}}};
    file.scale[2] = 0;
    CHECK(refusal(bytes_of(file), Format::las) ==
          "p: found a scale of '0' for z, expected a finite number other than 0");
    file.scale[2] = no_number;
    CHECK(refusal(bytes_of(file), Format::las) ==
          "p: found a scale of 'nan' for z, expected a finite number other than 0");
    file.scale[2] = 1;
    file.offset[2] = inf;
    CHECK(refusal(bytes_of(file), Format::las) == "p: found an offset of 'inf' for z, expected a finite number");
    file.scale[2] = 1e300;
    file.offset[2] = 0;
    CHECK(refusal(bytes_of(file), Format::las) ==
          "p: found a scale of '1e+300' and an offset of '0' for z, expected coordinates within the range of a double");
  }
}
