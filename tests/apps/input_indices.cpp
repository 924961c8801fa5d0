// Indices in files are positions in the input, also if --where and --skip-invalid leave out points.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "support/npy_file.h"
#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Writes the points of a perturbed grid, some of which do not count: a file of all, and one of those that count.
struct Points {
  std::string all, kept;
  std::vector<std::uint32_t> index;  // of the kept points
};

enum class Kind { where, invalid, ply };

Points points_of(Kind kind) {
  std::mt19937 random(7);
  Points made;
  std::string rows, kept_rows;
  std::uint32_t number = 0;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z) {
        const auto moved = [&](int at) { return std::to_string(at + static_cast<int>(random() % 100) / 400.0); };
        const std::string place = moved(x) + " " + moved(y) + " " + moved(z);
        const bool is_kept = random() % 4 != 0;
        const bool is_bad = kind == Kind::invalid && !is_kept;
        rows += is_bad ? "NA 0 0 0\n" : place + (is_kept ? " 1\n" : " 0\n");
        if (is_kept) kept_rows += place + " 1\n";
        if (is_kept) made.index.push_back(number);
        ++number;
      }
  const auto header = [&](std::size_t count) {
    return kind != Kind::ply
               ? std::string("x y z keep\n")
               : "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
                     "\nproperty double x\nproperty double y\nproperty double z\nproperty int keep\nend_header\n";
  };
  made.all = header(number) + rows;
  made.kept = header(made.index.size()) + kept_rows;
  return made;
}

template <typename Row>
std::vector<Row> renumbered(std::vector<Row> rows, const std::vector<std::uint32_t>& index) {
  for (Row& row : rows)
    for (std::uint32_t& corner : row) corner = index[corner];
  return rows;
}

json numbered(json all, const std::vector<std::uint32_t>& index) {
  if (all.is_number_integer()) return index[all.get<std::size_t>()];
  for (json& item : all) item = numbered(item, index);
  return all;
}

}  // namespace

