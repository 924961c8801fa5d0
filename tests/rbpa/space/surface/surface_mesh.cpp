#include "rbpa/space/surface/surface_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "support/for_space_sets.h"
#include "support/space_sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Mesh;
using rbpa::Surface;
using rbpa::SurfaceMesh;

TEST_SUITE_BEGIN("space");

namespace {

/// Checks that faces, corners and adjacency equal those of the surface, with one fan at each vertex.
void check_is(const SurfaceMesh& made, const Surface& surface, const Points3& points) {
  const Mesh& mesh = made.mesh;
  REQUIRE(mesh.n_faces() == surface.triangles.size());
  REQUIRE(made.input_index.size() == mesh.n_vertices());
  CHECK(std::is_sorted(made.input_index.begin(), made.input_index.end()));
  int wrong = 0;
  for (const Mesh::FaceHandle f : mesh.faces()) {
    const auto t = static_cast<std::size_t>(f.idx());
    const auto index = [&](Mesh::HalfedgeHandle h) {
      return made.input_index[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
    };
    auto h = mesh.halfedge_handle(f);
    for (int i = 0; i < 3 && index(h) != surface.triangles[t][0]; ++i) h = mesh.next_halfedge_handle(h);
    for (std::size_t k = 0; k < 3; ++k) {
      wrong += index(h) != surface.triangles[t][k];
      const auto across = mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)));
      const auto other = mesh.face_handle(across);
      // h ends at corner k; the side across from corner k begins where the next halfedge ends.
      const std::uint32_t expected = surface.neighbors[t][k];
      wrong += other.is_valid() ? static_cast<std::uint32_t>(other.idx()) != expected : expected != Surface::none;
      h = mesh.next_halfedge_handle(h);
    }
  }
  CHECK(wrong == 0);
  for (const Mesh::VertexHandle v : mesh.vertices()) {
    const rbpa::Point3& p = points[made.input_index[static_cast<std::size_t>(v.idx())]];
    CHECK(mesh.point(v) == Mesh::Point(p.x, p.y, p.z));
  }
  CHECK(meshops::validate(mesh).empty());
}

}  // namespace

TEST_CASE("the mesh of a surface is sound, and has its triangles glued in the same way") {
  Random random(91);
  std::size_t faces = 0, fans = 0;
  for_space_sets(25, 3, 29, random, [&](const Points3& points) {
    const double radius = space_radius(points, random);
    const Surface exposed = rbpa::exposed_triangles(points, radius),
                  some = rbpa::surface(points, random_normals(points.size(), random), radius);
    for (const Surface& surface : {exposed, some}) {
      const SurfaceMesh made = rbpa::surface_mesh(points, surface);
      check_is(made, surface, points);
      Surface given = surface;
      check_is(rbpa::surface_mesh(points, std::move(given)), surface, points);
      faces += made.mesh.n_faces();
      for (std::size_t v = 1; v < made.input_index.size(); ++v) fans += made.input_index[v] == made.input_index[v - 1];
    }
  });
  CHECK(faces > 5000);
  CHECK(fans > 500);
}

TEST_CASE("what is not a surface of the points is refused") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.1}};
  const Surface right = rbpa::exposed_triangles(points, 1);
  REQUIRE(right.triangles.size() == 4);
  CHECK(rbpa::surface_mesh({}, Surface{}).mesh.n_vertices() == 0);
  const auto is_refused = [&](const Surface& wrong) {
    CHECK_THROWS_AS(rbpa::surface_mesh(points, wrong), meshops::ContractViolation);
  };
  Surface wrong = right;
  wrong.triangles[1][2] = 4;
  is_refused(wrong);
  wrong = right;
  wrong.neighbors.pop_back();
  is_refused(wrong);
  wrong = right;
  wrong.neighbors[0][1] = 17;
  is_refused(wrong);
  wrong = right;
  wrong.neighbors[0] = {Surface::none, Surface::none, Surface::none};
  is_refused(wrong);
}

TEST_SUITE_END();
