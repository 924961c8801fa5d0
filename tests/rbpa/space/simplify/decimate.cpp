// Decimation of meshes with places in an array, and of surfaces between points.
#include "rbpa/space/simplify/decimate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/reconstruct.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "rbpa/space/surface/surface_of.h"
#include "space/simplify/placed.h"
#include "space/simplify/random_meshes.h"
#include "space/simplify/triangle_sets.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

meshops::TopologyReport topology_of(const std::vector<Point3>& points, const Surface& surface) {
  return meshops::report(rbpa::surface_mesh(points, surface).mesh);
}

/// Checks the law of Surface: each triangle begins with its least corner, triangles ascend, and neighbors are mutual
/// along the side between the same corners.
void check_canonical(const Surface& surface) {
  CHECK(std::is_sorted(surface.triangles.begin(), surface.triangles.end()));
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    CHECK(std::min_element(corners.begin(), corners.end()) == corners.begin());
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = surface.neighbors[t][k];
      if (other == Surface::none) continue;
      REQUIRE(other < surface.triangles.size());
      const auto& beyond = surface.neighbors[other];
      CHECK(std::find(beyond.begin(), beyond.end(), t) != beyond.end());
      const std::set<std::uint32_t> there(surface.triangles[other].begin(), surface.triangles[other].end());
      CHECK((there.contains(corners[(k + 1) % 3]) && there.contains(corners[(k + 2) % 3])));
    }
  }
}

/// Two tetrahedra that touch in a corner, and two that touch along an edge.
Triangles touching() {
  Triangles t;
  const auto add = [&](std::array<Point3, 4> corners) {
    std::array<std::uint32_t, 4> at{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto found = std::find(t.points.begin(), t.points.end(), corners[k]);
      at[k] = static_cast<std::uint32_t>(found - t.points.begin());
      if (found == t.points.end()) t.points.push_back(corners[k]);
    }
    for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      t.corners.push_back(
          {at[static_cast<std::size_t>(f[0])], at[static_cast<std::size_t>(f[1])], at[static_cast<std::size_t>(f[2])]});
  };
  add({Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  add({Point3{0, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 0, -1}});
  add({Point3{1, 0, 0}, {0, 1, 0}, {2, 2, 0}, {2, 2, 3}});
  return t;
}

}  // namespace

TEST_CASE("decimate ends at the number of triangles, counts what it refuses, and says when nothing is left to do") {
  for (const char* name : {"m3_spot.off", "m3_plate_holes.off", "m3_cube_no_bottom.off"}) {
    INFO(std::string(name));
    Placed with(read_off(bundled_data() / name));
    const std::size_t given = with.mesh.n_faces();
    const auto before = meshops::report(with.mesh);
    rbpa::Decimation counts = rbpa::decimate(with.mesh, with.places, {.faces = given / 4});
    CHECK(counts.given == given);
    CHECK((counts.left <= given / 4 && counts.left + 2 > given / 4));
    CHECK_FALSE(counts.is_exhausted);
    counts = rbpa::decimate(with.mesh, with.places, {});
    CHECK(counts.is_exhausted);
    CHECK(counts.left == meshops::report(with.mesh).faces);
    std::size_t refused = 0;
    for (const auto& [reason, count] : counts.refused) refused += count;
    CHECK(refused > 0);
    CHECK(meshops::report(with.mesh).betti == before.betti);
    CHECK(meshops::report(with.mesh).boundary_curves == before.boundary_curves);
    const std::vector<Point3> places = with.places;
    counts = rbpa::decimate(with.mesh, with.places, {.faces = counts.left});
    CHECK((counts.collapses == 0 && counts.left == counts.given && counts.refused.empty()));
    CHECK(with.places == places);
  }
}

TEST_CASE("decimate refuses polygons, places that are not finite and too few places, with the mesh untouched") {
  const Triangles t = read_off(bundled_data() / "m3_spot.off");
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    Placed with(t);
    with.places[17].y = wrong;
    CHECK_THROWS_WITH_AS(rbpa::decimate(with.mesh, with.places, {.faces = 100}),
                         "decimate: found coordinates of vertex 17 that are not finite, expected numbers",
                         rbpa::InvalidInput);
    CHECK(meshops::report(with.mesh).faces == t.corners.size());
    with.places.pop_back();
    CHECK_THROWS_AS(rbpa::decimate(with.mesh, with.places, {}), meshops::ContractViolation);
  }
  OpenMesh::PolyConnectivity square;
  meshops::PolygonSoup soup;
  soup.points = 4;
  soup.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  meshops::build_mesh(square, soup);
  meshops::request_status(square);
  std::vector<Point3> places(4);
  CHECK_THROWS_WITH_AS(rbpa::decimate(square, places, {}), "decimate: face 0 is not a triangle",
                       meshops::ContractViolation);
  OpenMesh::PolyConnectivity empty;
  meshops::request_status(empty);
  places.clear();
  CHECK(rbpa::decimate(empty, places, {}).left == 0);
}

