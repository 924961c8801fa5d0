// --scale-space of `rbpa surface`: noise, and the positions of points in files.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "support/program.h"
#include "support/spiral.h"

using namespace apps_test;
using nlohmann::json;

namespace {

constexpr int count = 3000;

/// A sphere of radius 1 with noise of about half a spacing.
std::vector<std::string> noisy_lines() {
  std::mt19937 random(7);
  std::vector<std::string> lines;
  const double spacing = std::sqrt(4 * 3.14159265358979 / count);
  for (const rbpa::Point3& p : rbpa_test::spiral(count)) {
    double bell = -6;
    for (int k = 0; k < 12; ++k) bell += static_cast<double>(random()) / 4294967296.0;
    const double r = 1 + 0.5 * spacing * bell;
    lines.push_back(rbpa_test::text_of({r * p.x, r * p.y, r * p.z}) + "\n");
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

/// Returns the standard deviation of the distances from the middle.
double deviation(const Folder& folder, const std::string& name) {
  const auto mesh = rbpa::app::read_mesh({folder.path(name), rbpa::app::Format::off});
  double sum = 0, squares = 0;
  for (const auto& p : mesh.positions) {
    sum += std::hypot(p[0], p[1], p[2]);
    squares += p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  }
  const auto n = static_cast<double>(mesh.positions.size());
  return std::sqrt(squares / n - sum / n * (sum / n));
}

}  // namespace

TEST_SUITE("surface") {
  TEST_CASE("noise of half a spacing gives a closed surface with nearly all points, at their original positions") {
    const Folder folder;
    std::vector<std::string> lines = noisy_lines();
    folder.file("p.xyz", joined(lines));
    const json plain = json::parse(folder.rbpa("surface p.xyz --radius 0.2 -o a.off --json").out);
    CHECK(plain["unused"] > count / 4);
    CHECK(plain["scale_space"].is_null());
    const Outcome outcome = folder.rbpa("surface p.xyz --radius 0.2 --scale-space auto -o b.off --json", 0);
    const json report = json::parse(outcome.out);
    CHECK(report["unused"] < count / 50);
    CHECK(report["boundary_curves"] == 0);
    CHECK(report["scale_space"] >= 1);
    CHECK(contains(outcome.err, ", moved by " + report["scale_space"].dump() + " step"));
    // The vertices are the points of the file.
    const auto given = rbpa::app::read_mesh({folder.path("a.off"), rbpa::app::Format::off});
    CHECK(rbpa::app::read_mesh({folder.path("b.off"), rbpa::app::Format::off}).positions == given.positions);

    const json moved = json::parse(
        folder.rbpa("surface p.xyz --radius 0.2 --scale-space auto --moved --watertight -o c.off -o c.npy --json").out);
    CHECK(moved["watertight"] == true);
    CHECK(deviation(folder, "c.off") < 0.3 * deviation(folder, "b.off"));
    CHECK(moved["area"].get<double>() < report["area"].get<double>());  // without bumps
    CHECK(folder.meshtopo("c.off -q --check closed,manifold,genus=0").code == 0);

    std::mt19937 random(8);
    const std::string npy = folder.content("c.npy");
    std::shuffle(lines.begin(), lines.end(), random);
    folder.file("p.xyz", joined(lines));
    const json shuffled = json::parse(
        folder.rbpa("surface p.xyz --radius 0.2 --scale-space auto --moved --watertight -o d.off --json --threads 2")
            .out);
    for (const char* key : {"triangles", "area", "unused", "scale_space", "component_list"})
      CHECK(shuffled[key] == moved[key]);
  }

  TEST_CASE("scale space takes a number of steps, and --moved needs it") {
    const Folder folder("p.xyz", joined(noisy_lines()));
    CHECK(json::parse(folder.rbpa("surface p.xyz --radius 0.2 --scale-space 3 -o a.off --json").out)["scale_space"] ==
          3);
    for (const std::string wrong : {"0", "-1", "1.5", "x", "101", "inf"})
      CHECK(folder.rbpa("surface p.xyz --radius 0.2 -o a.off '--scale-space=" + wrong + "'").err ==
            "rbpa: --scale-space: found '" + wrong + "', expected a whole number of steps (or auto) from 1 to 100\n");
    CHECK(folder.rbpa("surface p.xyz --radius 0.2 -o a.off --moved").err == "rbpa: --moved requires --scale-space\n");
  }
}
