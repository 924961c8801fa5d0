#include "rbpa/plane/filtration/filtered_cells.h"

#include <algorithm>
#include <limits>

#include "rbpa/plane/filtration/corners.h"
#include "rbpa/plane/filtration/least_alpha.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The edges of the triangulation, each at the alpha of the first of its triangles.
FilteredCells cells_of(const Mesh& mesh, const std::vector<double>& triangle_alpha, Pulse& pulse) {
  FilteredCells cells;
  cells.faces = triangle_alpha;
  cells.edges.resize(mesh.n_edges());
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    pulse.beat();
    FilteredCells::Edge& edge = cells.edges[e];
    edge.alpha = infinity;
    for (const unsigned side : {0u, 1u}) {
      const auto h = mesh.halfedge_handle(meshops::Edge(static_cast<int>(e)), side);
      const auto face = mesh.face_handle(h);
      edge.ends[side] = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      edge.sides[side] = face.is_valid() ? static_cast<std::uint32_t>(face.idx()) : cells.outside();
      if (face.is_valid()) edge.alpha = std::min(edge.alpha, triangle_alpha[edge.sides[side]]);
    }
  }
  return cells;
}

/// Some point is inside the circle whose diameter the edge is; then one of the two apexes is.
bool is_crowded(const Corners& corners, const Mesh& mesh, meshops::Edge edge) {
  for (const unsigned side : {0u, 1u}) {
    const auto h = mesh.halfedge_handle(edge, side);
    if (mesh.is_boundary(h)) continue;
    const Point& apex = corners.of_vertex(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
    const Point& a = corners.of_vertex(mesh.from_vertex_handle(h));
    const Point& b = corners.of_vertex(mesh.to_vertex_handle(h));
    if (Predicates<long double>::dot_sign(apex, a, b) < 0) return true;
  }
  return false;
}

/// An edge with no point inside its diametral circle comes at half its length, any other with its first triangle.
void bring_free_edges_forward(FilteredCells& cells, const Corners& corners, const Mesh& mesh, Pulse& pulse) {
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    pulse.beat();
    const meshops::Edge edge(static_cast<int>(e));
    const auto h = mesh.halfedge_handle(edge, 0);
    const double half =
        least_alpha(corners.of_vertex(mesh.from_vertex_handle(h)), corners.of_vertex(mesh.to_vertex_handle(h)));
    // Asked last, because on grids, where right angles are the rule, both are the same.
    if (half != cells.edges[e].alpha && !is_crowded(corners, mesh, edge)) cells.edges[e].alpha = half;
  }
}

/// Points on a line: neighbours on it are joined at half their distance.
FilteredCells cells_on_line(const std::vector<std::uint32_t>& distinct, std::span<const Point> points, Pulse& pulse) {
  std::vector<Point> line;
  for (const std::uint32_t i : distinct) {
    meshops::require(i < points.size(), "persistence: the complex is of other points than those given");
    line.push_back(points[i]);
  }
  std::sort(line.begin(), line.end(), [&](const Point& a, const Point& b) {
    pulse.beat();
    return a < b;
  });
  FilteredCells cells;
  cells.vertices.assign(line.size(), 0.0);
  for (std::uint32_t i = 1; i < line.size(); ++i) {
    pulse.beat();
    cells.edges.push_back({least_alpha(line[i - 1], line[i]), {i - 1, i}, {cells.outside(), cells.outside()}});
  }
  return cells;
}

}  // namespace

FilteredCells filtered_cells(const SolidAlphaComplex& delaunay, std::span<const Point> points,
                             const Filtration& filtration, ComplexKind kind, Pulse& pulse) {
  const Mesh& mesh = delaunay.mesh;
  meshops::require(filtration.triangle_alpha.size() == mesh.n_faces() && filtration.distinct == delaunay.distinct,
                   "persistence: the filtration is of another complex");
  const Corners corners(delaunay, points);
  if (mesh.n_faces() == 0)
    return kind == ComplexKind::full ? cells_on_line(delaunay.isolated, points, pulse) : FilteredCells();

  FilteredCells cells = cells_of(mesh, filtration.triangle_alpha, pulse);
  if (kind == ComplexKind::full) {
    cells.vertices.assign(mesh.n_vertices(), 0.0);
    bring_free_edges_forward(cells, corners, mesh, pulse);
  } else {
    cells.vertices.assign(mesh.n_vertices(), infinity);
    for (const FilteredCells::Edge& edge : cells.edges)
      for (const std::uint32_t v : edge.ends) cells.vertices[v] = std::min(cells.vertices[v], edge.alpha);
  }
  return cells;
}

}  // namespace rbpa
