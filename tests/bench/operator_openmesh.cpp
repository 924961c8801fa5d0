#include "bench/operator_openmesh.h"

#include <stdexcept>

namespace meshops_bench {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;

TriMesh::TriMesh() {
  request_vertex_status();
  request_edge_status();
  request_halfedge_status();
  request_face_status();
}

OpenMesh::VertexHandle vertex(std::uint32_t index) { return OpenMesh::VertexHandle(static_cast<int>(index)); }

HalfedgeHandle halfedge(const TriMesh& mesh, std::uint32_t from, std::uint32_t to) {
  const HalfedgeHandle h = mesh.find_halfedge(vertex(from), vertex(to));
  if (!h.is_valid()) throw std::runtime_error("a site is not in the mesh");
  return h;
}

HalfedgeHandle halfedge_of(const TriMesh& mesh, const Site& site) { return halfedge(mesh, site[0], site[1]); }
EdgeHandle edge_of(const TriMesh& mesh, const Site& site) { return mesh.edge_handle(halfedge_of(mesh, site)); }
FaceHandle face_of(const TriMesh& mesh, const Site& site) { return mesh.face_handle(halfedge_of(mesh, site)); }

namespace {

void add_all(TriMesh& mesh, const Task& task) {
  for (const Corners& t : task.triangles) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
}

Site itself(const TriMesh&, const Site& site) { return site; }

}  // namespace

void add_vertices(TriMesh& mesh, const Task& task) {
  mesh.reserve(task.vertices, task.vertices + task.triangles.size() + 1, task.triangles.size());
  for (std::uint32_t v = 0; v < task.vertices; ++v) mesh.new_vertex();
}

TriMesh mesh_of(const Task& task) {
  TriMesh mesh;
  add_vertices(mesh, task);
  add_all(mesh, task);
  return mesh;
}

template <>
void copy_with_room(const TriMesh& from, TriMesh& to) {
  to = from;
  to.reserve(2 * from.n_vertices(), 2 * from.n_edges(), 2 * from.n_faces());
}

template <>
Shape shape_of(const TriMesh& mesh) {
  Shape shape;
  for (const auto v : mesh.vertices()) shape.vertices += !mesh.status(v).deleted();
  for (const auto e : mesh.edges()) shape.edges += !mesh.status(e).deleted();
  for (const auto f : mesh.faces()) {
    Corners corners{};
    std::size_t i = 0;
    for (const auto v : mesh.fv_range(f)) corners.at(i++) = static_cast<std::uint32_t>(v.idx());
    shape.add_triangle(corners);
  }
  return shape;
}

Contestant openmesh_at(const Task& task) {
  const auto at = [&](auto locate, auto step) { return at_sites(mesh_of(task), task, locate, step); };
  switch (task.operation) {
    case Operation::split_edge:
      return at(edge_of, [](TriMesh& m, EdgeHandle e) { m.split(e, m.new_vertex()); });
    case Operation::split_face:
      return at(face_of, [](TriMesh& m, FaceHandle f) { m.split(f, m.new_vertex()); });
    case Operation::flip:
      return at(edge_of, [](TriMesh& m, EdgeHandle e) {
        if (m.is_flip_ok(e)) m.flip(e);
      });
    case Operation::collapse:
      return at(halfedge_of, [](TriMesh& m, HalfedgeHandle h) {
        if (m.is_collapse_ok(h)) m.collapse(h);
      });
    case Operation::split_vertex:
      return at(itself, [](TriMesh& m, const Site& s) {
        m.vertex_split(m.new_vertex(), vertex(s[0]), vertex(s[1]), vertex(s[2]));
      });
    case Operation::open_curve:
      return at(face_of, [](TriMesh& m, FaceHandle f) { m.delete_face(f, false); });
    case Operation::close_curve: {
      TriMesh mesh = mesh_of(task);
      for (const Site& site : task.sites) mesh.delete_face(face_of(mesh, site), false);
      return at_sites(mesh, task, itself,
                      [](TriMesh& m, const Site& s) { m.add_face(vertex(s[0]), vertex(s[1]), vertex(s[2])); });
    }
    case Operation::add_triangles:
      return at_once<TriMesh>([&task](TriMesh& m) { return add_vertices(m, task), 0; },
                              [&task](TriMesh& m, int) { add_all(m, task); });
    case Operation::build_mesh:
      return at_once<TriMesh>([](TriMesh&) { return 0; },
                              [&task](TriMesh& m, int) {
                                add_vertices(m, task);
                                add_all(m, task);
                              });
    case Operation::sew_curves:
      break;
  }
  throw std::invalid_argument("OpenMesh does not sew curves");
}

}  // namespace meshops_bench
