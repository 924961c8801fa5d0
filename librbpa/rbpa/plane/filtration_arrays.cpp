#include "rbpa/plane/filtration_arrays.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/filtration/elder_rule.h"
#include "rbpa/plane/filtration/filtered_cells.h"
#include "rbpa/plane/filtration/filtered_triangles.h"

namespace rbpa {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// Returns the numbers 0 … count − 1, sorted by `less`.
template <typename Less>
Numbers sorted_numbers(std::size_t count, Steps& pulse, const Less& less) {
  Numbers numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  sort(numbers, pulse, less);
  return numbers;
}

Numbers inverse(const Numbers& order) {
  Numbers place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  return place;
}

/// Adds the distinct points to the arrays, in lexicographic order. Returns the place of each point.
Numbers add_points(FiltrationArrays& arrays, const Numbers& index, std::span<const Point> points, Steps& pulse) {
  const Numbers order = sorted_numbers(
      index.size(), pulse, [&](std::uint32_t a, std::uint32_t b) { return points[index[a]] < points[index[b]]; });
  for (const std::uint32_t v : order) arrays.points.push_back(points[index[v]]);
  return inverse(order);
}

/// Returns the triangles with the places of the points as corners, the smallest first.
std::vector<Triangle> on_places(std::vector<Triangle> triangles, const Numbers& number, const Numbers& place) {
  for (auto& corners : triangles) {
    for (std::uint32_t& corner : corners) corner = place[number[corner]];
    corners = from_least(corners);
  }
  return triangles;
}

/// Adds the triangles to the arrays, sorted by alpha, then by corners. Returns the place of each triangle.
Numbers add_triangles(FiltrationArrays& arrays, const std::vector<Triangle>& triangles,
                      const std::vector<double>& alpha, Steps& pulse) {
  const Numbers order = sorted_numbers(triangles.size(), pulse, [&](std::uint32_t a, std::uint32_t b) {
    return alpha[a] != alpha[b] ? alpha[a] < alpha[b] : triangles[a] < triangles[b];
  });
  for (const std::uint32_t t : order) {
    arrays.triangles.push_back(triangles[t]);
    arrays.alpha.push_back(alpha[t]);
  }
  return inverse(order);
}

/// Returns the cells, numbered as in the arrays, with the edges sorted by alpha, then by ends. The result depends only
/// on the set of points.
FilteredCells renumbered(FilteredCells cells, const Numbers& vertices, const Numbers& faces, Steps& pulse) {
  FilteredCells result = cells;
  for (std::size_t v = 0; v < vertices.size(); ++v) result.vertices[vertices[v]] = cells.vertices[v];
  for (std::size_t f = 0; f < faces.size(); ++f) result.faces[faces[f]] = cells.faces[f];
  for (FilteredCells::Edge& edge : result.edges) {
    for (std::uint32_t& end : edge.ends) end = vertices[end];
    for (std::uint32_t& side : edge.sides)
      if (side != cells.outside()) side = faces[side];
    std::sort(edge.ends.begin(), edge.ends.end());
    std::sort(edge.sides.begin(), edge.sides.end());
  }
  sort(result.edges, pulse, [](const FilteredCells::Edge& a, const FilteredCells::Edge& b) {
    return std::tie(a.alpha, a.ends) < std::tie(b.alpha, b.ends);
  });
  return result;
}

void add_pairs(FiltrationArrays& arrays, const FilteredCells& cells, Steps& pulse) {
  Numbers first_at(arrays.points.size());
  for (std::size_t t = arrays.triangles.size(); t-- > 0;)
    for (const std::uint32_t corner : arrays.triangles[t]) first_at[corner] = static_cast<std::uint32_t>(t);
  pair_components(cells, pulse, [&](const Arrival& birth, const FilteredCells::Edge* ending) {
    const std::optional<double> death = ending == nullptr ? std::nullopt : std::optional(ending->alpha);
    arrays.pairs.push_back({{0, birth.alpha, death}, first_at[birth.cell]});
  });
  pair_holes(cells, pulse, [&](double birth, const Arrival& death) {
    arrays.pairs.push_back({{1, birth, death.alpha}, death.cell});
  });
  const auto key = [](const PlacedPair& p) {
    return std::tuple(p.pair.dimension, p.pair.birth, !p.pair.death, p.pair.death.value_or(0.0), p.triangle);
  };
  sort(arrays.pairs, pulse, [&](const PlacedPair& a, const PlacedPair& b) { return key(a) < key(b); });
}

void add_free_edges(FiltrationArrays& arrays, const FilteredCells& cells, Steps& pulse) {
  for (const FilteredCells::Edge& edge : cells.edges) {
    pulse();
    const std::uint32_t first = edge.sides[0];  // the first to appear: sides ascend, and triangles are sorted by alpha
    if (edge.alpha == arrays.alpha[first]) continue;
    const Triangle& corners = arrays.triangles[first];
    std::uint32_t side = 0;
    while (std::minmax({corners[side], corners[(side + 1) % 3]}) != std::pair(edge.ends[0], edge.ends[1])) ++side;
    arrays.free_edges.push_back({edge.alpha, first, side});
  }
  sort(arrays.free_edges, pulse, [](const FreeEdge& a, const FreeEdge& b) {
    return std::tie(a.alpha, a.triangle, a.side) < std::tie(b.alpha, b.triangle, b.side);
  });
}

}  // namespace

FiltrationArrays filtration_arrays(const Delaunay& delaunay, const Filtration& filtration, const GoOn& go_on) {
  const std::vector<Triangle>& triangles = delaunay.triangulation().triangles;
  require_same(filtration, delaunay.triangulation(), "filtration_arrays");
  Steps pulse(go_on);
  FiltrationArrays arrays;
  const DistinctPoints distinct = distinct_points(delaunay);
  const Numbers place = add_points(arrays, distinct.index, delaunay.points(), pulse);
  if (triangles.empty()) return arrays;
  const Numbers faces =
      add_triangles(arrays, on_places(triangles, distinct.number, place), filtration.triangle_alpha, pulse);
  const auto cells = [&](ComplexKind kind) {
    return renumbered(filtered_cells(delaunay, distinct, filtration, kind, pulse), place, faces, pulse);
  };
  add_pairs(arrays, cells(ComplexKind::solid), pulse);
  add_free_edges(arrays, cells(ComplexKind::full), pulse);
  return arrays;
}

}  // namespace rbpa
