#include "rbpa/solid_persistence.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/simplices_at.h"
#include "rbpa/base/steps.h"
#include "rbpa/space/persistence/sorted_by_alpha.h"
#include "rbpa/space/persistence/tunnels.h"
#include "rbpa/space/persistence/voids.h"

namespace rbpa {
namespace {

constexpr std::uint32_t none = Solid::none;

/// By birth, death, and what makes them, where they are by birth already.
void sort_equal_births(std::vector<SolidPair>& pairs, std::size_t first, Steps& step) {
  const auto is_before = [&](const SolidPair& a, const SolidPair& b) {
    step();
    const auto key = [](const SolidPair& p) {
      return std::tuple(!p.death, p.death.value_or(0), p.born_by, p.ended_by);
    };
    return key(a) < key(b);
  };
  for (std::size_t last; first < pairs.size(); first = last) {
    last = first + 1;
    while (last < pairs.size() && pairs[last].birth == pairs[first].birth) ++last;
    if (last - first > 1) std::sort(&pairs[first], &pairs[0] + last, is_before);
  }
}

/// Of the points, each there from the beginning: where two components meet, that of the greater point ends. Returns: which edges end one.
std::vector<bool> find_components(const SolidFiltration& filtration, std::span<const std::uint32_t> order, Steps& step,
                                  std::vector<SolidPair>& pairs) {
  const Solid& delaunay = filtration.delaunay;
  meshops::DisjointSets sets(corner_bound<4>(delaunay.simplices));
  std::vector<bool> joins(order.size(), false);
  for (const std::uint32_t edge : order) {
    step(4);
    const std::uint32_t a = sets.find(filtration.edges[edge][0]), b = sets.find(filtration.edges[edge][1]);
    if (a == b) continue;
    joins[edge] = true;
    pairs.push_back({0, 0, filtration.edge_alpha[edge], std::max(a, b), edge});
    sets.link(a, b);
  }
  if (delaunay.distinct > 0)
    pairs.push_back({.dimension = 0, .birth = 0, .death = {}, .born_by = 0});  // the first point is the least of all
  return joins;
}

void check(const SolidFiltration& filtration) {
  const auto& [simplices, neighbors, duplicates, isolated, distinct] = filtration.delaunay;
  const std::size_t triangles = filtration.triangles.size(), edges = filtration.edges.size();
  const auto require = [](bool fits) {
    meshops::require(fits, "solid_persistence: expected what solid_filtration() returned");
  };
  require(neighbors.size() == simplices.size() && filtration.triangles_of.size() == simplices.size() &&
          filtration.tetrahedron_alpha.size() == simplices.size() && filtration.triangle_alpha.size() == triangles &&
          filtration.edges_of.size() == triangles && filtration.edge_alpha.size() == edges);
  for (std::size_t t = 0; t < simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      require(filtration.triangles_of[t][k] < triangles &&
              (neighbors[t][k] == none || neighbors[t][k] < simplices.size()));
  for (const auto& of : filtration.edges_of)
    for (const std::uint32_t edge : of) require(edge < edges);
}

}  // namespace

std::vector<SolidPair> solid_persistence(const SolidFiltration& filtration, const std::function<bool()>& go_on) {
  check(filtration);
  Steps step(go_on);
  std::vector<SolidPair> pairs;
  const auto order = space::sorted_by_alpha(filtration.edge_alpha, step);
  const std::vector<bool> joins = find_components(filtration, order, step, pairs);
  sort_equal_births(pairs, 0, step);

  space::PersistentVoids voids = space::find_voids(filtration, step);
  const std::vector<std::uint32_t> ended_by = space::pair_tunnels(filtration, order, joins, voids.makes_one, step);
  const std::size_t first_tunnel = pairs.size();
  for (const std::uint32_t edge : order)
    if (ended_by[edge] != none && filtration.edge_alpha[edge] != filtration.triangle_alpha[ended_by[edge]])
      pairs.push_back(
          {1, filtration.edge_alpha[edge], filtration.triangle_alpha[ended_by[edge]], edge, ended_by[edge]});
  sort_equal_births(pairs, first_tunnel, step);

  const std::size_t first_void = pairs.size();
  for (auto at = voids.all.rbegin(); at != voids.all.rend(); ++at) {
    const double birth = filtration.triangle_alpha[at->triangle], death = filtration.tetrahedron_alpha[at->tetrahedron];
    if (birth != death) pairs.push_back({2, birth, death, at->triangle, at->tetrahedron});
  }
  sort_equal_births(pairs, first_void, step);
  return pairs;
}

}  // namespace rbpa
