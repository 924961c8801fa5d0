#include "rbpa/space/repair/suggested_repairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/progress.h"
#include "rbpa/base/error.h"
#include "rbpa/space/surface/surface_levels.h"
#include "support/arguments.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/spiral.h"

using namespace rbpa_test;
using rbpa::Hole;
using rbpa::Point3;
using rbpa::RimEdge;
using rbpa::SuggestedRepair;
using rbpa::SuggestedRepairKind;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

using Radii = std::vector<double>;
using Side = std::pair<std::uint32_t, std::uint32_t>;

struct Sample {
  Points3 points, normals;
};

/// Returns points spread over the unit sphere along a spiral, without a cap around the north pole.
Sample sphere_without_cap(int count, double highest) {
  Sample sample{.points = spiral(count), .normals = {}};
  std::erase_if(sample.points, [&](const Point3& p) { return p.z > highest; });
  sample.normals = sample.points;
  return sample;
}

Point3 turned(const Point3& n) { return {-n.x, -n.y, -n.z}; }

/// Decides from the whole surface whether a hole is closed: no edge of the hole is boundary, nor an edge of a triangle
/// of the last level that is connected with it by such triangles.
bool is_closed_by(const Hole& hole, const Surface& before, const Surface& after, std::uint32_t level) {
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  for (std::uint32_t t = 0; t < after.triangles.size(); ++t) number[after.triangles[t]] = t;
  std::set<std::uint32_t> reached;
  std::vector<std::uint32_t> waiting;
  bool is_open = false;
  const auto cross = [&](std::uint32_t t, std::size_t side) {
    const std::uint32_t other = after.neighbors[t][side];
    if (other == Surface::none)
      is_open = true;
    else if (after.levels[other] == level && reached.insert(other).second)
      waiting.push_back(other);
  };
  for (const RimEdge& edge : hole.edges) {
    const auto& corners = before.triangles[edge.triangle];
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] != edge.from && corners[k] != edge.to) cross(number.at(corners), k);
  }
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::size_t k = 0; k < 3; ++k) cross(t, k);
  }
  return !is_open;
}

std::set<Side> boundary_of(const Surface& surface) {
  std::set<Side> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (surface.neighbors[t][k] == Surface::none)
        sides.insert({surface.triangles[t][(k + 2) % 3], surface.triangles[t][(k + 1) % 3]});
  return sides;
}

Radii with(Radii radii, double further) {
  radii.push_back(further);
  return radii;
}

Points3 with_turned(Points3 normals, const std::vector<std::uint32_t>& at) {
  for (const std::uint32_t i : at) normals[i] = turned(normals[i]);
  return normals;
}

std::vector<SuggestedRepair> repairs_of(const Sample& sample, const Radii& radii, std::vector<Hole>* holes = nullptr) {
  const Surface surface = rbpa::surface(sample.points, sample.normals, radii);
  const std::vector<Hole> found = rbpa::holes(sample.points, sample.normals, radii, surface);
  if (holes != nullptr) *holes = found;
  return rbpa::suggested_repairs(sample.points, sample.normals, radii, surface, found);
}

}  // namespace

TEST_CASE("a ball closes a missing cap of a sphere, and no smaller ball closes it by the same triangles") {
  for (const double highest : {0.97, 0.9, 0.8}) {
    const Sample sample = sphere_without_cap(600, highest);
    std::vector<Hole> holes;
    const Radii radii = {0.12};
    const auto repairs = repairs_of(sample, radii, &holes);
    REQUIRE(repairs.size() == 1);
    REQUIRE(repairs.front().kind == SuggestedRepairKind::larger_ball);
    const double radius = repairs.front().radius;
    CHECK(radius > 0.12);
    CHECK(radius < 1);
    CHECK(boundary_of(rbpa::surface(sample.points, sample.normals, with(radii, radius))).empty());
    CHECK(!boundary_of(rbpa::surface(sample.points, sample.normals, with(radii, std::nextafter(radius, 0)))).empty());
    CHECK(repairs.front().points.empty());
    CHECK(!repairs.front().filled);
  }
}