TEST_SUITE("input_indices") {
  TEST_CASE("arrays, lists and tables have positions in the file") {
    for (const Kind kind : {Kind::where, Kind::invalid, Kind::ply}) {
      CAPTURE(static_cast<int>(kind));
      const Points points = points_of(kind);
      const Folder folder;
      const std::string ending = kind == Kind::ply ? ".ply" : ".csv";
      const std::string some = kind == Kind::invalid ? " --skip-invalid -q" : " --where \"keep == 1\" -q";
      folder.file("all" + ending, points.all);
      folder.file("kept" + ending, points.kept);
      const auto check_rows = [&](auto row, const std::string& name) {
        using Row = decltype(row);
        const std::vector<Row> kept = npy_rows<Row>(folder.content("kept_out." + name));
        CHECK(!kept.empty());
        CHECK(npy_rows<Row>(folder.content("all_out." + name)) == renumbered(kept, points.index));
      };
      using Three = std::array<std::uint32_t, 3>;
      using Four = std::array<std::uint32_t, 4>;
      const auto json_of = [&](const std::string& name) { return json::parse(folder.content(name)); };
      const auto run_all = [&](const std::string& verb, const std::string& options,
                               const std::vector<std::string>& names) {
        for (const bool is_all : {true, false}) {
          std::string line = verb + (is_all ? " all" : " kept") + ending + " " + options + (is_all ? some : " -q");
          for (const std::string& name : names) {
            const std::size_t at = line.find('@');
            line.replace(at, 1, (is_all ? "all_out." : "kept_out.") + name);
          }
          folder.rbpa(line, 0);
        }
      };
      run_all("solid", "--alpha 0.95 -o @ --boundary @ --voids @ --pockets @",
              {"npy", "skin.npy", "voids.json", "pockets.json"});
      check_rows(Four{}, "npy");
      check_rows(Three{}, "skin.npy");
      const json voids = json_of("all_out.voids.json"), kept_voids = json_of("kept_out.voids.json");
      CHECK(!voids.empty());
      for (std::size_t i = 0; i < voids.size(); ++i)
        for (const char* what : {"points", "triangles"})
          CHECK(voids[i][what] == numbered(kept_voids[i][what], points.index));
      const json pockets = json_of("all_out.pockets.json"), kept_pockets = json_of("kept_out.pockets.json");
      CHECK(!pockets.empty());
      for (std::size_t i = 0; i < pockets.size(); ++i)
        CHECK(pockets[i]["mouth"] == numbered(kept_pockets[i]["mouth"], points.index));
      run_all("solid", "--alpha 0.95 --box 5 -o @ --voids @", {"npy", "voids.json"});
      check_rows(Four{}, "npy");
      CHECK(json_of("all_out.voids.json")[0]["points"] ==
            numbered(json_of("kept_out.voids.json")[0]["points"], points.index));
      run_all("surface", "--normals none --radius 0.8 -o @", {"npy"});
      check_rows(Three{}, "npy");
      run_all("mesh", "--alpha 0.4 --complex full -o @", {"npy"});
      check_rows(Three{}, "npy");
      check_rows(std::array<std::uint32_t, 2>{}, "edges.npy");
      run_all("shape", "--alpha 0.1 --isolated @ -o /dev/null --output-format wkt", {"csv"});
      const auto indices = [&](const std::string& name) {
        std::vector<std::uint32_t> found;
        const std::string text = folder.content(name);
        for (std::size_t at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at + 1)) {
          const std::size_t end = text.find('\n', at + 1), comma = text.rfind(',', end);
          found.push_back(static_cast<std::uint32_t>(std::stoul(text.substr(comma + 1))));
        }
        return found;
      };
      std::vector<std::uint32_t> isolated = indices("kept_out.csv");
      CHECK(!isolated.empty());
      for (std::uint32_t& i : isolated) i = points.index[i];
      CHECK(indices("all_out.csv") == isolated);
      run_all("alpha", "--dimension 3 --representatives @ --top 5", {"cycles.json"});
      const json cycles = json_of("all_out.cycles.json"), kept_cycles = json_of("kept_out.cycles.json");
      CHECK(!cycles.empty());
      for (std::size_t i = 0; i < cycles.size(); ++i)
        for (const char* what : {"edges", "triangles"})
          if (cycles[i].contains(what)) CHECK(cycles[i][what] == numbered(kept_cycles[i][what], points.index));
    }
  }

  TEST_CASE("the points around a void have the names of the molecule's file") {
    std::string text;
    int serial = 10;
    const auto add = [&](const std::string& element, int x, int y, int z) {
      char line[96];
      std::snprintf(line, sizeof line, "ATOM  %5d  %-3s LYS B%4d%c   %8.3f%8.3f%8.3f  1.00  0.00          %2s\n",
                    ++serial, element.c_str(), 100 + x, y == 2 ? 'A' : ' ', 1.0 * x, 1.0 * y, 1.0 * z, element.c_str());
      text += line;
    };
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z) {
          add("H", x, y, z);  // which do not count
          if (x != 1 || y != 1 || z != 1) add("C", x, y, z);
        }
    const Folder folder("m.pdb", text);
    const std::string solid = "solid m.pdb --alpha 0.9 --where \"element != 'H'\" -q ";
    const Outcome outcome = folder.rbpa(solid + "--voids v.json --json", 0);
    const json voids = json::parse(folder.content("v.json"));
    REQUIRE(voids.size() == 1);
    CHECK(json::parse(outcome.out)["void_list"][0]["atoms"] == voids[0]["atoms"]);
    REQUIRE(voids[0]["points"].size() == 6);
    const json first = json::parse(R"({"serial": 20, "chain": "B", "resseq": 100, "icode": null, "resname": "LYS",
                                       "name": "C", "element": "C", "x": 0, "y": 1, "z": 1})");
    CHECK(voids[0]["atoms"][0] == first);
    for (std::size_t i = 0; i < 6; ++i) {
      const json& atom = voids[0]["atoms"][i];
      CHECK(atom["serial"].get<int>() == voids[0]["points"][i].get<int>() + 11);
      CHECK(atom["resseq"] == 100 + atom["x"].get<int>());
      CHECK((atom["icode"] == "A") == (atom["y"] == 2));
      const std::array<double, 3> at = {atom["x"], atom["y"], atom["z"]};
      CHECK(std::count(at.begin(), at.end(), 1.0) == 2);
    }
    CHECK(folder.rbpa("solid m.pdb --alpha 0.86 --where \"element != 'H'\" -q --pockets p.csv").code == 0);
    CHECK(folder.content("p.csv").starts_with(
        "number,volume_between_points,closes,filled,depth,mouth_a,mouth_b,mouth_c,serial_a,serial_b,serial_c\n"));
    folder.file("t.csv", "x,y,z,name,serial\n0,0,0,p,7\n1,0,0,q,8\n0,1,0,r,x9\n0,0,1,s,\n");
    CHECK(folder.rbpa("solid t.csv --alpha inf --voids t.json -q").code == 0);
    folder.file("t.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");  // without names
    CHECK(folder.rbpa("solid t.xyz --alpha inf --voids t.json -q").code == 0);
  }
}
