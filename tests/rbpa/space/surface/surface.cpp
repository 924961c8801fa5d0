#include "rbpa/space/surface/surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/space/predicate/resting_ball.h"
#include "support/for_space_sets.h"
#include "support/generate.h"
#include "support/order.h"
#include "support/refusal_of.h"
#include "support/space_sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::exposed_triangles;
using rbpa::Point3;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

Points3 normals_up(std::size_t count) { return Points3(count, {0, 0, 1}); }

/// Checks that every side of every triangle is glued to one side in the opposite direction, or to none.
void check_glued(const Surface& s) {
  REQUIRE(s.neighbors.size() == s.triangles.size());
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = s.neighbors[t][k];
      if (other == Surface::none) continue;
      REQUIRE(other < s.triangles.size());
      const std::uint32_t from = s.triangles[t][(k + 1) % 3], to = s.triangles[t][(k + 2) % 3];
      int found = 0;
      for (std::size_t j = 0; j < 3; ++j)
        found += s.neighbors[other][j] == t && s.triangles[other][(j + 1) % 3] == to &&
                 s.triangles[other][(j + 2) % 3] == from;
      CHECK(found == 1);
    }
  CHECK(std::is_sorted(s.triangles.begin(), s.triangles.end()));
  CHECK(std::adjacent_find(s.triangles.begin(), s.triangles.end()) == s.triangles.end());
  for (const Triangle& t : s.triangles) CHECK((t[0] < t[1] && t[0] < t[2]));
}

bool is_closed(const Surface& s) {
  return std::none_of(s.neighbors.begin(), s.neighbors.end(),
                      [](const Triangle& n) { return std::count(n.begin(), n.end(), Surface::none) > 0; });
}

/// Returns V − E + F, with a vertex for each fan.
int euler(const Surface& s) {
  std::vector<std::size_t> fan(3 * s.triangles.size());
  std::iota(fan.begin(), fan.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (fan[i] != i) i = fan[i] = fan[fan[i]];
    return i;
  };
  int sides = 0, glued = 0;
  for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides;
      const std::uint32_t other = s.neighbors[t][k];
      if (other == Surface::none) continue;
      ++glued;
      for (std::size_t j = 0; j < 3; ++j)
        for (const std::size_t corner : {(k + 1) % 3, (k + 2) % 3})
          if (s.triangles[other][j] == s.triangles[t][corner]) fan[root(3 * t + corner)] = root(3 * other + j);
    }
  int vertices = 0;
  for (std::size_t i = 0; i < fan.size(); ++i) vertices += root(i) == i;
  return vertices - (sides - glued / 2) + static_cast<int>(s.triangles.size());
}

/// Returns the triangles literally by the definition: every oriented triple against every point.
std::vector<Triangle> by_definition(const Points3& points, double radius) {
  std::vector<std::uint32_t> distinct;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (std::find(points.begin(), points.begin() + i, points[i]) == points.begin() + i) distinct.push_back(i);
  std::vector<Triangle> found;
  for (const std::uint32_t a : distinct)
    for (const std::uint32_t b : distinct)
      for (const std::uint32_t c : distinct) {
        if (!(a < b && a < c && b != c)) continue;
        const rbpa::space::RestingBall<long double> ball(points[a], points[b], points[c], radius);
        if (ball.rests() && std::none_of(distinct.begin(), distinct.end(), [&](std::uint32_t q) {
              return q != a && q != b && q != c && ball.contains(points[q]);
            }))
          found.push_back({a, b, c});
      }
  return canonical(found);
}

}  // namespace

TEST_CASE("the exposed triangles follow the definition, and are closed") {
  Random random(81);
  std::size_t triangles = 0;
  for_space_sets(25, 3, 8, random, [&](const Points3& points) {
    const double radius = space_radius(points, random);
    const Surface exposed = exposed_triangles(points, radius);
    CHECK(exposed.triangles == by_definition(points, radius));
    check_glued(exposed);
    CHECK(is_closed(exposed));
    triangles += exposed.triangles.size();
  });
  CHECK(triangles > 1000);
}

TEST_CASE("one triangle is exposed on both sides and rolls to itself; below its circumradius there is none") {
  const Points3 points = {{3, 4, 0}, {-4, 3, 0}, {0, -5, 0}};
  const Surface both = exposed_triangles(points, 5);
  CHECK(both.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}});
  CHECK(both.neighbors == std::vector<Triangle>{{1, 1, 1}, {0, 0, 0}});
  CHECK(exposed_triangles(points, std::nextafter(5, 0)).triangles.empty());
  const Surface up = rbpa::surface(points, normals_up(3), 5);
  CHECK(up.triangles == std::vector<Triangle>{{0, 1, 2}});
  CHECK(up.neighbors == std::vector<Triangle>{{Surface::none, Surface::none, Surface::none}});
}

