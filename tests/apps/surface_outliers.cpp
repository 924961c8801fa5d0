// `rbpa surface --drop-outliers`: isolated points are left out, and numbers are those of the file.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.h"

using namespace apps_test;
using nlohmann::json;

namespace {

/// Returns a sheet of 12 × 12 points with a hole, in lines of a file; before some of them is an isolated point.
struct Cloud {
  std::string clean, with_outliers;
  std::vector<std::uint32_t> number, outliers;  // of each clean point among all; of each other

  Cloud() {
    std::uint32_t next = 0;
    for (int i = 0; i < 144; ++i) {
      if (i % 30 == 7) {
        with_outliers += std::to_string(40 * i) + " 90 " + std::to_string(50 + i) + "\n";
        outliers.push_back(next++);
      }
      const int x = i % 12, y = i / 12;
      if (x > 3 && x < 8 && y > 3 && y < 8) continue;
      const std::string line = std::to_string(x) + " " + std::to_string(y) + ".25 0\n";
      clean += line;
      with_outliers += line;
      number.push_back(next++);
    }
  }
};

std::vector<std::uint32_t> indices_of(const std::string& npy) {
  const std::size_t begin = npy.find('\n') + 1;
  std::vector<std::uint32_t> values((npy.size() - begin) / 4);
  if (!values.empty()) std::memcpy(values.data(), npy.data() + begin, 4 * values.size());
  return values;
}

}  // namespace

TEST_SUITE("surface outliers") {
  TEST_CASE("the surface is that of the other points, by the numbers of the file") {
    const Folder folder;
    const Cloud cloud;
    folder.file("clean.xyz", cloud.clean);
    folder.file("all.xyz", cloud.with_outliers);
    const std::string files = " -q --json --radius 1 -o m.npy -o m.png --width 300 -o m.ply -o m.off";
    for (const std::string normals : {" --normals none", ""}) {
      CAPTURE(normals);
      const json of_clean = json::parse(folder.rbpa("surface clean.xyz" + normals + files, 0).out);
      std::vector<std::uint32_t> expected = indices_of(folder.content("m.npy"));
      REQUIRE(expected.size() > 300);
      for (std::uint32_t& index : expected) index = cloud.number[index];
      const std::string picture = folder.content("m.png");
      const json report = json::parse(folder.rbpa("surface all.xyz --drop-outliers auto" + normals + files, 0).out);
      CHECK(indices_of(folder.content("m.npy")) == expected);
      CHECK(folder.content("m.png") == picture);
      CHECK(report["outlier_points"] == json(cloud.outliers));
      CHECK(report["outliers"]["points"] == cloud.outliers.size());
      CHECK(report["outliers"]["factor"] == 4.0);
      CHECK(report["points"] == 144 - 16 + cloud.outliers.size());
      for (const char* same : {"distinct", "triangles", "components", "boundary_curves", "curves", "unused", "area"})
        CHECK(report[same] == of_clean[same]);
      REQUIRE(report["holes"].size() == of_clean["holes"].size());
      CHECK(contains(folder.content("m.ply"), "element vertex " + std::to_string(144 - 16 + cloud.outliers.size())));
    }
  }

  TEST_CASE("indices of holes and of unused points are those of the file") {
    const Folder folder;
    // The first point is an outlier; the last is not, as it is only farther than the ball reaches.
    std::string text = "500 500 500\n";
    for (int i = 0; i < 36; ++i) text += std::to_string(i % 6) + " " + std::to_string(i / 6) + " 0\n";
    text += "2.5 8 0\n";
    folder.file("p.xyz", text);
    const json report = json::parse(
        folder.rbpa("surface p.xyz --radius 0.8 --drop-outliers 6 --json -q -o m.obj --holes h.obj", 0).out);
    CHECK(report["outlier_points"] == json::parse("[0]"));
    REQUIRE(report["unused_points"].size() == 1);
    CHECK(report["unused_points"][0]["point"] == 37);
    const std::string holes = folder.content("h.obj");
    CHECK(holes.starts_with("v 500 500 500\nv 0 0 0\n"));
    const std::string loop = holes.substr(holes.find("\nl") + 2);
    CHECK(!contains(loop, " 1 "));  // 1 is the number of the outlier
    CHECK(contains(loop, " 2"));
  }

  TEST_CASE("a wrong factor is refused; without outliers nothing changes") {
    const Folder folder("p.xyz", Cloud().clean);
    for (const std::string bad : {"0.5", "x", "-3", "inf"}) {
      refuses(folder, "surface p.xyz --radius 1 -o m.ply --drop-outliers " + bad, 2,
              "--drop-outliers: found '" + bad + "', expected a factor, >= 1, or auto");
    }
    REQUIRE(folder.rbpa("surface p.xyz --radius 1 -o m.ply -q").code == 0);
    const std::string before = folder.content("m.ply");
    says(folder, "surface p.xyz --radius 1 -o m.ply --drop-outliers auto", 0,
         "0 outliers left out: more than 4 times as far from the 8th nearest point as the median, 2");
    CHECK(folder.content("m.ply") == before);
  }
}
