#include "meshops/stellar/interpolate.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <limits>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"

using namespace meshops;

namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  using Color = OpenMesh::Vec3uc;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Color | OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// The triangle (0, 0), (2, 0), (0, 2), with a value of each kind at its corners and a label on its face.
struct Triangle : Mesh {
  Triangle() {
    using meshops::Face, meshops::Vertex;  // not those of the mesh
    for (const auto& [x, y] : {std::pair(0, 0), {2, 0}, {0, 2}}) add_vertex({double(x), double(y), 0});
    add_property(weight, "w");
    add_property(number, "n");
    add_property(text, "t");
    add_property(label, "l");
    const Face f = add_face(Vertex(0), Vertex(1), Vertex(2));
    property(label, f) = 7;
    for (int i = 0; i < 3; ++i) {
      const Vertex v(i);
      property(weight, v) = 10 * i;
      property(number, v) = 2 * i + (i == 1 ? 1 : 0);  // 0, 3, 4
      property(text, v) = "corner";
      set_texcoord2D(v, {static_cast<float>(i), 1});
      set_color(v, {static_cast<unsigned char>(100 * i), 255, 1});
    }
  }
  auto hook() const { return Interpolate(weight, number, vertex_texcoords2D_pph(), vertex_colors_pph()); }

  OpenMesh::VPropHandleT<double> weight;
  OpenMesh::VPropHandleT<int> number;
  OpenMesh::VPropHandleT<std::string> text;
  OpenMesh::FPropHandleT<int> label;
};

static_assert(HasMean<double> && HasMean<unsigned char> && HasMean<OpenMesh::Vec3uc> && HasMean<OpenMesh::Vec2f>);
static_assert(!HasMean<std::string> && !HasMean<bool> && !HasMean<OpenMesh::VPropHandleT<int>>);

}  // namespace

TEST_SUITE("interpolate") {
  TEST_CASE("an edge split has the mean of both ends, and the labels that CarryOver gives") {
    Triangle mesh;
    const SplitEdgeEffect split = split_edge(mesh, mesh.find_halfedge(Vertex(0), Vertex(1)), mesh.hook());
    const Vertex v = split.added.vertex;
    CHECK(mesh.point(v) == Mesh::Point(1, 0, 0));
    CHECK(mesh.property(mesh.weight, v) == 5);
    CHECK(mesh.property(mesh.number, v) == 2);  // of 0 and 3: halves are rounded away from 0
    CHECK(mesh.texcoord2D(v) == Mesh::TexCoord2D(0.5F, 1));
    CHECK(mesh.color(v) == Mesh::Color(50, 255, 1));
    for (const Face f : split.added.faces()) CHECK(mesh.property(mesh.label, f) == 7);
    CHECK(mesh.property(mesh.text, v).empty());  // not named: the default
    CHECK(mesh.property(mesh.weight, Vertex(0)) == 0);
    CHECK(mesh.property(mesh.weight, Vertex(1)) == 10);
  }

  TEST_CASE("a face split has the mean of the corners") {
    Triangle mesh;
    const SplitFaceEffect split = split_face(mesh, Face(0), mesh.hook());
    const Vertex v = split.added.vertex;
    CHECK(mesh.property(mesh.weight, v) == doctest::Approx(10));
    CHECK(mesh.property(mesh.number, v) == 2);  // of 0, 3, 4: 2⅓
    CHECK(mesh.texcoord2D(v)[0] == doctest::Approx(1));
    CHECK(mesh.color(v) == Mesh::Color(100, 255, 1));
    CHECK(mesh.point(v)[0] == doctest::Approx(2.0 / 3));
    for (const Face f : split.added.faces()) CHECK(mesh.property(mesh.label, f) == 7);
  }

  TEST_CASE("a vertex split copies the values of the old vertex, also those without a mean") {
    Triangle mesh;
    const SplitVertexEffect split =
        split_vertex(mesh, mesh.halfedge_handle(Vertex(2)), std::nullopt, mesh.hook(), Keep::manifold);
    CHECK(mesh.property(mesh.weight, split.added.vertex) == 20);
    CHECK(mesh.property(mesh.text, split.added.vertex) == "corner");
  }

  TEST_CASE("properties are named by their managers as well") {
    Triangle mesh;
    auto heat = OpenMesh::VProp<double>(mesh, "heat");
    for (int i = 0; i < 3; ++i) heat[Vertex(i)] = 3 * i;
    const Vertex v = split_edge(mesh, mesh.find_halfedge(Vertex(1), Vertex(2)), Interpolate(heat)).added.vertex;
    CHECK(heat[v] == 4.5);
    CHECK(mesh.property(mesh.weight, v) == 0);
  }

  TEST_CASE("managers and handles are named together, in any order") {
    Triangle mesh;
    auto heat = OpenMesh::getOrMakeProperty<OpenMesh::VertexHandle, double>(mesh, "heat");
    for (int i = 0; i < 3; ++i) heat[Vertex(i)] = 3 * i;
    const Interpolate first(heat, mesh.vertex_texcoords2D_pph(), mesh.weight);
    const Interpolate last(mesh.vertex_colors_pph(), mesh.weight, heat);
    const Vertex v = split_edge(mesh, mesh.find_halfedge(Vertex(1), Vertex(2)), first).added.vertex;
    CHECK(heat[v] == 4.5);
    CHECK(mesh.property(mesh.weight, v) == 15);
    CHECK(mesh.texcoord2D(v) == Mesh::TexCoord2D(1.5F, 1));
    const Vertex w = split_edge(mesh, mesh.find_halfedge(Vertex(0), Vertex(1)), last).added.vertex;
    CHECK(heat[w] == 1.5);
    CHECK(mesh.property(mesh.weight, w) == 5);
    CHECK(mesh.color(w) == Mesh::Color(50, 255, 1));
  }

  TEST_CASE("a property that the mesh does not have is a contract violation, and the mesh is unchanged") {
    Triangle mesh;
    OpenMesh::VPropHandleT<double> elsewhere(mesh.text.idx());  // there is one of this number, of another type
    for (const OpenMesh::VPropHandleT<double> wrong :
         {OpenMesh::VPropHandleT<double>(), OpenMesh::VPropHandleT<double>(1000), elsewhere}) {
      CHECK_THROWS_AS(split_edge(mesh, mesh.halfedge_handle(Face(0)), Interpolate(mesh.number, wrong)),
                      ContractViolation);
      CHECK_THROWS_AS(split_vertex(mesh, mesh.halfedge_handle(Vertex(2)), std::nullopt, Interpolate(mesh.number, wrong),
                                   Keep::manifold),
                      ContractViolation);
      CHECK(mesh.n_vertices() == 3);
      CHECK(mesh.n_edges() == 3);
      CHECK(mesh.n_faces() == 1);
    }
  }

  TEST_CASE("the mean of finite values does not overflow, and the mean of equal values is the value") {
    Triangle mesh;
    const double most = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i) {
      mesh.property(mesh.weight, Vertex(i)) = most;
      mesh.property(mesh.number, Vertex(i)) = std::numeric_limits<int>::max();
    }
    const Vertex v = split_edge(mesh, mesh.find_halfedge(Vertex(0), Vertex(1)), mesh.hook()).added.vertex;
    CHECK(mesh.property(mesh.weight, v) == most);
    CHECK(mesh.property(mesh.number, v) == std::numeric_limits<int>::max());
  }
}
