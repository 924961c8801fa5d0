#include "oracle/cgal_topology.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace rbpa_test {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polygons = std::vector<std::vector<std::size_t>>;

Polygons polygons_of(const meshops::PolygonSoup& soup) {
  Polygons polygons;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    const auto face = soup.face(f);
    polygons.emplace_back(face.begin(), face.end());
  }
  return polygons;
}

/// Returns places that distinguish the points; the topology does not depend on them.
std::vector<Point> places(std::size_t points) {
  std::vector<Point> result;
  for (std::size_t p = 0; p < points; ++p) result.emplace_back(static_cast<double>(p), 0, 0);
  return result;
}

std::size_t point_at(const Mesh& mesh, Mesh::Vertex_index v) { return static_cast<std::size_t>(mesh.point(v).x()); }

/// Builds CGAL's mesh of a soup, without points that have no face.
Mesh mesh_of(const meshops::PolygonSoup& soup) {
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(places(soup.points), polygons_of(soup), mesh);
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.is_isolated(v)) mesh.remove_vertex(v);
  return mesh;
}

}  // namespace

bool cgal_takes(const meshops::PolygonSoup& soup) { return pmp::is_polygon_soup_a_polygon_mesh(polygons_of(soup)); }

meshops::PolygonSoup cgal_oriented(const meshops::PolygonSoup& soup) {
  std::vector<Point> points = places(soup.points);
  Polygons polygons = polygons_of(soup);
  pmp::orient_polygon_soup(points, polygons);
  meshops::PolygonSoup oriented;
  oriented.points = points.size();
  for (const std::vector<std::size_t>& polygon : polygons)
    oriented.add_face(std::vector<std::uint32_t>(polygon.begin(), polygon.end()));
  return oriented;
}

std::vector<std::vector<std::uint32_t>> cgal_kept_faces(const meshops::PolygonSoup& soup) {
  std::vector<Point> points = places(soup.points);
  Polygons polygons = polygons_of(soup);
  pmp::repair_polygon_soup(points, polygons);  // removes points without a face
  std::vector<std::vector<std::uint32_t>> faces;
  for (const std::vector<std::size_t>& polygon : polygons) {
    faces.emplace_back();
    for (const std::size_t corner : polygon) faces.back().push_back(static_cast<std::uint32_t>(points[corner].x()));
  }
  return faces;
}

std::vector<CgalPiece> cgal_pieces(const meshops::PolygonSoup& soup) {
  Mesh mesh = mesh_of(soup);
  const auto piece_of = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece").first;
  std::vector<CgalPiece> pieces(pmp::connected_components(mesh, piece_of));
  const auto piece_at = [&](Mesh::Halfedge_index h) -> CgalPiece& {
    return pieces[piece_of[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h)]];
  };
  for (const Mesh::Face_index f : mesh.faces()) ++pieces[piece_of[f]].faces;
  for (const Mesh::Edge_index e : mesh.edges()) ++piece_at(mesh.halfedge(e)).edges;
  for (const Mesh::Vertex_index v : mesh.vertices()) ++piece_at(mesh.halfedge(v)).vertices;
  std::vector<Mesh::Halfedge_index> cycles;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  for (const Mesh::Halfedge_index h : cycles) ++piece_at(h).border_cycles;
  for (CgalPiece& piece : pieces) {
    const long euler =
        static_cast<long>(piece.vertices) - static_cast<long>(piece.edges) + static_cast<long>(piece.faces);
    piece.genus = (2 - euler - static_cast<long>(piece.border_cycles)) / 2;
  }
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

CgalPinches cgal_pinches(const meshops::PolygonSoup& soup, const std::vector<std::uint32_t>& stands_on) {
  Mesh mesh = mesh_of(soup);
  std::vector<Mesh::Vertex_index> vertex_on(soup.points);
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (const std::size_t p = point_at(mesh, v); stands_on[p] == p) vertex_on[p] = v;
  std::vector<Mesh::Vertex_index> copies;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const std::size_t on = stands_on[point_at(mesh, v)];
    if (vertex_on[on] == v) continue;
    for (const Mesh::Halfedge_index h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
      mesh.set_target(h, vertex_on[on]);
    copies.push_back(v);
  }
  for (const Mesh::Vertex_index v : copies) mesh.remove_vertex(v);

  std::vector<Mesh::Halfedge_index> umbrellas;
  pmp::non_manifold_vertices(mesh, std::back_inserter(umbrellas));
  std::set<Mesh::Vertex_index> pinched;
  for (const Mesh::Halfedge_index h : umbrellas) pinched.insert(mesh.target(h));
  return {pinched.size(), pmp::duplicate_non_manifold_vertices(mesh)};
}

}  // namespace rbpa_test
