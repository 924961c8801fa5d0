// Tests of the program meshtopo: its reports, in JSON and for people, its repairs, and its loops.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "io/mesh/read_mesh.h"
#include "support/data_folder.h"
#include "support/mesh_files.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

json report_of(const Folder& folder, const std::string& arguments) {
  CAPTURE(arguments);
  const Outcome outcome = folder.meshtopo(arguments + " --json", 0);
  CHECK(outcome.err.empty());
  return json::parse(outcome.out);
}

json report_of_text(const std::string& content, const std::string& options = "") {
  const Folder folder("m.off", content);
  return report_of(folder, "m.off " + options);
}

/// Returns the text after a label in the report for people.
std::string row(const std::string& label, const std::string& text) {
  const std::size_t at = text.find(label + " ");
  REQUIRE(at != std::string::npos);
  const std::size_t first = text.find_first_not_of(' ', at + label.size());
  return text.substr(first, text.find('\n', first) - first);
}

struct Known {
  const char* name;
  long vertices, faces, components, boundary_curves, euler, genus;
};

void is_known(const std::filesystem::path& data, const Known& mesh) {
  CAPTURE(mesh.name);
  const Folder folder;
  const std::string path = (data / mesh.name).string();
  const json r = report_of(folder, "'" + path + ".off' --generators l.json");
  CHECK(r["vertices"] == mesh.vertices);
  CHECK(r["faces"] == mesh.faces);
  CHECK(r["edges"] == mesh.vertices + mesh.faces - mesh.euler);
  CHECK(r["euler"] == mesh.euler);
  CHECK(r["components"] == mesh.components);
  CHECK(r["boundary_curves"] == mesh.boundary_curves);
  CHECK(r["genus"] == mesh.genus);
  const long loops = 2 * mesh.genus + std::max(mesh.boundary_curves - 1, 0L);
  CHECK(r["betti"] == json::array({1, loops, mesh.boundary_curves == 0 ? 1 : 0}));
  CHECK(r["pinches"] == 0);
  CHECK(r["isolated"] == 0);
  CHECK(r["defects"].empty());
  CHECK(json::parse(folder.content("l.json")).size() == static_cast<std::size_t>(loops));
}

/// Three triangles at the edge 0 1; one repeated; one without area; two on either side of point 5.
const std::string broken =
    "OFF\n10 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n9 9 9\n8 9 9\n8 8 9\n10 9 9\n10 10 9\n"
    "3 0 1 2\n3 1 0 3\n3 0 1 4\n3 2 0 1\n3 7 7 6\n3 5 6 7\n3 5 8 9\n3 2 1 4\n";

/// A Möbius band of five triangles.
const std::string moebius =
    "OFF\n5 5 0\n0 0 0\n1 0 0\n2 0 1\n3 1 0\n4 0 0\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n";

}  // namespace

