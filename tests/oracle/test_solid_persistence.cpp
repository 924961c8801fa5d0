// Compares persistence in space with GUDHI's.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/gudhi_persistence.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/balls/weighted_filtration.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/arguments.h"
#include "support/ball_sets.h"
#include "support/data_folder.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::Point3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Value = std::array<double, 2>;
using Diagram = std::array<std::vector<Value>, 3>;

/// Returns the pairs sorted, without those that rounding can make or remove.
Diagram sorted(Diagram diagram) {
  for (auto& of : diagram) {
    std::erase_if(of, [](const Value& v) { return !(v[1] > v[0] * (1 + 1e-9)); });
    std::sort(of.begin(), of.end());
  }
  return diagram;
}

Diagram by_gudhi(const Points3& points) {
  Diagram diagram;
  for (const SquaredPair& pair : gudhi_persistence(points))
    if (pair.dimension < 3)
      diagram[static_cast<std::size_t>(pair.dimension)].push_back({std::sqrt(pair.birth), std::sqrt(pair.death)});
  return sorted(diagram);
}

/// Adds `shift` to all values.
Diagram by_rbpa(const rbpa::SolidFiltration& filtration, double shift = 0) {
  Diagram diagram;
  for (const rbpa::SolidPair& pair : rbpa::solid_persistence(filtration))
    diagram[static_cast<std::size_t>(pair.dimension)].push_back(
        {pair.birth + shift, pair.death.value_or(infinity) + shift});
  return sorted(diagram);
}

/// Returns the pairs of balls, all powers greater by `shift`.
Diagram by_gudhi(const Balls& balls, double shift) {
  std::vector<double> weights;
  for (const double radius : balls.radii) weights.push_back(radius * radius);
  Diagram diagram;
  for (const SquaredPair& pair : gudhi_persistence(balls.centers, weights))
    if (pair.dimension < 3)
      diagram[static_cast<std::size_t>(pair.dimension)].push_back({pair.birth + shift, pair.death + shift});
  return sorted(diagram);
}

bool is_near(double a, double b) { return a == b || std::abs(a - b) <= 1e-9 * std::max(a, b); }

/// Returns whether both have equally many pairs and each has a partner; values that rounding can confuse may be in any
/// order.
bool same(const Diagram& a, const Diagram& b) {
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    if (a[dimension].size() != b[dimension].size()) return false;
    std::vector<bool> is_taken(b[dimension].size(), false);
    for (const Value& value : a[dimension]) {
      const auto low = std::lower_bound(b[dimension].begin(), b[dimension].end(), Value{value[0] * (1 - 2e-9), 0});
      bool has_partner = false;
      for (auto at = static_cast<std::size_t>(low - b[dimension].begin());
           !has_partner && at < is_taken.size() && b[dimension][at][0] <= value[0] * (1 + 2e-9); ++at)
        if (!is_taken[at] && is_near(value[1], b[dimension][at][1])) has_partner = is_taken[at] = true;
      if (!has_partner) return false;
    }
  }
  return true;
}

std::string text(const Points3& points) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Point3& p : points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  return out.str();
}

/// Returns whether squares of radii are in range, because GUDHI squares radii.
bool has_squares(const Points3& points) {
  return std::all_of(points.begin(), points.end(), [](const Point3& p) {
    const auto fits = [](double x) { return x == 0 || (std::abs(x) > 1e-60 && std::abs(x) < 1e60); };
    return fits(p.x) && fits(p.y) && fits(p.z);
  });
}

