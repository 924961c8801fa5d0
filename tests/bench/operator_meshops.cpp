#include <unordered_map>
#include <utility>

#include "bench/operator_openmesh.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/insert_triangle.h"
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
Contestant insert_triangles(const Task& task) {
  return at_once<TriMesh>(
      [&task](TriMesh& m) {
        add_vertices(m, task);
        return std::vector<Halfedge>(3 * task.triangles.size());
      },
      [&task, earlier = earlier_sides(task)](TriMesh& m, std::vector<Halfedge>& side) {
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
Contestant zip_tubes(const Task& task) {
  return at_once<TriMesh>([start = mesh_of(task)](TriMesh& m) { return m = start, 0; },
                          [&task](TriMesh& m, int) {
                            meshops::zip_curves(m, halfedge_of(m, task.sites.front()),
                                                halfedge_of(m, task.sites.back()));
                          });
}

}  // namespace

Contestant meshops_at(const Task& task) {
  const auto at = [&](auto locate, auto step) { return at_sites(mesh_of(task), task, locate, step); };
  switch (task.operation) {
    case Operation::split_edge:
      return at(edge_of, [](TriMesh& m, Edge e) { meshops::split_edge(m, e); });
    case Operation::split_face:
      return at(face_of, [](TriMesh& m, Face f) { meshops::split_face(m, f); });
    case Operation::flip:
      return at(edge_of, [](TriMesh& m, Edge e) { meshops::flip(m, e); });
    case Operation::collapse:
      return at(halfedge_of, [](TriMesh& m, Halfedge h) { meshops::collapse(m, h); });
    case Operation::split_vertex:
      return at(left_and_right,
                [](TriMesh& m, const auto& ends) { meshops::split_vertex(m, ends.first, ends.second); });
    case Operation::open_curve:
      return at(face_of, [](TriMesh& m, Face f) { meshops::open_curve(m, f); });
    case Operation::close_curve: {
      TriMesh mesh = mesh_of(task);
      for (const Site& site : task.sites) meshops::open_curve(mesh, face_of(mesh, site));
      return at_sites(mesh, task, halfedge_of, [](TriMesh& m, Halfedge h) { meshops::close_curve(m, h); });
    }
    case Operation::add_triangles:
      return insert_triangles(task);
    case Operation::build_mesh:
      return at_once<TriMesh>([](TriMesh&) { return 0; },
                              [soup = soup_of(task)](TriMesh& m, int) { meshops::build_mesh(m, soup); });
    case Operation::sew_curves:
      break;
  }
  return zip_tubes(task);
}

}  // namespace meshops_bench
