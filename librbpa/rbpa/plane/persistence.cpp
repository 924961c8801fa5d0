#include "rbpa/plane/persistence.h"

#include <tuple>

#include "rbpa/base/run/steps.h"
#include "rbpa/plane/filtration/elder_rule.h"
#include "rbpa/plane/filtration/filtered_cells.h"
#include "rbpa/plane/filtration/filtered_triangles.h"

namespace rbpa {

std::vector<PersistencePair> persistence(const Delaunay& delaunay, const Filtration& filtration, ComplexKind kind,
                                         const GoOn& go_on) {
  require_same(filtration, delaunay.triangulation(), "persistence");
  Steps pulse(go_on);
  FilteredCells cells = filtered_cells(delaunay, distinct_points(delaunay), filtration, kind, pulse);
  // The order of edges with equal alphas affects only pairs with birth = death, which are left out.
  sort(cells.edges, pulse, [](const auto& a, const auto& b) { return a.alpha < b.alpha; });
  std::vector<PersistencePair> pairs;
  pair_components(cells, pulse, [&](const Arrival& birth, const FilteredCells::Edge* ending) {
    pairs.push_back({0, birth.alpha, ending == nullptr ? std::nullopt : std::optional(ending->alpha)});
  });
  pair_holes(cells, pulse, [&](double birth, const Arrival& death) { pairs.push_back({1, birth, death.alpha}); });
  const auto key = [](const PersistencePair& p) {
    return std::tuple(p.dimension, p.birth, !p.death, p.death.value_or(0.0));
  };
  sort(pairs, pulse, [&](const PersistencePair& a, const PersistencePair& b) { return key(a) < key(b); });
  return pairs;
}

}  // namespace rbpa
