#include "rbpa/filtration/persistence.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "rbpa/filtration/disjoint_sets.h"
#include "rbpa/filtration/filtered_cells.h"
#include "rbpa/filtration/pulse.h"

namespace rbpa {
namespace {

bool before(const PersistencePair& a, const PersistencePair& b) {
  const auto key = [](const PersistencePair& p) {
    return std::tuple(p.dimension, p.birth, !p.death, p.death.value_or(0.0));
  };
  return key(a) < key(b);
}

/// Edges ascending: an edge between two components ends the younger.
void pair_components(const FilteredCells& cells, std::vector<PersistencePair>& pairs, Pulse& pulse) {
  DisjointSets components(cells.vertices.size());
  std::vector<double> birth = cells.vertices;  // of the component, at the vertex that stands for it
  for (const FilteredCells::Edge& edge : cells.edges) {
    pulse.beat();
    const std::uint32_t a = components.find(edge.ends[0]), b = components.find(edge.ends[1]);
    if (a == b) continue;
    const auto [elder, younger] = std::minmax({birth[a], birth[b]});
    if (younger < edge.alpha) pairs.push_back({0, younger, edge.alpha});
    birth[components.link(a, b)] = elder;
  }
  for (std::uint32_t v = 0; v < birth.size(); ++v)
    if (components.find(v) == v) pairs.push_back({0, birth[v], std::nullopt});
}

/// Edges descending: taking an edge away joins the gaps on its sides. A gap fills up with the last of its triangles;
/// of two that are separate above this alpha the one that fills up first is a hole from here to there.
void pair_holes(const FilteredCells& cells, std::vector<PersistencePair>& pairs, Pulse& pulse) {
  DisjointSets gaps(cells.faces.size() + 1);
  std::vector<double> filled = cells.faces;
  filled.push_back(std::numeric_limits<double>::infinity());  // the outside
  for (auto edge = cells.edges.rbegin(); edge != cells.edges.rend(); ++edge) {
    pulse.beat();
    const std::uint32_t a = gaps.find(edge->sides[0]), b = gaps.find(edge->sides[1]);
    if (a == b) continue;
    const auto [first, last] = std::minmax({filled[a], filled[b]});
    if (edge->alpha < first) pairs.push_back({1, edge->alpha, first});
    filled[gaps.link(a, b)] = last;
  }
}

}  // namespace

std::vector<PersistencePair> persistence(const SolidAlphaComplex& delaunay, std::span<const Point> points,
                                         const Filtration& filtration, ComplexKind kind,
                                         const std::function<bool()>& go_on) {
  Pulse pulse(go_on);
  FilteredCells cells = filtered_cells(delaunay, points, filtration, kind, pulse);
  // In which order equal alphas come changes pairs of no length only.
  std::sort(cells.edges.begin(), cells.edges.end(), [&](const FilteredCells::Edge& a, const FilteredCells::Edge& b) {
    pulse.beat();
    return a.alpha < b.alpha;
  });
  std::vector<PersistencePair> pairs;
  pair_components(cells, pairs, pulse);
  pair_holes(cells, pairs, pulse);
  std::sort(pairs.begin(), pairs.end(), [&](const PersistencePair& a, const PersistencePair& b) {
    pulse.beat();
    return before(a, b);
  });
  return pairs;
}

}  // namespace rbpa
