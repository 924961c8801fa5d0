#include "rbpa/space/surface/surface_of.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/close_surface.h"
#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"
#include "support/for_space_sets.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Surface;
using rbpa::SurfaceOfTriangles;

TEST_SUITE_BEGIN("space");

namespace {

using Row = std::array<std::uint32_t, 3>;

struct Soup {
  Points3 points;
  std::vector<Row> triangles;

  SurfaceOfTriangles surface() const { return rbpa::surface_of(points, triangles); }
};

Soup cube(double x = 0, double y = 0, double z = 0) {
  Soup soup;
  for (unsigned i = 0; i < 8; ++i) soup.points.push_back({x + (i & 1U), y + (i >> 1U & 1U), z + (i >> 2U)});
  for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  }
  return soup;
}

Soup together(Soup a, const Soup& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({first + i, first + j, first + k});
  return a;
}

/// Returns the triangles with separate corners, as STL has them.
Soup unmerged(const Soup& soup) {
  Soup apart;
  for (const Row& t : soup.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.points.size());
    for (const std::uint32_t corner : t) apart.points.push_back(soup.points[corner]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

void check_canonical(const Soup& soup, const SurfaceOfTriangles& surface) {
  CHECK(std::is_sorted(surface.triangles.begin(), surface.triangles.end()));
  REQUIRE(surface.given.size() == soup.triangles.size());
  for (std::size_t t = 0; t < surface.given.size(); ++t) {
    Row own = surface.triangles[t];
    CHECK(own[0] == *std::min_element(own.begin(), own.end()));
    const Row& given = soup.triangles[surface.given[t]];
    const auto is_at_given = [&] {
      for (std::size_t k = 0; k < 3; ++k)
        if (soup.points[own[k]] != soup.points[given[k]]) return false;
      return true;
    };
    for (int turn = 0; turn < 3 && !is_at_given(); ++turn) std::rotate(own.begin(), own.begin() + 1, own.end());
    CHECK(is_at_given());
  }
  std::vector<std::uint32_t> each = surface.given;
  std::sort(each.begin(), each.end());
  for (std::uint32_t t = 0; t < each.size(); ++t) CHECK(each[t] == t);
}

std::string refusal_of(const Soup& soup) {
  try {
    soup.surface();
  } catch (const rbpa::InvalidInput& error) {
    return error.what();
  }
  return "done";
}

std::size_t open_sides(const Surface& surface) {
  std::size_t open = 0;
  for (const auto& beyond : surface.neighbors)
    open += static_cast<std::size_t>(std::count(beyond.begin(), beyond.end(), Surface::none));
  return open;
}

}  // namespace

TEST_CASE("a user's cube of triangles is closed and has the volume 1, merged or not, in any order") {
  Random random(5);
  for (const Soup& given : {cube(), unmerged(cube())}) {
    Soup soup = given;
    for (int trial = 0; trial < 5; ++trial) {
      const SurfaceOfTriangles surface = soup.surface();
      check_canonical(soup, surface);
      CHECK(surface.distinct == 8);
      CHECK(surface.duplicates.size() == soup.points.size() - 8);
      CHECK(open_sides(surface) == 0);
      const auto components = rbpa::surface_components(soup.points, surface);
      REQUIRE(components.all.size() == 1);
      CHECK(components.all[0].volume == 1);
      CHECK(components.all[0].area == 6);
      CHECK(rbpa::genus_of(surface, components) == std::vector<std::size_t>{0});
      for (Row& t : soup.triangles) std::rotate(t.begin(), t.begin() + random.below(3), t.end());
      for (std::size_t i = soup.triangles.size(); i > 1; --i)
        std::swap(soup.triangles[i - 1], soup.triangles[random.below(i)]);
    }
  }
}

TEST_CASE("bodies that touch along an edge are glued as they face each other; for indices they are two, in any order") {
  Soup soup = together(cube(), cube(1, 1, 0));
  for (int trial = 0; trial < 6; ++trial) {
    const SurfaceOfTriangles surface = soup.surface();
    CHECK(surface.distinct == 14);
    CHECK(open_sides(surface) == 0);
    CHECK(rbpa::surface_components(soup.points, surface).all.size() == 1);  // a ball rolls between them
    const auto components = rbpa::surface_components(soup.points, rbpa::indexable_surface(surface));
    REQUIRE(components.all.size() == 2);
    for (const auto& component : components.all) {
      CHECK(component.is_closed());
      CHECK(component.volume == 1);
    }
    std::rotate(soup.triangles.begin(), soup.triangles.begin() + 5, soup.triangles.end());
  }
  // Four wedges around one edge: bodies fill every second of eight directions.
  Soup star;
  star.points = {{0, 0, 0}, {0, 0, 1}};
  for (int k = 0; k < 8; ++k) {
    static constexpr std::array<std::array<double, 2>, 8> at = {
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    star.points.push_back({at[static_cast<std::size_t>(k)][0], at[static_cast<std::size_t>(k)][1], 0.5});
  }
  for (std::uint32_t k = 0; k < 8; k += 2) {
    const std::uint32_t p = 2 + k, q = 3 + k;
    for (const Row& t : {Row{0, p, 1}, Row{0, 1, q}, Row{0, q, p}, Row{1, p, q}}) star.triangles.push_back(t);
  }
  const SurfaceOfTriangles surface = star.surface();
  CHECK(open_sides(surface) == 0);
  const auto components = rbpa::surface_components(star.points, rbpa::indexable_surface(surface));
  CHECK(components.all.size() == 4);
  for (const auto& component : components.all) CHECK(component.volume > 0);
}

TEST_CASE("the exposed triangles of any points, given without neighbors, are glued as the ball rolls") {
  Random random(71);
  std::size_t non_manifold = 0;
  for_space_sets(25, 3, 39, random, [&](const Points3& points) {
    const Surface expected = rbpa::exposed_triangles(points, space_radius(points, random));
    const SurfaceOfTriangles found = rbpa::surface_of(points, expected.triangles);
    REQUIRE(found.triangles == expected.triangles);
    CHECK(found.neighbors == expected.neighbors);
    CHECK(found.duplicates == expected.duplicates);
    CHECK(found.distinct == expected.distinct);
    const SurfaceOfTriangles again = rbpa::surface_of(points, expected.triangles, expected.neighbors);
    CHECK(again.neighbors == expected.neighbors);
    non_manifold += rbpa::split_fans(expected).point.size() > expected.distinct;
  });
  CHECK(non_manifold > 10);
}

TEST_CASE("sides in one direction, triangles on top of each other and triangles without an area are not glued") {
  const Soup flipped{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 3}}};
  CHECK(open_sides(flipped.surface()) == 6);
  // Three triangles at an edge, two of them in one place: the third faces no other.
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}, {0, 2, 0}};
  CHECK(open_sides(Soup{points, {{0, 1, 2}, {0, 1, 2}, {1, 0, 3}}}.surface()) == 9);
  CHECK(open_sides(Soup{points, {{0, 1, 2}, {0, 1, 5}, {1, 0, 3}}}.surface()) == 9);
  CHECK(open_sides(Soup{points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}}.surface()) == 7);  // the last has no area
  CHECK(open_sides(Soup{points, {{0, 1, 2}, {1, 0, 3}}}.surface()) == 4);
  // Both sides of a sheet are glued at its rim; where a third triangle stands on it, only one of them faces that
  // triangle.
  CHECK(open_sides(Soup{points, {{0, 1, 2}, {0, 2, 1}}}.surface()) == 0);
  const SurfaceOfTriangles sheet = Soup{points, {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {0, 3, 1}}}.surface();
  CHECK(open_sides(sheet) == 0);
  const auto components = rbpa::surface_components(points, sheet);
  CHECK(components.all.size() == 1);
}

