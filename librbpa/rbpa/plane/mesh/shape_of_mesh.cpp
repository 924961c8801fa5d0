// Polygons of a complex that is a mesh: its faces as triangles in arrays, on the input points.
#include <algorithm>

#include "rbpa/plane/complex.h"
#include "rbpa/plane/mesh/linked_faces.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/polygon_of_points.h"

namespace rbpa {
namespace {

OwnedTriangles faces_on_points(const SolidAlphaComplex& complex) {
  OwnedTriangles faces = linked_faces(complex.mesh);
  for (auto& corners : faces.triangles)
    for (std::uint32_t& corner : corners) corner = complex.input_index[corner];
  return faces;
}

/// Returns the input points by index, up to the last that carries a vertex; points without a vertex are (0, 0).
std::vector<Point> points_under(const SolidAlphaComplex& complex) {
  std::size_t size = 0;
  for (const std::uint32_t p : complex.input_index) size = std::max(size, std::size_t{p} + 1);
  std::vector<Point> points(size);
  for (std::size_t v = 0; v < complex.input_index.size(); ++v) {
    const auto at = complex.mesh.point(Mesh::VertexHandle(static_cast<int>(v)));
    points[complex.input_index[v]] = {at[0], at[1]};
  }
  return points;
}

}  // namespace

std::vector<Polygon> outline_polygons(const SolidAlphaComplex& complex, const PolygonFilter& filter,
                                      const GoOn& go_on) {
  return outline_polygons(points_under(complex), faces_on_points(complex), filter, go_on);
}

std::vector<std::optional<std::uint32_t>> polygon_of_points(const SolidAlphaComplex& complex,
                                                            std::span<const Polygon> polygons,
                                                            const PolygonFilter& filter, std::span<const Point> points,
                                                            const GoOn& go_on) {
  return polygon_of_points(points, faces_on_points(complex), complex.duplicates, polygons, filter, go_on);
}

}  // namespace rbpa