TEST_CASE("a decimation that is cancelled leaves the places alone and the mesh sound") {
  Placed with(sphere(5));
  const std::vector<Point3> places = with.places;
  int calls = 0;
  CHECK_THROWS_AS(rbpa::decimate(with.mesh, with.places, {.go_on = [&] { return ++calls < 10; }}), rbpa::Cancelled);
  CHECK(with.places == places);
  CHECK(meshops::validate(with.mesh).empty());
  CHECK(meshops::report(with.mesh).faces < 8192);
  CHECK(meshops::report(with.mesh).betti == meshops::BettiNumbers{1, 0, 1});
}

TEST_CASE("where few triangles are left, the last collapses are repeated: nearer, in any order, of the same topology") {
  struct Case {
    const char* name;
    Triangles triangles;
    std::size_t faces;
  };
  Triangles apart = sphere(5);
  append(apart, sphere(4), 4);
  const std::vector<Case> cases = {{"sphere", sphere(6), 300},
                                   {"two spheres", apart, 100},
                                   {"torus", torus(60, 40), 90},
                                   {"sheet", sheet(40, 3), 20},
                                   {"spot", read_off(bundled_data() / "m3_spot.off"), 40}};
  std::mt19937 random(5);
  double product = 1, count = 0;
  for (const Case& each : cases)
    for (const rbpa::QuadricOptions& quadrics :
         {rbpa::QuadricOptions{}, {.at_ends = true}, {.no_crossings = true}, {.single_precision = true}}) {
      const Triangles& t = each.triangles;
      const std::size_t faces = each.faces;
      INFO(std::string(each.name), ", at ends: ", quadrics.at_ends, ", no crossings: ", quadrics.no_crossings);
      Placed with(t), once(t), other(shuffled(t, random));
      const auto before = meshops::report(with.mesh);
      const rbpa::Decimation counts = rbpa::decimate(with.mesh, with.places, {.faces = faces}, quadrics);
      CHECK((counts.left <= faces && counts.left + 2 > faces && !counts.is_exhausted));
      CHECK(counts.left == meshops::report(with.mesh).faces);
      CHECK(2 * counts.collapses >= counts.given - counts.left);
      CHECK(counts.collapses < counts.given - counts.left);
      CHECK(meshops::validate(with.mesh).empty());
      CHECK(meshops::report(with.mesh).betti == before.betti);
      CHECK(meshops::report(with.mesh).boundary_curves == before.boundary_curves);
      rbpa::decimate(other.mesh, other.places, {.faces = faces}, quadrics);
      CHECK(sorted_triangles(other.places, rbpa::space::corners_of(other.mesh)) ==
            sorted_triangles(with.places, rbpa::space::corners_of(with.mesh)));
      std::vector<rbpa::RecordedCollapse> record;  // with a record, no collapse is repeated
      rbpa::decimate(once.mesh, once.places, {.faces = faces}, quadrics, &record);
      CHECK(record.size() == counts.collapses);
      const auto apart_from_given = [&](const Placed& made) {
        const auto given = rbpa::space::SurfaceDistance(t.points, t.corners);
        const auto corners = rbpa::space::corners_of(made.mesh);
        const rbpa::space::SurfaceDistance left(made.places, corners);
        double most = 0;
        for (const auto& [a, b, c] : corners)
          most = std::max(most, given.least({made.places[a], made.places[b], made.places[c]}));
        for (const auto& [a, b, c] : t.corners)
          most = std::max(most, left.least({t.points[a], t.points[b], t.points[c]}));
        return most;
      };
      const double repeated = apart_from_given(with), single = apart_from_given(once);
      CHECK(repeated <= 1.2 * single);  // distances are from the mesh before the repeated collapses
      product *= repeated / single;
      ++count;
    }
  CHECK(std::pow(product, 1 / count) < 0.8);
}

TEST_CASE("collapses are repeated on meshes whose vertices have several fans") {
  // Two sheets with a common vertex, as OpenMesh's readers leave it.
  Triangles t = sheet(24, 1);
  Triangles more = sheet(24, 2);
  for (Point3& p : more.points) p = {-p.x, -p.y, p.x + p.y};
  for (auto& corners : more.corners) std::reverse(corners.begin(), corners.end());
  append(t, more);
  const auto origin = static_cast<std::uint32_t>(more.points.size());
  for (auto& corners : t.corners) std::replace(corners.begin(), corners.end(), origin, 0U);
  OpenMesh::PolyConnectivity mesh;
  mesh.resize(t.points.size(), 0, 0);
  for (const auto& [a, b, c] : t.corners)
    REQUIRE(mesh.add_face(meshops::Vertex(int(a)), meshops::Vertex(int(b)), meshops::Vertex(int(c))).is_valid());
  meshops::request_status(mesh);
  const auto before = meshops::report(mesh);
  REQUIRE(before.pinches == 1);
  const rbpa::Decimation counts = rbpa::decimate(mesh, t.points, {.faces = 24});
  CHECK(counts.left <= 24);
  CHECK(meshops::report(mesh).betti == before.betti);
  CHECK(meshops::report(mesh).pinches == 1);
}