TEST_CASE("input that makes no surface is refused by name") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  CHECK(refusal_of({points, {{0, 1, 2}, {0, 1, 4}}}) == "triangle 1: found corner 4, expected one of 4 points");
  CHECK(refusal_of({points, {{0, 1, 1}}}).starts_with("triangle 0: two corners are at one place"));
  CHECK(refusal_of({points, {{0, 1, 2}, {0, 1, 3}}}).starts_with("triangle 1: two corners are at one place"));
  Points3 broken = points;
  broken[3].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal_of({broken, {{0, 1, 2}}}).starts_with("point 3 is (1, nan, 0)"));
  CHECK(refusal_of({{}, {{0, 1, 2}}}).starts_with("triangle 0: found corner 0"));
  CHECK(Soup{}.surface().triangles.empty());
  constexpr std::uint32_t none = Surface::none;
  const std::vector<Row> one = {{0, 1, 2}};
  CHECK_THROWS_AS(rbpa::surface_of(points, one, std::vector<Row>{}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::surface_of(points, one, std::vector<Row>{{7, none, none}}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::surface_of(points, one, std::vector<Row>{{0, none, none}}), meshops::ContractViolation);
  CHECK(rbpa::surface_of(points, one, std::vector<Row>{{none, none, none}}).neighbors.size() == 1);
}

TEST_CASE("a user's open box is closed, and its filling refined") {
  Soup box = cube();
  box.triangles.erase(box.triangles.begin() + 2, box.triangles.begin() + 4);  // the lid
  const rbpa::ClosedSurface closed = rbpa::close_surface(box.points, rbpa::indexable_surface(box.surface()));
  CHECK(open_sides(closed.surface) == 0);
  CHECK(std::count(closed.is_new.begin(), closed.is_new.end(), true) == 2);
  CHECK(rbpa::surface_components(box.points, closed.surface).all[0].volume == 1);
  const rbpa::RefinedSurface refined = rbpa::refine_filling(box.points, closed.surface, closed.is_new);
  CHECK(refined.smooth + refined.flat + refined.coarse == 1);
  CHECK(open_sides(refined.surface) == 0);
}

TEST_SUITE_END();
