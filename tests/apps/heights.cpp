// Third coordinates of points read in the plane: a warning says that they are left out if they are differing heights.
#include <doctest/doctest.h>

#include <cstring>
#include <string>
#include <vector>

#include "support/las_file.h"
#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;

namespace {

std::string warning(const std::string& file, int points = 3) {
  return "rbpa: " + file + ": z of " + std::to_string(points) +
         " points is not used (rbpa mesh keeps heights, rbpa grid interpolates them; rbpa surface and solid work in "
         "space)\n";
}

/// Returns points of three numbers with the given third ones.
std::string npy(const std::vector<double>& z, bool columns_first) {
  const std::size_t n = z.size();
  const auto value = [&](std::size_t i, std::size_t k) { return k == 2 ? z[i] : static_cast<double>((i + k) % n); };
  std::string bytes;
  for (std::size_t i = 0; i < n * 3; ++i) bytes += little(columns_first ? value(i % n, i / n) : value(i / 3, i % 3));
  return npy_file("{'descr': '<f8', 'fortran_order': " + std::string(columns_first ? "True" : "False") +
                      ", 'shape': (" + std::to_string(n) + ", 3)}",
                  bytes);
}

std::string ply(const std::vector<double>& z, bool binary, bool with_list) {
  std::string text = "ply\nformat " + std::string(binary ? "binary_little_endian" : "ascii") +
                     " 1.0\nelement vertex 3\nproperty double x\nproperty double z\nproperty double y\n" +
                     (with_list ? "property list uchar int q\n" : "") + "end_header\n";
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = static_cast<double>(i % 2), y = static_cast<double>(i / 2);
    text += binary ? little(x) + little(z[i]) + little(y)
                   : std::to_string(x) + " " + std::to_string(z[i]) + " " + std::to_string(y);
    if (with_list) text += binary ? std::string(1, '\0') : " 0";
    if (!binary) text += '\n';
  }
  return text;
}

}  // namespace

