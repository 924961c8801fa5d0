#include "rbpa/hrbpa.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "rbpa/core/error.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Hierarchy;
using rbpa::Point;

TEST_SUITE_BEGIN("hierarchy");

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
const double infinity = std::numeric_limits<double>::infinity();

Hierarchy hierarchy(const Points& points, double alpha, std::size_t leaf_capacity) {
  return rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = {}});
}

/// The triangles that were there when a level ended, in canonical order.
Triangles triangles_after(const Hierarchy& h, std::size_t level) {
  Triangles found;
  const auto& mesh = h.complex.mesh;
  for (std::size_t f = 0; f < mesh.n_faces(); ++f) {
    if (rbpa::level_of(h, f) > level) continue;
    std::array<std::uint32_t, 3> corners;
    auto halfedge = mesh.halfedge_handle(OpenMesh::FaceHandle(static_cast<int>(f)));
    for (auto& corner : corners) {
      corner = h.complex.input_index[static_cast<std::size_t>(mesh.to_vertex_handle(halfedge).idx())];
      halfedge = mesh.next_halfedge_handle(halfedge);
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    found.push_back(corners);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void check_law_of_the_levels(const Points& points, double alpha, std::size_t leaf_capacity) {
  CAPTURE(alpha);
  CAPTURE(leaf_capacity);
  const Hierarchy h = hierarchy(points, alpha, leaf_capacity);
  const rbpa::SolidAlphaComplex direct = rbpa::rbpa(points, alpha);
  CHECK(rbpa::triangles(h.complex) == rbpa::triangles(direct));
  CHECK(h.complex.isolated == direct.isolated);
  CHECK(h.complex.duplicates == direct.duplicates);
  CHECK(h.complex.distinct == direct.distinct);
  for (std::size_t i = 0; i < h.levels.size(); ++i) {
    CAPTURE(h.levels[i].number);
    CAPTURE(h.levels[i].alpha);
    REQUIRE(triangles_after(h, i) == rbpa::triangles(rbpa::rbpa(points, h.levels[i].alpha)));
  }
}

}  // namespace

TEST_CASE("after every level the mesh is the complex of its radius, and at the end that of alpha") {
  for (const NamedSet& set : generated_sets()) {
    Points points = set.make();
    if (points.size() > 250) points.resize(250);
    CAPTURE(set.name);
    for (const std::size_t k : {1u, 6u, 64u}) check_law_of_the_levels(points, infinity, k);
    for (const double alpha : set.alphas) check_law_of_the_levels(points, alpha, 4);
  }
}

TEST_SUITE_END();
