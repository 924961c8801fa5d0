// Subdivision: counts, topology, convergence, boundary curves, and independence of numbers.
#include "rbpa/space/simplify/subdivide.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
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
#include "meshops/topology/report.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "space/simplify/placed.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using meshops::Vertex;
using rbpa::SubdivisionOptions;
using rbpa::SubdivisionRule;

TEST_SUITE_BEGIN("space");

namespace {

struct SubdividedMesh : Placed {
  explicit SubdividedMesh(const Triangles& t) : Placed(t, false) {}
  void subdivide(SubdivisionRule rule, unsigned times) {
    rbpa::subdivide(mesh, places, {.rule = rule, .times = times});
    CHECK(places.size() == mesh.n_vertices());
  }
  std::vector<std::array<Point3, 3>> surface() const { return sorted_triangles(places, rbpa::space::corners_of(mesh)); }
  std::set<Point3> boundary() const {
    std::set<Point3> all;
    for (const Vertex v : mesh.vertices())
      if (mesh.is_boundary(v)) all.insert(places[static_cast<std::size_t>(v.idx())]);
    return all;
  }
};

}  // namespace

TEST_CASE("subdivision multiplies triangles, keeps the topology, and does not depend on numbers") {
  std::mt19937 random(21);
  struct Row {
    const char* name;
    Triangles given;
  };
  for (const Row& row :
       {Row{"octahedron", sphere(0)},
        {"tetrahedron", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}},
        {"a triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}},
        {"sheet", sheet(4, 3)},
        {"torus", read_off(bundled_data() / "m3_torus.off")},
        {"cube without bottom", read_off(bundled_data() / "m3_cube_no_bottom.off")}})
    for (const auto& [rule, factor] : {std::pair(SubdivisionRule::loop, 4U), {SubdivisionRule::sqrt3, 3U}}) {
      const std::string title = std::string(row.name) + " " + std::to_string(factor);
      CAPTURE(title);
      SubdividedMesh one(row.given), other(shuffled(row.given, random)), twice(row.given);
      const auto before = meshops::report(one.mesh);
      const std::size_t faces = one.mesh.n_faces();
      one.subdivide(rule, 2);
      CHECK(one.mesh.n_faces() == faces * factor * factor);
      CHECK(meshops::validate(one.mesh).empty());
      const auto now = meshops::report(one.mesh);
      CHECK(now.betti == before.betti);
      CHECK(now.genus == before.genus);
      CHECK(now.boundary_curves == before.boundary_curves);
      other.subdivide(rule, 2);
      CHECK(one.surface() == other.surface());
      for (int time = 0; time < 2; ++time) twice.subdivide(rule, 1);
      CHECK(twice.places == one.places);
    }
}

TEST_CASE("boundary curves depend on themselves alone, and stay in place by the other rule") {
  Triangles flat = sheet(6, 2), bent = flat;
  for (Point3& p : bent.points)
    if (p.x > 0 && p.y > 0 && p.x < 6 && p.y < 6) p.z += 3;
  SubdividedMesh one(flat), other(bent), fixed(bent);
  const auto given = fixed.boundary();
  one.subdivide(SubdivisionRule::loop, 3);
  other.subdivide(SubdivisionRule::loop, 3);
  CHECK(one.boundary() == other.boundary());
  CHECK(one.boundary().size() == 8 * given.size());
  for (const Point3& p : one.boundary()) CHECK(std::min({p.x, p.y, 6 - p.x, 6 - p.y}) < 0.3);
  fixed.subdivide(SubdivisionRule::sqrt3, 3);
  CHECK(fixed.boundary() == given);
}

TEST_CASE("a subdivided octahedron converges to a surface near a sphere, of edges that shrink") {
  for (const SubdivisionRule rule : {SubdivisionRule::loop, SubdivisionRule::sqrt3}) {
    double last_area = 0, last_change = 10;
    for (unsigned times = 1; times <= 6; ++times) {
      SubdividedMesh ball(sphere(1));
      ball.subdivide(rule, times);
      double area = 0, least = 1, greatest = 0;
      for (const auto& [a, b, c] : ball.surface()) {
        const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
        area += std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
      }
      for (const Point3& p : ball.places) {
        least = std::min(least, std::hypot(p.x, p.y, p.z));
        greatest = std::max(greatest, std::hypot(p.x, p.y, p.z));
      }
      CHECK(greatest / least < 1.1);
      if (times > 1) {
        const double change = std::abs(area - last_area);
        CHECK(change < 0.6 * last_change);
        last_change = change;
      }
      last_area = area;
    }
    CHECK(last_change < 0.01);
  }
}

TEST_CASE("a mesh with points gets new points; meshes and options that do not suit are refused, nothing changed") {
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  const Triangles t = sphere(0);
  for (const Point3& p : t.points)
    mesh.add_vertex({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  for (const auto& [a, b, c] : t.corners)
    mesh.add_face(Vertex(static_cast<int>(a)), Vertex(static_cast<int>(b)), Vertex(static_cast<int>(c)));
  rbpa::subdivide(mesh, {.times = 1});
  CHECK(mesh.n_faces() == 32);
  CHECK(mesh.point(Vertex(6)).norm() == doctest::Approx(std::sqrt(0.375 * 0.375 * 2)));
  CHECK_THROWS_AS(rbpa::subdivide(mesh, {.times = 7, .go_on = [] { return false; }}), rbpa::Cancelled);
  CHECK(mesh.n_faces() > 32);
  for (const Vertex v : mesh.vertices()) CHECK(mesh.point(v).norm() > 0.3);

  SubdividedMesh with(t);
  const auto places = with.places;
  CHECK_THROWS_WITH_AS(rbpa::subdivide(with.mesh, with.places, {.times = 30}),
                       "subdivide: found 30 times, expected at most 10, as the limit is 20000000 triangles",
                       rbpa::InvalidInput);
  SubdividedMesh large(sphere(5));
  CHECK_THROWS_AS(rbpa::subdivide(large.mesh, large.places, {.go_on = [] { return false; }}), rbpa::Cancelled);
  CHECK(large.mesh.n_faces() == 8192);
  with.places[2].x = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(rbpa::subdivide(with.mesh, with.places, {}), rbpa::InvalidInput);
  with.places.pop_back();
  CHECK_THROWS_AS(rbpa::subdivide(with.mesh, with.places, {}), meshops::ContractViolation);
  with.places = places;
  CHECK(with.mesh.n_faces() == 8);
  SubdividedMesh square({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {}});
  square.mesh.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
  CHECK_THROWS_AS(rbpa::subdivide(square.mesh, square.places, {}), meshops::ContractViolation);
  SubdividedMesh none(Triangles{{{1, 2, 3}}, {}});
  none.subdivide(SubdivisionRule::loop, 9);
  CHECK(none.places == std::vector<Point3>{{1, 2, 3}});
}

TEST_SUITE_END();