TEST_CASE("exactly the normals that point the wrong way are suggested for turning") {
  Sample sample = sphere_without_cap(600, 1);
  const std::vector<std::uint32_t> wrong = {50, 300, 301, 420};
  sample.normals = with_turned(sample.normals, wrong);
  const auto repairs = repairs_of(sample, {0.15});
  CHECK(repairs.size() == 4);
  std::set<std::uint32_t> named;
  for (const SuggestedRepair& repair : repairs) {
    CHECK(repair.kind == SuggestedRepairKind::turn_normals);
    named.insert(repair.points.begin(), repair.points.end());
  }
  CHECK(named == std::set<std::uint32_t>(wrong.begin(), wrong.end()));
}

TEST_CASE("filling is suggested for the open side of a box, as a ball does not agree with the normals at its rim") {
  Sample box;
  const int size = 6;
  for (int x = 0; x <= size; ++x)
    for (int y = 0; y <= size; ++y)
      for (int z = 0; z < size; ++z) {
        const bool has_x = x == 0 || x == size, has_y = y == 0 || y == size, has_z = z == 0;
        if (!has_x && !has_y && !has_z) continue;
        box.points.push_back({double(x), double(y), double(z)});
        const auto out = [&](bool is_there, int at) { return is_there ? (at == 0 ? -1.0 : 1.0) : 0.0; };
        box.normals.push_back({out(has_x, x), out(has_y, y), out(has_z, z)});
      }
  const auto repairs = repairs_of(box, {0.9});
  REQUIRE(repairs.size() == 1);
  CHECK(repairs.front() == SuggestedRepair{.kind = SuggestedRepairKind::filling, .filled = rbpa::HoleOutcome::filled});
}

TEST_CASE("a suggested repair holds for the whole surface, and balls that fail around a hole fail on the whole") {
  std::array<std::size_t, 4> found{};
  for (int trial = 0; trial < trials(400); ++trial) {
    Random random(9000 + static_cast<std::uint64_t>(trial));
    Sample sample;
    sample.points = space_set(static_cast<SpaceKind>(random.below(space_kinds)), 30 + random.below(120), random);
    if (trial % 2 == 0) {
      sample = sphere_without_cap(60 + static_cast<int>(random.below(200)), 1 - random.unit() / 3);
      for (Point3& p : sample.points) p = {p.x + 0.05 * random.unit(), p.y, p.z};
    } else {
      for (const Point3& p : sample.points) sample.normals.push_back(p == Point3{} ? Point3{0, 0, 1} : p);
    }
    for (Point3& n : sample.normals)
      if (random.chance(0.04)) n = turned(n);
    Radii radii = {trial % 2 == 0 ? 0.1 + 0.3 * random.unit() : space_radius(sample.points, random)};
    if (random.chance(0.3)) radii.push_back(radii.back() * (1 + random.unit()));
    const Surface surface = rbpa::surface(sample.points, sample.normals, radii);
    const std::vector<Hole> holes = rbpa::holes(sample.points, sample.normals, radii, surface);
    const auto repairs = rbpa::suggested_repairs(sample.points, sample.normals, radii, surface, holes,
                                                 {.threads = static_cast<unsigned>(1 + random.below(2))});
    REQUIRE(repairs.size() == holes.size());
    const auto level = static_cast<std::uint32_t>(radii.size());
    const std::set<Side> before = boundary_of(surface);
    CAPTURE(trial);
    for (std::size_t i = 0; i < holes.size(); ++i) {
      CAPTURE(i);
      const SuggestedRepair& repair = repairs[i];
      ++found[static_cast<std::size_t>(repair.kind)];
      if (repair.kind == SuggestedRepairKind::larger_ball) {
        CHECK(repair.radius > radii.back());
        const Surface after = rbpa::surface(sample.points, sample.normals, with(radii, repair.radius));
        CHECK(is_closed_by(holes[i], surface, after, level));
      } else if (repair.kind == SuggestedRepairKind::turn_normals) {
        REQUIRE(!repair.points.empty());
        const Surface after = rbpa::surface(sample.points, with_turned(sample.normals, repair.points), radii);
        std::set<Side> left = boundary_of(after), edges;
        for (const auto& t : after.triangles)
          for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        for (const RimEdge& edge : holes[i].edges) {
          CHECK(!left.contains({edge.from, edge.to}));
          CHECK(edges.contains(std::minmax(edge.from, edge.to)));
        }
        CHECK(std::includes(before.begin(), before.end(), left.begin(), left.end()));
      } else if (trial % 8 < 2) {
        double diagonal = 0;
        for (const RimEdge& e : holes[i].edges)
          for (const RimEdge& f : holes[i].edges) {
            const Point3 &p = sample.points[e.from], &q = sample.points[f.from];
            diagonal = std::max(diagonal, std::hypot(q.x - p.x, q.y - p.y, q.z - p.z));
          }
        double radius = radii.back();
        for (int step = 0; step < 3 && std::isfinite(radius *= 1.25) && (step == 0 || radius <= diagonal); ++step)
          CHECK(!is_closed_by(holes[i], surface, rbpa::surface(sample.points, sample.normals, with(radii, radius)),
                              level));
      }
    }
  }
  for (const std::size_t count : found) CHECK(count > static_cast<std::size_t>(trials(20)));
}

