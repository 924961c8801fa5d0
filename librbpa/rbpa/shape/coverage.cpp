#include "rbpa/shape/coverage.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rbpa/shape/components.h"
#include "rbpa/shape/nesting.h"
#include "rbpa/shape/steps.h"

namespace rbpa {
namespace {

using Number = std::optional<std::uint32_t>;

/// The first edge of a shell, by input indices. It is on no other ring.
struct FirstEdge {
  std::uint32_t from, to, polygon;
};

/// For each component of the mesh, by its least vertex, the polygon that it is; absent where it is none.
std::vector<Number> polygon_of_components(const SolidAlphaComplex& complex, std::span<const Polygon> polygons,
                                          meshops::DisjointSets& components, Steps& step) {
  std::vector<FirstEdge> firsts;
  for (std::uint32_t p = 0; p < polygons.size(); ++p)
    firsts.push_back({polygons[p].shell.points[0], polygons[p].shell.points[1], p});
  const auto key = [](const FirstEdge& edge) { return std::pair(edge.from, edge.to); };
  const auto less = [&](const FirstEdge& a, const FirstEdge& b) { return key(a) < key(b); };
  sort(firsts, step, less);

  const Mesh& mesh = complex.mesh;
  std::vector<Number> polygon(mesh.n_vertices());
  for (const auto h : mesh.halfedges()) {
    step();
    if (mesh.is_boundary(h) || !mesh.is_boundary(mesh.opposite_halfedge_handle(h))) continue;
    const auto from = static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx());
    const auto to = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
    const FirstEdge wanted{complex.input_index[from], complex.input_index[to], 0};
    const auto found = std::lower_bound(firsts.begin(), firsts.end(), wanted, less);
    if (found != firsts.end() && key(*found) == key(wanted)) polygon[components.find(from)] = found->polygon;
  }
  return polygon;
}

}  // namespace

std::vector<Number> polygon_of_points(const SolidAlphaComplex& complex, std::span<const Polygon> polygons,
                                      const PolygonFilter& filter, std::span<const Point> points,
                                      const std::function<bool()>& go_on) {
  Steps step(go_on);
  meshops::DisjointSets components = components_of(complex.mesh, step);
  const std::vector<Number> polygon = polygon_of_components(complex, polygons, components, step);
  std::vector<Number> result(points.size());
  for (std::uint32_t v = 0; v < complex.input_index.size(); ++v) {
    step();
    Number& of_point = result[complex.input_index[v]];
    const Number here = polygon[components.find(v)];
    if (here && (!of_point || *here < *of_point)) of_point = here;
  }
  if (filter.min_hole_area > 0) {
    // What is in no polygon so far may be in a hole that was filled.
    std::vector<bool> repeats(points.size(), false);
    for (const Duplicate& duplicate : complex.duplicates) repeats[duplicate.index] = true;
    std::vector<std::uint32_t> queries;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (!result[i] && !repeats[i]) queries.push_back(i);
    const std::vector<Number> around = polygons_around(polygons, points, queries, step);
    for (std::size_t q = 0; q < queries.size(); ++q) result[queries[q]] = around[q];
  }
  for (const Duplicate& duplicate : complex.duplicates) result[duplicate.index] = result[duplicate.stands_for];
  return result;
}

}  // namespace rbpa
