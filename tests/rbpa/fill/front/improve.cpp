#include "rbpa/fill/front/improve.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "support/exact.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::Point;

bool is_counter_clockwise(const rbpa::Mesh& mesh) {
  for (const auto f : mesh.faces()) {
    std::vector<Point> corner;
    for (const auto v : mesh.fv_ccw_range(f)) corner.push_back({mesh.point(v)[0], mesh.point(v)[1]});
    if (rbpa_test::exact::orientation(corner[0], corner[1], corner[2]) <= 0) return false;
  }
  return true;
}

/// Returns four triangles around the last point, which may move.
rbpa::Mesh star_of(const std::array<Point, 5>& places) {
  rbpa::Mesh mesh;
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  meshops::PolygonSoup soup{.points = 5, .corners = {}};
  for (const std::uint32_t i : {0U, 1U, 2U, 3U}) soup.add_face(std::array{i, (i + 1) % 4, 4U});
  meshops::build_mesh(mesh, soup);
  for (int i = 0; i < 5; ++i) {
    const Point& p = places[static_cast<std::size_t>(i)];
    mesh.set_point(rbpa::Mesh::VertexHandle(i), {p.x, p.y, 0});
  }
  return mesh;
}

}  // namespace

TEST_CASE("no triangle is inverted, however flat it is") {
  rbpa_test::Random random(17);
  const rbpa::SizeField field(1, 1, {});
  std::size_t tried = 0, moved = 0;
  for (int i = 0; i < 40000; ++i) {
    // A quadrangle on a slanted line, except for some units in the last place, and a point in it.
    std::array<Point, 5> places;
    const double slope = random.between(0.3, 0.9);
    const std::array<double, 5> along = {0, random.between(0.2, 0.8), 1, random.between(0.2, 0.8),
                                         random.between(0.3, 0.7)};
    for (std::size_t k = 0; k < 5; ++k) {
      places[k] = {1 + along[k], 1 + slope * along[k]};
      for (int step = k == 1 || k == 3 ? random.integer(1, 6) : random.integer(0, 1); step > 0; --step)
        places[k].y = std::nextafter(places[k].y, k == 1 ? 0 : 9);
    }
    rbpa::Mesh mesh = star_of(places);
    if (!is_counter_clockwise(mesh)) continue;
    ++tried;
    rbpa::improve(mesh, 4, field, [] {});
    moved += mesh.point(rbpa::Mesh::VertexHandle(4))[0] != places[4].x;
    CHECK(meshops::validate(mesh).empty());
    REQUIRE(is_counter_clockwise(mesh));
  }
  CHECK(tried > 1000);
  CHECK(moved > 100);
}

TEST_CASE("a point moves to where its triangles are best, and boundary points stay") {
  rbpa::Mesh mesh = star_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.9, 0.2}}});
  rbpa::improve(mesh, 4, rbpa::SizeField(0.7, 1, {}), [] {});
  CHECK(std::abs(mesh.point(rbpa::Mesh::VertexHandle(4))[0] - 0.5) < 0.01);
  CHECK(std::abs(mesh.point(rbpa::Mesh::VertexHandle(4))[1] - 0.5) < 0.01);
  CHECK(mesh.point(rbpa::Mesh::VertexHandle(2))[0] == 1);
  rbpa::Mesh fixed = star_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.9, 0.2}}});
  rbpa::improve(fixed, 5, rbpa::SizeField(0.7, 1, {}), [] {});
  CHECK(fixed.point(rbpa::Mesh::VertexHandle(4))[0] == 0.9);
}

TEST_SUITE_END();