TEST_CASE("a tetrahedron is solid from its circumradius on: only its outside is exposed") {
  const Points3 points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const double radius = std::sqrt(3);  // below the circumradius as a real number, or above
  const bool solid = 3 <= radius * radius && std::nextafter(radius, 0) * std::nextafter(radius, 0) < 3;
  const Surface inside_too = exposed_triangles(points, std::nextafter(radius, 0));
  CHECK(inside_too.triangles.size() == 8);  // a ball fits into it, and rests on each triangle
  CHECK(exposed_triangles(points, std::nextafter(radius, 2)).triangles.size() == 4);
  CHECK((!solid || exposed_triangles(points, radius).triangles.size() <= 8));
  CHECK(euler(exposed_triangles(points, 2)) == 2);
  CHECK(euler(inside_too) == 4);  // two spheres
}

TEST_CASE("a cube of integer points is solid at exactly its circumradius") {
  Points3 points;
  for (int i = 0; i < 8; ++i) points.push_back({6.0 * (i & 1), 6.0 * (i >> 1 & 1), 3.0 * (i >> 2)});  // diagonal 9
  const Surface at = exposed_triangles(points, 4.5);
  CHECK(at.triangles.size() == 12);
  CHECK(euler(at) == 2);
  const Surface below = exposed_triangles(points, std::nextafter(4.5, 0));
  CHECK(below.triangles.size() == 24);  // its inside too
  CHECK(euler(below) == 4);
}

TEST_CASE("points of a plane with one normal have the triangles of rbpa() at that radius, and its boundary") {
  const std::vector<rbpa_test::Points> sets = {random_grid(9, 60, true, 5), uniform(300, 6),
                                               perfect_grid(9, 1),          integer_circle(65),
                                               rotated_integer_grid(8),     duplicates(30, 3, 7)};
  for (const rbpa_test::Points& flat : sets) {
    Points3 points;
    for (const rbpa::Point& p : flat) points.push_back({p.x, p.y, 2});
    for (const double radius : {0.5, 0.75, 1.0, 2.5, 3.5, 65.0}) {
      const rbpa::AlphaComplex plane = rbpa::alpha_complex(flat, radius, {.neighbors = true});
      const Surface space = rbpa::surface(points, normals_up(points.size()), radius);
      CHECK(space.triangles == plane.triangles);
      CHECK(space.neighbors == plane.neighbors);
      CHECK(space.duplicates == plane.duplicates);
      CHECK(space.distinct == plane.distinct);
    }
  }
}

TEST_CASE("shuffled points have the same surface, also scaled by a power of two") {
  Random random(82);
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < 6; ++trial) {
      CAPTURE(name(static_cast<SpaceKind>(k)));
      Points3 points = space_set(static_cast<SpaceKind>(k), 25, random);
      const double radius = space_radius(points, random);
      sort_distinct(points);
      const Points3 normals = random_normals(points.size(), random);
      const Surface expected = rbpa::surface(points, normals, radius);
      check_glued(expected);

      const std::vector<std::uint32_t> order = random_order(points.size(), random);
      const Points3 shuffled = in_order(points, order), turned = in_order(normals, order);
      const Surface actual = rbpa::surface(shuffled, turned, radius);
      CHECK(renumbered(actual.triangles, order) == expected.triangles);
      CHECK(euler(actual) == euler(expected));

      if (static_cast<SpaceKind>(k) == SpaceKind::extreme) continue;
      for (const double scale : {0x1p-300, 0x1p-100, 0x1p300}) {
        Points3 scaled;
        for (const Point3& p : points) scaled.push_back({scale * p.x, scale * p.y, scale * p.z});
        const Surface other = rbpa::surface(scaled, normals, scale * radius);
        CHECK(other.triangles == expected.triangles);
        CHECK(other.neighbors == expected.neighbors);
      }
    }
}

TEST_CASE("the surface has the exposed triangles that agree with all normals, glued as exposed triangles are") {
  Random random(83);
  std::size_t kept = 0, boundary = 0;
  for_space_sets(20, 12, 0, random, [&](const Points3& points) {
    const Points3 normals = random_normals(points.size(), random);
    const double radius = space_radius(points, random);
    const Surface all = exposed_triangles(points, radius), some = rbpa::surface(points, normals, radius);
    std::vector<std::uint32_t> number(all.triangles.size(), Surface::none);
    std::uint32_t next = 0;
    std::vector<Triangle> expected;
    for (std::size_t t = 0; t < all.triangles.size(); ++t) {
      const auto& [a, b, c] = all.triangles[t];
      bool agrees = true;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i] == points[a] || points[i] == points[b] || points[i] == points[c])
          agrees = agrees && rbpa::space::exact::normal_sign(points[a], points[b], points[c], normals[i]) > 0;
      if (!agrees) continue;
      number[t] = next++;
      expected.push_back(all.triangles[t]);
    }
    CHECK(some.triangles == expected);
    check_glued(some);
    for (std::size_t t = 0; t < all.triangles.size(); ++t)
      for (std::size_t side = 0; side < 3 && number[t] != Surface::none; ++side) {
        const std::uint32_t mate = number[all.neighbors[t][side]];
        CHECK(some.neighbors[number[t]][side] == mate);
        boundary += mate == Surface::none;
      }
    kept += expected.size();
  });
  CHECK(kept > 100);
  CHECK(boundary > 100);
}

