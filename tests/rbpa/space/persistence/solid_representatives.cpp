#include "rbpa/space/persistence/solid_representatives.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/full_topology.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/solid_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::SolidFiltration;
using rbpa::SolidPair;
using rbpa::SolidRepresentative;

TEST_SUITE_BEGIN("space");

namespace {

using Chain = std::set<std::uint32_t>;

void add(Chain& chain, std::uint32_t cell) {
  if (!chain.insert(cell).second) chain.erase(cell);
}

/// Returns the simplices of one dimension in the order of the filtration.
std::vector<std::uint32_t> in_order(const std::vector<double>& alpha) {
  std::vector<std::uint32_t> order(alpha.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return alpha[a] < alpha[b]; });
  return order;
}

/// Finds the triangle that makes a chain of edges a boundary: by elimination, triangle by triangle.
class BoundariesOfTriangles {
 public:
  explicit BoundariesOfTriangles(const SolidFiltration& filtration) {
    for (const std::uint32_t triangle : in_order(filtration.triangle_alpha)) {
      Chain chain;
      for (const std::uint32_t edge : filtration.edges_of[triangle]) add(chain, edge);
      while (!chain.empty() && by_last_.contains(*chain.rbegin())) add_to(chain, by_last_.at(*chain.rbegin()).second);
      const auto place = static_cast<std::uint32_t>(place_.size());
      place_[triangle] = place;
      if (!chain.empty()) by_last_.emplace(*chain.rbegin(), std::pair(place, chain));
    }
  }
  /// Returns the place of the last triangle that is needed; none where no triangles have this boundary.
  std::uint32_t last_needed(Chain chain) const {
    std::uint32_t last = 0;
    while (!chain.empty()) {
      const auto found = by_last_.find(*chain.rbegin());
      if (found == by_last_.end()) return rbpa::Solid::none;
      last = std::max(last, found->second.first);
      add_to(chain, found->second.second);
    }
    return last;
  }
  std::uint32_t place(std::uint32_t triangle) const { return place_.at(triangle); }

 private:
  static void add_to(Chain& chain, const Chain& other) {
    for (const std::uint32_t cell : other) add(chain, cell);
  }
  std::map<std::uint32_t, std::pair<std::uint32_t, Chain>> by_last_;  // by number of the last edge
  std::map<std::uint32_t, std::uint32_t> place_;
};

/// Returns the length of the shortest cycle through an edge among edges up to it that becomes a boundary exactly when
/// it should, by trying all cycles that visit no point twice.
double shortest_by_trial(const Points3& points, const SolidFiltration& filtration, const SolidPair& pair,
                         const BoundariesOfTriangles& boundaries, const std::vector<std::uint32_t>& edge_place) {
  double least = infinity;
  std::vector<std::uint32_t> path = {pair.born_by};
  std::set<std::uint32_t> visited = {filtration.edges[pair.born_by][0]};
  const std::function<void(std::uint32_t, double)> go = [&](std::uint32_t at, double length) {
    if (length >= least) return;
    if (at == filtration.edges[pair.born_by][0]) {
      if (boundaries.last_needed({path.begin(), path.end()}) == boundaries.place(pair.ended_by)) least = length;
      return;
    }
    visited.insert(at);
    for (std::uint32_t edge = 0; edge < filtration.edges.size(); ++edge) {
      const auto& [a, b] = filtration.edges[edge];
      if ((a != at && b != at) || edge_place[edge] >= edge_place[pair.born_by]) continue;
      const std::uint32_t to = a == at ? b : a;
      if (visited.contains(to) && to != filtration.edges[pair.born_by][0]) continue;
      path.push_back(edge);
      go(to, length + std::sqrt(std::pow(points[b].x - points[a].x, 2) + std::pow(points[b].y - points[a].y, 2) +
                                std::pow(points[b].z - points[a].z, 2)));
      path.pop_back();
    }
    visited.erase(at);
  };
  const auto& [a, b] = filtration.edges[pair.born_by];
  go(b, std::sqrt(std::pow(points[b].x - points[a].x, 2) + std::pow(points[b].y - points[a].y, 2) +
                  std::pow(points[b].z - points[a].z, 2)));
  return least;
}

}  // namespace