TEST_SUITE("meshtopo") {
  TEST_CASE("meshes of known topology are reported right") {
    for (const Known& mesh : {Known{"m3_cube_no_bottom", 25, 40, 1, 1, 1, 0}, Known{"m3_bob", 250, 500, 1, 0, 0, 1},
                              Known{"m3_torus", 2304, 4608, 1, 0, 0, 1},
                              Known{"m3_plate_holes", 618, 1252, 1, 0, -8, 5}, Known{"m3_spot", 829, 1654, 1, 0, 2, 0}})
      is_known(rbpa_test::bundled_data(), mesh);
  }

  TEST_CASE("further meshes of known topology are reported right") {
    for (const Known& mesh :
         {Known{"m3_wingnut", 3047, 6090, 1, 0, 2, 0}, Known{"m3_quadknot", 1440, 2880, 1, 0, 0, 1},
          Known{"m3_plane_holes", 8519, 16747, 1, 27, -25, 0}, Known{"m3_human_woman", 6890, 13776, 1, 0, 2, 0}}) {
      if (rbpa_test::has_further_data()) is_known(rbpa_test::further_data(), mesh);
    }
  }

  TEST_CASE("the JSON report has these keys in this order and no others") {
    const Folder folder("m.off", pyramid_off);
    const auto r = nlohmann::ordered_json::parse(folder.meshtopo("m.off --json").out);
    std::vector<std::string> keys;
    for (const auto& [key, value] : r.items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"vertices", "edges", "faces", "euler", "components", "boundary_curves",
                                           "genus", "betti", "pinches", "isolated", "defects", "geometric_defects",
                                           "area", "volume", "box", "per_component"});
    CHECK(r["per_component"] ==
          nlohmann::ordered_json::parse(R"([{"first_face": 0, "vertices": 5, "edges": 8, "faces": 5, "euler": 2,
            "boundary_curves": 0, "orientable": true, "genus": 0, "betti": [1, 0, 1]}])"));
  }

  TEST_CASE("the report has the area, the volume of closed oriented pieces, and the box of all vertices") {
    const Folder folder("m.off", pyramid_off);
    const auto r = nlohmann::json::parse(folder.meshtopo("m.off --json").out);
    CHECK(r["volume"] == doctest::Approx(1.0 / 3).epsilon(1e-15));
    CHECK(r["area"] == doctest::Approx(1 + std::sqrt(5.0)).epsilon(1e-15));
    CHECK(r["box"] == nlohmann::json::parse("[[0, 0, 0], [1, 1, 1]]"));
    CHECK(contains(folder.meshtopo("m.off").out,
                   "area               3.23606798\nvolume             0.333333333\n"
                   "box                x 0 .. 1\n                   y 0 .. 1\n"
                   "                   z 0 .. 1\n"));
    std::string turned = pyramid_off;
    turned.replace(turned.find("3 0 1 4"), 7, "3 4 1 0");
    folder.file("turned.off", turned);
    CHECK(nlohmann::json::parse(folder.meshtopo("turned.off --json").out)["volume"] == nullptr);
    folder.file("open.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n0 2 0\n7 8 9\n3 0 1 2\n");
    const auto open = nlohmann::json::parse(folder.meshtopo("open.off --json").out);
    CHECK(open["volume"] == nullptr);
    CHECK(open["area"] == 2);
    CHECK(open["box"] == nlohmann::json::parse("[[0, 0, 0], [7, 8, 9]]"));
    // Far from the origin the volume is as exact as the coordinates.
    folder.file("far.obj",
                "v 500000 4649000 0\nv 500001 4649000 0\nv 500000 4649001 0\nv 500000 4649000 1\nf 1 3 2\nf 1 2 4\nf 1 "
                "4 3\nf 2 3 4\n");
    CHECK(nlohmann::json::parse(folder.meshtopo("far.obj --json").out)["volume"] ==
          doctest::Approx(1.0 / 6).epsilon(1e-15));
  }

  TEST_CASE("every format gives the same report, from a file and from standard input") {
    const Folder folder({{"m.off", pyramid_off},
                         {"m.obj", pyramid_obj},
                         {"m.ply", pyramid_ply},
                         {"little.ply", ply_binary(std::endian::little)},
                         {"big.PLY", ply_binary(std::endian::big)}});
    const std::string expected = folder.meshtopo("m.off").out;
    CHECK(expected.find("vertices") == 0);
    for (const char* name : {"m.obj", "m.ply", "little.ply", "big.PLY"}) CHECK(folder.meshtopo(name).out == expected);
    for (const char* format : {"off", "obj", "ply"})
      CHECK(folder.meshtopo(std::string("- --format ") + format + " <m." + format).out == expected);
    // STL has triangles only, in the order of their corners.
    folder.file("text.stl", stl_text(pyramid_triangles));
    folder.file("binary.stl", stl_binary(pyramid_triangles));
    const json r = report_of(folder, "text.stl");
    CHECK(r == report_of(folder, "binary.stl"));
    CHECK(r["vertices"] == 5);
    CHECK(r["edges"] == 9);
    CHECK(r["faces"] == 6);
    CHECK(r["euler"] == 2);
    CHECK(r["genus"] == 0);
    CHECK(r["defects"].empty());
  }

  TEST_CASE("defects are listed with vertices, faces and lines of the file") {
    const json r = report_of_text(broken);
    std::map<std::string, json> where;
    for (const json& defect : r["defects"]) where[defect["kind"]] = defect["where"];
    CHECK(where["degenerate_face"] ==
          json::parse(R"({"vertices": [7, 7, 6], "faces": [4], "vertex_lines": [10, 10, 9], "face_lines": [17]})"));
    CHECK(where["duplicate_face"]["faces"] == json::array({0, 3}));
    CHECK(where["duplicate_face"]["face_lines"] == json::array({13, 16}));
    CHECK(where["non_manifold_edge"]["vertices"] == json::array({0, 1}));
    CHECK(where["non_manifold_edge"]["faces"] == json::array({0, 1, 2}));
    CHECK(where["pinch"]["vertices"] == json::array({5}));
    CHECK(where["pinch"]["vertex_lines"] == json::array({8}));
    CHECK(r["pinches"].get<int>() >= 1);
    CHECK(r["components"] == 2);
    CHECK(r["genus"].is_null());
  }

  TEST_CASE("binary files name elements and no lines") {
    const Folder folder("m.stl", stl_binary({{0, 1, 4}, {0, 1, 4}}));
    const json r = report_of(folder, "m.stl");
    REQUIRE(r["defects"].size() == 1);
    CHECK(r["defects"][0] ==
          json::parse(R"({"kind": "duplicate_face", "where": {"vertices": [0, 1, 2], "faces": [0, 1]}})"));
  }

  TEST_CASE("a surface without sides has no genus") {
    const json r = report_of_text(moebius);
    CHECK(r["genus"].is_null());
    CHECK(r["euler"] == 0);
    CHECK(r["boundary_curves"] == 1);
    CHECK(r["betti"] == json::array({1, 1, 0}));
    CHECK(r["per_component"][0]["orientable"] == false);
  }

  TEST_CASE("the report for people says why there is no genus") {
    const Folder folder;
    folder.file("band.off", moebius);
    folder.file("book.off", broken);
    folder.file("both.off",
                "OFF\n6 7 0\n0 0 0\n1 0 0\n2 0 1\n3 1 0\n4 0 0\n5 5 5\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n"
                "3 4 0 1\n3 0 1 5\n3 0 2 5\n");
    const auto genus = [&](const std::string& name) { return row("genus", folder.meshtopo(name).out); };
    CHECK(genus("band.off") == "not orientable");
    CHECK(genus("book.off") == "not a manifold");
    folder.file("pieces.off", moebius.substr(0, 4) +
                                  "8 6 0\n0 0 0\n1 0 0\n2 0 1\n3 1 0\n4 0 0\n5 0 0\n6 0 1\n7 1 0\n"
                                  "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n3 5 6 7\n");
    CHECK(genus("pieces.off") == "not orientable");
    // In the table of pieces one has a genus, and the other has none.
    const std::string table = folder.meshtopo("pieces.off").out;
    CHECK(table.find("not orientable\n") != table.rfind("not orientable\n"));
    CHECK(contains(table, " 1               0\n"));
  }

  TEST_CASE("faces without area are found exactly") {
    const json r = report_of_text(
        "OFF\n9 5 0\n0 0 0\n1 1 1\n3 3 3\n3 3 3.0000000000000004\n0.1 0.1 0.1\n0.2 0.2 0.2\n0.30000000000000004 "
        "0.30000000000000004 0.30000000000000004\n0.3 0.3 0.3\n5 5 5\n"
        "3 0 1 2\n3 0 1 3\n3 4 5 6\n4 0 1 2 8\n3 0 1 1\n");
    json zero;
    for (const json& defect : r["geometric_defects"])
      if (defect["kind"] == "zero_area_face") zero.push_back(defect["where"]);
    REQUIRE(zero.size() == 3);
    CHECK(zero[0] == json::parse(R"({"vertices": [0, 1, 2], "faces": [0], "vertex_lines": [3, 4, 5],
                                    "face_lines": [12]})"));
    CHECK(zero[1]["faces"] == json::array({2}));  // on the diagonal, whatever the last bits are
    CHECK(zero[2]["faces"] == json::array({3}));  // not the last one, which is degenerate without looking at it
  }

  TEST_CASE("faces without area at the ends of double are found, and those with very little are not") {
    const json r = report_of_text(
        "OFF\n9 5 0\n-1.7e308 -1.7e308 0\n0 0 0\n1.7e308 1.7e308 0\n1.7e308 1.6999999999999e308 0\n"
        "5e-324 0 0\n0 5e-324 0\n1e-324 0 1e-320\n0 0 2e-320\n0 0 3e-320\n"
        "3 0 1 2\n3 0 1 3\n3 1 4 5\n3 1 7 8\n3 4 7 8\n");
    std::vector<int> zero;
    for (const json& defect : r["geometric_defects"])
      if (defect["kind"] == "zero_area_face") zero.push_back(defect["where"]["faces"][0]);
    CHECK(zero == std::vector<int>{0, 3});
  }

  TEST_CASE("vertices at one place are found exactly") {
    const json r = report_of_text(
        "OFF\n8 1 0\n1 2 3\n0 0 0\n1 2 3.0000000000000004\n-0 0 -0\n1 2 3\n9 9 9\n1 2 3\n0 0 5e-324\n3 0 1 5\n");
    REQUIRE(r["geometric_defects"].size() == 2);
    CHECK(r["geometric_defects"][0] ==
          json::parse(R"({"kind": "coincident_vertices", "where": {"vertices": [0, 4, 6], "faces": [],
                          "vertex_lines": [3, 7, 9], "face_lines": []}})"));
    CHECK(r["geometric_defects"][1]["where"]["vertices"] == json::array({1, 3}));
    CHECK(r["defects"].empty());
  }

  TEST_CASE("defects of geometry are counted and listed for people, up to the limit for those of topology") {
    const Folder folder;
    std::string content = "OFF\n60 0 0\n";
    for (int i = 0; i < 60; ++i) content += std::to_string(i / 2) + " 0 0\n";
    folder.file("m.off", content);
    const std::string text = folder.meshtopo("m.off --max-defects 2").out;
    CHECK(row("geometric defects", text) == "30");
    CHECK(
        text.ends_with("\n\ngeometric defects\n  coincident vertices: vertices 0 1, lines 3 4\n"
                       "  coincident vertices: vertices 2 3, lines 5 6\n  ... and 28 more\n"));
    CHECK(report_of(folder, "m.off --max-defects 2")["geometric_defects"].size() == 30);
    folder.file("m.off", pyramid_off);
    CHECK(row("geometric defects", folder.meshtopo("m.off").out) == "0");
    CHECK(report_of(folder, "m.off")["geometric_defects"].empty());
  }

  TEST_CASE("isolated vertices, pieces, and a mesh without faces are reported") {
    const json r =
        report_of_text("OFF\n8 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n7 7 7\n8 8 8\n3 0 1 2\n3 3 4 5\n");
    CHECK(r["isolated"] == 2);
    CHECK(r["components"] == 4);
    CHECK(r["per_component"].size() == 2);
    CHECK(r["per_component"][1]["first_face"] == 1);
    CHECK(r["betti"] == json::array({4, 0, 0}));
    const json none = report_of_text("OFF\n2 0 0\n0 0 0\n1 1 1\n");
    CHECK(none["components"] == 2);
    CHECK(none["faces"] == 0);
    CHECK(report_of_text("OFF\n0 0 0\n")["components"] == 0);
  }

  TEST_CASE("the report for people lists defects up to a limit, and counts the rest") {
    const Folder folder;
    std::string content = "OFF\n3 30 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (int i = 0; i < 30; ++i) content += "3 0 1 2\n";
    folder.file("m.off", content);
    const auto named = [&](const std::string& options) {
      const std::string text = folder.meshtopo("m.off " + options).out;
      CAPTURE(text);
      std::size_t count = 0;
      for (auto at = text.find(": vertices 0 1 2"); at != std::string::npos; at = text.find(": vertices", at + 1))
        ++count;
      CHECK(contains(text, std::to_string(29 - count) + " more\n") == (count < 29));
      return count;
    };
    CHECK(named("") == 20);
    CHECK(named("--max-defects 3") == 3);
    CHECK(named("--max-defects 0") == 0);
    CHECK(named("--max-defects 100") == 29);
    CHECK(contains(folder.meshtopo("m.off --max-defects 1").out, ": vertices 0 1 2, faces 0 1, lines 6 7\n"));
    CHECK(report_of(folder, "m.off --max-defects 1")["defects"].size() == 29);
  }

  TEST_CASE("the report for people has the first few of many numbers, JSON all") {
    std::string content = "OFF\n22 20 0\n0 0 0\n1 0 0\n";
    for (int i = 2; i < 22; ++i) content += "0 1 " + std::to_string(i) + "\n";
    for (int i = 2; i < 22; ++i) content += "3 0 1 " + std::to_string(i) + "\n";
    const Folder folder("m.off", content);
    CHECK(contains(
        folder.meshtopo("m.off").out,
        "non-manifold edge: vertices 0 1, faces 0 1 2 3 4 5 6 7 ... (20), lines 25 26 27 28 29 30 31 32 ... (20)\n"));
    CHECK(report_of(folder, "m.off")["defects"][0]["where"]["faces"].size() == 20);
  }

  TEST_CASE("the report goes where it is sent, and nowhere when quiet") {
    const Folder folder("m.off", pyramid_off);
    const std::string text = folder.meshtopo("m.off").out, report = folder.meshtopo("m.off --json").out;
    CHECK(folder.meshtopo("m.off -o r.txt").out.empty());
    CHECK(folder.content("r.txt") == text);
    CHECK(folder.meshtopo("m.off --json -q -o r.json").out.empty());
    CHECK(folder.content("r.json") == report);
    // The ending chooses the report, as --json does.
    CHECK(folder.meshtopo("m.off -o e.JSON -q").code == 0);
    CHECK(folder.content("e.JSON") == report);
    CHECK(folder.meshtopo("m.off --json -o r.log").code == 0);
    CHECK(folder.content("r.log") == report);
    CHECK(folder.meshtopo("m.off -o report").code == 0);
    CHECK(folder.content("report") == text);
    CHECK(folder.meshtopo("m.off -o -").out == text);
    CHECK(folder.meshtopo("m.off -o - --json -q").out == report);
    CHECK(folder.meshtopo("m.off --json -q").out == report);
    CHECK(folder.meshtopo("m.off -q").out.empty());
  }
}

