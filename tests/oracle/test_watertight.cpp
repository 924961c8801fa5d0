// Reads the output of `rbpa surface --watertight` and `meshtopo --fill-holes` by CGAL.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/support/program.h"
#include "oracle/cgal_solid.h"
#include "support/data_folder.h"
#include "support/random.h"

namespace rbpa_test {
namespace {

using apps_test::Folder;
using apps_test::Outcome;

/// Checks a run. Returns: whether it wrote a file; otherwise it must name the reason. Faces that enclose a volume
/// enclose it from outside, except with estimated normals, which may all be reversed.
bool check_watertight(const Folder& folder, const std::string& input, const std::string& options) {
  const Outcome outcome = folder.rbpa("surface " + input + " --watertight -o w.off --json " + options);
  if (outcome.code == 1) {
    CHECK(outcome.err.find("rbpa: --watertight: ") != std::string::npos);
    CHECK_FALSE(folder.has("w.off"));
    return false;
  }
  REQUIRE(outcome.code == 0);
  const auto report = nlohmann::json::parse(outcome.out);
  const CgalSolid solid = cgal_solid(folder.path("w.off"));
  CHECK(solid.faces == report["triangles"].get<std::size_t>());
  CHECK(solid.closed);
  // CGAL counts vertices at one place as a crossing.
  if (report["touching_points"] == 0) {
    CHECK_FALSE(solid.crosses_itself);
    if (report["components"] == 1 && report["component_list"][0]["volume"].get<double>() > 0)
      CHECK(solid.bounds_a_volume);
  }
  std::filesystem::remove(folder.path("w.off"));
  return true;
}

std::string row(std::initializer_list<double> numbers) {
  std::string text;
  for (const double x : numbers) {
    char number[40];
    std::snprintf(number, sizeof number, "%.17g ", x);
    text += number;
  }
  return text + "\n";
}

/// Closes the scans and models of a folder. Returns: how many become watertight, which must be more than half.
std::size_t check_scans(const std::filesystem::path& data) {
  std::size_t tried = 0, closed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("m3_") && !name.starts_with("c3_")) continue;
    if (entry.path().extension() != ".off" && entry.path().extension() != ".xyz") continue;
    if (entry.file_size() > 5'000'000) continue;
    CAPTURE(name);
    const Folder folder;
    std::filesystem::create_symlink(entry.path(), folder.path(name));
    ++tried;
    closed += check_watertight(folder, name, "--radius auto --keep-largest 1");
  }
  MESSAGE(closed << " of " << tried << " become watertight");
  CHECK(2 * closed > tried);
  return closed;
}

TEST_CASE("bundled scans and models become watertight, or the remaining holes are reported") {
  CHECK(check_scans(bundled_data()) >= 4);  // of six
}

TEST_CASE("further scans and models become watertight, or the remaining holes are reported") {
  if (has_further_data()) CHECK(check_scans(further_data()) > 0);
}

TEST_CASE("most lumps with holes, thin walls, noise, and points in layers become watertight") {
  Random random(71);
  std::size_t closed = 0;
  for (int i = 0; i < 120; ++i) {
    CAPTURE(i);
    std::string text;
    const int count = random.integer(100, 1500);
    const double dent = random.unit(), noise = random.chance(0.5) ? 0 : 0.05 * random.unit();
    const double flat = random.chance(0.3) ? 0.1 : 1;
    const bool in_layers = random.chance(0.3);
    std::vector<std::array<double, 3>> gaps;
    for (int gap = random.integer(0, 4); gap > 0; --gap)
      gaps.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    for (int k = 0; k < count; ++k) {
      const double h = 1 - (2.0 * k + 1) / count, angle = k * 2.399963229728653, s = std::sqrt(1 - h * h);
      const double r = 1 + dent * std::sin(4 * angle) * s * h + noise * (random.unit() - 0.5);
      std::array<double, 3> p{r * s * std::cos(angle), r * s * std::sin(angle), flat * r * h};
      bool is_gone = false;
      for (const auto& gap : gaps) is_gone = is_gone || std::hypot(p[0] - gap[0], p[1] - gap[1], p[2] - gap[2]) < 0.4;
      if (is_gone) continue;
      if (in_layers)
        for (double& x : p) x = std::round(x * 16) / 16;
      text += row({p[0], p[1], p[2], s * std::cos(angle), s * std::sin(angle), h});
    }
    const Folder folder;
    folder.file("p.xyz", text);
    closed += check_watertight(folder, "p.xyz", i % 2 == 0 ? "--radius auto" : "--radius 0.2,0.4 --keep-largest 1");
  }
  MESSAGE(closed << " of 120 become watertight");
  CHECK(closed > 60);
}

/// Returns a sphere of n × 2n faces, with triangles at its poles, without one in every `of` faces.
std::string open_sphere(int n, int of, Random& random) {
  std::string vertices, faces;
  int count = 0;
  const auto at = [&](int i, int j) { return i == 0 ? 0 : i == n ? 1 : 2 + (i - 1) * 2 * n + j % (2 * n); };
  const double pi = std::acos(-1.0);
  vertices += row({0, 0, 1}) + row({0, 0, -1});
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j)
      vertices += row({std::sin(pi * i / n) * std::cos(pi * j / n), std::sin(pi * i / n) * std::sin(pi * j / n),
                       std::cos(pi * i / n)});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      if (random.integer(1, of) == 1) continue;
      std::vector<int> face{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      if (i == 0) face.pop_back();
      if (i == n - 1) face.erase(face.begin() + 1);
      faces += std::to_string(face.size());
      for (const int corner : face) faces += " " + std::to_string(corner);
      faces += "\n";
      ++count;
    }
  return "OFF\n" + std::to_string(2 + (n - 1) * 2 * n) + " " + std::to_string(count) + " 0\n" + vertices + faces;
}

TEST_CASE("most open meshes of triangles and squares become watertight") {
  Random random(73);
  std::size_t closed = 0;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Folder folder;
    folder.file("m.off", open_sphere(random.integer(3, 20), random.integer(3, 40), random));
    const Outcome outcome =
        folder.meshtopo("m.off --keep-largest 1 --repair w.off --fill-holes rims --check closed -q --json -o r.json");
    REQUIRE((outcome.code == 0 || outcome.code == 4));
    if (outcome.code == 4) continue;
    ++closed;
    const CgalSolid solid = cgal_solid(folder.path("w.off"));
    CHECK(solid.closed);
    const auto report = nlohmann::json::parse(folder.content("r.json"));
    if (report["result"]["geometric_defects"] == 0) CHECK_FALSE(solid.crosses_itself);
  }
  MESSAGE(closed << " of 100 become closed");
  CHECK(closed > 50);
}

}  // namespace
}  // namespace rbpa_test
