#include "io/triangle_mesh.h"

namespace rbpa::app {
namespace {

/// Calls visit(i) for every index; it may change them.
template <typename Visit>
void for_each_index(std::vector<Triangle>& triangles, std::vector<Edge>& edges, std::vector<std::uint32_t>& points,
                    const Visit& visit) {
  for (Triangle& triangle : triangles)
    for (std::uint32_t& i : triangle) visit(i);
  for (Edge& edge : edges)
    for (std::uint32_t& i : edge) visit(i);
  for (std::uint32_t& i : points) visit(i);
}

}  // namespace

CompactMesh::CompactMesh(const TriangleMesh& mesh)
    : triangles_(mesh.triangles.begin(), mesh.triangles.end()),
      edges_(mesh.edges.begin(), mesh.edges.end()),
      points_(mesh.points.begin(), mesh.points.end()) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for_each_index(triangles_, edges_, points_, [&](std::uint32_t i) { used[i] = true; });
  std::vector<std::uint32_t> renumbered(mesh.vertices.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    renumbered[i] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(mesh.vertices[i]);
  }
  for_each_index(triangles_, edges_, points_, [&](std::uint32_t& i) { i = renumbered[i]; });
}

}  // namespace rbpa::app
