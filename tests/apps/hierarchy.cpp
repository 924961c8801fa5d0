// `--method hrbpa` and `--levels`: the same files, the report of levels, wrong usage.
#include <doctest/doctest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/vtu_arrays.h"

using namespace apps_test;
using nlohmann::json;

namespace {

const std::string data = "'" RBPA_TEST_DATA "/shape_hdbscan_clusterable.xy' ";

const std::vector<std::string> counts = {"triangles", "solid_components", "components", "holes", "boundary_curves"};

void refuses(const std::string& arguments, const std::string& message) {
  const Folder folder("p.xy", corner);
  refuses(folder, arguments, 2, message);
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

}  // namespace

TEST_SUITE("hierarchy") {
  TEST_CASE("the bytes do not depend on the method, whatever the leaves hold") {
    for (const std::string alpha : {"0.005", "0.02", "inf"}) {
      const Folder folder;
      const auto run = [&](const std::string& name, const std::string& method) {
        std::string mesh = "mesh " + data + "--alpha " + alpha + " -q" + method;
        for (const char* ending : {".off", ".ply", ".obj", ".npy", ".svg", ".png"}) mesh += " -o " + name + ending;
        REQUIRE(folder.rbpa(mesh).code == 0);
        REQUIRE(
            folder.rbpa("shape " + data + "--alpha " + alpha + " -q -o " + name + ".wkt -o " + name + ".json" + method)
                .code == 0);
      };
      run("direct", " --method rbpa");
      for (const char* method : {"", " --leaf-capacity 1", " --leaf-capacity 7", " --leaf-capacity 100000"}) {
        run("levels", std::string(" --method hrbpa") + method);
        for (const char* ending : {".off", ".ply", ".obj", ".npy", ".svg", ".png", ".wkt", ".json"}) {
          CAPTURE(ending);
          CAPTURE(alpha);
          CAPTURE(method);
          CHECK(folder.content(std::string("direct") + ending).size() > 20);
          CHECK(folder.content(std::string("direct") + ending) == folder.content(std::string("levels") + ending));
        }
      }
    }
  }

  TEST_CASE("every triangle of a .vtu has the number of its level, also with --levels and by the paper's search") {
    const Folder folder;
    const std::string run = "mesh " + data + "--alpha 0.05 --method hrbpa -q --leaf-capacity 9 ";
    REQUIRE(folder.rbpa(run + "-o arrays.vtu").code == 0);
    REQUIRE(folder.rbpa(run + "-o mesh.vtu --levels l.json").code == 0);
    REQUIRE(folder.rbpa(run + "-o paper.vtu --search paper").code == 0);
    REQUIRE(folder.rbpa(run + "-o compact.vtu --compact").code == 0);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.05 -q -o plain.vtu").code == 0);
    CHECK(folder.content("arrays.vtu") == folder.content("mesh.vtu"));
    CHECK(folder.content("arrays.vtu") == folder.content("paper.vtu"));
    CHECK(!contains(folder.content("plain.vtu"), "level"));
    const json report = json::parse(folder.content("l.json"));
    std::vector<std::size_t> of_level;
    for (const char* name : {"arrays.vtu", "compact.vtu"}) {
      CAPTURE(name);
      const std::vector<std::uint16_t> levels = array_of<std::uint16_t>(folder.content(name), "level");
      of_level.assign(100, 0);
      for (const std::uint16_t level : levels) ++of_level.at(level);
      std::size_t sum = 0;
      for (const json& level : report["levels"]) {
        const auto number = level["level"].get<std::size_t>();
        CHECK(level["triangles_added"] == of_level.at(number));
        sum += of_level.at(number);
      }
      CHECK(sum == levels.size());
    }
  }

  TEST_CASE("the paper's own search changes no bytes, and of a level only which points took part") {
    const Folder folder;
    for (const std::string alpha : {"0.02", "inf"}) {
      CAPTURE(alpha);
      const std::string run = "mesh " + data + "--alpha " + alpha + " --method hrbpa -q --leaf-capacity 9 --search ";
      REQUIRE(folder.rbpa(run + "near -o near.off -o near.npy --levels near.json").code == 0);
      REQUIRE(folder.rbpa(run + "paper -o paper.off -o paper.npy --levels paper.json").code == 0);
      CHECK(folder.content("near.off") == folder.content("paper.off"));
      CHECK(folder.content("near.npy") == folder.content("paper.npy"));
      const json near = json::parse(folder.content("near.json")), paper = json::parse(folder.content("paper.json"));
      CHECK(near["least_radius"] == paper["least_radius"]);
      REQUIRE(near["levels"].size() == paper["levels"].size());
      for (std::size_t i = 0; i < near["levels"].size(); ++i)
        for (const auto& [key, value] : near["levels"][i].items()) {
          const json& other = paper["levels"][i][key];
          if (key == "taking_part")
            CHECK(other == paper["levels"][i]["transferred"]);
          else if (key != "seconds")
            CHECK(other == value);
        }
    }
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --method hrbpa --search paper --levels l.json -q").code == 0);
    CHECK(json::parse(folder.content("l.json"))["leaf_capacity"] == 32);
    REQUIRE(folder.rbpa("mesh " + data + "--alpha 0.02 --method hrbpa --levels l.json -q").code == 0);
    CHECK(json::parse(folder.content("l.json"))["leaf_capacity"] == 16384);
  }

  TEST_CASE("the topology of a level is that of a run at its radius, and that of the last is that of the whole run") {
    const Folder folder;
    REQUIRE(folder
                .rbpa("mesh " + data +
                      "--alpha 0.05 --method hrbpa --leaf-capacity 4 --levels l.json --stats s.json -o m.off -q")
                .code == 0);
    const json report = json::parse(folder.content("l.json"));
    CHECK(report["leaf_capacity"] == 4);
    const json& levels = report["levels"];
    REQUIRE(levels.size() > 3);
    CHECK(levels[0]["alpha"] == report["least_radius"]);
    long triangles = 0;
    for (const json& level : levels) {
      REQUIRE(folder.rbpa("mesh " + data + "--alpha " + level["alpha"].dump() + " --stats d.json -q").code == 0);
      const json direct = json::parse(folder.content("d.json"));
      for (const std::string& key : counts) CHECK(level[key] == direct[key]);
      CHECK(level["covered"] == direct["vertices"]);
      CHECK(direct["method"] == "rbpa");
      triangles += level["triangles_added"].get<long>();
      CHECK(triangles == level["triangles"]);
      CHECK(level["taking_part"] <= level["transferred"]);
      CHECK(level["seconds"] >= 0.0);
    }
    const json stats = json::parse(folder.content("s.json"));
    CHECK(stats["method"] == "hrbpa");
    CHECK(levels.back()["alpha"] == 0.05);
    for (const std::string& key : counts) CHECK(levels.back()[key] == stats[key]);
  }

  TEST_CASE("csv has the keys of json as its first line, and the same values except the times") {
    const Folder folder;
    const std::string run = "mesh " + data + "--alpha inf --method hrbpa --leaf-capacity 20 -q --levels ";
    const Outcome csv = folder.rbpa(run + "-", 0);
    REQUIRE(folder.rbpa(run + "l.JSON").code == 0);
    const json levels = nlohmann::json::parse(folder.content("l.JSON"))["levels"];
    const auto rows = rows_of(csv.out);
    REQUIRE(rows.size() == levels.size() + 1);
    CHECK(rows[0] == std::vector<std::string>{"level", "alpha", "transferred", "taking_part", "advancing",
                                              "triangles_added", "triangles", "solid_components", "components", "holes",
                                              "boundary_curves", "covered", "seconds"});
    for (std::size_t i = 0; i < levels.size(); ++i) {
      REQUIRE(rows[i + 1].size() == rows[0].size());
      REQUIRE(levels[i].size() == rows[0].size());
      for (std::size_t k = 0; k + 1 < rows[0].size(); ++k) {
        const json& value = levels[i][rows[0][k]];
        if (value.is_string())
          CHECK(rows[i + 1][k] == value.get<std::string>());
        else
          CHECK(std::stod(rows[i + 1][k]) == value.get<double>());
      }
    }
    CHECK(rows.back()[1] == "inf");
  }

  TEST_CASE("two triangles far apart have the levels computed by hand") {
    const Folder folder("p.xy", "0 0\n1 0\n0 1\n100 0\n140 0\n100 30\n0 0\n");
    const Outcome outcome = folder.rbpa("mesh p.xy --alpha 25 --method hrbpa --leaf-capacity 3 --levels - -q", 0);
    const auto rows = rows_of(outcome.out);
    REQUIRE(rows.size() >= 2);
    const std::vector<std::string>& last = rows.back();
    CHECK(std::vector(last.begin() + 6, last.end() - 1) == std::vector<std::string>{"2", "2", "2", "0", "2", "6"});
    CHECK(rows[1][2] == "6");  // distinct points; the first level takes all
    CHECK(rows[1][3] == "6");
  }

  TEST_CASE("without triangles there are no levels") {
    const Folder folder("p.xy", "0 0\n1 1\n2 2\n");
    const Outcome csv = folder.rbpa("mesh p.xy --alpha 1 --method hrbpa --levels - -q", 0);
    CHECK(rows_of(csv.out).size() == 1);
    CHECK(csv.err == "rbpa: the complex is empty: all points are collinear\n");
    REQUIRE(folder.rbpa("mesh p.xy --alpha 1 --method hrbpa --levels l.json -q").code == 0);
    CHECK(json::parse(folder.content("l.json"))["levels"].empty());
  }

  TEST_CASE("wrong usage is refused before anything is read") {
    refuses("mesh p.xy --alpha 1 --method hbpa -o m.off", "--method: found 'hbpa', expected rbpa or hrbpa");
    refuses("shape p.xy --alpha 1 --method hbpa -o m.wkt", "--method: found 'hbpa', expected rbpa or hrbpa");
    for (const char* method : {"", " --method rbpa"})
      refuses(std::string("mesh p.xy --alpha 1 --levels l.csv") + method, "--levels requires --method hrbpa");
    refuses("mesh p.xy --alpha 1 --method hrbpa --levels l.txt",
            "--levels: found the ending 'txt', expected one of json, csv");
    refuses("shape p.xy --alpha 1 --leaf-capacity 9 -o s.wkt", "--leaf-capacity requires --method hrbpa");
    refuses("mesh p.xy --alpha 1 --method hrbpa --leaf-capacity 0 -o m.off",
            "--leaf-capacity: found '0', expected a whole number of points from 1");
    for (const char* method : {"", " --method hrbpa"})
      refuses(std::string("mesh p.xy --alpha 1 --search far -o m.off") + method,
              "--search: found 'far', expected near or paper");
    const Folder folder("p.csv", corner);
    for (const char* twice : {"--levels p.csv", "--levels a.csv --stats a.csv", "--levels - --stats -"})
      CHECK(folder.rbpa(std::string("mesh p.csv --alpha 1 --method hrbpa ") + twice).code == 2);
    CHECK(folder.rbpa("shape p.csv --alpha 1 --method hrbpa --levels l.csv -o s.wkt").code == 2);
    CHECK(folder.rbpa("mesh p.csv --alpha 1 --method hrbpa --leaf-capacity many -o m.off").code == 2);
    CHECK(folder.names() == std::vector<std::string>{"p.csv"});
  }
}
