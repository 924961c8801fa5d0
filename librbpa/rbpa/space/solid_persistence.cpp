#include "rbpa/solid_persistence.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/simplices_at.h"
#include "rbpa/base/steps.h"
#include "rbpa/space/persistence/sorted_by_alpha.h"
#include "rbpa/space/persistence/tunnels.h"

namespace rbpa {
namespace {

constexpr std::uint32_t none = Solid::none;

class Pairs {
 public:
  void add(int dimension, double birth, double death, std::uint32_t born_by, std::uint32_t ended_by) {
    if (birth != death) all_.push_back({dimension, birth, death, born_by, ended_by});
  }
  void add_for_ever(std::uint32_t point) {
    all_.push_back({.dimension = 0, .birth = 0, .death = {}, .born_by = point});
  }

  std::vector<SolidPair> sorted(Steps& step) && {
    const auto key = [](const SolidPair& p) {
      return std::tuple(p.dimension, p.birth, !p.death, p.death.value_or(0), p.born_by, p.ended_by);
    };
    sort(all_, step, [&](const SolidPair& a, const SolidPair& b) { return key(a) < key(b); });
    return std::move(all_);
  }

 private:
  std::vector<SolidPair> all_;
};

/// Of the points, each there from the beginning: where two components meet, that of the greater point ends.
std::vector<bool> find_components(const Solid& delaunay, const SolidFiltration& filtration,
                                  std::span<const std::uint32_t> order, Steps& step, Pairs& pairs) {
  meshops::DisjointSets sets(corner_bound<4>(delaunay.simplices));
  std::vector<bool> joins(order.size(), false);
  for (const std::uint32_t edge : order) {
    step(4);
    const std::uint32_t a = sets.find(filtration.edges[edge][0]), b = sets.find(filtration.edges[edge][1]);
    if (a == b) continue;
    joins[edge] = true;
    pairs.add(0, 0, filtration.edge_alpha[edge], std::max(a, b), edge);
    sets.link(a, b);
  }
  if (!delaunay.simplices.empty()) pairs.add_for_ever(delaunay.simplices.front()[0]);
  return joins;
}

/// Backwards in alpha, tetrahedra that are left out are joined by the triangles between them: where two voids are parted, that is a birth, and the one whose last
/// tetrahedron comes first ends with it. Returns: the triangles that make no void, and so end a tunnel; ascending.
std::vector<std::uint32_t> find_voids(const Solid& delaunay, const SolidFiltration& filtration, Steps& step,
                                      Pairs& pairs) {
  const auto& alpha = filtration.tetrahedron_alpha;
  const auto outside = static_cast<std::uint32_t>(alpha.size());
  std::vector<std::array<std::uint32_t, 2>> sides(filtration.triangles.size(), {outside, outside});
  for (std::uint32_t t = 0; t < outside; ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = delaunay.neighbors[t][k];
      sides[filtration.triangles_of[t][k]] = {t, beyond == none ? outside : beyond};
    }
  meshops::DisjointSets sets(alpha.size() + 1);
  std::vector<std::uint32_t> last(alpha.size() + 1);  // tetrahedron of each set
  for (std::uint32_t t = 0; t <= outside; ++t) last[t] = t;
  const auto is_before = [&](std::uint32_t t, std::uint32_t other) {
    if (other == outside || t == outside) return other == outside;
    return alpha[t] != alpha[other] ? alpha[t] < alpha[other] : t < other;
  };
  const std::vector<std::uint32_t> order = space::sorted_by_alpha(filtration.triangle_alpha, step);
  std::vector<std::uint32_t> ending;
  for (std::size_t i = order.size(); i-- > 0;) {
    step(4);
    const std::uint32_t triangle = order[i];
    const std::uint32_t a = sets.find(sides[triangle][0]), b = sets.find(sides[triangle][1]);
    if (a == b) {
      ending.push_back(triangle);
      continue;
    }
    const bool is_a_first = is_before(last[a], last[b]);
    const std::uint32_t ended = last[is_a_first ? a : b], stays = last[is_a_first ? b : a];
    pairs.add(2, filtration.triangle_alpha[triangle], alpha[ended], triangle, ended);
    last[sets.link(a, b)] = stays;
  }
  std::sort(ending.begin(), ending.end());  // neighbours come together
  return ending;
}

void check(const Solid& delaunay, const SolidFiltration& filtration) {
  const bool fits = delaunay.neighbors.size() == delaunay.simplices.size() &&
                    filtration.triangles_of.size() == delaunay.simplices.size() &&
                    filtration.tetrahedron_alpha.size() == delaunay.simplices.size() &&
                    filtration.triangle_alpha.size() == filtration.triangles.size() &&
                    filtration.edge_alpha.size() == filtration.edges.size();
  meshops::require(fits, "solid_persistence: expected the filtration of this triangulation");
  for (std::size_t t = 0; t < delaunay.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = delaunay.neighbors[t][k];
      meshops::require(filtration.triangles_of[t][k] < filtration.triangles.size() &&
                           (beyond == none || beyond < delaunay.simplices.size()),
                       "solid_persistence: expected the filtration of this triangulation");
    }
}

}  // namespace

std::vector<SolidPair> solid_persistence(const Solid& delaunay, const SolidFiltration& filtration,
                                         const std::function<bool()>& go_on) {
  check(delaunay, filtration);
  Steps step(go_on);
  Pairs pairs;
  if (delaunay.simplices.empty() && delaunay.distinct == 1) pairs.add_for_ever(0);
  const std::vector<std::uint32_t> order = space::sorted_by_alpha(filtration.edge_alpha, step);
  const std::vector<bool> joins = find_components(delaunay, filtration, order, step, pairs);
  const std::vector<std::uint32_t> ending = find_voids(delaunay, filtration, step, pairs);
  const std::vector<std::uint32_t> ended_by = space::pair_tunnels(filtration, order, joins, ending, step);
  for (std::uint32_t edge = 0; edge < ended_by.size(); ++edge)
    if (ended_by[edge] != none)
      pairs.add(1, filtration.edge_alpha[edge], filtration.triangle_alpha[ended_by[edge]], edge, ended_by[edge]);
  return std::move(pairs).sorted(step);
}

}  // namespace rbpa