TEST_CASE("neither the order of the points nor the threads change a suggested repair") {
  Sample sample = sphere_without_cap(500, 0.9);
  sample.normals = with_turned(sample.normals, {100, 101, 250});
  Random random(5);
  const std::vector<std::uint32_t> order = random_order(sample.points.size(), random);
  Sample shuffled;
  std::vector<std::uint32_t> was(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    shuffled.points.push_back(sample.points[order[i]]);
    shuffled.normals.push_back(sample.normals[order[i]]);
  }
  const auto described = [](std::vector<SuggestedRepair> repairs, const std::vector<std::uint32_t>& names) {
    std::set<std::pair<double, std::set<std::uint32_t>>> all;
    for (const SuggestedRepair& repair : repairs) {
      std::set<std::uint32_t> at;
      for (const std::uint32_t i : repair.points) at.insert(names.empty() ? i : names[i]);
      all.insert({repair.radius, at});
    }
    return all;
  };
  const auto expected = described(repairs_of(sample, {0.15}), {});
  CHECK(expected.size() >= 3);
  CHECK(described(repairs_of(shuffled, {0.15}), order) == expected);
}

TEST_CASE("wrong calls of suggested_repairs are refused, and a run can be cancelled") {
  const Sample sample = sphere_without_cap(200, 0.8);
  const Radii radii = {0.25};
  const Surface surface = rbpa::surface(sample.points, sample.normals, radii);
  const std::vector<Hole> holes = rbpa::holes(sample.points, sample.normals, radii, surface);
  REQUIRE(!holes.empty());
  const auto repairs = [&](const Sample& of, const Radii& by, const std::vector<Hole>& at) {
    return rbpa::suggested_repairs(of.points, of.normals, by, surface, at);
  };
  CHECK(repairs(sample, radii, {}).empty());
  CHECK_THROWS_AS(repairs(sample, {0.25, 0.2}, holes), rbpa::InvalidInput);
  CHECK_THROWS_AS(repairs({sample.points, {}}, radii, holes), rbpa::InvalidInput);
  CHECK_THROWS_AS(repairs(sample, radii, std::vector<Hole>(1)), meshops::ContractViolation);
  std::vector<Hole> other = holes;
  std::swap(other.front().edges.front().from, other.front().edges.front().to);
  CHECK_THROWS_AS(repairs(sample, radii, other), meshops::ContractViolation);
  other.front().edges.front().triangle = 1000000;
  CHECK_THROWS_AS(repairs(sample, radii, other), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::suggested_repairs(sample.points, sample.normals, radii, surface, holes,
                                          {.threads = 1, .progress = [](const rbpa::Progress&) { return false; }}),
                  rbpa::Cancelled);
}

TEST_SUITE_END();
