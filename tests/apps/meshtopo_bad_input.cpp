// All kinds of bad meshes and command lines of meshtopo: the exit code, the whole message, and no output.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>

#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;

namespace {

void refuses_mesh(const std::string& name, const std::string& content, const std::string& message) {
  CAPTURE(content);
  const Folder folder(name, content);
  meshtopo_refuses(folder, name + " --repair -o out.off --generators loops.obj", 3, message);
}

const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string three_points = "0 0 0\n1 0 0\n0 1 0\n";

std::string binary_ply(const std::string& data) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
         "z\n" +
         ply_faces + data;
}

std::string float_bytes(float value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

}  // namespace

TEST_SUITE("meshtopo: bad input") {
  TEST_CASE("a missing file, a folder and an empty file are refused") {
    const Folder folder;
    meshtopo_refuses(folder, "none.off", 3, "none.off: found no such file, expected a mesh file");
    meshtopo_refuses(folder, ". --format off", 3, ".: found a folder, expected a mesh file");
    refuses_mesh("m.off", "", "m.off: found an empty file, expected a mesh");
  }

  TEST_CASE("errors in OFF are refused by line") {
    const std::string head = "OFF\n3 1 0\n" + three_points;
    refuses_mesh("m.off", "NOPE\n3 1 0\n", "m.off:1: found 'NOPE', expected OFF, COFF, NOFF or CNOFF");
    refuses_mesh("m.off", "OFF BINARY\n", "m.off:1: found binary OFF, expected ASCII OFF");
    refuses_mesh("m.off", "OFF\n# c\nx 1 0\n",
                 "m.off:3: found 'x 1 0', expected the numbers of vertices, faces and edges");
    refuses_mesh("m.off", "OFF\n3\n" + three_points,
                 "m.off:2: found '3', expected the numbers of vertices, faces and edges");
    refuses_mesh("m.off", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", "m.off:4: found 'zero', expected a number");
    refuses_mesh("m.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "m.off:4: found '1 0', expected one more number");
    refuses_mesh("m.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
                 "m.off:4: found 'nan', expected a finite number");
    refuses_mesh("m.off", head + "3 0 1 3\n", "m.off:6: found '3', expected a vertex number from 0 to 2");
    refuses_mesh("m.off", head + "3 0 1 -1\n", "m.off:6: found '-1', expected a vertex number from 0 to 2");
    refuses_mesh("m.off", head + "4 0 1 2\n", "m.off:6: found 3 corners ('4 0 1 2'), expected 4 as the line says");
    refuses_mesh("m.off", head + "three 0 1 2\n", "m.off:6: found 'three', expected the number of corners of a face");
    refuses_mesh("m.off", head + "3 0 1 2\n\n3 2 1 0\n",
                 "m.off:8: found '3 2 1 0', expected the end of the file after 1 face line as line 2 says");
    refuses_mesh("m.off", "OFF\n2 2 0\n0 0 0\n0 0 0\n2 0 1 255 255 255\n",
                 "m.off:5: found '255 255 255' in a face line, and 0 lines after it, expected 1 line after it, one for "
                 "each element in the header, or in the line words of these elements only");
    refuses_mesh("m.off", "OFF\n3 0 0\n0 0 0\n0 0 0 # long enough\n",
                 "m.off: found 2 vertex lines, expected 3 vertex lines as line 2 says");
  }

  TEST_CASE("counts beyond the file are refused before memory is allocated") {
    refuses_mesh("m.off", "OFF\n99999999999999 0 0\n0 0 0\n",
                 "m.off: found 6 bytes of data, expected 99999999999999 vertex lines as line 2 says");
    refuses_mesh("m.off", "OFF\n1 99999999999999 0\n0 0 0\n3 0 0 0\n",
                 "m.off: found 8 bytes of data, expected 99999999999999 face lines as line 2 says");
    refuses_mesh("m.off", "OFF\n1 1 0\n0 0 0\n99999999999999 0 0 0\n",
                 "m.off:4: found 3 corners ('99999999999999 0 0 0'), expected 99999999999999 as the line says");
    refuses_mesh("m.ply",
                 "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty "
                 "float z\nelement face 99999999999999\nproperty list int int vertex_index\nend_header\n12345678",
                 "m.ply: found 8 bytes of data, expected 99999999999999 face elements as line 7 says");
    std::string stl(84, '\0');
    stl.replace(80, 4, "\xff\xff\xff\xff");
    refuses_mesh("m.stl", stl,
                 "m.stl: found 84 bytes, expected 214748364834 for the 4294967295 facets that the header counts in "
                 "bytes 80 to 83");
  }

  TEST_CASE("errors in ASCII PLY are refused by line") {
    refuses_mesh("m.ply", "plya\n",
                 "m.ply: found a first line 'plya', expected 'ply', the first line of every .ply file");
    refuses_mesh("m.ply", "ply\nformat ascii 1.0\nend_header\n",
                 "m.ply: found a header without vertices, expected an element 'vertex'");
    refuses_mesh("m.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
                 "m.ply:3: found vertices without 'z', expected number properties x, y and z");
    refuses_mesh(
        "m.ply", ply_head + "element face 1\nproperty int a\nend_header\n" + three_points + "1\n",
        "m.ply:7: found faces without a list of vertices, expected a list property vertex_indices or vertex_index");
    refuses_mesh("m.ply", ply_head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n",
                 "m.ply:7: found triangle strips, expected faces as lists of vertex indices");
    refuses_mesh("m.ply", ply_head + ply_faces + three_points + "3 0 1 3\n",
                 "m.ply:13: found '3', expected a vertex number from 0 to 2");
    refuses_mesh("m.ply", ply_head + ply_faces + three_points,
                 "m.ply: found 0 bytes of data, expected 1 face element as line 7 says");
    refuses_mesh("m.ply", ply_head + ply_faces + "0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n",
                 "m.ply:11: found 'inf', expected a finite number");
  }

  TEST_CASE("errors in binary PLY are refused by element") {
    const std::string zero = float_bytes(0);
    refuses_mesh("m.ply",
                 binary_ply(zero + float_bytes(std::numeric_limits<float>::quiet_NaN()) + zero + "\x01" + zero),
                 "m.ply: vertex 0: found 'nan', expected a finite number");
    refuses_mesh("m.ply", binary_ply(zero + zero + zero + "\x01\x07" + zero.substr(1)),
                 "m.ply: face 0: found '7', expected a vertex number from 0 to 0");
    refuses_mesh("m.ply", binary_ply(zero + zero + zero + "\x02" + zero),
                 "m.ply: found 0 whole face elements, expected 1 face element as line 7 says");
    refuses_mesh("m.ply", binary_ply(zero + zero),
                 "m.ply: found 8 bytes of data, expected 1 vertex element as line 3 says");
  }

  TEST_CASE("errors in OBJ are refused by line") {
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    refuses_mesh("m.obj", "# nothing\n", "m.obj: found no line 'v x y z', expected the vertices of a mesh");
    refuses_mesh("m.obj", "v 0 0\n", "m.obj:1: found 'v 0 0', expected one more number");
    refuses_mesh("m.obj", head + "f 1 2 4\n", "m.obj:4: found '4', expected a vertex number from 1 to 3");
    refuses_mesh("m.obj", head + "f 1 2 0\n", "m.obj:4: found '0', expected a vertex number from 1, or from -1 to -3");
    refuses_mesh("m.obj", head + "f 1 2 -4\n",
                 "m.obj:4: found '-4', expected a vertex number from 1, or from -1 to -3");
    refuses_mesh("m.obj", head + "f 1 \\\n2 x/1\n",
                 "m.obj:4: found 'x/1', expected a vertex number from 1, or from -1 to -3");
    refuses_mesh("m.obj", head + "f\n", "m.obj:4: found a face without corners, expected vertex numbers after 'f'");
  }

  TEST_CASE("errors in STL are refused by line or facet") {
    refuses_mesh(
        "m.stl", "not a mesh",
        "m.stl: found 10 bytes, expected text that begins with 'solid', or at least the 84 bytes of a binary header");
    const std::string text = stl_text(pyramid_triangles), bytes = stl_binary(pyramid_triangles);
    refuses_mesh("m.stl", text.substr(0, text.find("endsolid")),
                 "m.stl: found the end of the file, expected facet or endsolid");
    refuses_mesh("m.stl", "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
                 "m.stl:6: found 'endloop', expected vertex");
    refuses_mesh("m.stl", "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 x\n",
                 "m.stl:4: found 'x', expected a number");
    refuses_mesh("m.stl", "solid\nmesh\n", "m.stl:2: found 'mesh', expected facet or endsolid");
    refuses_mesh("m.stl", "solid\nendsolid\nmore\n", "m.stl:3: found 'more', expected solid");
    refuses_mesh("m.stl", bytes.substr(0, bytes.size() - 1),
                 "m.stl: found 383 bytes, expected 384 for the 6 facets that the header counts in bytes 80 to 83");
    std::string broken = bytes;
    broken.replace(84 + 50 * 2 + 12 + 4, 4, float_bytes(std::numeric_limits<float>::infinity()));
    refuses_mesh("m.stl", broken, "m.stl: facet 2: found 'inf', expected a finite number");
  }
}

TEST_SUITE("meshtopo: a corner out of range") {
  TEST_CASE("bad input is refused and never repaired away") {
    const std::string good = "OFF\n3 2 0\n" + three_points + "3 0 1 2\n";
    for (const std::string command :
         {"--repair out.off", "--repair -o out.off", "--repair out.off -o r.json", "--json"}) {
      const Folder folder;
      folder.file("m.off", good + "3 0 1 3\n");
      folder.file("m.ply", ply_head + "element face 1\nproperty list uchar uint vertex_indices\nend_header\n" +
                               three_points + "3 0 1 4294967295\n");
      folder.file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
      meshtopo_refuses(folder, "m.off " + command, 3, "m.off:7: found '3', expected a vertex number from 0 to 2");
      meshtopo_refuses(folder, "m.ply " + command, 3,
                       "m.ply:13: found '4294967295', expected a vertex number from 0 to 2");
      meshtopo_refuses(folder, "m.obj " + command, 3, "m.obj:5: found '9', expected a vertex number from 1 to 3");
      meshtopo_refuses(folder, "- --format off " + command + " <m.off", 3,
                       "standard input:7: found '3', expected a vertex number from 0 to 2");
    }
  }
}

TEST_SUITE("meshtopo: wrong usage") {
  TEST_CASE("unknown formats are refused") {
    const Folder folder({{"m.off", pyramid_off}, {"m", pyramid_off}});
    meshtopo_refuses(folder, "m.foo", 2,
                     "m.foo: found the ending 'foo', expected one of off, ply, obj, stl, or --format");
    meshtopo_refuses(folder, "m", 2, "m: found the ending '', expected one of off, ply, obj, stl, or --format");
    meshtopo_refuses(folder, "m --format xyz", 2, "--format: found 'xyz', expected one of off, ply, obj, stl");
    meshtopo_refuses(folder, "- </dev/null", 3, "standard input: found an empty file, expected a mesh");
    meshtopo_refuses(folder, "m.off --repair -o out.vtu", 2,
                     "out.vtu: found the ending 'vtu', expected one of off, ply, obj, stl, or --output-format");
    meshtopo_refuses(folder, "m.off --repair -o - -q", 2, "-o - requires --output-format: one of off, ply, obj, stl");
    meshtopo_refuses(folder, "m.off --repair -o out --output-format vtu", 2,
                     "--output-format: found 'vtu', expected one of off, ply, obj, stl");
    meshtopo_refuses(folder, "m.off --generators loops.off", 2,
                     "--generators: found the ending 'off', expected one of obj, json");
  }

  TEST_CASE("a report with another ending is refused") {
    const Folder folder("m.off", pyramid_off);
    for (const std::string ending : {"ply", "off", "OBJ", "stl"})
      for (const std::string json : {"", " --json"})
        meshtopo_refuses(folder, "m.off -o x." + ending + json, 2,
                         "x." + ending + ": found the ending '" + ending +
                             "' of a mesh, expected json or txt for a report, or --repair OUT to write a mesh (to "
                             "convert: --weld 0 -o x." +
                             ending + ")");
    meshtopo_refuses(folder, "m.off -o x.csv", 2,
                     "x.csv: found the ending 'csv', expected one of json, txt, or --json");
    meshtopo_refuses(folder, "m.off -o x.txt --json", 2, "x.txt: found the ending 'txt' with --json, expected json");
  }

  TEST_CASE("contradicting arguments are refused") {
    const Folder folder("m.off", pyramid_off);
    meshtopo_refuses(folder, "m.off --repair", 2,
                     "--repair requires a file for the repaired mesh (--repair OUT or -o OUT)");
    meshtopo_refuses(folder, "m.off --repair r.off -o s.off", 2,
                     "s.off: found the ending 'off' of a mesh, expected json or txt for a report, or --repair OUT to "
                     "write a mesh (to convert: --weld 0 -o s.off)");
    meshtopo_refuses(folder, "m.off --repair - --output-format off", 2,
                     "--repair -: the mesh and the report cannot both go to standard output (name a file for the mesh, "
                     "or leave out the report with --quiet)");
    meshtopo_refuses(folder, "m.off --repair m.off", 2,
                     "m.off: found the file of the mesh, expected another file to write to");
    meshtopo_refuses(folder, "m.off --repair a.obj --generators a.obj", 2,
                     "a.obj: found twice among the files to write, expected once");
    meshtopo_refuses(folder, "m.off --output-format off", 2,
                     "--output-format requires a mesh to write (-o OUT or --repair OUT)");
    meshtopo_refuses(folder, "m.off -q -o r.txt", 2,
                     "-o cannot write a text report with --quiet, which leaves the report out (add --json)");
    meshtopo_refuses(folder, "m.off --repair -o - --output-format off", 2,
                     "-o -: the mesh and the report cannot both go to standard output (name a file for the mesh, or "
                     "leave out the report with --quiet)");
    meshtopo_refuses(folder, "m.off --repair -o m.off", 2,
                     "m.off: found the file of the mesh, expected another file to write to");
    meshtopo_refuses(folder, "m.off --repair -o a.obj --generators ./a.obj", 2,
                     "./a.obj: found twice among the files to write, expected once");
    CHECK(folder.content("m.off") == pyramid_off);
  }

  TEST_CASE("a missing mesh, an unknown option and a wrong number are refused") {
    const Folder folder("m.off", pyramid_off);
    CHECK(folder.meshtopo("").code == 2);
    CHECK(folder.meshtopo("m.off --jsno").code == 2);
    meshtopo_refuses(folder, "m.off --genus", 2,
                     "found '--genus', expected an option of meshtopo (is it --generators? see meshtopo --help)");
    meshtopo_refuses(folder, "m.off --max-defects many", 2,
                     "--max-defects: found 'many', expected a whole number from 0");
    meshtopo_refuses(folder, "m.off --max-defects -1", 2, "--max-defects: found '-1', expected a whole number from 0");
  }

  TEST_CASE("help and version exit with 0") {
    const Folder folder;
    CHECK(folder.meshtopo("--help").code == 0);
    CHECK(contains(folder.meshtopo("--help").out, "Examples:"));
    CHECK(folder.meshtopo("--version").out.find("meshtopo 0.") == 0);
  }
}

TEST_SUITE("meshtopo: failure while running") {
  TEST_CASE("a full or unwritable output is reported, and nothing is left behind") {
    const Folder folder("m.off", pyramid_off);
    meshtopo_refuses(folder, "m.off -o /dev/full", 1, "/dev/full: cannot write: No space left on device");
    meshtopo_refuses(folder, "m.off --json -o none/r.json", 1,
                     "none/r.json: found no folder 'none', expected one to write to");
    meshtopo_refuses(folder, "m.off --repair -o none/m.off", 1,
                     "none/m.off: found no folder 'none', expected one to write to");
    meshtopo_refuses(folder, "m.off --repair -o out.off --generators none/l.obj", 1,
                     "none/l.obj: found no folder 'none', expected one to write to");
    meshtopo_refuses(folder, "m.off -o /dev/full --generators loops.json", 1,
                     "/dev/full: cannot write: No space left on device");
  }
}