TEST_CASE("a decimation that repeats collapses and is cancelled at any time leaves the places alone and a sound mesh") {
  int all = 0;
  Placed whole(sphere(5));
  rbpa::decimate(whole.mesh, whole.places, {.faces = 60, .go_on = [&] { return ++all > 0; }});
  REQUIRE(all > 20);
  for (int limit = 1; limit <= all; limit += 7) {
    Placed with(sphere(5));
    const std::vector<Point3> places = with.places;
    int calls = 0;
    CHECK_THROWS_AS(rbpa::decimate(with.mesh, with.places, {.faces = 60, .go_on = [&] { return ++calls < limit; }}),
                    rbpa::Cancelled);
    CHECK(with.places == places);
    CHECK(meshops::validate(with.mesh).empty());
    CHECK(meshops::report(with.mesh).betti == meshops::BettiNumbers{1, 0, 1});
  }
}

TEST_CASE("a decimated surface is a surface of the same points, in canonical order, with the same topology") {
  std::mt19937 random(7);
  std::vector<Triangles> all = {touching(), sheet(9, 2), sphere(3)};
  for (const char* name : {"m3_spot.off", "m3_torus.off", "m3_plate_holes.off", "m3_cube_no_bottom.off"})
    all.push_back(read_off(bundled_data() / name));
  for (const Triangles& t : all) {
    Surface surface = rbpa::surface_of(t.points, t.corners);
    const auto before = topology_of(t.points, surface);
    for (const std::size_t part : {1U, 3U, 10U, 1000000U}) {
      const auto left = rbpa::decimate(t.points, surface, {.faces = t.corners.size() / part});
      check_canonical(left);
      CHECK(left.counts.left == left.triangles.size());
      CHECK(left.duplicates == surface.duplicates);
      CHECK(left.given.size() == left.triangles.size());
      CHECK(std::set(left.given.begin(), left.given.end()).size() == left.given.size());
      const auto after = topology_of(t.points, left);
      CHECK(after.betti == before.betti);
      CHECK(after.genus == before.genus);
      CHECK(after.boundary_curves == before.boundary_curves);
      CHECK(after.solid_components == before.solid_components);
      if (part == 1) {
        CHECK(left.triangles == surface.triangles);
        CHECK(left.neighbors == surface.neighbors);
      }
    }
    surface.levels.resize(surface.triangles.size());
    for (std::uint32_t i = 0; i < surface.levels.size(); ++i) surface.levels[i] = i;
    const auto left = rbpa::decimate(t.points, surface, {.faces = t.corners.size() / 3});
    CHECK(left.levels == left.given);
    // A shuffled surface gives the same triangles.
    const Triangles other = shuffled(t, random);
    const auto again =
        rbpa::decimate(other.points, rbpa::surface_of(other.points, other.corners), {.faces = t.corners.size() / 3});
    CHECK(sorted_triangles(other.points, again.triangles) == sorted_triangles(t.points, left.triangles));
  }
}

TEST_CASE("a reconstruction is decimated after everything else, and stays watertight") {
  const Triangles t = sphere(4);
  std::vector<Point3> points;
  for (const Point3& p : t.points)
    if (p.z < 0.8) points.push_back(p);
  const auto whole = rbpa::reconstruct(points, {.normals = points, .watertight = true, .refine = true});
  REQUIRE(whole.is_watertight());
  const auto made = rbpa::reconstruct(
      points,
      {.normals = points, .watertight = true, .refine = true, .decimation = rbpa::DecimationOptions{.faces = 200}});
  CHECK(made.is_watertight());
  CHECK(made.inside == std::vector<std::size_t>{0});
  CHECK(made.points == whole.points);
  REQUIRE(made.decimated);
  CHECK(made.decimated->given == whole.surface.triangles.size());
  CHECK(made.surface.triangles ==
        rbpa::decimate(whole.points, whole.surface, {.faces = 200, .no_crossings = true}).triangles);
  CHECK((made.surface.triangles.size() <= 200 && made.filled.size() == made.surface.triangles.size()));
  REQUIRE(made.components.all.size() == 1);
  CHECK(made.components.all[0].triangles == made.surface.triangles.size());
  CHECK(made.components.all[0].volume == doctest::Approx(whole.components.all[0].volume).epsilon(0.1));
  CHECK(std::find(made.filled.begin(), made.filled.end(), true) != made.filled.end());
  CHECK_FALSE(whole.decimated);
}

TEST_SUITE_END();
