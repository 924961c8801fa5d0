#include "bench/operator_openmesh.h"

#include <stdexcept>

namespace meshops_bench {

TriMesh::TriMesh() {
  request_vertex_status();
  request_edge_status();
  request_halfedge_status();
  request_face_status();
}

OpenMesh::VertexHandle vertex(std::uint32_t index) { return OpenMesh::VertexHandle(static_cast<int>(index)); }

OpenMesh::HalfedgeHandle halfedge(const TriMesh& mesh, std::uint32_t from, std::uint32_t to) {
  const OpenMesh::HalfedgeHandle h = mesh.find_halfedge(vertex(from), vertex(to));
  if (!h.is_valid()) throw std::runtime_error("a site is not in the mesh");
  return h;
}

OpenMesh::FaceHandle face(const TriMesh& mesh, const Site& site) {
  return mesh.face_handle(halfedge(mesh, site[0], site[1]));
}

namespace {

void add_all(TriMesh& mesh, const Task& task) {
  for (const Corners& t : task.triangles) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
}

void make_room(TriMesh& mesh, const Task& task) {
  mesh.reserve(task.vertices, task.vertices + task.triangles.size() + 1, task.triangles.size());
}

void add_vertices(TriMesh& mesh, const Task& task) {
  for (std::uint32_t v = 0; v < task.vertices; ++v) mesh.new_vertex();
}

}  // namespace

TriMesh mesh_of(const Task& task) {
  TriMesh mesh;
  make_room(mesh, task);
  add_vertices(mesh, task);
  add_all(mesh, task);
  return mesh;
}

void copy_with_room(const TriMesh& from, TriMesh& to) {
  to = from;
  to.reserve(2 * from.n_vertices(), 2 * from.n_edges(), 2 * from.n_faces());
}

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

std::vector<Entry> openmesh_entries(Operation operation) {
  using OpenMesh::EdgeHandle;
  using OpenMesh::FaceHandle;
  using OpenMesh::HalfedgeHandle;
  static const auto edge_of = [](const TriMesh& m, const Site& s) { return m.edge_handle(halfedge(m, s[0], s[1])); };
  static const auto halfedge_of = [](const TriMesh& m, const Site& s) { return halfedge(m, s[0], s[1]); };
  static const auto face_of = [](const TriMesh& m, const Site& s) { return face(m, s); };
  static const auto as_is = [](const TriMesh&, const Site& s) { return s; };
  switch (operation) {
    case Operation::split_edge:
      return {{"openmesh", [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of,
                                 [](TriMesh& m, EdgeHandle e) { m.split(e, m.new_vertex()); });
               }}};
    case Operation::split_face:
      return {{"openmesh", [](const Task& task) {
                 return at_sites(mesh_of(task), task, face_of,
                                 [](TriMesh& m, FaceHandle f) { m.split(f, m.new_vertex()); });
               }}};
    case Operation::flip:
      return {{"openmesh",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of, [](TriMesh& m, EdgeHandle e) {
                   if (m.is_flip_ok(e)) m.flip(e);
                 });
               }},
              {"openmesh, unchecked", [](const Task& task) {
                 return at_sites(mesh_of(task), task, edge_of, [](TriMesh& m, EdgeHandle e) { m.flip(e); });
               }}};
    case Operation::collapse:
      return {{"openmesh",
               [](const Task& task) {
                 return at_sites(mesh_of(task), task, halfedge_of, [](TriMesh& m, HalfedgeHandle h) {
                   if (m.is_collapse_ok(h)) m.collapse(h);
                 });
               }},
              {"openmesh, unchecked", [](const Task& task) {
                 return at_sites(mesh_of(task), task, halfedge_of, [](TriMesh& m, HalfedgeHandle h) { m.collapse(h); });
               }}};
    case Operation::split_vertex:
      return {{"openmesh", [](const Task& task) {
                 return at_sites(mesh_of(task), task, as_is, [](TriMesh& m, const Site& s) {
                   m.vertex_split(m.new_vertex(), vertex(s[0]), vertex(s[1]), vertex(s[2]));
                 });
               }}};
    case Operation::open_curve:
      return {{"openmesh", [](const Task& task) {
                 return at_sites(mesh_of(task), task, face_of,
                                 [](TriMesh& m, FaceHandle f) { m.delete_face(f, false); });
               }}};
    case Operation::close_curve:
      return {{"openmesh", [](const Task& task) {
                 TriMesh mesh = mesh_of(task);
                 for (const Site& site : task.sites) mesh.delete_face(face(mesh, site), false);
                 return at_sites(std::move(mesh), task, as_is, [](TriMesh& m, const Site& s) {
                   m.add_face(vertex(s[0]), vertex(s[1]), vertex(s[2]));
                 });
               }}};
    case Operation::add_triangles:
      return {{"openmesh", [](const Task& task) {
                 return at_once(
                     [&task](TriMesh& m) {
                       make_room(m, task);
                       add_vertices(m, task);
                     },
                     [&task](TriMesh& m) { add_all(m, task); });
               }}};
    case Operation::build_mesh:
      return {{"openmesh", [](const Task& task) {
                 return at_once([](TriMesh&) {},
                                [&task](TriMesh& m) {
                                  make_room(m, task);
                                  add_vertices(m, task);
                                  add_all(m, task);
                                });
               }}};
    default:
      return {};
  }
}

}  // namespace meshops_bench
