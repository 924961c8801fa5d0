// Text files with several elements a line: read word by word, or refused; rows of faces are never read as points.
#include <doctest/doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "support/data_folder.h"
#include "support/program.h"

using namespace apps_test;

namespace {

constexpr const char* words[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
constexpr const char* faces[] = {"3 0 2 1", "3 0 1 3", "3 0 3 2", "3 1 2 3"};

/// Returns the texts as lines, `a_line` of them on each.
template <std::size_t count>
std::string rows(const char* const (&texts)[count], std::size_t a_line) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i)
    result += std::string(texts[i]) + ((i + 1) % a_line == 0 || i + 1 == count ? "\n" : "  ");
  return result;
}

std::string off(std::size_t vertices, std::size_t faces_a_line) {
  return "OFF\n4 4 6\n" + rows(words, vertices) + rows(faces, faces_a_line);
}

std::string ply(std::size_t vertices, std::size_t faces_a_line) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "4\nproperty list uchar int vertex_indices\nend_header\n" +
         rows(words, vertices) + rows(faces, faces_a_line);
}

std::string pcd(std::size_t a_line) {
  return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA ascii\n" +
         rows(words, a_line);
}

/// Returns the volume of the hull of the points.
double volume_of_points(const Folder& folder, const std::string& name) {
  return nlohmann::json::parse(folder.rbpa("solid " + name + " --alpha inf -o o.npy --json -q", 0).out)["volume"];
}

nlohmann::json mesh_report(const Folder& folder, const std::string& name) {
  return nlohmann::json::parse(folder.meshtopo(name + " --json", 0).out);
}

std::string finding(const std::string& name) { return (rbpa_test::bundled_data() / "findings" / name).string(); }

std::string refusal(const Folder& folder, const std::string& name) {
  const Outcome points = folder.rbpa("solid " + name + " --alpha inf -o refused.npy -q", 3);
  CHECK_FALSE(folder.has("refused.npy"));
  return points.err;
}

}  // namespace

