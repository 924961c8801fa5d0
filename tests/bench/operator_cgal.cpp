#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "bench/operator_contest.h"

namespace meshops_bench {
namespace {

using Point = CGAL::Simple_cartesian<float>::Point_3;  // float, as is OpenMesh's default
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
using HalfedgePairs = std::vector<std::pair<Halfedge, Halfedge>>;
namespace Euler = CGAL::Euler;

void make_room(SurfaceMesh& mesh, const Task& task) {
  mesh.reserve(task.vertices, static_cast<SurfaceMesh::size_type>(task.vertices + task.triangles.size() + 1),
               static_cast<SurfaceMesh::size_type>(task.triangles.size()));
}

SurfaceMesh room_for(const Task& task) {
  SurfaceMesh mesh;
  make_room(mesh, task);
  for (std::uint32_t v = 0; v < task.vertices; ++v) mesh.add_vertex();
  return mesh;
}

void add_all(SurfaceMesh& mesh, const Task& task) {
  for (const Corners& t : task.triangles)
    Euler::add_face(std::array<Vertex, 3>{Vertex(t[0]), Vertex(t[1]), Vertex(t[2])}, mesh);
}

SurfaceMesh mesh_of(const Task& task) {
  SurfaceMesh mesh = room_for(task);
  add_all(mesh, task);
  return mesh;
}

}  // namespace

template <>
void copy_with_room(const SurfaceMesh& from, SurfaceMesh& to) {
  to = from;
  to.reserve(2 * from.num_vertices(), 2 * from.num_edges(), 2 * from.num_faces());
}

template <>
Shape shape_of(const SurfaceMesh& mesh) {
  Shape shape{mesh.number_of_vertices(), mesh.number_of_edges()};
  for (const auto f : mesh.faces()) {
    Corners corners{};
    std::size_t i = 0;
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) corners.at(i++) = mesh.source(h);
    shape.add_triangle(corners);
  }
  return shape;
}

namespace {

Halfedge halfedge(const SurfaceMesh& mesh, std::uint32_t from, std::uint32_t to) {
  const Halfedge h = mesh.halfedge(Vertex(from), Vertex(to));
  if (h == SurfaceMesh::null_halfedge()) throw std::runtime_error("a site is not in the mesh");
  return h;
}
Halfedge halfedge_of(const SurfaceMesh& mesh, const Site& site) { return halfedge(mesh, site[0], site[1]); }

void split_edge(SurfaceMesh& mesh, Halfedge h) {
  const Halfedge o = mesh.opposite(h), to_new = Euler::split_edge(h, mesh);
  if (!mesh.is_border(h)) Euler::split_face(to_new, mesh.next(h), mesh);
  if (!mesh.is_border(o)) Euler::split_face(o, mesh.next(mesh.opposite(to_new)), mesh);
}

/// The two faces at the new edge have four sides until they are split.
void split_vertex(SurfaceMesh& mesh, const std::pair<Halfedge, Halfedge>& from_right_to_left) {
  const Halfedge h = Euler::split_vertex(from_right_to_left.first, from_right_to_left.second, mesh);
  const Halfedge o = mesh.opposite(h);
  Euler::split_face(mesh.prev(h), mesh.next(h), mesh);
  Euler::split_face(o, mesh.prev(mesh.prev(o)), mesh);
}

struct Soup {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

Soup soup_of(const Task& task) {
  Soup soup{std::vector<Point>(task.vertices, Point(0, 0, 0)), {}};
  for (const Corners& t : task.triangles) soup.triangles.push_back({t[0], t[1], t[2]});
  return soup;
}

}  // namespace

Contestant cgal_at(const Task& task) {
  const auto at = [&](auto locate, auto step) { return at_sites(mesh_of(task), task, locate, step); };
  switch (task.operation) {
    case Operation::split_edge:
      return at(halfedge_of, split_edge);
    case Operation::split_face:
      return at(halfedge_of, [](SurfaceMesh& m, Halfedge h) { Euler::add_center_vertex(h, m); });
    case Operation::flip:
      return at(halfedge_of, [](SurfaceMesh& m, Halfedge h) {
        const Halfedge o = m.opposite(h);
        if (m.is_border(h) || m.is_border(o)) return;
        if (CGAL::halfedge(m.target(m.next(h)), m.target(m.next(o)), m).second) return;
        Euler::flip_edge(h, m);
      });
    case Operation::collapse:
      return at(halfedge_of, [](SurfaceMesh& m, Halfedge h) {
        if (Euler::does_satisfy_link_condition(m.edge(h), m)) Euler::collapse_edge(m.edge(h), m);
      });
    case Operation::split_vertex:
      return at(
          [](const SurfaceMesh& m, const Site& s) {
            return std::pair(m.opposite(halfedge(m, s[0], s[2])), m.prev(halfedge(m, s[0], s[1])));
          },
          split_vertex);
    case Operation::open_curve:
      return at(halfedge_of, [](SurfaceMesh& m, Halfedge h) { Euler::make_hole(h, m); });
    case Operation::close_curve: {
      SurfaceMesh mesh = mesh_of(task);
      for (const Site& site : task.sites) Euler::make_hole(halfedge_of(mesh, site), mesh);
      return at_sites(mesh, task, halfedge_of, [](SurfaceMesh& m, Halfedge h) { Euler::fill_hole(h, m); });
    }
    case Operation::add_triangles:
      return at_once<SurfaceMesh>([&task](SurfaceMesh& m) { return m = room_for(task), make_room(m, task), 0; },
                                  [&task](SurfaceMesh& m, int) { add_all(m, task); });
    case Operation::build_mesh:
      return at_once<SurfaceMesh>([](SurfaceMesh&) { return 0; },
                                  [soup = soup_of(task)](SurfaceMesh& m, int) {
                                    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points,
                                                                                                soup.triangles, m);
                                  });
    case Operation::sew_curves:
      break;
  }
  return at_once<SurfaceMesh>(
      [&task, start = mesh_of(task)](SurfaceMesh& m) {
        m = start;
        HalfedgePairs pairs;
        for (std::size_t i = 0; i < task.steps; ++i)
          pairs.push_back({halfedge_of(m, task.sites[i]), halfedge_of(m, task.sites[task.steps + i])});
        return pairs;
      },
      [](SurfaceMesh& m, const HalfedgePairs& pairs) { CGAL::Polygon_mesh_processing::stitch_borders(m, pairs); });
}

}  // namespace meshops_bench
