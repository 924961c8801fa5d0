#include "rbpa/space/normals/sides/orient_normals.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

/// Orients the normals of points with one nearest point each.
Points3 oriented(Points3 points, std::vector<std::uint32_t> nearest, Points3 normals) {
  rbpa::space::orient_normals<double>({std::move(points), {}, 1, std::move(nearest)}, normals, {});
  return normals;
}

}  // namespace

TEST_CASE("an edge along a surface indicates one side, one through a plate opposite sides") {
  const Point3 up = {0, 0, 1}, down = {0, 0, -1};
  for (const Point3& given : {up, down}) {
    CHECK(oriented({{0, 0, 0}, {1, 0, 0.1}}, {1, 0}, {given, up}) == Points3{up, up});
    CHECK(oriented({{0, 0, 0}, {1, 0, 0.1}}, {1, 0}, {up, given}) == Points3{up, up});
    CHECK(oriented({{0, 0, 0}, {0.1, 0, 1}}, {1, 0}, {given, up}) == Points3{down, up});
    CHECK(oriented({{0, 0, 0}, {0.1, 0, 1}}, {1, 0}, {up, given}) == Points3{down, up});
  }
}

TEST_CASE("an edge around a corner indicates the outside of both faces") {
  const Point3 up = {0, 0, 1}, down = {0, 0, -1};
  for (const double sign : {1.0, -1.0}) {
    CHECK(oriented({{0, 0, 1}, {1, 0, 0}}, {1, 0}, {up, {sign, 0, 0}}) == Points3{up, {1, 0, 0}});
    // From below, the corner is an outer one too.
    CHECK(oriented({{0, 0, 1}, {1, 0, 2}}, {1, 0}, {up, {sign, 0, 0}}) == Points3{down, {1, 0, 0}});
  }
}

TEST_CASE("points that are the nearest of no point are reached too") {
  const Point3 up = {0, 0, 1}, down = {0, 0, -1};
  CHECK(oriented({{0, 0, 1}, {1, 0, 1.5}, {-5, 0, 0}}, {1, 0, 0}, {down, down, down}) == Points3{up, up, up});
}

TEST_CASE("two components have a first point each") {
  const Point3 up = {0, 0, 1}, down = {0, 0, -1};
  CHECK(oriented({{0, 0, 1}, {1, 0, 1}, {0, 0, 7}, {1, 0, 7}}, {1, 0, 3, 2}, {down, up, down, up}) ==
        Points3{up, up, up, up});
}

TEST_SUITE_END();