TEST_SUITE("several elements a line") {
  TEST_CASE("OFF, PLY and PCD are read by their words, as points and as meshes") {
    for (const std::size_t vertices : {1U, 2U, 3U, 4U}) {
      for (const std::size_t faces_a_line : {1U, 2U, 3U, 4U}) {
        const Folder folder;
        CAPTURE(vertices);
        CAPTURE(faces_a_line);
        folder.file("m.off", off(vertices, faces_a_line));
        folder.file("m.ply", ply(vertices, faces_a_line));
        folder.file("n.off", "OFF 4 4 6 " + rows(words, vertices) + rows(faces, faces_a_line));
        for (const std::string name : {"m.off", "m.ply", "n.off"}) {
          CAPTURE(name);
          CHECK(volume_of_points(folder, name) == doctest::Approx(1.0 / 6).epsilon(1e-15));
          const nlohmann::json report = mesh_report(folder, name);
          CHECK(report["vertices"] == 4);
          CHECK(report["faces"] == 4);
          CHECK(report["volume"] == doctest::Approx(1.0 / 6).epsilon(1e-15));
        }
      }
      const Folder folder("m.pcd", pcd(vertices));
      CHECK(volume_of_points(folder, "m.pcd") == doctest::Approx(1.0 / 6).epsilon(1e-15));
    }
  }

  TEST_CASE("normals, lists and other properties are words of their own") {
    const Folder folder;
    folder.file("n.off", "NOFF\n4 4 6\n0 0 0 0 0 1  1 0 0 0 0 1\n0 1 0 0 0 1  0 0 1 0 0 1\n" + rows(faces, 2));
    folder.file("l.ply",
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty list uchar int near\nproperty float x\nproperty "
                "float y\nproperty float z\nproperty uchar tag\nelement face 4\nproperty list uchar int "
                "vertex_indices\nproperty int group\nend_header\n0 0 0 0 9  2 5 5 1 0 0 9\n1 7 0 1 0 9  0 0 0 1 9\n"
                "3 0 2 1 8 3 0 1 3 8\n3 0 3 2 8 3 1 2 3 8\n");
    for (const std::string name : {"n.off", "l.ply"}) {
      CAPTURE(name);
      CHECK(volume_of_points(folder, name) == doctest::Approx(1.0 / 6).epsilon(1e-15));
      CHECK(mesh_report(folder, name)["faces"] == 4);
    }
  }

  TEST_CASE("words after an element on a line of its own are skipped, as colors are") {
    const Folder folder(
        "c.off",
        "OFF\n4 4 6\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0\n0 0 1 7\n3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2\n3 1 2 3 9\n");
    CHECK(volume_of_points(folder, "c.off") == doctest::Approx(1.0 / 6).epsilon(1e-15));
    CHECK(mesh_report(folder, "c.off")["faces"] == 4);
  }

  TEST_CASE("a line that is neither is refused by its number") {
    const Folder folder;
    // A color of the plane's vertices and a file that is cut off; two words too many; two vertices and half of one a
    // line.
    folder.file("a.off", "OFF\n4 4 6\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n0 0 1 255 0 0\n3 0 2 1\n");
    folder.file("b.off", off(2, 1) + "3 4\n");
    folder.file("c.ply", ply(4, 4) + "7\n");
    folder.file("d.pcd", pcd(2) + "5 5\n");
    for (const std::string name : {"a.off", "b.off", "c.ply", "d.pcd"}) {
      CAPTURE(name);
      CHECK(contains(refusal(folder, name), name + ":"));
    }
    CHECK(refusal(folder, "a.off") ==
          "rbpa: a.off:3: found '255 0 0' in a vertex line, and 4 lines after it, expected 7 lines after it, one for "
          "each element in the header, or in the line words of these elements only\n");
    folder.file("v.obj", "v 0 0 0 v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    folder.file("w.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 f 3 2 1\n");
    folder.file("x.obj", "v 0 0 0 1 0 0 0 1 0 0 0 1\n");
    for (const std::string name : {"v.obj", "w.obj", "x.obj"}) {
      CAPTURE(name);
      CHECK(folder.meshtopo(name + " -q").code == 3);
      refusal(folder, name);
    }
    folder.file(
        "s.stl",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0 vertex 9 9 9\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\nendsolid\n");
    CHECK(folder.meshtopo("s.stl -q").err ==
          "meshtopo: s.stl:4: found 'vertex 0 0 0 vertex 9 9 9', expected one vertex of three numbers a line\n");
  }

  TEST_CASE("files of others are read") {
    const Folder folder;
    CHECK(volume_of_points(folder, finding("case_face_rows_read_as_points/two_a_line.off")) ==
          doctest::Approx(1.0 / 6).epsilon(1e-15));
    CHECK(volume_of_points(folder, finding("case_face_rows_read_as_points/one_line.ply")) ==
          doctest::Approx(1.0 / 6).epsilon(1e-15));
    CHECK(mesh_report(folder, finding("case_face_rows_read_as_points/two_a_line.off"))["faces"] == 4);
    const nlohmann::json cube = mesh_report(folder, finding("case_off_glued/glued.off"));
    CHECK(cube["vertices"] == 8);
    CHECK(cube["faces"] == 12);
    CHECK(volume_of_points(folder, finding("case_pcd_count_0/ouster.pcd")) == 1);
  }

  TEST_CASE("a count of 0 takes no words and no bytes, and a coordinate has one") {
    const std::string head =
        "VERSION .7\nFIELDS x _ y z\nSIZE 4 1 4 4\nTYPE F U F F\nCOUNT 1 0 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\n";
    std::string binary = head + "DATA binary\n";
    for (const float x : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F}) {
      char bytes[sizeof x];
      std::memcpy(bytes, &x, sizeof x);
      binary.append(bytes, sizeof x);
    }
    const Folder folder({{"a.pcd", head + "DATA ascii\n" + rows(words, 1)}, {"b.pcd", binary}});
    for (const std::string name : {"a.pcd", "b.pcd"}) CHECK(volume_of_points(folder, name) == doctest::Approx(1.0 / 6));
    std::string without = head + "DATA ascii\n" + rows(words, 1);
    without.replace(without.find("1 0 1 1"), 7, "1 1 1 0");
    folder.file("z.pcd", without);
    CHECK(refusal(folder, "z.pcd") == "rbpa: z.pcd: found points without 'z', expected the fields x, y and z\n");
  }

  TEST_CASE("the number of vertices may follow the word OFF, with its prefixes") {
    for (const std::string word : {"OFF", "COFF", "NOFF", "STOFF"}) {
      CAPTURE(word);
      const Folder folder;
      std::string text = word + "4 4 6\n";
      for (const char* vertex : words) text += std::string(vertex) + (word == "NOFF" ? " 0 0 1\n" : "\n");
      folder.file("m.off", text + rows(faces, 1));
      CHECK(mesh_report(folder, "m.off")["volume"] == doctest::Approx(1.0 / 6));
      CHECK(volume_of_points(folder, "m.off") == doctest::Approx(1.0 / 6));
    }
    const Folder folder("m.off", "OFFx 4 6\n");
    CHECK(refusal(folder, "m.off") == "rbpa: m.off:1: found 'OFFx', expected OFF, COFF, NOFF or CNOFF\n");
  }
}
