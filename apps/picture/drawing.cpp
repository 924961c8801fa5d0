#include "picture/drawing.h"

#include <algorithm>
#include <utility>

#include "io/interrupt.h"
#include "io/sort.h"
#include "rbpa/plane/boundary_curves.h"

namespace rbpa::app {
namespace {

/// Returns the closed curve rotated so that its least edge is first: the edge from the lowest index. If the lowest
/// index occurs several times (a pinch), the edge with the lowest next index is first.
std::vector<std::uint32_t> from_least_edge(std::vector<std::uint32_t> curve) {
  const std::size_t length = curve.size();
  std::size_t first = 0;
  const auto edge = [&](std::size_t i) { return Edge{curve[i], curve[(i + 1) % length]}; };
  for (std::size_t i = 1; i < length; ++i)
    if (edge(i) < edge(first)) first = i;
  std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(first), curve.end());
  return curve;
}

void put_in_order(Drawing& drawing) {
  sort(drawing.inner_edges);
  for (std::vector<std::uint32_t>& curve : drawing.curves) curve = from_least_edge(std::move(curve));
  sort(drawing.curves);
}

}  // namespace

Drawing drawing_of(std::span<const Point> points, const AlphaComplex& complex, ComplexKind kind) {
  Drawing drawing{.points = points,
                  .inner_edges = {},
                  .curves = boundary_curves(complex, until_interrupted()),
                  .isolated = kind == ComplexKind::full ? complex.points : complex.isolated,
                  .dangling = complex.edges};
  drawing.inner_edges.reserve(complex.triangles.size() * 3 / 2);
  for (std::uint32_t t = 0; t < complex.triangles.size(); ++t) {
    if (t % 16384 == 0) stop_if_interrupted();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = complex.neighbors[t][k];
      if (other == AlphaComplex::none || other < t) continue;
      const std::uint32_t a = complex.triangles[t][(k + 1) % 3], b = complex.triangles[t][(k + 2) % 3];
      drawing.inner_edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  put_in_order(drawing);
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

Drawing drawing_of(std::span<const Point> points, std::span<const Polygon> polygons,
                   std::span<const std::uint64_t> polygon_begin, std::span<const std::string> names) {
  Drawing drawing = drawing_of(points, polygons, {});
  std::size_t curves = 0, polygon = 0;
  for (const std::uint64_t begin : polygon_begin) {
    for (; polygon < begin; ++polygon) curves += 1 + polygons[polygon].holes.size();
    drawing.groups.push_back(curves);
  }
  drawing.group_names = names;
  return drawing;
}

}  // namespace rbpa::app
