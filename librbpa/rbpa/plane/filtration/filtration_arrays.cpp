#include "rbpa/filtration_arrays.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "rbpa/base/pulse.h"
#include "rbpa/plane/filtration/corners.h"
#include "rbpa/plane/filtration/elder_rule.h"
#include "rbpa/plane/filtration/filtered_cells.h"

namespace rbpa {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// 0 … count − 1, sorted.
template <typename Less>
Numbers sorted_numbers(std::size_t count, Pulse& pulse, const Less& less) {
  Numbers numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
    pulse.beat();
    return less(a, b);
  });
  return numbers;
}

Numbers inverse(const Numbers& order) {
  Numbers place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  return place;
}

/// Returns the place of each vertex among the points.
Numbers add_points(FiltrationArrays& arrays, const SolidAlphaComplex& delaunay, std::span<const Point> points,
                   Pulse& pulse) {
  // Points on a line are in no mesh.
  const Numbers& distinct = delaunay.mesh.n_faces() == 0 ? delaunay.isolated : delaunay.input_index;
  const Numbers order = sorted_numbers(distinct.size(), pulse, [&](std::uint32_t a, std::uint32_t b) {
    return points[distinct[a]] < points[distinct[b]];
  });
  for (const std::uint32_t v : order) arrays.points.push_back(points[distinct[v]]);
  return inverse(order);
}

std::array<std::uint32_t, 3> triangle_of(const Mesh& mesh, std::uint32_t face, const Numbers& point_of_vertex) {
  std::array<std::uint32_t, 3> corners{};
  auto h = mesh.halfedge_handle(meshops::Face(static_cast<int>(face)));
  for (std::uint32_t& corner : corners) {
    corner = point_of_vertex[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())];
    h = mesh.next_halfedge_handle(h);
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Returns the place of each face among the triangles.
Numbers add_triangles(FiltrationArrays& arrays, const Mesh& mesh, const std::vector<double>& alpha,
                      const Numbers& point_of_vertex, Pulse& pulse) {
  std::vector<std::array<std::uint32_t, 3>> triangles(mesh.n_faces());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) triangles[f] = triangle_of(mesh, f, point_of_vertex);
  const Numbers order = sorted_numbers(triangles.size(), pulse, [&](std::uint32_t a, std::uint32_t b) {
    return alpha[a] != alpha[b] ? alpha[a] < alpha[b] : triangles[a] < triangles[b];
  });
  for (const std::uint32_t f : order) {
    arrays.triangles.push_back(triangles[f]);
    arrays.alpha.push_back(alpha[f]);
  }
  return inverse(order);
}

/// The same cells by the numbers of the arrays, the edges sorted: which depends on the points alone.
FilteredCells renumbered(FilteredCells cells, const Numbers& vertices, const Numbers& faces, Pulse& pulse) {
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
  std::sort(result.edges.begin(), result.edges.end(), [&](const FilteredCells::Edge& a, const FilteredCells::Edge& b) {
    pulse.beat();
    return std::tie(a.alpha, a.ends) < std::tie(b.alpha, b.ends);
  });
  return result;
}

void add_pairs(FiltrationArrays& arrays, const FilteredCells& cells, Pulse& pulse) {
  Numbers first_at(arrays.points.size());
  for (std::size_t t = arrays.triangles.size(); t-- > 0;)
    for (const std::uint32_t corner : arrays.triangles[t]) first_at[corner] = static_cast<std::uint32_t>(t);
  pair_components(cells, pulse, [&](const Arrival& birth, const std::optional<double>& death) {
    arrays.pairs.push_back({{0, birth.alpha, death}, first_at[birth.cell]});
  });
  pair_holes(cells, pulse, [&](double birth, const Arrival& death) {
    arrays.pairs.push_back({{1, birth, death.alpha}, death.cell});
  });
  const auto key = [](const PlacedPair& p) {
    return std::tuple(p.pair.dimension, p.pair.birth, !p.pair.death, p.pair.death.value_or(0.0), p.triangle);
  };
  std::sort(arrays.pairs.begin(), arrays.pairs.end(), [&](const PlacedPair& a, const PlacedPair& b) {
    pulse.beat();
    return key(a) < key(b);
  });
}

void add_free_edges(FiltrationArrays& arrays, const FilteredCells& cells, Pulse& pulse) {
  for (const FilteredCells::Edge& edge : cells.edges) {
    pulse.beat();
    const std::uint32_t first = edge.sides[0];  // sorted, as the triangles are by alpha
    if (edge.alpha == arrays.alpha[first]) continue;
    const std::array<std::uint32_t, 3>& corners = arrays.triangles[first];
    std::uint32_t side = 0;
    while (std::minmax({corners[side], corners[(side + 1) % 3]}) != std::pair(edge.ends[0], edge.ends[1])) ++side;
    arrays.free_edges.push_back({edge.alpha, first, side});
  }
  std::sort(arrays.free_edges.begin(), arrays.free_edges.end(), [&](const FreeEdge& a, const FreeEdge& b) {
    pulse.beat();
    return std::tie(a.alpha, a.triangle, a.side) < std::tie(b.alpha, b.triangle, b.side);
  });
}

}  // namespace

FiltrationArrays filtration_arrays(const SolidAlphaComplex& delaunay, std::span<const Point> points,
                                   const Filtration& filtration, const std::function<bool()>& go_on) {
  Pulse pulse(go_on);
  // Checks that all are of the same points.
  FilteredCells solid = filtered_cells(delaunay, points, filtration, ComplexKind::solid, pulse);
  FiltrationArrays arrays;
  const Numbers vertices = add_points(arrays, delaunay, points, pulse);
  if (delaunay.mesh.n_faces() == 0) return arrays;
  const Numbers faces = add_triangles(arrays, delaunay.mesh, filtration.triangle_alpha, vertices, pulse);
  add_pairs(arrays, renumbered(std::move(solid), vertices, faces, pulse), pulse);
  const FilteredCells full = filtered_cells(delaunay, points, filtration, ComplexKind::full, pulse);
  add_free_edges(arrays, renumbered(full, vertices, faces, pulse), pulse);
  return arrays;
}

}  // namespace rbpa
