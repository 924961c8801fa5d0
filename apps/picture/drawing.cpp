#include "picture/drawing.h"

#include <algorithm>

#include "io/interrupt.h"
#include "io/sort.h"
#include "meshops/front/boundary_curve.h"

namespace rbpa::app {
namespace {

/// The curve from its least point on; where it passes that point several times (a pinch), the next point decides.
std::vector<std::uint32_t> from_least_edge(std::vector<std::uint32_t> curve) {
  const std::size_t length = curve.size();
  std::size_t first = 0;
  const auto edge = [&](std::size_t i) { return Edge{curve[i], curve[(i + 1) % length]}; };
  for (std::size_t i = 1; i < length; ++i)
    if (edge(i) < edge(first)) first = i;
  std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(first), curve.end());
  return curve;
}

}  // namespace

Drawing drawing_of(std::span<const Point> points, const SolidAlphaComplex& complex) {
  Drawing drawing{.points = points, .inner_edges = {}, .curves = {}, .isolated = complex.isolated};
  const Mesh& mesh = complex.mesh;
  const auto input = [&](OpenMesh::VertexHandle v) { return complex.input_index[static_cast<std::size_t>(v.idx())]; };

  drawing.inner_edges.reserve(mesh.n_edges());
  for (const auto edge : mesh.edges()) {
    if (edge.idx() % 16384 == 0) stop_if_interrupted();
    if (mesh.is_boundary(edge)) continue;
    const auto halfedge = mesh.halfedge_handle(edge, 0);
    const std::uint32_t a = input(mesh.from_vertex_handle(halfedge)), b = input(mesh.to_vertex_handle(halfedge));
    drawing.inner_edges.push_back({std::min(a, b), std::max(a, b)});
  }
  sort(drawing.inner_edges);

  for (const meshops::BoundaryCurve& boundary : meshops::boundary_curves(mesh)) {
    stop_if_interrupted();
    std::vector<std::uint32_t> curve;
    for (const meshops::Halfedge halfedge : boundary) curve.push_back(input(mesh.from_vertex_handle(halfedge)));
    drawing.curves.push_back(from_least_edge(std::move(curve)));
  }
  sort(drawing.curves);
  return drawing;
}

Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint32_t> isolated) {
  Drawing drawing{.points = points, .inner_edges = {}, .curves = {}, .isolated = isolated};
  for (const Polygon& polygon : polygons) {
    drawing.curves.push_back(polygon.shell.points);
    for (const Ring& hole : polygon.holes) drawing.curves.push_back(hole.points);
  }
  return drawing;
}

}  // namespace rbpa::app
