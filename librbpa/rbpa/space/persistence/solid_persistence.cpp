#include "rbpa/space/persistence/solid_persistence.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "rbpa/base/run/input.h"
#include "rbpa/base/run/side_by_side.h"
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

std::vector<SolidPair> solid_persistence(const SolidFiltration& filtration, const GoOn& go_on, unsigned wanted,
                                         const std::function<void(const GoOn&)>& beside) {
  space::check_filtration("solid_persistence", filtration);
  Threads threads = threads_for(filtration.edges.size(), wanted);
  const space::OuterPairing pairing(filtration, threads, go_on);
  std::vector<std::uint32_t> end_of;
  const auto find_tunnels = [&](Steps& of_task, const GoOn&) {
    end_of = space::Tunnels(filtration, pairing.edges, pairing.components.joins, pairing.voids.makes_one, of_task)
                 .all_ended_by();
  };
  const auto run_beside = [&](Steps&, const GoOn& goes_on) {
    if (beside) beside(goes_on);
  };
  std::vector<SolidPair> pairs, voids;
  const auto add = [](std::vector<SolidPair>& to, int dimension, double birth, double death, std::uint32_t born_by,
                      std::uint32_t ended_by) {
    if (birth != death) to.push_back({dimension, birth, death, born_by, ended_by});
  };
  const auto birth_of = [&](std::uint32_t point) {
    return filtration.point_alpha.empty() ? 0 : filtration.point_alpha[point];
  };
  const auto find_others = [&](Steps& of_task, const GoOn&) {
    for (const auto& [point, edge] : pairing.components.all)
      add(pairs, 0, birth_of(point), filtration.edge_alpha[edge], point, edge);
    if (const std::uint32_t first = pairing.components.first; filtration.delaunay.distinct > 0)
      pairs.push_back({.dimension = 0, .birth = birth_of(first), .death = {}, .born_by = first});
    if (!filtration.point_alpha.empty())
      sort(pairs, of_task, [](const SolidPair& a, const SolidPair& b) { return a.birth < b.birth; });
    sort_equal_births(pairs, 0, of_task);
    for (auto at = pairing.voids.all.rbegin(); at != pairing.voids.all.rend(); ++at)
      add(voids, 2, filtration.triangle_alpha[at->triangle], filtration.tetrahedron_alpha[at->tetrahedron],
          at->triangle, at->tetrahedron);
    sort_equal_births(voids, 0, of_task);
  };
  side_by_side(threads, go_on, find_tunnels, run_beside, find_others);
  const std::size_t first_tunnel = pairs.size();
  // Memory is reserved first, because a growing vector would need twice as much.
  const auto tunnels = std::count_if(end_of.begin(), end_of.end(), [](std::uint32_t t) { return t != Solid::none; });
  pairs.reserve(pairs.size() + static_cast<std::size_t>(tunnels) + voids.size());
  for (const std::uint32_t edge : pairing.edges)
    if (const std::uint32_t triangle = end_of[edge]; triangle != Solid::none)
      add(pairs, 1, filtration.edge_alpha[edge], filtration.triangle_alpha[triangle], edge, triangle);
  Steps step(go_on);
  sort_equal_births(pairs, first_tunnel, step);
  pairs.insert(pairs.end(), voids.begin(), voids.end());
  return pairs;
}

}  // namespace rbpa
