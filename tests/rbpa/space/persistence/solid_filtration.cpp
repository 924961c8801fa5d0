#include "rbpa/space/persistence/solid_filtration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/least_sphere.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/order.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::FullCounts;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::SolidFiltration;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the rows with ascending corners, sorted.
std::vector<std::array<std::uint32_t, 4>> sorted_rows(const Solid& solid) {
  auto rows = solid.simplices;
  for (auto& row : rows) std::sort(row.begin(), row.end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

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
    const double three = rbpa::space::LeastSphere(p[0], p[1], p[2]).radius_rounded_up();
    CHECK((std::isinf(three) || rbpa::space::exact::compare_circumradius(p[0], p[1], p[2], three) <= 0));
    CHECK(rbpa::space::exact::compare_circumradius(p[0], p[1], p[2], std::nextafter(three, 0.0)) > 0);
  }
  CHECK(exact > 10);
}

TEST_CASE("the simplices whose radius is at most alpha are those of the full complex, for every alpha") {
  std::size_t checked = 0;
  for_solids(60, [&](const Points3& points) {
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    const Solid& delaunay = filtration.delaunay;
    if (delaunay.simplices.size() > 1000) return;
    const Solid in_canonical_order = rbpa::solid(points, infinity);
    CHECK(sorted_rows(delaunay) == sorted_rows(in_canonical_order));
    CHECK(delaunay.duplicates == in_canonical_order.duplicates);
    CHECK(delaunay.isolated == in_canonical_order.isolated);
    CHECK(std::set(filtration.edges.begin(), filtration.edges.end()).size() == filtration.edges.size());
    CHECK(filtration.tetrahedron_alpha == rbpa::circumradii(points, delaunay.simplices));
    CHECK(std::set(filtration.triangles.begin(), filtration.triangles.end()).size() == filtration.triangles.size());
    for (std::size_t t = 0; t < delaunay.simplices.size(); ++t)
      for (std::size_t k = 0; k < 4; ++k) {
        rbpa::Triangle across = {delaunay.simplices[t][(k + 1) % 4], delaunay.simplices[t][(k + 2) % 4],
                                 delaunay.simplices[t][(k + 3) % 4]};
        std::sort(across.begin(), across.end());
        CHECK(filtration.triangles[filtration.triangles_of[t][k]] == across);
        CHECK(filtration.triangle_alpha[filtration.triangles_of[t][k]] <= filtration.tetrahedron_alpha[t]);
      }
    for (std::size_t i = 0; i < filtration.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t edge = filtration.edges_of[i][k];
        const std::uint32_t a = filtration.triangles[i][k == 0 ? 1 : 0], b = filtration.triangles[i][k == 2 ? 1 : 2];
        CHECK(filtration.edges[edge] == std::array{a, b});
        CHECK(filtration.edge_alpha[edge] <= filtration.triangle_alpha[i]);
      }
    std::vector<double> alphas = filtration.edge_alpha;
    alphas.insert(alphas.end(), filtration.triangle_alpha.begin(), filtration.triangle_alpha.end());
    sort_distinct(alphas);
    for (std::size_t i = 0; i < alphas.size(); i += 1 + alphas.size() / 12)
      for (const double alpha : {std::nextafter(alphas[i], 0.0), alphas[i]}) {
        CAPTURE(alpha);
        if (!(alpha > 0) || std::isinf(alpha)) continue;
        const FullCounts counts = rbpa::count_full(points, delaunay, filtration.tetrahedron_alpha, alpha);
        const auto within = [&](const std::vector<double>& radii) {
          return static_cast<std::size_t>(
              std::count_if(radii.begin(), radii.end(), [&](double r) { return r <= alpha; }));
        };
        CHECK(within(filtration.edge_alpha) == counts.edges);
        CHECK(within(filtration.triangle_alpha) == counts.triangles);
        CHECK(within(filtration.tetrahedron_alpha) == counts.tetrahedra);
        ++checked;
      }
  });
  CHECK(checked > 200);
}

TEST_CASE("threads make no difference, and large sets have no wrong neighbor of a face") {
  const Points3 points = uniform_cube(12000, 5002);
  const SolidFiltration one = rbpa::solid_filtration(points, {.threads = 1});
  const SolidFiltration more = rbpa::solid_filtration(points, {.threads = 3});
  CHECK(one.delaunay.simplices == more.delaunay.simplices);
  CHECK(one.triangles == more.triangles);
  CHECK(one.edges == more.edges);
  CHECK(one.tetrahedron_alpha == more.tetrahedron_alpha);
  CHECK(one.triangle_alpha == more.triangle_alpha);
  CHECK(one.edge_alpha == more.edge_alpha);
  // Euler's formula for the ball that the hull bounds.
  CHECK(12000 - one.edges.size() + one.triangles.size() - one.tetrahedron_alpha.size() == 1);
}

TEST_CASE("a point with many edges has all of them") {
  const Points3 moment = [] {
    Points3 points;
    for (int i = 1; i <= 150; ++i) points.push_back({double(i), double(i) * i, double(i) * i * i});
    return points;
  }();
  const SolidFiltration filtration = rbpa::solid_filtration(moment);
  CHECK(filtration.edges.size() == 150 * 149 / 2);
}