TEST_CASE("a cycle exists at its birth, and is a boundary exactly from the end of its tunnel on") {
  std::size_t cycles = 0, shortest = 0;
  for (const std::size_t size : {30u, 120u})
    for_solids(size, 1200, [&](const Points3& points) {
      const SolidFiltration filtration = rbpa::solid_filtration(points);
      const BoundariesOfTriangles boundaries(filtration);
      const std::vector<std::uint32_t> order = in_order(filtration.edge_alpha);
      std::vector<std::uint32_t> place(order.size());
      for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
      const std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
      const auto all = rbpa::solid_representatives(points, filtration, pairs);
      REQUIRE(all.size() == pairs.size());
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const SolidPair& pair = pairs[i];
        if (pair.dimension == 0 && pair.death) CHECK(all[i].cells == std::vector<std::uint32_t>{pair.ended_by});
        if (pair.dimension != 1) continue;
        const SolidRepresentative& cycle = all[i];
        std::map<std::uint32_t, int> degree;
        Chain chain;
        for (const std::uint32_t edge : cycle.cells) {
          CHECK(chain.insert(edge).second);
          CHECK(place[edge] <= place[pair.born_by]);
          for (const std::uint32_t p : filtration.edges[edge]) ++degree[p];
        }
        REQUIRE(!cycle.cells.empty());
        CHECK(cycle.cells.front() == pair.born_by);
        for (const auto& [point, edges] : degree) CHECK(edges % 2 == 0);
        CHECK(boundaries.last_needed(chain) == boundaries.place(pair.ended_by));
        if (cycle.is_shortest)
          for (std::size_t k = 0; k < cycle.cells.size(); ++k) {
            const auto& e = filtration.edges[cycle.cells[k]];
            const auto& f = filtration.edges[cycle.cells[(k + 1) % cycle.cells.size()]];
            CHECK((e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]));
          }
        ++cycles;
        shortest += cycle.is_shortest;
      }
    });
  CHECK(cycles > 1000);
  CHECK(shortest > cycles / 2);
  CHECK(shortest < cycles);
}

