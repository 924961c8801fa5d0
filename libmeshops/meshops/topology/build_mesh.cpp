#include "meshops/topology/build_mesh.h"

#include <algorithm>
#include <numeric>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/reserve.h"
#include "meshops/topology/soup_defects.h"
#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

/// Makes the edges and links them to their faces. Returns: for each corner, the halfedge by which its face leaves it.
std::vector<Halfedge> link_faces(Connectivity& mesh, const PolygonSoup& soup, const detail::SoupSides& sides,
                                 Steps& step) {
  std::vector<Halfedge> side_of_corner(soup.corners.size());
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    step();
    const auto edge = sides.edge(e);
    const Halfedge h = mesh.halfedge_handle(Edge(static_cast<int>(e)), 0);
    side_of_corner[edge[0].corner] = h;
    if (edge.size() == 2) side_of_corner[edge[1].corner] = mesh.opposite_halfedge_handle(h);
  }
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    const std::size_t begin = soup.begin[f], end = soup.begin[f + 1];
    const Face face(static_cast<int>(f));
    mesh.set_halfedge_handle(face, side_of_corner[begin]);
    for (std::size_t c = begin; c < end; ++c) {
      step();
      mesh.set_face_handle(side_of_corner[c], face);
      mesh.set_next_halfedge_handle(side_of_corner[c], side_of_corner[c + 1 < end ? c + 1 : begin]);
    }
  }
  return side_of_corner;
}

/// Makes `v` the start of all edges of the fan around the start of `first`, a halfedge with a face. If the fan is open,
/// also links the boundary at `v`.
void give_fan(Connectivity& mesh, Halfedge first, Vertex v) {
  Halfedge out = first;  // counter-clockwise, as long as there are faces
  do {
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), v);
    out = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(out));
  } while (out != first && !mesh.is_boundary(out));
  mesh.set_halfedge_handle(v, out);
  if (out == first) return;
  mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), v);
  Halfedge in = mesh.opposite_halfedge_handle(first);  // clockwise, up to the boundary
  while (!mesh.is_boundary(in)) {
    in = mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(in));
    mesh.set_vertex_handle(in, v);
  }
  mesh.set_next_halfedge_handle(in, out);
}

/// Fills `mesh`. Returns: the point of each vertex.
std::vector<std::uint32_t> fill(Connectivity& mesh, const PolygonSoup& soup, const detail::SoupSides& sides,
                                Steps& step) {
  reserve(mesh, soup.points, sides.edges(), soup.faces());
  mesh.resize(soup.points, sides.edges(), soup.faces());
  const std::vector<Halfedge> side_of_corner = link_faces(mesh, soup, sides, step);
  std::vector<std::uint32_t> point_of_vertex(soup.points);
  std::iota(point_of_vertex.begin(), point_of_vertex.end(), 0U);
  // Each fan gets its vertex at its first corner in the soup. Before, the halfedges of the fan have no end.
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    step();
    const Halfedge out = side_of_corner[c];
    if (mesh.to_vertex_handle(mesh.opposite_halfedge_handle(out)).is_valid()) continue;
    Vertex v(static_cast<int>(soup.corners[c]));
    if (mesh.halfedge_handle(v).is_valid()) {
      v = mesh.new_vertex();
      point_of_vertex.push_back(soup.corners[c]);
    }
    give_fan(mesh, out, v);
  }
  return point_of_vertex;
}

}  // namespace

std::vector<std::uint32_t> build_mesh(Connectivity& mesh, const PolygonSoup& soup, const GoOn& go_on) {
  require(mesh.n_vertices() == 0 && mesh.n_edges() == 0 && mesh.n_faces() == 0, "build_mesh: the mesh is not empty");
  const auto refuse = [&] {
    for (const SoupDefect& defect : find_defects(soup, go_on))
      if (defect.kind != SoupDefectKind::pinch) throw ContractViolation("build_mesh: " + describe(defect));
  };
  if (!detail::has_sound_faces(soup, go_on)) refuse();
  const detail::SoupSides sides(soup, go_on);
  if (!detail::is_manifold(soup, sides, go_on)) refuse();
  try {
    Steps step(go_on);
    return fill(mesh, soup, sides, step);
  } catch (...) {  // cancelled, or out of memory
    mesh.resize(0, 0, 0);
    throw;
  }
}

PolygonSoup soup_of(const Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex) {
  if (!point_of_vertex.empty())
    require_one_each("soup_of", point_of_vertex.size(), "points", mesh.n_vertices(), "vertices");
  PolygonSoup soup;
  soup.points = point_of_vertex.empty() ? mesh.n_vertices() : 0;
  for (const std::uint32_t p : point_of_vertex) soup.points = std::max<std::size_t>(soup.points, p + std::size_t{1});
  std::vector<std::uint32_t> corners;
  for_each_face(mesh, [&](Face f) {
    corners.clear();
    const Halfedge first = mesh.halfedge_handle(f);
    Halfedge h = first;
    do {
      const auto v = static_cast<std::size_t>(mesh.from_vertex_handle(h).idx());
      corners.push_back(point_of_vertex.empty() ? static_cast<std::uint32_t>(v) : point_of_vertex[v]);
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
    soup.add_face(corners);
  });
  return soup;
}

}  // namespace meshops
