// Meshes as surfaces, and their holes filled in place.
#include "rbpa/space/repair/mesh_holes.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "meshops/handle/destroy.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/count.h"
#include "meshops/topology/cut_open.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/surface/surface_components.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using meshops::Face;
using meshops::Vertex;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

/// Makes a torus of `along` by `around` squares, each cut in two.
void make_torus(Mesh& mesh, std::uint32_t along, std::uint32_t around) {
  meshops::PolygonSoup soup;
  soup.points = along * around;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % along * around + j % around; };
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      soup.add_face(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.add_face(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  meshops::build_mesh(mesh, soup);
  for (const Vertex v : mesh.vertices()) {
    const double u = 2 * std::numbers::pi * (v.idx() / static_cast<int>(around)) / along;
    const double w = 2 * std::numbers::pi * (v.idx() % static_cast<int>(around)) / around;
    mesh.set_point(v, {(2 + std::cos(w)) * std::cos(u), (2 + std::cos(w)) * std::sin(u), std::sin(w)});
  }
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Face f : meshops::live_faces(mesh)) {
    auto& t = triangles.emplace_back();
    std::size_t k = 0;
    for (const Vertex v : mesh.fv_range(f)) t[k++] = static_cast<std::uint32_t>(v.idx());
  }
  return triangles;
}

/// Removes the triangles around a vertex.
void remove_around(Mesh& mesh, Vertex middle) {
  std::set<Face> faces;
  for (const Vertex v : mesh.vv_range(middle))
    for (const Face f : mesh.vf_range(v)) faces.insert(f);
  for (const Face f : faces) meshops::remove_triangle(mesh, f);
}

}  // namespace

TEST_CASE("a mesh converted to a surface and back is the same except for handles; deleted elements are skipped") {
  Mesh mesh;
  make_torus(mesh, 12, 8);
  remove_around(mesh, Vertex(30));
  const rbpa::SurfaceOfTriangles surface = rbpa::surface_of(mesh);
  const std::vector<Point3> places = rbpa::places_of(mesh);
  REQUIRE(places.size() == mesh.n_vertices());
  const meshops::TopologyCounts counts = meshops::count_topology(mesh);
  REQUIRE(surface.triangles.size() == counts.faces);
  for (std::size_t t = 0; t < surface.given.size(); ++t) {
    const Face f(static_cast<int>(surface.given[t]));
    REQUIRE(meshops::is_live(mesh, f));
    std::set<std::uint32_t> own, given(surface.triangles[t].begin(), surface.triangles[t].end());
    for (const Vertex v : mesh.fv_range(f)) own.insert(static_cast<std::uint32_t>(v.idx()));
    CHECK(own == given);
  }
  rbpa::SurfaceMesh back = rbpa::surface_mesh(places, surface);
  meshops::TopologyCounts again = meshops::count_topology(back.mesh);
  again.vertices += counts.isolated;
  again.components += counts.isolated;
  again.isolated = counts.isolated;
  CHECK(again == counts);
  CHECK(rbpa::surface_components(places, surface).all[0].boundary_curves == counts.boundary_curves);
}

TEST_CASE("vertices at one place that are not glued stay apart, and glued ones stay glued") {
  Mesh mesh;  // two adjacent triangles, each with corners of its own
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}})
    mesh.add_vertex({double(x), double(y), 0});
  mesh.add_face(Vertex(0), Vertex(1), Vertex(2));
  mesh.add_face(Vertex(3), Vertex(4), Vertex(5));
  const rbpa::SurfaceOfTriangles surface = rbpa::surface_of(mesh);
  CHECK(surface.distinct == 4);
  CHECK(rbpa::surface_components(rbpa::places_of(mesh), surface).all.size() == 2);
}

TEST_CASE("a deleted vertex is no corner, wherever it was") {
  Mesh mesh;
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.delete_vertex(mesh.add_vertex({5, 5, 5}));
  for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {0, 0}, {0, 0}}) mesh.add_vertex({double(x), double(y), 0});
  mesh.add_face(Vertex(1), Vertex(2), Vertex(3));
  const rbpa::SurfaceOfTriangles surface = rbpa::surface_of(mesh);
  CHECK(surface.triangles == std::vector<std::array<std::uint32_t, 3>>{{1, 2, 3}});
  CHECK(surface.distinct == 3);
  CHECK(surface.duplicates == std::vector<rbpa::Duplicate>{{4, 3}});
}