TEST_CASE("a cycle reported as shortest is the shortest among all cycles of few points") {
  Random random(5200);
  std::size_t compared = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Points3 points = space_set(trial % 2 == 0 ? SpaceKind::cube : SpaceKind::noisy_sphere, 9, random);
    if (rbpa::solid(points, infinity).simplices.empty()) continue;
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    const BoundariesOfTriangles boundaries(filtration);
    const std::vector<std::uint32_t> order = in_order(filtration.edge_alpha);
    std::vector<std::uint32_t> place(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    const std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
    const auto all = rbpa::solid_representatives(points, filtration, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].dimension != 1) continue;
      const double least = shortest_by_trial(points, filtration, pairs[i], boundaries, place);
      CHECK(all[i].length >= least * (1 - 1e-9));
      if (!all[i].is_shortest) continue;
      CHECK(all[i].length <= least * (1 + 1e-9));
      ++compared;
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("a void's tetrahedra are all of it at its birth, and its triangles are their boundary") {
  std::size_t voids = 0;
  for (const SolidSet& set : solid_sets(150)) {
    if (!set.is_solid) continue;
    CAPTURE(set.name);
    const std::size_t tetrahedra = rbpa::solid(set.points, infinity).simplices.size();
    if (tetrahedra == 0 || tetrahedra > 3000) continue;
    const SolidFiltration filtration = rbpa::solid_filtration(set.points);
    std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
    std::erase_if(pairs, [](const SolidPair& pair) { return pair.dimension != 2; });
    const auto all = rbpa::solid_representatives(set.points, filtration, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const SolidRepresentative& found = all[i];
      Chain boundary;
      for (const std::uint32_t t : found.tetrahedra) {
        CHECK(filtration.tetrahedron_alpha[t] > pairs[i].birth);
        for (const std::uint32_t triangle : filtration.triangles_of[t]) add(boundary, triangle);
      }
      CHECK(std::vector<std::uint32_t>(boundary.begin(), boundary.end()) == found.cells);
      double enclosed = 0;  // by the faces, which are turned outward
      for (std::size_t k = 0; k < found.faces.size(); ++k) {
        rbpa::Triangle corners = found.faces[k];
        const auto corner = [&](std::size_t at) { return set.points[corners[at]] - set.points[found.faces[0][0]]; };
        enclosed += dot(corner(0), cross(corner(1), corner(2))) / 6;
        std::sort(corners.begin(), corners.end());
        CHECK(corners == filtration.triangles[found.cells[k]]);
      }
      if (found.volume > 1e-3 && found.volume < 1e9) CHECK(enclosed == doctest::Approx(found.volume).epsilon(1e-6));
      for (const std::uint32_t triangle : found.cells) CHECK(filtration.triangle_alpha[triangle] <= pairs[i].birth);
      CHECK(std::binary_search(found.tetrahedra.begin(), found.tetrahedra.end(), pairs[i].ended_by));
      for (const std::uint32_t t : found.tetrahedra) CHECK(filtration.tetrahedron_alpha[t] <= *pairs[i].death);
      if (i % 7 == 0 && std::isfinite(pairs[i].birth)) {
        const rbpa::FullVoids at_birth = rbpa::full_voids(
            set.points, rbpa::void_space(set.points, filtration.delaunay, filtration.tetrahedron_alpha, pairs[i].birth),
            pairs[i].birth);
        // Triangles that stand in the void are counted twice there, and bound nothing here.
        CHECK(std::any_of(at_birth.all.begin(), at_birth.all.end(), [&](const rbpa::SolidVoid& v) {
          return std::abs(v.volume - found.volume) <= 1e-9 * v.volume && found.area <= v.area * (1 + 1e-9);
        }));
      }
      ++voids;
    }
  }
  CHECK(voids > 300);
}

TEST_CASE("a ring's tunnels have cycles around its hole and around its tube") {
  Points3 ring;
  constexpr double turn = 6.283185307179586;
  Random random(5201);
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 16; ++j) {
      const double along = turn * (i + 0.1 * random.unit()) / 60, around = turn * (j + 0.1 * random.unit()) / 16;
      const double out = 3 + std::cos(around);
      ring.push_back({out * std::cos(along), out * std::sin(along), std::sin(around)});
    }
  const SolidFiltration filtration = rbpa::solid_filtration(ring);
  std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
  std::erase_if(pairs, [](const SolidPair& pair) { return pair.dimension != 1; });
  std::sort(pairs.begin(), pairs.end(),
            [](const SolidPair& a, const SolidPair& b) { return *a.death - a.birth > *b.death - b.birth; });
  pairs.resize(2);
  const auto cycles = rbpa::solid_representatives(ring, filtration, pairs);
  // Through the hole fits a ball of radius 2, in the tube one of radius 1.
  CHECK(*pairs[0].death == doctest::Approx(2).epsilon(0.05));
  CHECK(cycles[0].length == doctest::Approx(2 * turn).epsilon(0.1));
  CHECK(cycles[1].length > 0.95 * turn);
  CHECK(cycles[1].length < 1.5 * turn);  // of the few edges there are at its birth
  CHECK(cycles[0].is_shortest);
}

TEST_CASE("arguments that do not belong together are refused, and a run can be cancelled") {
  const Points3 points = uniform_cube(2000, 5202);
  const SolidFiltration filtration = rbpa::solid_filtration(points);
  std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
  CHECK_THROWS_AS(rbpa::solid_representatives(points, filtration, pairs, [] { return false; }), rbpa::Cancelled);
  CHECK(rbpa::solid_representatives(points, filtration, {}).empty());
  const auto refuses = [&](const SolidPair& pair) {
    CHECK_THROWS_AS(rbpa::solid_representatives(points, filtration, {&pair, 1}), meshops::ContractViolation);
  };
  refuses({.dimension = 3, .birth = 0, .death = 1});
  refuses({.dimension = 1, .birth = 0, .death = 1, .born_by = 0xfffffff0, .ended_by = 0});
  refuses({.dimension = 2, .birth = 0, .death = {}, .born_by = 0});
  refuses({.dimension = 1, .birth = 0, .death = 1, .born_by = pairs[2100].born_by, .ended_by = pairs[2101].ended_by});
  refuses({.dimension = 2, .birth = 0, .death = 1, .born_by = 0, .ended_by = 0});  // it reaches the outside
  CHECK_THROWS_AS(rbpa::solid_representatives(Points3(points.begin(), points.end() - 1), filtration, pairs),
                  meshops::ContractViolation);
}
