// What:   the elder rule, while the cells of a triangulation are added in ascending order: births and deaths of
//         components, each with its first vertex, and of holes, each with its last face.
// Law:    when two components meet, the younger dies; of two components with the same alpha of birth, the component
//         whose first vertex has the greater number dies.
// Cost:   near-linear.
// Source: Edelsbrunner, Letscher, Zomorodian (2002); Delfinado, Edelsbrunner (1995);
//         docs/explanation/filtration_and_persistence.md, section 5.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/filtration/filtered_cells.h"

namespace rbpa {

/// A cell and the alpha at which it is added.
struct Arrival {
  double alpha;
  std::uint32_t cell;  ///< a vertex, or a face
  friend auto operator<=>(const Arrival&, const Arrival&) = default;
};

/// Pairs components. Edges are added in ascending order; an edge between two components ends the younger. Calls
/// pair(birth, edge) for each component with birth.alpha < death: `birth` is the Arrival of its first vertex, `edge` a
/// pointer to the edge that ends the component, null if no edge does.
/// Requires: the edges of `cells` are sorted by alpha.
template <typename Pair>
void pair_components(const FilteredCells& cells, Steps& pulse, const Pair& pair) {
  meshops::DisjointSets components(cells.vertices.size());
  std::vector<Arrival> first;  // first vertex of each component, at the number of its representative vertex
  first.reserve(cells.vertices.size());
  for (std::uint32_t v = 0; v < cells.vertices.size(); ++v) first.push_back({cells.vertices[v], v});
  for (const FilteredCells::Edge& edge : cells.edges) {
    pulse();
    const std::uint32_t a = components.find(edge.ends[0]), b = components.find(edge.ends[1]);
    if (a == b) continue;
    const auto [elder, younger] = std::minmax({first[a], first[b]});
    if (younger.alpha < edge.alpha) pair(younger, &edge);
    first[components.link(a, b)] = elder;
  }
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (components.find(v) == v) pair(first[v], static_cast<const FilteredCells::Edge*>(nullptr));
}

/// Pairs holes. Edges are removed by descending alpha. A gap is a bounded or unbounded piece outside of the complex;
/// each removal joins the two gaps beside the edge. A gap is filled when the last of its triangles is added. Of two
/// gaps that an edge separates, the gap that is filled first is a hole from the alpha of the edge until then. Calls
/// pair(birth, death) for each hole with birth < death.alpha: `birth` is the alpha of the edge, `death` the Arrival of
/// the face that fills the hole.
/// Requires: the edges of `cells` are sorted by alpha.
template <typename Pair>
void pair_holes(const FilteredCells& cells, Steps& pulse, const Pair& pair) {
  meshops::DisjointSets gaps(cells.faces.size() + 1);
  std::vector<Arrival> last;
  last.reserve(cells.faces.size() + 1);
  for (std::uint32_t f = 0; f < cells.faces.size(); ++f) last.push_back({cells.faces[f], f});
  last.push_back({std::numeric_limits<double>::infinity(), cells.outside()});
  for (auto edge = cells.edges.rbegin(); edge != cells.edges.rend(); ++edge) {
    pulse();
    const std::uint32_t a = gaps.find(edge->sides[0]), b = gaps.find(edge->sides[1]);
    if (a == b) continue;
    const auto [first, survivor] = std::minmax({last[a], last[b]});
    if (edge->alpha < first.alpha) pair(edge->alpha, first);
    last[gaps.link(a, b)] = survivor;
  }
}

}  // namespace rbpa