TEST_SUITE("heights") {
  TEST_CASE("a warning says that differing heights are left out, for every format that has them") {
    const Folder folder;
    const auto says = [&](const std::string& name, const std::string& content, bool said) {
      CAPTURE(name);
      CAPTURE(content);
      folder.file(name, content);
      const Outcome outcome = folder.rbpa("info " + name, 0);
      CHECK(contains(outcome.err, warning(name)) == said);
      CHECK(outcome.err.find("z of") == (said ? outcome.err.find(warning(name)) + 8 + name.size() : std::string::npos));
    };
    for (const std::string z : {"z", "Elevation", "height (m)"}) {
      says("h.csv", "x,y," + z + "\n0,0,1\n1,0,1\n0,1,2\n", true);
      says("h.csv", "y," + z + ",x\n0,\"1\",0\n1,3,0\n0,2,1\n", true);
      says("h.csv", "x,y," + z + "\n0,0,1\n1,0,1.0\n0,1,1e0\n", false);  // all of one height
      says("h.csv", "x,y," + z + "\n0,0,1\n1,0,NA\n0,1,none\n", false);
    }
    says("p.csv", "x,y,population\n0,0,1\n1,0,1\n0,1,2\n", false);
    says("g.csv", "id,wkt\n1,POINT Z (0 0 1)\n2,POINT Z (1 0 2)\n3,POINT (1 1)\n", true);
    says("u.xyz", "0 0 1\n1 0 1\n0 1 2\n", true);
    says("n.xyz", "0 0 1 0 0 1\n1 0 1 0 0 1\n0 1 2 0 0 1\n", true);
    says("u.xyz", "0 0 1\n1 0 1\n0 1 1\n", false);
    says("u.txt", "0 0 1\n1 0 1\n0 1 2\n", false);  // may be anything
    says("m.off", "OFF\n3 0 0\n0 0 1\n1 0 0\n0 1 0\n", true);
    says("m.off", "OFF\n3 0 0\n0 0 1\n1 0 1\n0 1 1\n", false);
    says("m.off", "OFF\n3 0 0\n0 0\n1 0\n0 1\n", false);
    says("p.wkt", "POINT Z (0 0 1) POINTZ(1 0 2) POINT(1 1)", true);
    says("p.wkt", "MULTIPOINT ZM (0 0 1 4, 1 0 2 4, 1 1 1 4)", true);
    says("p.wkt", "MULTIPOINT M (0 0 1, 1 0 2, 1 1 1)", false);
    says("p.geojson", "{\"type\":\"MultiPoint\",\"coordinates\":[[0,0,1],[1,0,2],[1,1,1]]}", true);
    says("p.geojson", "{\"type\":\"MultiPoint\",\"coordinates\":[[0,0,1],[1,0,1],[1,1]]}", false);
    for (const bool either : {false, true}) {
      says("p.npy", npy({1, 1, 2}, either), true);
      says("p.npy", npy({2, 2, 2}, either), false);
      for (const bool list : {false, true}) {
        if (list && !either) continue;  // of a text with lists heights are not looked for
        says("p.ply", ply({1, 1, 2}, either, list), true);
        says("p.ply", ply({5, 5, 5}, either, list), false);
      }
    }
    // Footprints of lidar need no heights, so there is no warning.
    says("p.las", bytes_of(LasFile{.points = {{.z = 1}, {.x = 1, .z = 2}, {.y = 1}}}), false);
  }

  TEST_CASE("heights are a field, as z or by the name of their column, and are then not ignored") {
    struct Case {
      std::string file, content, field, sum = "6";
    };
    const std::vector<Case> cases = {
        {"p.csv", "x,y,Height\n0,0,1\n1,0,1\n0,1,4\n", "Height"},
        {"p.csv", "x,y,Height\n0,0,1\n1,0,1\n0,1,4\n", "z"},
        {"p.csv", "lon;height;lat\n0;1;0\n1;1;0\n0;4;1\n", "height"},
        {"p.ply", ply({1, 1, 4}, true, false), "z"},
        {"p.ply", ply({1, 1, 4}, false, false), "Z"},
        {"p.las", bytes_of(LasFile{.points = {{.z = 1}, {.x = 1, .z = 1}, {.y = 1, .z = 4}}}), "z",
         "0.06"},  // in hundredths
        {"p.geojson", "{\"type\":\"MultiPoint\",\"coordinates\":[[0,0,1],[1,0,1],[1,1,4]]}", "z"}};
    const Folder folder;
    for (const Case& one : cases) {
      CAPTURE(one.file + " " + one.field);
      folder.file(one.file, one.content);
      const Outcome made =
          folder.rbpa("shape " + one.file + " --alpha inf --summarize " + one.field + ":sum -o s.geojson");
      CHECK(made.err.find("z of") == std::string::npos);
      CHECK(folder.content("s.geojson").find("\"" + one.field + "_sum\":" + one.sum + "}") != std::string::npos);
    }
    folder.file("p.csv", "x,y,Height\n0,0,1\n1,0,1\n0,1,4\n9,9,5\n");
    folder.rbpa("shape p.csv --alpha 2 --fields Height --isolated i.csv -o s.wkt");
    CHECK(folder.content("i.csv").find("Height\n9,9,") != std::string::npos);
    CHECK(folder.content("i.csv").find(",5\n") != std::string::npos);
  }

  TEST_CASE("mesh and grid take z from a third column, and list the columns that may have it") {
    const Folder folder("p.csv", "x,y,Nr,H,name,NN\n0,0,1,5,a,7\n4,0,2,6,b,8\n0,4,3,7,c,9\n");
    folder.file("n.txt", "0 0 1 5\n4 0 2 6\n0 4 3 7\n");
    const std::string start =
        ": no column has a known name of heights, so there is no z (--columns X,Y,Z takes z from ";
    CHECK(contains(folder.rbpa("mesh p.csv --alpha inf -o m.obj", 0).err, "p.csv" + start + "'Nr', 'H' or 'NN')\n"));
    CHECK(contains(folder.content("m.obj"), "v 0 0 0\n"));
    CHECK(contains(folder.rbpa("mesh n.txt --alpha inf -o m.obj", 0).err, "n.txt" + start + "column 3 or column 4)\n"));
    CHECK(contains(folder.rbpa("grid p.csv --cell 1 -o g.asc", 3).err, start));
    // A mesh without z, or values of another column, need no heights.
    for (const std::string run :
         {"mesh p.csv --alpha inf -o m.svg", "mesh p.csv --alpha inf --where \"Nr < 9 and H < 9 and NN < 99\" -o m.obj",
          "grid p.csv --value NN --cell 1 -o g.asc"})
      CHECK(!contains(folder.rbpa(run, 0).err, "no z"));
    for (const std::string columns : {"x,y,NN", "1,2,6", "x,2,nn"}) {
      CAPTURE(columns);
      CHECK(!contains(folder.rbpa("mesh p.csv --alpha inf --columns " + columns + " -o m.obj", 0).err, "no z"));
      CHECK(contains(folder.content("m.obj"), "v 0 0 7\nv 4 0 8\nv 0 4 9\n"));
      CHECK(folder.rbpa("grid p.csv --contours 8 --columns " + columns + " -o g.wkt -q", 0).err.empty());
      CHECK(contains(folder.content("g.wkt"), "8)"));
    }
    folder.rbpa("mesh n.txt --alpha inf --columns 1,2,4 -o m.obj", 0);
    CHECK(contains(folder.content("m.obj"), "v 0 0 5\n"));
    // A named column replaces the one whose name is known.
    folder.file("z.csv", "x,y,z,H\n0,0,1,5\n4,0,2,6\n0,4,3,7\n");
    folder.rbpa("mesh z.csv --alpha inf --columns x,y,H -o m.obj", 0);
    CHECK(contains(folder.content("m.obj"), "v 0 0 5\n"));
    for (const std::string wrong : {"x,y,", "x,y,x", "x,y,H,NN", "x,y,1"})
      CHECK(folder.rbpa("mesh p.csv --alpha inf --columns " + wrong + " -o m.obj", 2)
                .err.starts_with("rbpa: --columns: found "));
    says(folder, "mesh p.csv --alpha inf --columns x,y,9 -o m.obj", 3, "expected at least 9 columns");
    says(folder, "mesh p.csv --alpha inf --columns x,y,W -o m.obj", 3, "expected a header with a column 'W'");
    says(folder, "shape p.csv --alpha inf --columns x,y,H -o s.wkt", 2, "expected X,Y (two column numbers or names)");
  }

  TEST_CASE("all verbs of the plane without vertices print that warning, and info says how it counts duplicates") {
    const Folder folder("p.csv", "x,y,z\n0,0,1\n1,0,1\n0,1,2\n0,1,3\n");
    for (const std::string verb : {"info p.csv", "alpha p.csv", "mesh p.csv --alpha 2 -o m.svg",
                                   "shape p.csv --alpha 2 -o s.wkt", "report p.csv -o r.html"}) {
      CAPTURE(verb);
      CHECK(folder.rbpa(verb).err.starts_with(warning("p.csv", 4)));
      CHECK(!contains(folder.rbpa(verb + " --quiet").err, "z of"));
    }
    CHECK(contains(folder.rbpa("info p.csv").out, "duplicates  1  (of x and y; z was ignored)\n"));
    CHECK(!contains(folder.rbpa("surface p.csv --radius 2 -o s.off").err, "not used"));
    folder.file("q.csv", "x,y\n0,0\n0,0\n");
    CHECK(contains(folder.rbpa("info q.csv").out, "duplicates  1\n"));
  }
}