TEST_SUITE("meshtopo --repair") {
  TEST_CASE("--repair OUT names its file as --generators OUT does, and all spellings write the same") {
    const Folder folder("m.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 2\n3 0 1 3\n");
    REQUIRE(folder.meshtopo("m.off --repair a.off --generators l.obj -o r.json").code == 0);
    CHECK(json::parse(folder.content("r.json"))["repair"].size() > 0);
    REQUIRE(folder.meshtopo("m.off --repair=b.off -q").code == 0);
    REQUIRE(folder.meshtopo("m.off --repair -o c.off -q").code == 0);
    REQUIRE(folder.meshtopo("m.off -o d.off --repair -q").code == 0);
    REQUIRE(folder.meshtopo("--repair m.off -o e.off -q").code ==
            0);  // the mesh follows the flag, as in older versions
    REQUIRE(folder.meshtopo("--repair f.off m.off -q").code == 0);
    for (const std::string name : {"b", "c", "d", "e", "f"})
      CHECK(folder.content(name + ".off") == folder.content("a.off"));
    CHECK(folder.meshtopo("m.off --repair - --output-format off -q").out == folder.content("a.off"));
    CHECK(folder.meshtopo("--repair m.off").code == 2);
  }

  TEST_CASE("a repaired mesh is free of defects, and the steps are reported") {
    for (const std::string& content : {broken, moebius})
      for (const std::string ending : {"off", "ply", "obj"}) {
        CAPTURE(ending);
        const Folder folder("m.off", content);
        const json before = report_of(folder, "m.off --repair -o r." + ending);
        CHECK_FALSE(before["defects"].empty());
        CHECK_FALSE(before["repair"].empty());
        for (const json& step : before["repair"]) CHECK(step["where"].contains("faces"));
        const json after = report_of(folder, "r." + ending + " --repair -o again." + ending);
        CHECK(after["defects"].empty());
        CHECK(after["repair"].empty());
        CHECK(after["genus"].is_number());
        CHECK(folder.content("again." + ending) == folder.content("r." + ending));
      }
  }

  TEST_CASE("a mesh without defects is written unchanged") {
    const Folder folder;
    const std::string path = (rbpa_test::bundled_data() / "m3_bob.off").string();
    REQUIRE(folder.meshtopo("'" + path + "' --repair -o bob.ply -q").code == 0);
    const auto given = rbpa::app::read_mesh({path, rbpa::app::Format::off});
    const auto written = rbpa::app::read_mesh({folder.path("bob.ply"), rbpa::app::Format::ply});
    CHECK(given.positions == written.positions);
    CHECK(given.soup.corners == written.soup.corners);
    CHECK(given.soup.begin == written.soup.begin);
  }

  TEST_CASE("the format is that of the ending of OUT, or of --output-format") {
    const Folder folder("m.off", pyramid_off);
    REQUIRE(folder.meshtopo("m.off --repair -o a.obj --output-format off -q").code == 0);
    REQUIRE(folder.meshtopo("m.off --repair -o b --output-format off -q").code == 0);
    CHECK(folder.content("a.obj") == pyramid_obj);
    CHECK(folder.content("b") == pyramid_off);
  }

  TEST_CASE("new points are where the old ones were") {
    const Folder folder("m.off", broken);
    const Outcome outcome = folder.meshtopo("m.off --repair -o - --output-format off -q", 0);
    folder.file("r.off", outcome.out);
    const auto given = rbpa::app::read_mesh({folder.path("m.off"), rbpa::app::Format::off});
    const auto written = rbpa::app::read_mesh({folder.path("r.off"), rbpa::app::Format::off});
    REQUIRE(written.positions.size() > given.positions.size());
    const std::set<std::array<double, 3>> places(given.positions.begin(), given.positions.end());
    for (std::size_t i = 0; i < written.positions.size(); ++i)
      CHECK((i < given.positions.size() ? written.positions[i] == given.positions[i]
                                        : places.contains(written.positions[i])));
  }
}

