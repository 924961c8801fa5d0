#include "rbpa/solid_filtration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/full_topology.h"
#include "rbpa/solid_radii.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/least_sphere.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::FullCounts;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::SolidFiltration;

TEST_SUITE_BEGIN("space");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("the least radius of two and of three points is the least double that is not below it") {
  Random random(5000);
  std::size_t exact = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Points3 p = space_set(static_cast<SpaceKind>(trial % space_kinds), 3, random);
    if (p.size() < 3 || p[0] == p[1]) continue;
    const double two = rbpa::space::least_radius_rounded_up(p[0], p[1]);
    const double below = std::nextafter(two, 0.0);
    CHECK((std::isinf(two) || rbpa::space::exact::compare_circumradius(p[0], p[1], two) <= 0));
    CHECK((below == 0 || rbpa::space::exact::compare_circumradius(p[0], p[1], below) > 0));
    exact += rbpa::space::exact::compare_circumradius(p[0], p[1], two) == 0 ? 1u : 0u;
    if (rbpa::space::exact::compare_circumradius(p[0], p[1], p[2], infinity) >= 0) continue;  // on a line
    const double three = rbpa::space::least_radius_rounded_up(p[0], p[1], p[2]);
    CHECK((std::isinf(three) || rbpa::space::exact::compare_circumradius(p[0], p[1], p[2], three) <= 0));
    CHECK(rbpa::space::exact::compare_circumradius(p[0], p[1], p[2], std::nextafter(three, 0.0)) > 0);
  }
  CHECK(exact > 10);
}

TEST_CASE("the simplices whose radius is at most alpha are those of the full complex, for every alpha") {
  std::size_t checked = 0;
  for (const SolidSet& set : solid_sets(60)) {
    if (!set.is_solid) continue;
    CAPTURE(set.name);
    const Solid delaunay = rbpa::solid(set.points, infinity);
    if (delaunay.simplices.size() > 1000) continue;
    const SolidFiltration one = rbpa::solid_filtration(set.points, delaunay, 1);
    const SolidFiltration filtration = rbpa::solid_filtration(set.points, delaunay, 3);
    CHECK(filtration.edge_alpha == one.edge_alpha);
    CHECK(filtration.triangle_alpha == one.triangle_alpha);
    CHECK(filtration.edges == one.edges);
    CHECK(std::is_sorted(filtration.edges.begin(), filtration.edges.end()));
    CHECK(filtration.tetrahedron_alpha == rbpa::circumradii(set.points, delaunay.simplices));
    CHECK(std::set(filtration.triangles.begin(), filtration.triangles.end()).size() == filtration.triangles.size());
    for (std::size_t t = 0; t < delaunay.simplices.size(); ++t)
      for (std::size_t k = 0; k < 4; ++k) {
        rbpa::Triangle across = {delaunay.simplices[t][(k + 1) % 4], delaunay.simplices[t][(k + 2) % 4],
                                 delaunay.simplices[t][(k + 3) % 4]};
        std::sort(across.begin(), across.end());
        CHECK(filtration.triangles[filtration.triangles_of[t][k]] == across);
        CHECK(filtration.triangle_alpha[filtration.triangles_of[t][k]] <= filtration.tetrahedron_alpha[t]);
      }
    std::vector<double> alphas = filtration.edge_alpha;
    alphas.insert(alphas.end(), filtration.triangle_alpha.begin(), filtration.triangle_alpha.end());
    std::sort(alphas.begin(), alphas.end());
    alphas.erase(std::unique(alphas.begin(), alphas.end()), alphas.end());
    for (std::size_t i = 0; i < alphas.size(); i += 1 + alphas.size() / 12)
      for (const double alpha : {std::nextafter(alphas[i], 0.0), alphas[i]}) {
        CAPTURE(alpha);
        if (!(alpha > 0) || std::isinf(alpha)) continue;
        const FullCounts counts = rbpa::count_full(set.points, delaunay, filtration.tetrahedron_alpha, alpha);
        const auto within = [&](const std::vector<double>& radii) {
          return static_cast<std::size_t>(
              std::count_if(radii.begin(), radii.end(), [&](double r) { return r <= alpha; }));
        };
        CHECK(within(filtration.edge_alpha) == counts.edges);
        CHECK(within(filtration.triangle_alpha) == counts.triangles);
        CHECK(within(filtration.tetrahedron_alpha) == counts.tetrahedra);
        ++checked;
      }
  }
  CHECK(checked > 200);
}

TEST_CASE("what has no filtration is refused") {
  const Points3 flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  CHECK_THROWS_AS(rbpa::solid_filtration(flat, rbpa::solid(flat, infinity)), rbpa::InvalidInput);
  Random random(5001);
  const Points3 points = space_set(SpaceKind::cube, 20, random);
  Solid delaunay = rbpa::solid(points, infinity);
  delaunay.neighbors.clear();
  CHECK_THROWS_AS(rbpa::solid_filtration(points, delaunay), meshops::ContractViolation);
  const Points3 one = {{1, 2, 3}, {1, 2, 3}};
  CHECK(rbpa::solid_filtration(one, rbpa::solid(one, infinity)).edges.empty());
}
