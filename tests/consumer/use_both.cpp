// First steps of a user of both libraries. Returns 0 only when all results are right.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <limits>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/handle/create.h"
#include "meshops/handle/unglue.h"
#include "meshops/topology/count.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"

namespace {

int failures = 0;
void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "failed: %s\n", what);
  ++failures;
}

}  // namespace

int main() {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  meshops::request_status(mesh);
  const meshops::Halfedge a = meshops::create_triangle(mesh).boundary;
  const meshops::Halfedge b = meshops::create_triangle(mesh).boundary;
  const meshops::GlueEffect glued = meshops::glue(mesh, a, b);
  expect(glued.what == meshops::GlueCase::join, "two triangles join");
  expect(meshops::count_topology(mesh).edges == 5, "five edges are left");
  meshops::unglue(mesh, glued);
  expect(meshops::count_topology(mesh).components == 2, "unglued they are two again");
  expect(meshops::validate(mesh).empty(), "the mesh is sound");
  try {
    meshops::glue(mesh, a, a);
    expect(false, "an edge is not glued to itself");
  } catch (const meshops::ContractViolation&) {
  }

  const std::vector<rbpa::Point> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}};
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, 1.0);
  expect(rbpa::triangles(complex).size() == 2, "a square has two triangles");
  expect(complex.isolated == std::vector<std::uint32_t>{4}, "a far point is isolated");
  expect(rbpa::count(complex).boundary_curves == 1, "the square has one boundary");
  try {
    rbpa::rbpa(points, std::numeric_limits<double>::quiet_NaN());
    expect(false, "a radius that is not a number is refused");
  } catch (const rbpa::InvalidInput&) {
  }
  return failures;
}
