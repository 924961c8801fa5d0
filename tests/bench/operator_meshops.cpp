#include <map>
#include <unordered_map>
#include <utility>

#include "bench/operator_openmesh.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/insert_triangle.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/topology/build_mesh.h"

namespace meshops_bench {
namespace {

using meshops::Edge;
using meshops::Face;
using meshops::Halfedge;
using meshops::Keep;
using meshops::Vertex;

Edge edge_of(const TriMesh& m, const Site& s) { return m.edge_handle(halfedge(m, s[0], s[1])); }
Halfedge halfedge_of(const TriMesh& m, const Site& s) { return halfedge(m, s[0], s[1]); }
std::pair<Halfedge, Halfedge> left_and_right(const TriMesh& m, const Site& s) {
  return {halfedge(m, s[0], s[1]), halfedge(m, s[0], s[2])};
}

meshops::PolygonSoup soup_of(const Task& task) {
  meshops::PolygonSoup soup;
  soup.points = task.vertices;
  for (const Corners& t : task.triangles) soup.add_face(t);
  return soup;
}

/// Returns a table: entry 3t + i is the side of an earlier triangle to which side i of triangle t is glued, or -1.
std::vector<int> earlier_sides(const Task& task) {
  std::unordered_map<std::uint64_t, int> sides;
  std::vector<int> earlier;
  for (const Corners& t : task.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t from = t[i], to = t[(i + 1) % 3];
      const auto found = sides.find(to << 32U | from);
      sides[from << 32U | to] = static_cast<int>(earlier.size());
      earlier.push_back(found == sides.end() ? -1 : found->second);
    }
  return earlier;
}

/// Inserts triangles. A front knows the boundary halfedge to which each triangle is attached; here a table gives it.
std::unique_ptr<Contestant> insert_triangles(const Task& task) {
  return at_once(
      [&task](TriMesh& m) {
        m.reserve(task.vertices, task.vertices + task.triangles.size() + 1, task.triangles.size());
        for (std::uint32_t v = 0; v < task.vertices; ++v) m.new_vertex();
      },
      [&task, earlier = earlier_sides(task), side = std::vector<Halfedge>()](TriMesh& m) mutable {
        side.resize(3 * task.triangles.size());
        for (std::size_t t = 0; t < task.triangles.size(); ++t) {
          meshops::TriangleSides sides;
          for (std::size_t i = 0; i < 3; ++i) {
            sides.corner[i] = vertex(task.triangles[t][i]);
            if (const int mate = earlier[3 * t + i]; mate >= 0)
              sides.side[i] = m.opposite_halfedge_handle(side[static_cast<std::size_t>(mate)]);
          }
          const meshops::InsertedTriangle inserted = meshops::insert_triangle(m, sides);
          std::copy(inserted.side.begin(), inserted.side.end(), side.begin() + static_cast<std::ptrdiff_t>(3 * t));
        }
      });
}

/// Zips two tubes, beginning at the boundary halfedge of the last vertex of either tube (see operator_task.cpp), which
/// are mates.
std::unique_ptr<Contestant> zip_tubes(const Task& task) {
  return at_once([start = mesh_of(task)](TriMesh& m) { m = start; },
                 [&task](TriMesh& m) {
                   const Halfedge a = halfedge(m, task.sites.front()[0], task.sites.front()[1]);
                   const Halfedge b = halfedge(m, task.sites.back()[0], task.sites.back()[1]);
                   meshops::zip_curves(m, a, b);
                 });
}

}  // namespace

std::vector<Entry> meshops_entries(Operation operation) {
  switch (operation) {
    case Operation::split_edge:
      return {{"meshops",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of, [](TriMesh& m, Edge e) { meshops::split_edge(m, e); });
               }},
              {"meshops, manifold", [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of,
                                 [](TriMesh& m, Edge e) { meshops::split_edge(m, e, Keep::manifold); });
               }}};
    case Operation::split_face:
      return {{"meshops", [](const Task& task) {
                 return at_sites(mesh_of(task), task, face, [](TriMesh& m, Face f) { meshops::split_face(m, f); });
               }}};
    case Operation::flip:
      return {{"meshops",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of, [](TriMesh& m, Edge e) { meshops::flip(m, e); });
               }},
              {"meshops, blocker first",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of, [](TriMesh& m, Edge e) {
                   if (!meshops::flip_blocker(m, e)) meshops::flip(m, e);
                 });
               }},
              {"meshops, manifold", [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of,
                                 [](TriMesh& m, Edge e) { meshops::flip(m, e, Keep::manifold); });
               }}};
    case Operation::collapse:
      return {{"meshops",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, halfedge_of,
                                 [](TriMesh& m, Halfedge h) { meshops::collapse(m, h); });
               }},
              {"meshops, blocker first",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, halfedge_of, [](TriMesh& m, Halfedge h) {
                   if (!meshops::collapse_blocker(m, h)) meshops::collapse(m, h);
                 });
               }},
              {"meshops, manifold", [](const Task& task) {
                 return at_sites(mesh_of(task), task, halfedge_of,
                                 [](TriMesh& m, Halfedge h) { meshops::collapse(m, h, Keep::manifold); });
               }}};
    case Operation::split_vertex:
      return {{"meshops",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, left_and_right,
                                 [](TriMesh& m, const auto& at) { meshops::split_vertex(m, at.first, at.second); });
               }},
              {"meshops, from vertices",
               [](const Task& task) {
                 return at_sites(
                     mesh_of(task), task, [](const TriMesh&, const Site& s) { return s; },
                     [](TriMesh& m, const Site& s) {
                       meshops::split_vertex(m, m.find_halfedge(vertex(s[0]), vertex(s[1])),
                                             m.find_halfedge(vertex(s[0]), vertex(s[2])));
                     });
               }},
              {"meshops, manifold", [](const Task& task) {
                 return at_sites(mesh_of(task), task, left_and_right, [](TriMesh& m, const auto& at) {
                   meshops::split_vertex(m, at.first, at.second, Keep::manifold);
                 });
               }}};
    case Operation::open_curve:
      return {{"meshops", [](const Task& task) {
                 return at_sites(mesh_of(task), task, face, [](TriMesh& m, Face f) { meshops::open_curve(m, f); });
               }}};
    case Operation::close_curve:
      return {{"meshops", [](const Task& task) {
                 TriMesh mesh = mesh_of(task);
                 for (const Site& site : task.sites) meshops::open_curve(mesh, face(mesh, site));
                 return at_sites(std::move(mesh), task, halfedge_of,
                                 [](TriMesh& m, Halfedge h) { meshops::close_curve(m, h); });
               }}};
    case Operation::unglue:
      return {{"meshops", [](const Task& task) {
                 return at_sites(mesh_of(task), task, halfedge_of,
                                 [](TriMesh& m, Halfedge h) { meshops::unglue(m, h); });
               }}};
    case Operation::glue:
      return {{"meshops", [](const Task& task) {
                 TriMesh mesh = mesh_of(task);
                 std::map<Site, std::pair<Halfedge, Halfedge>> parted;
                 for (const Site& site : task.sites) {
                   const auto effect = meshops::unglue(mesh, halfedge_of(mesh, site));
                   parted[site] = {effect.first, effect.second};
                 }
                 return at_sites(
                     std::move(mesh), task, [&](const TriMesh&, const Site& s) { return parted.at(s); },
                     [](TriMesh& m, const auto& at) { meshops::glue(m, at.first, at.second); });
               }}};
    case Operation::add_triangles:
      return {{"meshops", insert_triangles}};
    case Operation::build_mesh:
      return {{"meshops", [](const Task& task) {
                 return at_once([](TriMesh&) {}, [soup = soup_of(task)](TriMesh& m) { meshops::build_mesh(m, soup); });
               }}};
    case Operation::sew_curves:
      return {{"meshops", zip_tubes}};
  }
  return {};
}

}  // namespace meshops_bench
