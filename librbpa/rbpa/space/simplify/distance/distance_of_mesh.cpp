#include "rbpa/space/simplify/distance/distance_of_mesh.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/core/live_range.h"
#include "rbpa/base/error.h"

namespace rbpa::space {

void require_places(const char* operation, const meshops::Connectivity& mesh, const std::vector<Point3>& places) {
  meshops::require_one_each(operation, places.size(), "places", mesh.n_vertices(), "vertices");
  for (const meshops::Vertex v : meshops::live_vertices(mesh))
    if (!is_finite(places[static_cast<std::size_t>(v.idx())]))
      throw InvalidInput(operation + (": found coordinates of vertex " + std::to_string(v.idx())) +
                         " that are not finite, expected numbers");
}

std::vector<std::array<std::uint32_t, 3>> corners_of(const meshops::Connectivity& mesh) {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (const meshops::Face f : meshops::live_faces(mesh)) {
    auto& corners = all.emplace_back();
    meshops::Halfedge h = mesh.halfedge_handle(f);
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
  }
  return all;
}

double distance_of(const meshops::Connectivity& mesh, const std::vector<Point3>& places, const SurfaceDistance& given,
                   const GoOn& go_on) {
  return distance_of(corners_of(mesh), places, given, go_on);
}

double distance_of(const std::vector<std::array<std::uint32_t, 3>>& all, const std::vector<Point3>& places,
                   const SurfaceDistance& given, const GoOn& go_on) {
  meshops::Steps step(go_on);
  std::vector<SurfaceDistance::Corners> triangles;
  double least = 0, greatest = 0;
  for (const auto& [a, b, c] : all) {
    auto& corners = triangles.emplace_back(std::array{places[a], places[b], places[c]});
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    least = std::max(least, given.least(corners));
    step(64);
  }
  for (const auto& corners : triangles) {
    greatest = std::max(greatest, given.greatest(corners, least));
    step(256);
  }
  return greatest;
}

}  // namespace rbpa::space
