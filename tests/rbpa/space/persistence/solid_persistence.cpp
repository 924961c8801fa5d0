#include "rbpa/space/persistence/solid_persistence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/full_topology.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::Solid;
using rbpa::SolidFiltration;
using rbpa::SolidPair;

TEST_SUITE_BEGIN("space");

namespace {

using Simplex = std::vector<std::uint32_t>;

struct Entry {
  double alpha;
  std::size_t number;  ///< among the simplices of its dimension
  Simplex simplex;
};

/// Finds the pairs by the definition: columns of the whole boundary matrix, reduced in the order of the filtration.
std::vector<SolidPair> pairs_by_matrix(const SolidFiltration& filtration) {
  const Solid& delaunay = filtration.delaunay;
  std::vector<Entry> all;
  std::set<std::uint32_t> corners;
  for (const auto& row : delaunay.simplices) corners.insert(row.begin(), row.end());
  for (const std::uint32_t p : corners) all.push_back({0, p, {p}});
  for (std::size_t i = 0; i < filtration.edges.size(); ++i)
    all.push_back({filtration.edge_alpha[i], i, {filtration.edges[i].begin(), filtration.edges[i].end()}});
  for (std::size_t i = 0; i < filtration.triangles.size(); ++i)
    all.push_back({filtration.triangle_alpha[i], i, {filtration.triangles[i].begin(), filtration.triangles[i].end()}});
  for (std::size_t i = 0; i < delaunay.simplices.size(); ++i) {
    Simplex s(delaunay.simplices[i].begin(), delaunay.simplices[i].end());
    std::sort(s.begin(), s.end());
    all.push_back({filtration.tetrahedron_alpha[i], i, s});
  }
  std::sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) {
    return std::tuple(a.alpha, a.simplex.size(), a.number) < std::tuple(b.alpha, b.simplex.size(), b.number);
  });
  std::map<Simplex, std::size_t> place;
  std::map<std::size_t, std::pair<std::size_t, std::set<std::size_t>>> reduced;  // by pivot
  std::vector<bool> is_paired(all.size(), false);
  std::vector<SolidPair> pairs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    place.emplace(all[i].simplex, i);
    std::set<std::size_t> column;
    for (std::size_t k = 0; all[i].simplex.size() > 1 && k < all[i].simplex.size(); ++k) {
      Simplex face = all[i].simplex;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
      column.insert(place.at(face));
    }
    while (!column.empty()) {
      const auto [at, is_new] = reduced.emplace(*column.rbegin(), std::pair{i, column});
      if (is_new) {
        const Entry& birth = all[at->first];
        is_paired[at->first] = is_paired[i] = true;
        if (birth.alpha != all[i].alpha)
          pairs.push_back({static_cast<int>(birth.simplex.size()) - 1, birth.alpha, all[i].alpha,
                           static_cast<std::uint32_t>(birth.number), static_cast<std::uint32_t>(all[i].number)});
        break;
      }
      for (const std::size_t row : at->second.second)
        if (!column.insert(row).second) column.erase(row);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!is_paired[i])
      pairs.push_back({static_cast<int>(all[i].simplex.size()) - 1,
                       all[i].alpha,
                       {},
                       static_cast<std::uint32_t>(all[i].number),
                       Solid::none});
  const auto key = [](const SolidPair& p) {
    return std::tuple(p.dimension, p.birth, !p.death, p.death.value_or(0), p.born_by, p.ended_by);
  };
  std::sort(pairs.begin(), pairs.end(), [&](const SolidPair& a, const SolidPair& b) { return key(a) < key(b); });
  return pairs;
}

using Values = std::tuple<int, double, double>;
std::vector<Values> values_of(const std::vector<SolidPair>& pairs) {
  std::vector<Values> values;
  for (const SolidPair& p : pairs) values.emplace_back(p.dimension, p.birth, p.death.value_or(infinity));
  return values;
}

}  // namespace

TEST_CASE("pairs are those of the whole boundary matrix, simplex by simplex") {
  std::array<std::size_t, 3> found = {0, 0, 0};
  for (const std::size_t size : {20u, 60u}) {
    for_solids(size, 700, [&](const Points3& points) {
      const SolidFiltration filtration = rbpa::solid_filtration(points);
      const std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
      CHECK(pairs == pairs_by_matrix(filtration));
      for (const SolidPair& pair : pairs) ++found[static_cast<std::size_t>(pair.dimension)];
    });
  }
  for (const std::size_t count : found) CHECK(count > 100);
}

