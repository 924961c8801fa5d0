#include "rbpa/space/persistence/solid_persistence.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/pairing.h"

namespace rbpa {
namespace {

/// Sorts pairs of equal birth, from index `first` on, by death, then by simplices. Requires: pairs are sorted by birth.
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

}  // namespace

std::vector<SolidPair> solid_persistence(const SolidFiltration& filtration, const GoOn& go_on, unsigned wanted) {
  space::check_filtration("solid_persistence", filtration);
  Steps step(go_on);
  Threads threads = threads_for(filtration.edges.size(), wanted);
  space::Pairing pairing(filtration, threads, go_on, step);
  const std::vector<std::uint32_t> end_of = std::move(pairing.tunnels).all_ended_by();
  std::vector<SolidPair> pairs;
  // Memory is reserved first, because a growing vector would need twice as much.
  const auto tunnels = std::count_if(end_of.begin(), end_of.end(), [](std::uint32_t t) { return t != Solid::none; });
  pairs.reserve(pairing.components.all.size() + 1 + static_cast<std::size_t>(tunnels) + pairing.voids.all.size());
  const auto add = [&](int dimension, double birth, double death, std::uint32_t born_by, std::uint32_t ended_by) {
    if (birth != death) pairs.push_back({dimension, birth, death, born_by, ended_by});
  };
  const auto birth_of = [&](std::uint32_t point) {
    return filtration.point_alpha.empty() ? 0 : filtration.point_alpha[point];
  };
  for (const auto& [point, edge] : pairing.components.all)
    add(0, birth_of(point), filtration.edge_alpha[edge], point, edge);
  if (const std::uint32_t first = pairing.components.first; filtration.delaunay.distinct > 0)
    pairs.push_back({.dimension = 0, .birth = birth_of(first), .death = {}, .born_by = first});
  if (!filtration.point_alpha.empty())
    sort(pairs, step, [](const SolidPair& a, const SolidPair& b) { return a.birth < b.birth; });
  sort_equal_births(pairs, 0, step);

  const std::size_t first_tunnel = pairs.size();
  for (const std::uint32_t edge : pairing.edges)
    if (const std::uint32_t triangle = end_of[edge]; triangle != Solid::none)
      add(1, filtration.edge_alpha[edge], filtration.triangle_alpha[triangle], edge, triangle);
  sort_equal_births(pairs, first_tunnel, step);

  const std::size_t first_void = pairs.size();
  for (auto at = pairing.voids.all.rbegin(); at != pairing.voids.all.rend(); ++at)
    add(2, filtration.triangle_alpha[at->triangle], filtration.tetrahedron_alpha[at->tetrahedron], at->triangle,
        at->tetrahedron);
  sort_equal_births(pairs, first_void, step);
  return pairs;
}

}  // namespace rbpa
