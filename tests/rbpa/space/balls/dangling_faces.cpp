#include "rbpa/space/balls/dangling_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/least_sphere.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::DanglingFaces;
using rbpa::Point3;
using rbpa::Solid;
namespace exact = rbpa::space::exact;

TEST_SUITE_BEGIN("space");

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Finds the faces by definition, over all points. A face of the triangulation is in the complex if a simplex that it
/// is a face of is in the complex, or if its least sphere has a radius of at most alpha and no point inside.
DanglingFaces by_definition(const Points3& points, const Solid& delaunay, double alpha) {
  std::map<rbpa::Triangle, bool> triangles;
  std::map<Edge, bool> edges;
  std::set<rbpa::Triangle> of_tetrahedra;
  std::set<std::uint32_t> isolated(delaunay.isolated.begin(), delaunay.isolated.end());
  for (const auto& row : delaunay.simplices) {
    std::array<std::uint32_t, 4> t = row;
    isolated.insert(t.begin(), t.end());
    std::sort(t.begin(), t.end());
    const bool is_within = std::isinf(alpha) || exact::compare_circumradius(points[t[0]], points[t[1]], points[t[2]],
                                                                            points[t[3]], alpha) <= 0;
    for (const auto& [i, j, k] : {std::array{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
      const rbpa::Triangle triangle = {t[std::size_t(i)], t[std::size_t(j)], t[std::size_t(k)]};
      triangles[triangle] |= is_within;
      if (is_within) of_tetrahedra.insert(triangle);
    }
  }
  const auto none_inside = [&](auto is_inside) { return std::none_of(points.begin(), points.end(), is_inside); };
  DanglingFaces result;
  std::set<Edge> of_triangles;
  std::set<std::uint32_t> of_edges;
  for (auto& [t, is_in] : triangles) {
    const Point3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    if (!is_in)
      is_in = exact::compare_circumradius(a, b, c, alpha) <= 0 &&
              none_inside([&](const Point3& q) { return exact::side_of_least_sphere(a, b, c, q) > 0; });
    for (const Edge edge : {Edge{t[0], t[1]}, Edge{t[0], t[2]}, Edge{t[1], t[2]}}) {
      edges[edge] |= is_in;
      if (is_in) of_triangles.insert(edge);
    }
    if (is_in && !of_tetrahedra.contains(t)) result.triangles.push_back(t);
  }
  for (const auto& [edge, of_triangle] : edges) {
    const Point3 &a = points[edge[0]], &b = points[edge[1]];
    if (!of_triangle && (exact::compare_circumradius(a, b, alpha) > 0 ||
                         !none_inside([&](const Point3& q) { return exact::side_of_least_sphere(a, b, q) > 0; })))
      continue;
    of_edges.insert(edge.begin(), edge.end());
    if (!of_triangle) result.edges.push_back(edge);
  }
  for (const std::uint32_t point : isolated)
    if (!of_edges.contains(point)) result.points.push_back(point);
  return result;
}

}  // namespace

TEST_CASE("triangles, edges and points follow the definition, at alphas from tiny to infinite") {
  std::size_t triangles = 0, edges = 0, isolated = 0;
  for_solids(60, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity);
    if (delaunay.simplices.size() > 4000) return;
    const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
    std::vector<double> sorted = radii;
    std::sort(sorted.begin(), sorted.end());
    const double middle = sorted[sorted.size() / 2];
    for (const double alpha :
         {middle * 0.1, middle * 0.5, middle * 0.8, middle, sorted[sorted.size() / 10], infinity}) {
      if (!(alpha > 0)) continue;
      CAPTURE(alpha);
      const DanglingFaces expected = by_definition(points, delaunay, alpha);
      for (const unsigned threads : {1u, 3u}) {
        const DanglingFaces found = rbpa::dangling_faces(points, delaunay, radii, alpha, threads);
        CHECK(found.triangles == expected.triangles);
        CHECK(found.edges == expected.edges);
        CHECK(found.points == expected.points);
      }
      triangles += expected.triangles.size();
      edges += expected.edges.size();
      isolated += expected.points.size();
    }
  });
  CHECK(triangles > 500);
  CHECK(edges > 500);
  CHECK(isolated > 500);
}

