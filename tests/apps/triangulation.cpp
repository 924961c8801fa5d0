// Functions of arrays agree with those of the mesh of the same triangles.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "meshops/front/boundary_curve.h"
#include "picture/drawing.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/rbpa.h"
#include "support/sets.h"
#include "support/spacing.h"

using namespace rbpa_test;

namespace {

/// Returns the content of a picture from the mesh: edges between two triangles, and curves around fans.
struct MeshDrawing {
  std::vector<rbpa::app::Edge> inner_edges = {};
  std::vector<std::vector<std::uint32_t>> curves = {};
};

/// Rotates a curve to begin at its least edge.
std::vector<std::uint32_t> from_least_edge(const std::vector<std::uint32_t>& curve) {
  std::vector<std::uint32_t> least = curve, turned = curve;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (std::pair(turned[0], turned[1]) < std::pair(least[0], least[1])) least = turned;
  }
  return least;
}

MeshDrawing drawing_of(const rbpa::SolidAlphaComplex& complex) {
  MeshDrawing drawing;
  const rbpa::Mesh& mesh = complex.mesh;
  const auto input = [&](OpenMesh::VertexHandle v) { return complex.input_index[static_cast<std::size_t>(v.idx())]; };
  for (const auto edge : mesh.edges()) {
    if (mesh.is_boundary(edge)) continue;
    const auto halfedge = mesh.halfedge_handle(edge, 0);
    const std::uint32_t a = input(mesh.from_vertex_handle(halfedge)), b = input(mesh.to_vertex_handle(halfedge));
    drawing.inner_edges.push_back({std::min(a, b), std::max(a, b)});
  }
  for (const meshops::BoundaryCurve& boundary : meshops::boundary_curves(mesh)) {
    std::vector<std::uint32_t> curve;
    for (const meshops::Halfedge halfedge : boundary) curve.push_back(input(mesh.from_vertex_handle(halfedge)));
    drawing.curves.push_back(from_least_edge(curve));
  }
  std::ranges::sort(drawing.inner_edges);
  std::ranges::sort(drawing.curves);
  return drawing;
}

void check_same(const Points& points, double alpha) {
  CAPTURE(alpha);
  const rbpa::SolidAlphaComplex mesh = rbpa::rbpa(points, alpha);
  const rbpa::AlphaComplex arrays = rbpa::alpha_complex(points, alpha, {.neighbors = true});
  const MeshDrawing of_mesh = drawing_of(mesh);
  const auto of_arrays = rbpa::app::drawing_of(points, arrays, rbpa::ComplexKind::solid);
  CHECK(of_arrays.inner_edges == of_mesh.inner_edges);
  CHECK(of_arrays.curves == of_mesh.curves);
  CHECK(std::ranges::equal(of_arrays.isolated, mesh.isolated));
  CHECK(of_arrays.dangling.empty());
}

}  // namespace

TEST_SUITE("triangulation") {
  TEST_CASE("arrays and meshes give the same drawings, on sets of every kind, with pinches") {
    for (const NamedSet& set : generated_sets()) {
      CAPTURE(set.name);
      const Points points = set.make();
      for (const double alpha : set.alphas) check_same(points, alpha);
      for (const double spacings : {0.55, 0.8, 2.0})
        if (mean_spacing(points) > 0) check_same(points, spacings * mean_spacing(points));
      check_same(points, std::numeric_limits<double>::infinity());
    }
  }
}