TEST_CASE("points in a plane have their Delaunay triangulation there, with its ties, at any slope") {
  Random random(5003);
  std::size_t triangles = 0, alone = 0;
  for (int trial = 0; trial < 120; ++trial) {
    // On a lattice of the plane, where many points are cocircular; in every second trial nearly so.
    std::vector<rbpa::Point> plane;
    for (std::size_t i = 0; i < 3 + random.below(60); ++i)
      plane.push_back({double(random.below(9)), double(random.below(9)) + (trial % 2 ? random.unit() : 0)});
    const auto number = [&] { return double(random.integer(-9, 9)); };
    const std::array<double, 3> u = {number(), number(), number()}, v = {number(), number(), number()};
    const bool is_level = trial % 3 == 0;
    Points3 points;
    for (const rbpa::Point& p : plane) {
      // Slopes for which nothing is rounded, where y is not an integer.
      const double a = p.x, b = is_level || trial % 2 == 0 ? p.y : std::ldexp(std::floor(std::ldexp(p.y, 20)), -20);
      points.push_back(is_level ? Point3{a, b, 0}
                                : Point3{a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]});
    }
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    REQUIRE(filtration.delaunay.simplices.empty());
    REQUIRE(filtration.triangles_of.empty());
    const auto sorted_triangles = [](auto rows) {
      for (auto& row : rows) std::sort(row.begin(), row.end());
      std::sort(rows.begin(), rows.end());
      return rows;
    };
    if (is_level)
      CHECK(sorted_triangles(filtration.triangles) == sorted_triangles(rbpa::alpha_complex(plane, infinity).triangles));
    CHECK(filtration.delaunay.distinct + filtration.triangles.size() - filtration.edges.size() ==
          1);  // Euler: one disc
    CHECK(std::set(filtration.edges.begin(), filtration.edges.end()).size() == filtration.edges.size());
    for (std::size_t i = 0; i < filtration.triangles.size(); ++i) {
      const auto& [a, b, c] = filtration.triangles[i];
      const rbpa::space::LeastSphere sphere(points[a], points[b], points[c]);
      CHECK(std::none_of(points.begin(), points.end(), [&](const Point3& p) { return sphere.has_inside(p); }));
      CHECK(filtration.triangle_alpha[i] == sphere.radius_rounded_up());
      CHECK(filtration.edges[filtration.edges_of[i][0]] == std::array{b, c});
      CHECK(filtration.edges[filtration.edges_of[i][1]] == std::array{a, c});
      CHECK(filtration.edges[filtration.edges_of[i][2]] == std::array{a, b});
    }
    for (std::size_t i = 0; i < filtration.edges.size(); ++i) {
      const auto& [a, b] = filtration.edges[i];
      const bool is_alone = std::none_of(points.begin(), points.end(), [&, at_a = a, at_b = b](const Point3& p) {
        return rbpa::space::in_least_sphere(points[at_a], points[at_b], p);
      });
      double first = infinity;
      for (std::size_t t = 0; t < filtration.triangles.size(); ++t)
        if (std::count(filtration.edges_of[t].begin(), filtration.edges_of[t].end(), i) > 0)
          first = std::min(first, filtration.triangle_alpha[t]);
      CHECK(filtration.edge_alpha[i] ==
            (is_alone ? rbpa::space::least_radius_rounded_up(points[a], points[b]) : first));
      alone += is_alone ? 1U : 0U;
    }
    triangles += filtration.triangles.size();
  }
  CHECK(triangles > 1500);
  CHECK(alone > 1500);
}

TEST_CASE("flat sets at the limits of double, and on lines, have all their edges") {
  using Edges = std::set<std::array<std::uint32_t, 2>>;
  for (const double scale : {1.0, 0x1p-1070, 0x1p1020}) {
    CAPTURE(scale);
    for (const Point3& along : {Point3{0, 0, 1}, Point3{-1, 2, 0}, Point3{1, 1, 1}, Point3{0, -3, 2}}) {
      Points3 line;
      for (const double t : {3.0, 0.0, 1.0, -4.0, 1.0, 2.0})
        line.push_back({t * along.x * scale, t * along.y * scale, t * along.z * scale});
      const SolidFiltration filtration = rbpa::solid_filtration(line);
      CHECK(Edges(filtration.edges.begin(), filtration.edges.end()) == Edges{{0, 5}, {2, 5}, {1, 2}, {1, 3}});
      CHECK(filtration.triangles.empty());
    }
    const Points3 square = {
        {scale, -scale, scale}, {-scale, -scale, scale}, {-scale, scale, scale}, {scale, scale, scale}};
    const SolidFiltration filtration = rbpa::solid_filtration(square);
    CHECK(filtration.triangles.size() == 2);
    CHECK(
        Edges(filtration.edges.begin(), filtration.edges.end()).contains({0, 2}));  // the least points get the diagonal
  }
}

TEST_CASE("points without a filtration are refused, and a run can be cancelled") {
  CHECK_THROWS_AS(rbpa::solid_filtration(Points3{{0, 0, infinity}}), rbpa::InvalidInput);
  const Points3 points = uniform_cube(3000, 5001);
  for (const int calls : {0, 3, 8, 20}) {
    int left = calls;
    const auto stop = [&](const rbpa::Progress&) { return left-- > 0; };
    CHECK_THROWS_AS(rbpa::solid_filtration(points, {.progress = stop}), rbpa::Cancelled);
  }
  const Points3 one = {{1, 2, 3}, {1, 2, 3}};
  const SolidFiltration filtration = rbpa::solid_filtration(one);
  CHECK(filtration.edges.empty());
  CHECK(filtration.delaunay.isolated == std::vector<std::uint32_t>{0});
  CHECK(filtration.delaunay.duplicates == std::vector<rbpa::Duplicate>{{1, 0}});
}