TEST_CASE("the pairs of each dimension alive at an alpha are as many as the Betti number") {
  std::size_t checked = 0;
  for_solids(250, [&](const Points3& points) {
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    const std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
    std::vector<double> alphas = filtration.triangle_alpha;
    std::sort(alphas.begin(), alphas.end());
    for (std::size_t i = 0; i < alphas.size(); i += 1 + alphas.size() / 9) {
      if (!(alphas[i] > 0) || std::isinf(alphas[i])) continue;
      const rbpa::FullCounts counts =
          rbpa::count_full(points, filtration.delaunay, filtration.tetrahedron_alpha, alphas[i]);
      std::array<std::size_t, 3> alive = {0, 0, 0};
      for (const SolidPair& pair : pairs)
        if (pair.birth <= alphas[i] && alphas[i] < pair.death.value_or(infinity))
          ++alive[static_cast<std::size_t>(pair.dimension)];
      CHECK(alive == std::array{counts.components, counts.tunnels, counts.voids});
      ++checked;
    }
  });
  CHECK(checked > 80);
}

TEST_CASE("shuffled points have the same births and deaths") {
  Random random(5100);
  for_solids(200, [&](Points3 points) {
    std::vector<std::vector<Values>> all;
    for (int time = 0; time < 2; ++time) {
      all.push_back(values_of(rbpa::solid_persistence(rbpa::solid_filtration(points))));
      random.shuffle(points);
    }
    CHECK(all[0] == all[1]);
  });
}

TEST_CASE("a hollow ball has a void for as long as a ball fits into it, and a ring has a tunnel") {
  Random random(5101);
  Points3 shell, ring;
  for (int i = 0; i < 800; ++i) {
    const double z = (2 * i + 1) / 800.0 - 1, r = std::sqrt(1 - z * z);
    shell.push_back({r * std::cos(2.4 * i), r * std::sin(2.4 * i), z});
    const double turn = 6.283185307179586 * random.unit(), around = 6.283185307179586 * random.unit();
    const double out = 1 + 0.2 * std::cos(around);
    ring.push_back({out * std::cos(turn), out * std::sin(turn), 0.2 * std::sin(around)});
  }
  const auto longest = [](const Points3& points, int dimension) {
    double length = 0, second = 0, death = 0;
    for (const SolidPair& pair : rbpa::solid_persistence(rbpa::solid_filtration(points))) {
      if (pair.dimension != dimension || !pair.death) continue;
      const double ratio = *pair.death / pair.birth;
      if (ratio > length) {
        second = length;
        length = ratio;
        death = *pair.death;
      } else {
        second = std::max(second, ratio);
      }
    }
    CHECK(length > 3 * second);
    return death;
  };
  CHECK(longest(shell, 2) == doctest::Approx(1).epsilon(0.01));
  CHECK(longest(ring, 1) == doctest::Approx(0.8).epsilon(0.1));
}

TEST_CASE("few points have pairs, arguments that do not belong together are refused, and a run can be cancelled") {
  const Points3 none, one = {{1, 2, 3}, {1, 2, 3}};
  const auto pairs = [](const Points3& points) { return rbpa::solid_persistence(rbpa::solid_filtration(points)); };
  CHECK(pairs(none).empty());
  REQUIRE(pairs(one).size() == 1);
  CHECK(!pairs(one)[0].death);
  CHECK(pairs({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).size() == 4);  // components
  const Points3 points = uniform_cube(3000, 5102);
  SolidFiltration filtration = rbpa::solid_filtration(points);
  CHECK_THROWS_AS(rbpa::solid_persistence(filtration, [] { return false; }), rbpa::Cancelled);
  filtration.triangles_of.pop_back();
  CHECK_THROWS_AS(rbpa::solid_persistence(filtration), meshops::ContractViolation);
}

TEST_CASE("a filtration in which a radius is no number is refused") {
  const SolidFiltration good = rbpa::solid_filtration(uniform_cube(50, 3));
  for (std::vector<double> SolidFiltration::*alpha :
       {&SolidFiltration::tetrahedron_alpha, &SolidFiltration::triangle_alpha, &SolidFiltration::edge_alpha}) {
    SolidFiltration bad = good;
    REQUIRE(!(bad.*alpha).empty());
    (bad.*alpha).back() = std::nan("");
    CHECK_THROWS_AS(rbpa::solid_persistence(bad), meshops::ContractViolation);
  }
  CHECK_NOTHROW(rbpa::solid_persistence(good));
}
