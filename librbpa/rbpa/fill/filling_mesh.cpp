#include "rbpa/fill/filling_mesh.h"

#include <cstddef>
#include <numeric>

#include "meshops/core/disjoint_sets.h"
#include "meshops/topology/build_mesh.h"
#include "rbpa/base/arrays/fans.h"

namespace rbpa {
FillingMesh filling_mesh(const Filling& filling) {
  require_linked(filling, filling.points.size());
  const GoOn never;
  Steps step(never);
  meshops::DisjointSets fans = fans_of(filling, step);
  // Each fan gets its own point, so that the builder does not glue triangles of different fans along a common edge.
  std::vector<std::uint32_t> point(filling.points.size()), own(fans.size());
  std::iota(point.begin(), point.end(), 0U);
  std::vector<bool> is_taken(point.size(), false);
  meshops::PolygonSoup soup;
  for (std::uint32_t corner = 0; corner < own.size(); ++corner) {
    const std::uint32_t first = fans.find(corner), on = filling.triangles[corner / 3][corner % 3];
    if (first == corner) {
      own[corner] = is_taken[on] ? static_cast<std::uint32_t>(point.size()) : on;
      if (is_taken[on]) point.push_back(on);
      is_taken[on] = true;
    }
    own[corner] = own[first];
    if (corner % 3 == 2) soup.add_face(std::span(own).subspan(corner - 2, 3));
  }
  soup.points = point.size();

  FillingMesh result;
  result.point_of_vertex = meshops::build_mesh(result.mesh, soup);  // indices into the points of the soup
  for (std::uint32_t& p : result.point_of_vertex) p = point[p];
  for (std::size_t v = 0; v < result.point_of_vertex.size(); ++v) {
    const Point& p = filling.points[result.point_of_vertex[v]];
    result.mesh.set_point(meshops::Vertex(static_cast<int>(v)), {p.x, p.y, 0});
  }
  return result;
}

}  // namespace rbpa