TEST_SUITE("meshtopo --generators") {
  TEST_CASE("loops are closed polylines along edges of the mesh") {
    const Folder folder;
    const std::string path = (rbpa_test::bundled_data() / "m3_plate_holes.off").string();
    REQUIRE(folder.meshtopo("'" + path + "' --generators l.obj -q").code == 0);
    REQUIRE(folder.meshtopo("'" + path + "' --generators l.json -q").code == 0);
    const auto mesh = rbpa::app::read_mesh({path, rbpa::app::Format::off});
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (std::size_t f = 0; f < mesh.soup.faces(); ++f) {
      const auto face = mesh.soup.face(f);
      for (std::size_t k = 0; k < face.size(); ++k) sides.insert({face[k], face[(k + 1) % face.size()]});
    }
    std::string lines, kind;
    const json loops = json::parse(folder.content("l.json"));
    REQUIRE(loops.size() == 10);
    for (const json& loop : loops) {
      if (loop["kind"] != kind) lines += "g " + (kind = loop["kind"]) + "\n";
      const auto vertices = loop["vertices"].get<std::vector<std::uint32_t>>();
      REQUIRE(vertices.size() >= 3);
      REQUIRE(loop["positions"].size() == vertices.size());
      lines += "l";
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        CHECK(sides.contains({vertices[i], vertices[(i + 1) % vertices.size()]}));
        CHECK(loop["positions"][i].get<std::array<double, 3>>() == mesh.positions[vertices[i]]);
        lines.append(" ").append(std::to_string(vertices[i] + 1));
      }
      lines.append(" ").append(std::to_string(vertices[0] + 1)).append("\n");
    }
    const std::string obj = folder.content("l.obj");
    CHECK(obj.substr(obj.find("g ")) == lines);
  }

  TEST_CASE("five of the shortest loops of a plate with five holes go around handles, five through tunnels") {
    const Folder folder;
    const std::string path = (rbpa_test::bundled_data() / "m3_plate_holes.off").string();
    REQUIRE(folder.meshtopo("'" + path + "' --generators l.json --shortest -q").code == 0);
    std::map<std::string, int> kinds;
    for (const json& loop : json::parse(folder.content("l.json"))) ++kinds[loop["kind"].get<std::string>()];
    CHECK(kinds == std::map<std::string, int>{{"handle", 5}, {"tunnel", 5}});
    folder.file("open.off", "OFF\n6 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n");
    REQUIRE(folder.meshtopo("open.off --generators l.json -q").code == 0);
    CHECK(json::parse(folder.content("l.json"))[0]["kind"] == "unknown");
  }

  TEST_CASE("a mesh that is not a surface is refused, and its repair is taken instead") {
    const Folder folder("m.off", broken);
    meshtopo_refuses(folder, "m.off --generators l.obj", 3,
                     "m.off: found degenerate face (vertices 7 7 6, face 4, line 17), expected a surface, as "
                     "--generators requires (--repair makes one, or rbpa surface --manifold)");
    CHECK(folder.names().size() == 1);
    CHECK(folder.meshtopo("m.off --repair -o r.off --generators l.obj -q").code == 0);
    CHECK(folder.has("l.obj"));
  }

  TEST_CASE("coordinates at the ends of double are read and reported") {
    const Folder folder;
    // A triangular prism without its ends.
    folder.file("m.off",
                "OFF\n6 3 0\n-1.7e308 -1.7e308 0\n1.7e308 -1.7e308 0\n0 1.7e308 0\n-1.7e308 -1.7e308 5e-324\n"
                "1.7e308 -1.7e308 5e-324\n0 1.7e308 1.7e308\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n");
    CHECK(folder.meshtopo("m.off --generators l.json -q").code == 0);
    CHECK(json::parse(folder.content("l.json")).size() == 1);
  }

  TEST_CASE("no loop is an answer") {
    const Folder folder("m.off", pyramid_off);
    CHECK(folder.meshtopo("m.off --generators l.json -q").code == 0);
    CHECK(json::parse(folder.content("l.json")) == json::array());
  }
}
