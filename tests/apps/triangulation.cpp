// What is asked of arrays is what is asked of the mesh of the same triangles.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "picture/drawing.h"
#include "rbpa/rbpa.h"
#include "rbpa/topology.h"
#include "rbpa/triangulate.h"
#include "support/sets.h"
#include "support/spacing.h"
#include "triangulation/counts.h"

using namespace rbpa_test;

namespace {

void check_same(const Points& points, double alpha) {
  CAPTURE(alpha);
  const rbpa::SolidAlphaComplex mesh = rbpa::rbpa(points, alpha);
  const rbpa::Triangulation arrays = rbpa::triangulate(points, alpha, {.neighbors = true});
  CHECK(rbpa::app::count(arrays, rbpa::Complex::solid) == rbpa::count(mesh));
  const auto of_mesh = rbpa::app::drawing_of(points, mesh);
  const auto of_arrays = rbpa::app::drawing_of(points, arrays, rbpa::Complex::solid);
  CHECK(of_arrays.inner_edges == of_mesh.inner_edges);
  CHECK(of_arrays.curves == of_mesh.curves);
  CHECK(std::ranges::equal(of_arrays.isolated, of_mesh.isolated));
  CHECK(of_arrays.dangling.empty());
}

}  // namespace

TEST_SUITE("triangulation") {
  TEST_CASE("counts and drawings, on sets of every kind, with pinches") {
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