TEST_CASE("points on a torus have a closed surface of genus 1") {
  Points3 points, normals;
  Random random(84);
  const int around = 60, tube = 25;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) {
      const double u = (i + random.between(-0.3, 0.3)) * 2 * M_PI / around,
                   v = (j + random.between(-0.3, 0.3)) * 2 * M_PI / tube;
      normals.push_back({std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)});
      const double out = 1 + 0.4 * std::cos(v);
      points.push_back({out * std::cos(u), out * std::sin(u), 0.4 * std::sin(v)});
    }
  const Surface torus = rbpa::surface(points, normals, 0.2);
  CHECK(torus.triangles.size() == 2 * points.size());
  check_glued(torus);
  CHECK(is_closed(torus));
  CHECK(euler(torus) == 0);
  const Surface exposed = exposed_triangles(points, 0.2);
  CHECK(exposed.triangles.size() == 4 * points.size());  // the inside too
  CHECK(is_closed(exposed));
}

TEST_CASE("a surface has the same bytes with any number of threads; a run can be watched and cancelled") {
  Random random(85);
  const Points3 points = space_set(SpaceKind::noisy_sphere, 6000, random);
  const Points3 normals = points;  // relative to the center
  std::size_t calls = 0, last = 0;
  const auto watch = [&](const rbpa::Progress& p) {
    ++calls;
    CHECK(p.triangles >= last);
    CHECK(p.points == points.size());
    last = p.triangles;
    return true;
  };
  const Surface one = exposed_triangles(points, 0.2, {.threads = 1, .progress = watch});
  CHECK(calls > 20);
  CHECK(last == one.triangles.size());
  const Surface agreeing = rbpa::surface(points, normals, 0.2, {.threads = 1});
  CHECK(agreeing.triangles.size() > 1000);
  for (const unsigned threads : {2u, 5u, 0u}) {
    const Surface several = exposed_triangles(points, 0.2, {.threads = threads});
    CHECK(several.triangles == one.triangles);
    CHECK(several.neighbors == one.neighbors);
    CHECK(rbpa::surface(points, normals, 0.2, {.threads = threads}).neighbors == agreeing.neighbors);
  }
  for (const unsigned threads : {1u, 2u})
    CHECK_THROWS_AS(exposed_triangles(points, 0.2, {.threads = threads, .progress = [](auto) { return false; }}),
                    rbpa::Cancelled);
}

TEST_CASE("invalid input is refused by name; few points and far points have an empty surface") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto refusal = [](auto call) -> std::string { return refusal_of<rbpa::InvalidInput>(call); };
  for (const double radius : {0.0, -1.0, none, infinity})
    CHECK(refusal([&] { exposed_triangles(points, radius); }).find("expected a finite number above 0") !=
          std::string::npos);
  CHECK(refusal([&] {
          exposed_triangles(Points3{{0, 0, 0}, {1, none, 0}}, 1);
        }) == "point 1 is (1, nan, 0), expected finite coordinates");
  CHECK(refusal([&] { rbpa::surface(points, normals_up(2), 1); }) == "2 normals, expected one for each of 3 points");
  for (const Point3& bad : {Point3{0, -0.0, 0}, Point3{infinity, 0, 0}})
    CHECK(refusal([&] { rbpa::surface(points, Points3{{0, 0, 1}, bad, {0, 0, 1}}, 1); }).find("normal 1 is (") == 0);
  for (std::size_t n = 0; n < 3; ++n)
    CHECK(exposed_triangles(Points3(points.begin(), points.begin() + static_cast<long>(n)), 9).triangles.empty());
  CHECK(exposed_triangles(points, 0.1).triangles.empty());
}

TEST_CASE("the lowest index represents duplicates, and all their normals count") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, 1, 0}};
  Points3 normals = normals_up(5);
  const Surface up = rbpa::surface(points, normals, 1);
  CHECK(up.triangles == std::vector<Triangle>{{0, 1, 2}});
  CHECK(up.distinct == 3);
  CHECK(up.duplicates == std::vector<rbpa::Duplicate>{{3, 0}, {4, 2}});
  normals[4] = {0, 0, -1};
  CHECK(rbpa::surface(points, normals, 1).triangles.empty());
}

TEST_SUITE_END();