std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Points3 distinct(Points3 points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

TEST_CASE("small sets of every kind have GUDHI's pairs") {
  const std::uint64_t sets = argument("count", 200) / space_kinds;
  std::array<std::size_t, 3> pairs = {0, 0, 0};
  for (int k = 0; k < space_kinds; ++k) {
    Random random(800 + static_cast<std::uint64_t>(k));
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (std::uint64_t trial = 0; trial < sets; ++trial) {
      const Points3 points = distinct(space_set(static_cast<SpaceKind>(k), 4 + random.below(50), random));
      if (!has_squares(points)) continue;
      const Diagram expected = by_gudhi(points);
      if (!same(by_rbpa(rbpa::solid_filtration(points)), expected)) FAIL_CHECK(text(points));
      for (std::size_t dimension = 0; dimension < 3; ++dimension) pairs[dimension] += expected[dimension].size();
    }
  }
  for (const std::size_t count : pairs) CHECK(count > sets);
}

TEST_CASE("larger sets of every shape have GUDHI's pairs") {
  std::size_t compared = 0;
  for (const SolidSet& set : solid_sets(argument("points", 200))) {
    const Points3 points = distinct(set.points);
    if (!set.is_solid || !has_squares(points) || set.name.find("moment") != std::string::npos) continue;
    CAPTURE(set.name);
    CHECK(same(by_rbpa(rbpa::solid_filtration(points)), by_gudhi(points)));
    ++compared;
  }
  CHECK(compared > 10);
}

TEST_CASE("sets in a plane and on a line have GUDHI's pairs") {
  Random random(802);
  std::size_t tunnels = 0;
  for (std::uint64_t trial = 0; trial < argument("count", 200) / 4; ++trial) {
    const auto integer = [&] { return double(random.below(13)) - 6; };
    const Point3 u = {integer(), integer(), integer()},
                 v = trial % 8 == 0 ? Point3{} : Point3{integer(), integer(), integer()};
    Points3 points;
    for (std::size_t i = 0; i < 1 + random.below(50); ++i) {
      const double a = integer(),
                   b = trial % 2 == 0 ? integer() : std::ldexp(std::floor(std::ldexp(random.unit(), 20)), -17);
      points.push_back({1 + a * u.x + b * v.x, a * u.y + b * v.y, a * u.z + b * v.z - 5});
    }
    points = distinct(points);
    const Diagram expected = by_gudhi(points);
    if (!same(by_rbpa(rbpa::solid_filtration(points)), expected)) FAIL_CHECK(text(points));
    tunnels += expected[1].size();
  }
  CHECK(tunnels > argument("count", 200) / 4);
}

TEST_CASE("small sets of balls of every kind have the pairs of GUDHI's weighted alpha complex") {
  const std::uint64_t sets = argument("count", 200) / 40;
  std::array<std::size_t, 3> pairs = {0, 0, 0};
  std::size_t later = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int r = 0; r < radius_kinds; ++r) {
      Random random(830 + static_cast<std::uint64_t>(k * radius_kinds + r));
      CAPTURE(name(static_cast<SpaceKind>(k)));
      CAPTURE(name(static_cast<RadiusKind>(r)));
      for (std::uint64_t trial = 0; trial < sets; ++trial) {
        Balls balls = ball_set(static_cast<SpaceKind>(k), static_cast<RadiusKind>(r), 4 + random.below(40), random);
        if (!has_squares(balls.centers)) continue;
        double greatest = 0;
        for (double& radius : balls.radii) {
          radius = double(static_cast<float>(radius));  // so that squares are doubles
          greatest = std::max(greatest, radius);
        }
        if (greatest > 1e30) continue;                 // as float, infinite
        const double shift = 2 * greatest * greatest;  // so that rounding is small beside all values
        const rbpa::SolidFiltration filtration = rbpa::weighted_filtration(balls.centers, balls.radii);
        const Diagram expected = by_gudhi(balls, shift);
        if (!same(by_rbpa(filtration, shift), expected)) FAIL_CHECK(text(balls));
        for (std::size_t dimension = 0; dimension < 3; ++dimension) pairs[dimension] += expected[dimension].size();
        later += static_cast<std::size_t>(std::count_if(filtration.point_alpha.begin(), filtration.point_alpha.end(),
                                                        [](double power) { return power > 0; }));
      }
    }
  for (const std::size_t count : pairs) CHECK(count > 20 * sets);
  CHECK(later > 100 * sets);
}

TEST_CASE("lysozyme has the voids of the full complex that follow from GUDHI's pairs, at radii around that of water") {
  Points3 atoms;
  std::istringstream lines(read_text(bundled_data() / "mol3_2lyz.pdb"));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("ATOM  "))  // water molecules are HETATM
      atoms.push_back({std::stod(line.substr(30, 8)), std::stod(line.substr(38, 8)), std::stod(line.substr(46, 8))});
  REQUIRE(atoms.size() == 1001);
  const Diagram expected = by_gudhi(atoms);
  const rbpa::Solid delaunay = rbpa::solid(atoms, infinity);
  const std::vector<double> radii = rbpa::circumradii(atoms, delaunay.simplices);
  for (const double alpha : {2.2, 2.6, 2.8, 3.1, 3.3, 3.6, 4.0}) {
    CAPTURE(alpha);
    const auto alive = std::count_if(expected[2].begin(), expected[2].end(),
                                     [&](const Value& v) { return v[0] <= alpha && alpha < v[1]; });
    const rbpa::FullVoids voids = rbpa::full_voids(atoms, rbpa::void_space(atoms, delaunay, radii, alpha), alpha);
    CHECK(voids.all.size() == static_cast<std::size_t>(alive));
    if (alpha != 3.1) continue;
    REQUIRE(voids.all.size() == 9);
    CHECK(voids.all[2].volume == doctest::Approx(65.8056).epsilon(1e-6));
    CHECK(voids.all[3].volume == doctest::Approx(36.1009).epsilon(1e-6));
  }
}

TEST_CASE("the comparison detects wrong pairs") {
  const Points3 points = uniform_cube(60, 801);
  const Diagram right = by_gudhi(points);
  REQUIRE(same(by_rbpa(rbpa::solid_filtration(points)), right));
  Diagram wrong = right;
  wrong[1].pop_back();
  CHECK(!same(right, wrong));
  wrong = right;
  wrong[2][0][1] *= 1.001;
  CHECK(!same(right, wrong));
  Balls balls{points, std::vector<double>(points.size(), 0.125)};
  const Diagram of_balls = by_gudhi(balls, 1);
  balls.radii[7] = 0.25;
  CHECK(same(by_rbpa(rbpa::weighted_filtration(balls.centers, balls.radii), 1), by_gudhi(balls, 1)));
  CHECK(!same(by_rbpa(rbpa::weighted_filtration(balls.centers, balls.radii), 1), of_balls));
}
