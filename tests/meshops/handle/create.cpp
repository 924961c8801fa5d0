#include "meshops/handle/create.h"

#include <doctest/doctest.h>

#include "meshops/handle/effect.h"
#include "meshops/topology/count.h"
#include "support/check_sound.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

TEST_CASE("create adds one triangle, and changes the counts by the table") {
  TestMesh mesh;
  strip(mesh, 2);
  const TopologyCounts before = count_topology(mesh);
  const CreateTriangleEffect effect = create_triangle(mesh);
  const TopologyCounts after = count_topology(mesh);
  const Delta delta = effect.delta();
  CHECK(static_cast<int>(after.vertices - before.vertices) == delta.vertices);
  CHECK(static_cast<int>(after.edges - before.edges) == delta.edges);
  CHECK(static_cast<int>(after.faces - before.faces) == delta.faces);
  CHECK(static_cast<int>(after.boundary_curves - before.boundary_curves) == delta.curves);
  CHECK(static_cast<int>(after.components - before.components) == delta.components);
  CHECK(after.euler() - before.euler() == delta.euler());
  CHECK(after.genus() == before.genus());
  CHECK(delta == delta_of_create());
  CHECK(mesh.face_handle(effect.inner) == effect.face);
  CHECK(mesh.halfedge_handle(effect.face) == effect.inner);
  CHECK(mesh.opposite_halfedge_handle(effect.inner) == effect.boundary);
  CHECK(mesh.is_boundary(effect.boundary));
  check_sound(mesh);
}
