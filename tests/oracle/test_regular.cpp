#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "oracle/cgal_regular.h"
#include "rbpa/space/balls/regular_triangulation.h"
#include "support/arguments.h"
#include "support/ball_sets.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using rbpa::RegularTriangulation;

namespace {

RegularTriangulation triangulated(const Balls& balls) {
  return rbpa::regular_triangulation(balls.centers, balls.radii);
}

bool same(const RegularTriangulation& actual, const RegularByCgal& expected) {
  return actual.simplices == expected.simplices && actual.neighbors == expected.neighbors &&
         actual.flat == expected.flat && actual.hidden == expected.hidden;
}

}  // namespace

TEST_CASE("small sets of balls of every kind have CGAL's regular triangulation and hidden balls, flat ones too") {
  const std::uint64_t sets = argument("count", 2000) / (space_kinds * radius_kinds);
  std::size_t tetrahedra = 0, flat = 0, hidden = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int r = 0; r < radius_kinds; ++r) {
      Random random(900 + static_cast<std::uint64_t>(k * radius_kinds + r));
      CAPTURE(name(static_cast<SpaceKind>(k)));
      CAPTURE(name(static_cast<RadiusKind>(r)));
      for (std::uint64_t trial = 0; trial < sets; ++trial) {
        const Balls balls =
            ball_set(static_cast<SpaceKind>(k), static_cast<RadiusKind>(r), 1 + random.below(24), random);
        const RegularByCgal expected = regular_by_cgal(balls);
        if (!same(triangulated(balls), expected)) FAIL_CHECK(text(balls));
        tetrahedra += expected.simplices.size();
        flat += expected.flat.size();
        hidden += expected.hidden.size();
      }
    }
  CHECK(tetrahedra > 1400 * sets);
  CHECK(flat > 100 * sets);
  CHECK(hidden > 250 * sets);
}

TEST_CASE("larger sets of balls have CGAL's regular triangulation and hidden balls") {
  const std::size_t count = argument("points", 200);
  for (const SpaceKind k : {SpaceKind::cube, SpaceKind::grid, SpaceKind::near_sphere, SpaceKind::plate,
                            SpaceKind::noisy_sphere, SpaceKind::clusters, SpaceKind::nearest})
    for (int r = 0; r < radius_kinds; ++r) {
      CAPTURE(name(k));
      CAPTURE(name(static_cast<RadiusKind>(r)));
      Random random(1100 + static_cast<std::uint64_t>(r));
      const Balls balls = ball_set(k, static_cast<RadiusKind>(r), count, random);
      CHECK(same(triangulated(balls), regular_by_cgal(balls)));
    }
}

TEST_CASE("further: atoms have CGAL's regular triangulation, without and with a probe") {
  const std::map<char, double> radius = {{'H', 1.1}, {'C', 1.7}, {'N', 1.55}, {'O', 1.52}, {'P', 1.8}, {'S', 1.8}};
  if (!has_further_data()) return;
  std::size_t molecules = 0;
  for (const auto& file : std::filesystem::directory_iterator(further_data())) {
    if (file.path().extension() != ".pdb") continue;
    ++molecules;
    CAPTURE(file.path().string());
    for (const double probe : {0.0, 1.4}) {
      Balls balls;
      std::ifstream input(file.path());
      for (std::string line; std::getline(input, line);) {
        if ((line.rfind("ATOM", 0) != 0 && line.rfind("HETATM", 0) != 0) || line.size() < 54) continue;
        const auto number = [&](std::size_t column) { return std::stod(line.substr(column, 8)); };
        const auto of = radius.find(line[13]);
        balls.centers.push_back({number(30), number(38), number(46)});
        balls.radii.push_back((of == radius.end() ? 2 : of->second) + probe);
      }
      REQUIRE(balls.radii.size() > 100);
      CHECK(same(triangulated(balls), regular_by_cgal(balls)));
    }
  }
  CHECK(molecules > 0);
}

TEST_CASE("parts of a grid of 4 by 4 by 4 with radii of a few values have CGAL's regular triangulation") {
  const std::uint64_t sets = argument("count", 2000) / 20;
  Random random(901);
  std::size_t tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Balls balls;
    const std::uint64_t values = 1 + random.below(3);
    for (int i = 0; i < 64; ++i)
      if (random.chance(trial % 4 == 0 ? 1 : 0.6)) {
        balls.centers.push_back({double(i & 3), double(i >> 2 & 3), double(i >> 4)});
        balls.radii.push_back(static_cast<double>(random.below(values)));
      }
    const RegularByCgal expected = regular_by_cgal(balls);
    if (!same(triangulated(balls), expected)) FAIL_CHECK(text(balls));
    tetrahedra += expected.simplices.size();
  }
  CHECK(tetrahedra > 40 * sets);
}

TEST_CASE("the oracle detects wrong results") {
  Random random(902);
  Balls balls = ball_set(SpaceKind::cube, RadiusKind::decades, 50, random);
  const RegularByCgal expected = regular_by_cgal(balls);
  const RegularTriangulation right = triangulated(balls);
  REQUIRE(same(right, expected));
  REQUIRE(!right.hidden.empty());
  RegularTriangulation wrong = right;
  std::swap(wrong.neighbors[0][0], wrong.neighbors[0][1]);
  CHECK(!same(wrong, expected));
  wrong = right;
  std::swap(wrong.simplices[0][2], wrong.simplices[0][3]);
  CHECK(!same(wrong, expected));
  wrong = right;
  wrong.hidden.pop_back();
  CHECK(!same(wrong, expected));
  balls.radii[right.hidden[0]] = 1e6;
  CHECK(!same(right, regular_by_cgal(balls)));
}
