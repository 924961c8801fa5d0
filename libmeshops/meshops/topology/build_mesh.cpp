#include "meshops/topology/build_mesh.h"

#include <algorithm>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/topology/soup_defects.h"
#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

/// Whether there are no defects but pinches: where all edges fit, the directions of the faces agree as they are.
bool is_oriented_manifold(const detail::FaceFaults& faults, const detail::SoupSides& sides) {
  for (const detail::FaceFault fault : faults.of)
    if (fault != detail::FaceFault::none) return false;
  for (std::size_t e = 0; e < sides.edges(); ++e)
    if (!detail::fits(sides.edge(e))) return false;
  return true;
}

/// The vertex of each corner, and the point of each vertex.
struct Vertices {
  std::vector<int> of_corner;
  std::vector<std::uint32_t> point;
};

Vertices number_vertices(const PolygonSoup& soup, const detail::SoupSides& sides) {
  auto fans = detail::fans_of(soup, sides, [](auto) { return true; });
  Vertices vertices{std::vector<int>(soup.corners.size()), {}};
  for (std::uint32_t p = 0; p < soup.points; ++p) vertices.point.push_back(p);
  std::vector<bool> taken(soup.points, false);
  for (std::uint32_t c = 0; c < soup.corners.size(); ++c) {
    // The root of a set is its least corner, so that it has its vertex already.
    const std::uint32_t root = fans.find(c);
    if (root != c) {
      vertices.of_corner[c] = vertices.of_corner[root];
      continue;
    }
    const std::uint32_t p = soup.corners[c];
    vertices.of_corner[c] = static_cast<int>(taken[p] ? vertices.point.size() : p);
    if (taken[p]) vertices.point.push_back(p);
    taken[p] = true;
  }
  return vertices;
}

/// The boundary halfedge that leaves the end of a boundary halfedge: around the fan there.
Halfedge next_on_boundary(const Connectivity& mesh, Halfedge h) {
  Halfedge out = mesh.opposite_halfedge_handle(h);
  do {
    out = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(out));
  } while (!mesh.is_boundary(out));
  return out;
}

}  // namespace

std::vector<std::uint32_t> build_mesh(Connectivity& mesh, const PolygonSoup& soup) {
  require(mesh.n_vertices() == 0 && mesh.n_edges() == 0 && mesh.n_faces() == 0, "build_mesh: the mesh is not empty");
  const detail::FaceFaults faults = detail::find_face_faults(soup);
  const detail::SoupSides sides(soup, faults);
  if (!is_oriented_manifold(faults, sides))
    for (const SoupDefect& defect : find_defects(soup))
      if (defect.kind != SoupDefectKind::pinch) throw ContractViolation("build_mesh: " + describe(defect));

  Vertices vertices = number_vertices(soup, sides);
  mesh.resize(vertices.point.size(), sides.edges(), soup.faces());

  std::vector<Halfedge> side_of_corner(soup.corners.size());
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    const auto ends = [&](const detail::SoupSide& s) {
      const int low = vertices.of_corner[sides.corner_at_low(s)], high = vertices.of_corner[sides.corner_at_high(s)];
      return s.ascending ? std::pair(low, high) : std::pair(high, low);
    };
    const Halfedge h = mesh.halfedge_handle(OpenMesh::EdgeHandle(static_cast<int>(e)), 0);
    const auto [from, to] = ends(edge[0]);
    mesh.set_vertex_handle(h, Vertex(to));
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(h), Vertex(from));
    side_of_corner[edge[0].corner] = h;
    if (edge.size() == 2) side_of_corner[edge[1].corner] = mesh.opposite_halfedge_handle(h);
  }
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    const std::size_t begin = soup.begin[f], end = soup.begin[f + 1];
    mesh.set_halfedge_handle(Face(static_cast<int>(f)), side_of_corner[begin]);
    for (std::size_t c = begin; c < end; ++c) {
      const Halfedge h = side_of_corner[c];
      mesh.set_face_handle(h, Face(static_cast<int>(f)));
      mesh.set_next_halfedge_handle(h, side_of_corner[c + 1 < end ? c + 1 : begin]);
      mesh.set_halfedge_handle(mesh.from_vertex_handle(h), h);
    }
  }
  for_each_halfedge(mesh, [&](Halfedge h) {
    if (!mesh.is_boundary(h)) return;
    mesh.set_next_halfedge_handle(h, next_on_boundary(mesh, h));
    mesh.set_halfedge_handle(mesh.from_vertex_handle(h), h);
  });
  return vertices.point;
}

PolygonSoup soup_of(const Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex) {
  require(point_of_vertex.empty() || point_of_vertex.size() == mesh.n_vertices(),
          "soup_of: not one point for each vertex");
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