TEST_CASE(
    "holes of a mesh are filled in place as fill_holes() fills those of its triangles, and the rest is not changed") {
  Mesh mesh;
  make_torus(mesh, 20, 12);
  remove_around(mesh, Vertex(30));
  remove_around(mesh, Vertex(150));
  const std::vector<Point3> places = rbpa::places_of(mesh);
  const auto old = triangles_of(mesh);
  const auto loops = rbpa::boundary_loops(old);
  const rbpa::HoleFilling expected = rbpa::fill_holes(places, old, loops);
  const std::vector<meshops::BoundaryCurve> curves = meshops::boundary_curves(mesh);
  REQUIRE(curves.size() == 2);
  const std::size_t vertices = meshops::count_topology(mesh).vertices;

  const rbpa::FilledMesh filled = rbpa::fill_holes(mesh, curves);
  REQUIRE(filled.holes.size() == 2);
  for (const rbpa::HoleFill& hole : filled.holes) CHECK(hole.outcome == rbpa::HoleOutcome::filled);
  CHECK(meshops::validate(mesh).empty());
  const meshops::TopologyCounts counts = meshops::count_topology(mesh);
  CHECK(counts.boundary_curves == 0);
  CHECK(counts.genus() == 1);
  CHECK(counts.vertices == vertices);
  CHECK(filled.faces.size() == expected.triangles.size() - old.size());
  auto found = triangles_of(mesh);
  CHECK(std::equal(old.begin(), old.end(), found.begin()));
  auto wanted = expected.triangles;
  for (auto* all : {&found, &wanted}) {
    for (auto& t : *all) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(all->begin(), all->end());
  }
  CHECK(found == wanted);
  CHECK(rbpa::crossing_triangles(rbpa::places_of(mesh), found, 1).empty());
}

TEST_CASE("a hole that touches itself at vertices in one place is filled, and these are merged") {
  // An octahedron without two faces that meet only in a corner: the hole visits that corner twice, at vertices 3 and 6.
  Mesh mesh;
  const std::array<std::array<double, 3>, 7> at = {
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}}};
  for (const auto& p : at) mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& [a, b, c] : {std::array{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {1, 0, 5}, {2, 1, 5}, {0, 6, 5}})
    mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  REQUIRE(meshops::validate(mesh).empty());
  const auto curves = meshops::boundary_curves(mesh);
  REQUIRE(curves.size() == 1);
  REQUIRE(curves[0].length() == 6);
  const rbpa::FilledMesh filled = rbpa::fill_holes(mesh, curves);
  CHECK(filled.holes[0].outcome == rbpa::HoleOutcome::filled);
  CHECK(filled.faces.size() == 2);
  CHECK(meshops::validate(mesh).empty());
  const meshops::TopologyCounts counts = meshops::count_topology(mesh);
  CHECK(counts.vertices == 6);
  CHECK(counts.faces == 8);
  CHECK(counts.boundary_curves == 0);
  CHECK(counts.genus() == 0);
}

TEST_CASE("a slit, along which vertices lie in pairs, is closed by gluing alone") {
  Mesh mesh;
  make_torus(mesh, 12, 8);
  const meshops::TopologyCounts before = meshops::count_topology(mesh);
  const auto edge = [&](int a, int b) { return mesh.edge_handle(mesh.find_halfedge(Vertex(a), Vertex(b))); };
  meshops::cut_open(mesh, std::vector<meshops::Edge>{edge(8, 16), edge(16, 24), edge(24, 32)});
  const auto curves = meshops::boundary_curves(mesh);
  REQUIRE(curves.size() == 1);
  REQUIRE(curves[0].length() == 6);
  const rbpa::FilledMesh filled = rbpa::fill_holes(mesh, curves);
  CHECK(filled.holes[0].outcome == rbpa::HoleOutcome::filled);
  CHECK(filled.faces.empty());
  CHECK(meshops::validate(mesh).empty());
  CHECK(meshops::count_topology(mesh) == before);
}

TEST_CASE("a mesh whose holes cannot be filled is refused and not changed") {
  Mesh mesh;
  make_torus(mesh, 12, 8);
  remove_around(mesh, Vertex(30));
  const auto curves = meshops::boundary_curves(mesh);
  const std::size_t faces = mesh.n_faces();
  const std::vector<Point3> few(3);
  CHECK_THROWS_AS(rbpa::fill_holes(mesh, few, curves), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::surface_of(mesh, few), meshops::ContractViolation);
  const std::vector<meshops::BoundaryCurve> twice = {curves[0], curves[0]};
  CHECK_THROWS_AS(rbpa::fill_holes(mesh, twice), meshops::ContractViolation);
  Mesh larger;
  make_torus(larger, 30, 20);
  remove_around(larger, Vertex(500));
  CHECK_THROWS_AS(rbpa::fill_holes(mesh, meshops::boundary_curves(larger)), meshops::ContractViolation);
  mesh.set_point(Vertex(50), {0, std::numeric_limits<double>::infinity(), 0});  // behind the removed vertex
  CHECK_THROWS_AS(rbpa::fill_holes(mesh, curves), rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(rbpa::surface_of(mesh), "vertex 50 is (0, inf, 0), expected finite coordinates",
                       rbpa::InvalidInput);
  mesh.set_point(Vertex(50), mesh.point(*mesh.vv_begin(Vertex(50))));
  CHECK_THROWS_AS(rbpa::surface_of(mesh), rbpa::InvalidInput);
  CHECK(mesh.n_faces() == faces);

  Mesh square;
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) square.add_vertex({double(x), double(y), 0});
  square.add_face(Vertex(0), Vertex(1), Vertex(2), Vertex(3));
  CHECK_THROWS_AS(rbpa::surface_of(square), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::fill_holes(square, meshops::boundary_curves(square)), meshops::ContractViolation);
  OpenMesh::PolyMesh_ArrayKernelT<> without_status;
  without_status.add_vertex({0, 0, 0});
  CHECK(rbpa::surface_of(without_status).triangles.empty());
  CHECK_THROWS_AS(rbpa::fill_holes(without_status, {}), meshops::ContractViolation);
}

TEST_SUITE_END();
