// A user's own mesh type, with float points and properties of both kinds, under every operator. Returns 0 only when
// surviving elements keep their properties.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <map>

#include "meshops/meshops.h"

namespace {

struct MyTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3f;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color);
  VertexTraits { float weight = 0; };
  FaceTraits { int material = 0; };
};

class MyMesh : public OpenMesh::TriMesh_ArrayKernelT<MyTraits> {
 public:
  MyMesh() { add_property(crease, "crease"); }
  OpenMesh::EPropHandleT<int> crease;
};

int failures = 0;
void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "failed: %s\n", what);
  ++failures;
}

/// Gives every element values of its own.
void mark(MyMesh& mesh) {
  for (const auto v : mesh.vertices()) {
    mesh.data(v).weight = static_cast<float>(v.idx());
    mesh.set_point(v, {static_cast<float>(v.idx()), 1, 2});
  }
  for (const auto e : mesh.edges()) mesh.property(mesh.crease, e) = 100 + e.idx();
  for (const auto f : mesh.faces()) mesh.data(f).material = 1000 + f.idx();
}

/// Checks that every element that was marked and is live still has its values.
void expect_marks(const MyMesh& mesh, int vertices, int edges, int faces, const char* what) {
  bool kept = true;
  meshops::for_each_vertex(mesh, [&](meshops::Vertex v) {
    if (v.idx() < vertices)
      kept =
          kept && mesh.data(v).weight == static_cast<float>(v.idx()) && mesh.point(v)[0] == static_cast<float>(v.idx());
  });
  meshops::for_each_edge(mesh, [&](meshops::Edge e) {
    if (e.idx() < edges) kept = kept && mesh.property(mesh.crease, e) == 100 + e.idx();
  });
  meshops::for_each_face(mesh, [&](meshops::Face f) {
    if (f.idx() < faces) kept = kept && mesh.data(f).material == 1000 + f.idx();
  });
  expect(kept, what);
  expect(meshops::validate(mesh).empty(), "the mesh is sound");
}

}  // namespace

int main() {
  MyMesh mesh;
  std::vector<meshops::Halfedge> boundary;
  for (int t = 0; t < 4; ++t) boundary.push_back(meshops::create_triangle(mesh).boundary);
  mark(mesh);
  const auto check = [&](const char* what) { expect_marks(mesh, 12, 12, 4, what); };

  const meshops::GlueEffect glued = meshops::glue(mesh, boundary[0], boundary[1]);
  check("glue keeps properties");
  meshops::unglue(mesh, glued);
  check("taken back, what was deleted has its own again");
  meshops::glue(mesh, boundary[0], boundary[1]);
  const meshops::UnglueEffect parted = meshops::unglue(mesh, boundary[0]);
  check("unglue keeps properties");
  expect(mesh.data(parted.new_start).weight == mesh.data(mesh.from_vertex_handle(boundary[0])).weight,
         "a second vertex has the properties of the first");
  expect(mesh.point(parted.new_start) == mesh.point(mesh.from_vertex_handle(boundary[0])), "and its place");
  meshops::glue(mesh, parted.first, parted.second);

  meshops::zip_curves(mesh, boundary[2], boundary[3]);
  check("zip keeps properties");
  const meshops::CloseCurveEffect closed = meshops::close_curve(mesh, meshops::boundary_curves(mesh).front().front());
  meshops::open_curve(mesh, closed.face);
  check("close and open keep properties");

  const meshops::Edge inner = mesh.edge_handle(boundary[0]);
  const meshops::SplitEdgeEffect split = meshops::split_edge(mesh, inner);
  check("an edge split keeps properties");
  const auto middle =
      mesh.point(mesh.from_vertex_handle(split.line)) + mesh.point(mesh.to_vertex_handle(split.halfedge));
  expect(2.F * mesh.point(split.added.vertex) == middle, "the new vertex is in the middle of the edge");
  const meshops::Face face = mesh.face_handle(split.halfedge);
  mesh.data(face).material = 77;
  const meshops::SplitFaceEffect face_split = meshops::split_face(mesh, face, meshops::CarryOver());
  check("a face split keeps properties");
  for (const meshops::Face f : face_split.added.faces())
    expect(mesh.data(f).material == 77, "the new faces have those of the face");
  meshops::collapse(mesh, face_split.halfedge);
  meshops::collapse(mesh, split.halfedge);
  check("collapses keep properties");
  meshops::flip(mesh, inner);
  check("a flip keeps properties");

  const meshops::TopologyCounts before = meshops::count_topology(mesh);
  mesh.garbage_collection();
  expect(meshops::count_topology(mesh) == before, "garbage collection changes nothing that counts");
  expect(meshops::validate(mesh).empty(), "and leaves a sound mesh");
  return failures;
}
