// `rbpa mesh --group-by`: the triangles of each group of the points.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/npy_file.h"
#include "support/program.h"
#include "support/random.h"
#include "support/vtu_arrays.h"

using namespace apps_test;
using nlohmann::json;

namespace {

void refuses(const std::string& arguments, const std::string& message) {
  const Folder folder("p.csv", "x,y,g\n0,0,1\n1,0,1\n0,1,1\n");
  refuses(folder, "mesh p.csv --columns x,y --group-by g --alpha inf " + arguments, 2, message);
}

}  // namespace

TEST_SUITE("mesh groups") {
  TEST_CASE("triangles are those of each group alone, with its number and properties") {
    const Folder folder;
    rbpa_test::Random random(5);
    std::string all = "x,y,group\n";
    std::map<int, std::vector<std::uint32_t>> members;
    std::map<int, std::string> alone;
    for (std::uint32_t i = 0; i < 600; ++i) {
      const int group = random.integer(1, 12);
      const std::string point = std::to_string(random.integer(0, 40)) + "," + std::to_string(random.integer(0, 40));
      all += point + "," + std::to_string(group) + "\n";
      members[group].push_back(i);
      alone[group] += point + "\n";
    }
    folder.file("all.csv", all);
    const std::string run = "mesh all.csv --columns x,y --group-by group --alpha 4 ";
    const Outcome outcome = folder.rbpa(run + "--fields none -o m.vtu -o m.ply -o m.npy -o m.off --stats s.json", 0);
    const auto triangles = npy_rows<std::array<std::uint32_t, 3>>(folder.content("m.npy"));
    CHECK(outcome.err == "rbpa: 600 points, 12 groups, " + std::to_string(triangles.size()) +
                             " triangles -> m.vtu, m.ply, m.npy, m.off\n");
    const std::string vtu = folder.content("m.vtu");
    const auto group = array_of<std::uint32_t>(vtu, "group");
    const auto name = array_of<double>(vtu, "name"), alpha = array_of<double>(vtu, "alpha"),
               points = array_of<double>(vtu, "points"), area = array_of<double>(vtu, "area");
    REQUIRE(group.size() == triangles.size());
    REQUIRE(folder.rbpa("shape all.csv --columns x,y --group-by group --alpha 4 -q -o s.geojson").code == 0);
    const json features = json::parse(folder.content("s.geojson"))["features"];
    std::size_t at = 0;
    for (const auto& [number, indices] : members) {
      folder.file("one.csv", alone[number]);
      REQUIRE(folder.rbpa("mesh one.csv --alpha 4 -q -o one.npy").code == 0);
      const json& known = features[static_cast<std::size_t>(number - 1)]["properties"];
      for (const auto& row : npy_rows<std::array<std::uint32_t, 3>>(folder.content("one.npy"))) {
        REQUIRE(at < triangles.size());
        for (std::size_t k = 0; k < 3; ++k) CHECK(triangles[at][k] == indices[row[k]]);
        CHECK(group[at] == static_cast<std::uint32_t>(number - 1));
        CHECK(name[at] == number);
        CHECK(alpha[at] == 4);
        CHECK(points[at] == static_cast<double>(indices.size()));
        CHECK(area[at] == known["area"]);
        ++at;
      }
    }
    CHECK(at == triangles.size());
    CHECK(contains(folder.content("m.ply"), "property uint group\n"));
    const json stats = json::parse(folder.content("s.json"));
    CHECK(stats["groups"] == 12);
    CHECK(stats["triangles"] == triangles.size());
    // Unused vertices are left out of meshes, not of arrays; the rest is the same.
    REQUIRE(folder.rbpa(run + "--fields none -o c.vtu -o c.npy --compact -q --threads 1").code == 0);
    CHECK(folder.content("c.npy") == folder.content("m.npy"));
    CHECK(array_of<std::uint32_t>(folder.content("c.vtu"), "group") == group);
  }

  TEST_CASE("groups with text names have only their number in the file, and a group without triangles is named") {
    const Folder folder("p.csv", "x,y,tree\n0,0,oak\n1,0,oak\n0,1,oak\n5,5,elm\n7,7,fir\n8,7,fir\n7,8,fir\n");
    const Outcome outcome = folder.rbpa("mesh p.csv --group-by tree --alpha auto -o m.vtu", 0);
    CHECK(outcome.err ==
          "rbpa: p.csv: 1 group without a polygon: 'elm', fewer than three distinct points (1)\n"
          "rbpa: 7 points, 3 groups, 2 triangles -> m.vtu\n");
    CHECK(array_of<std::uint32_t>(folder.content("m.vtu"), "group") == std::vector<std::uint32_t>{1, 2});
    CHECK(array_of<double>(folder.content("m.vtu"), "name").empty());
    CHECK(array_of<double>(folder.content("m.vtu"), "points") == std::vector<double>{3, 3});
  }

  TEST_CASE("options of a single complex are refused") {
    const std::string both = " cannot be combined with --group-by or --group-by-file";
    refuses("-o m.off --complex full", "--complex full" + both);
    refuses("-o m.off --method hrbpa", "--method hrbpa" + both);
    refuses("-o m.off --search paper", "--search paper" + both);
    refuses("-o m.off --method hrbpa --levels l.csv", "--levels" + both);
    refuses("-o m.svg",
            "--group-by: found m.svg, expected a mesh or an array (rbpa shape --group-by draws its polygons)");
  }
}