TEST_CASE("the filters of least spheres never differ from integers") {
  Random random(7);
  std::size_t on = 0;
  for (int round = 0; round < 20000; ++round) {
    const bool is_grid = round % 2 == 0;
    const auto coordinate = [&] {
      return is_grid ? random.integer(0, 4) : std::ldexp(random.unit(), random.integer(-3, 3));
    };
    const auto point = [&] { return Point3{double(coordinate()), double(coordinate()), double(coordinate())}; };
    const Point3 a = point(), b = point(), c = point(), q = point();
    if (a == b) continue;
    const double radius = is_grid ? random.integer(1, 6) / 2.0 : random.between(0.1, 5);
    REQUIRE(rbpa::space::is_least_sphere_within(a, b, radius) == (exact::compare_circumradius(a, b, radius) <= 0));
    REQUIRE(rbpa::space::in_least_sphere(a, b, q) == (exact::side_of_least_sphere(a, b, q) > 0));
    on += exact::side_of_least_sphere(a, b, q) == 0;
    if (exact::compare_circumradius(a, b, c, 1e300) > 0) continue;  // on a line
    const rbpa::space::LeastSphere sphere(a, b, c);
    REQUIRE(sphere.is_within(radius) == (exact::compare_circumradius(a, b, c, radius) <= 0));
    REQUIRE(sphere.has_inside(q) == (exact::side_of_least_sphere(a, b, c, q) > 0));
    on += exact::side_of_least_sphere(a, b, c, q) == 0;
  }
  CHECK(on > 500);
}

TEST_CASE("least spheres are those computed by hand") {
  const Point3 a = {0, 0, 0}, b = {2, 0, 0}, c = {0, 2, 0};
  CHECK(exact::compare_circumradius(a, b, 1) == 0);
  CHECK(exact::compare_circumradius(a, b, 0.9) == 1);
  CHECK(exact::side_of_least_sphere(a, b, {1, 0.5, 0.5}) == 1);
  CHECK(exact::side_of_least_sphere(a, b, {1, 1, 0}) == 0);
  CHECK(exact::side_of_least_sphere(a, b, {1, 1, 1e-300}) == -1);
  CHECK(exact::side_of_least_sphere(a, b, c, {2, 2, 0}) == 0);
  CHECK(exact::side_of_least_sphere(a, b, c, {1, 1, 1}) == 1);
  CHECK(exact::side_of_least_sphere(a, b, c, {1, 1, 1.5}) == -1);
}

TEST_CASE("arguments that do not belong together are refused") {
  const Points3 points = jittered_cubes(60, 6);
  const Solid solid = rbpa::solid(points, infinity), bare = rbpa::solid(points, infinity, {.neighbors = false});
  const std::vector<double> radii = rbpa::circumradii(points, solid.simplices);
  CHECK_THROWS_AS(rbpa::dangling_faces(points, solid, {}, 1), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::dangling_faces(points, bare, radii, 1), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::dangling_faces(points, solid, radii, 0), rbpa::InvalidInput);
  const Points3 one = {{1, 2, 3}, {1, 2, 3}};
  CHECK(rbpa::dangling_faces(one, rbpa::solid(one, infinity), {}, 1).points == std::vector<std::uint32_t>{0});
}

TEST_CASE("all simplices of points in a plane or on a line dangle") {
  const auto at = [](const Points3& points, double alpha) {
    return rbpa::dangling_faces(points, rbpa::solid(points, infinity), {}, alpha);
  };
  using Edges = std::vector<std::array<std::uint32_t, 2>>;
  const Points3 house = {{0, 0, 5}, {0, 2, 5}, {2, 2, 5}, {2, 0, 5}, {0, 2, 5}, {0, 5, 5}, {9, 9, 5}};
  CHECK(at(house, 0.9).points == std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6});
  CHECK(at(house, 1).edges == Edges{{0, 1}, {0, 3}, {1, 2}, {2, 3}});
  CHECK(at(house, 1).points == std::vector<std::uint32_t>{5, 6});
  CHECK(at(house, 1.5).triangles == std::vector<rbpa::Triangle>{{0, 1, 3}, {1, 2, 3}});
  CHECK(at(house, 1.5).edges == Edges{{1, 5}});
  CHECK(at(house, infinity).edges.empty());
  CHECK(at({{0, 0, 0}, {3, 3, 3}, {1, 1, 1}}, 1).edges == Edges{{0, 2}});
  CHECK(at({{0, 0, 0}, {3, 3, 3}, {1, 1, 1}}, 1).points == std::vector<std::uint32_t>{1});
}

TEST_SUITE_END();
