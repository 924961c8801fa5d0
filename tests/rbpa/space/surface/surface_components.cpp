#include "rbpa/space/surface/surface_components.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "support/for_space_sets.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Surface;
using rbpa::SurfaceComponent;
using rbpa::SurfaceComponents;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the triangles reached from each triangle, step by step.
std::vector<std::set<std::size_t>> pieces_of(const Surface& surface) {
  std::vector<std::set<std::size_t>> pieces;
  std::vector<bool> seen(surface.triangles.size(), false);
  for (std::size_t t = 0; t < seen.size(); ++t) {
    if (seen[t]) continue;
    std::vector<std::size_t> waiting = {t};
    pieces.emplace_back();
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      if (seen[at]) continue;
      seen[at] = true;
      pieces.back().insert(at);
      for (const std::uint32_t other : surface.neighbors[at])
        if (other != Surface::none) waiting.push_back(other);
    }
  }
  return pieces;
}

/// Returns area and volume, term by term in long double.
std::array<long double, 2> measures(const Points3& points, const Surface& surface, const std::set<std::size_t>& piece) {
  long double area = 0, volume = 0;
  for (const std::size_t t : piece) {
    const auto [a, b, c] = surface.triangles[t];
    const auto from = [](const Point3& p, const Point3& q) {
      return std::array<long double, 3>{(long double)q.x - p.x, (long double)q.y - p.y, (long double)q.z - p.z};
    };
    const auto u = from(points[a], points[b]), v = from(points[a], points[c]);
    const std::array n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    area += std::hypot(n[0], n[1], n[2]) / 2;
    const auto p = from(points[surface.triangles[*piece.begin()][0]], points[a]);
    volume += (p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) / 6;
  }
  return {area, volume};
}

bool equal(const SurfaceComponent& c, const SurfaceComponent& d) {
  return c.triangles == d.triangles && c.boundary_sides == d.boundary_sides && c.boundary_curves == d.boundary_curves &&
         c.area == d.area && c.volume == d.volume && c.low == d.low && c.high == d.high;
}

}  // namespace

TEST_CASE("components are the connected triangles, with measures that are the same to the last bit in any order") {
  Random random(301);
  std::size_t several = 0, open = 0, with_handles = 0;
  for_space_sets(20, 4, 39, random, [&](const Points3& points, SpaceKind kind, int) {
    Points3 normals = random_normals(points.size(), random);
    const double radius = space_radius(points, random);
    for (const bool shells : {true, false}) {
      const Surface surface = shells ? rbpa::exposed_triangles(points, radius) : rbpa::surface(points, normals, radius);
      const SurfaceComponents components = rbpa::surface_components(points, surface);
      const auto pieces = pieces_of(surface);
      REQUIRE(components.all.size() == pieces.size());
      REQUIRE(components.number.size() == surface.triangles.size());
      several += pieces.size() > 1;
      std::set<std::uint32_t> numbers;
      for (const auto& piece : pieces) {
        const std::uint32_t number = components.number[*piece.begin()];
        REQUIRE(numbers.insert(number).second);
        const SurfaceComponent& component = components.all.at(number);
        CHECK(component.triangles == piece.size());
        std::size_t sides = 0;
        std::array<std::array<double, 2>, 3> box;
        box.fill({INFINITY, -INFINITY});
        for (const std::size_t t : piece) {
          CHECK(components.number[t] == number);
          for (std::size_t j = 0; j < 3; ++j) {
            sides += surface.neighbors[t][j] == Surface::none;
            const Point3& p = points[surface.triangles[t][j]];
            const std::array coordinates = {p.x, p.y, p.z};
            for (std::size_t axis = 0; axis < 3; ++axis)
              box[axis] = {std::min(box[axis][0], coordinates[axis]), std::max(box[axis][1], coordinates[axis])};
          }
        }
        CHECK(component.boundary_sides == sides);
        CHECK(component.is_closed() == (sides == 0));
        open += sides > 0;
        CHECK(component.low == Point3{box[0][0], box[1][0], box[2][0]});
        CHECK(component.high == Point3{box[0][1], box[1][1], box[2][1]});
        const auto [area, volume] = measures(points, surface, piece);
        if (kind == SpaceKind::extreme) continue;  // these terms have no digits there
        CHECK(component.area == doctest::Approx(double(area)));
        if (sides > 0)
          CHECK(component.volume == 0);
        else
          CHECK(std::abs(component.volume - double(volume)) <= 1e-9 * std::pow(double(area), 1.5));
      }
      std::size_t curves = 0;
      for (const SurfaceComponent& component : components.all) {
        curves += component.boundary_curves;
        CHECK((component.boundary_curves == 0) == component.is_closed());
      }
      // The sum of 2 − 2 genus − curves is the Euler characteristic of the mesh.
      std::size_t handles = 0;
      for (const std::size_t genus : rbpa::genus_of(surface, components)) handles += genus;
      const rbpa::SurfaceMesh mesh = rbpa::surface_mesh(points, surface);
      CHECK(mesh.mesh.n_vertices() + mesh.mesh.n_faces() + 2 * handles + curves ==
            2 * components.all.size() + mesh.mesh.n_edges());
      with_handles += handles > 0;
      if (!shells) CHECK(curves == rbpa::holes(points, normals, radius, surface).size());
      for (std::size_t c = 1; c < components.all.size(); ++c)
        CHECK(components.all[c - 1].area >= components.all[c].area);

      // Shuffled points have the same components, in the same order.
      const std::vector<std::uint32_t> order = random_order(points.size(), random);
      const Points3 shuffled = in_order(points, order), turned = in_order(normals, order);
      const Surface again =
          shells ? rbpa::exposed_triangles(shuffled, radius) : rbpa::surface(shuffled, turned, radius);
      const SurfaceComponents others = rbpa::surface_components(shuffled, again);
      REQUIRE(others.all.size() == components.all.size());
      for (std::size_t c = 0; c < others.all.size(); ++c) CHECK(equal(others.all[c], components.all[c]));
    }
  });
  CHECK(several > 50);
  CHECK(open > 200);
  CHECK(with_handles > 0);
}

TEST_CASE("kept components are glued as before, and others are removed") {
  Random random(303);
  std::size_t dropped = 0;
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    const Points3 points = space_set(SpaceKind::noisy_sphere, 60, random);
    const Points3 normals = random_normals(points.size(), random);
    const double radius = space_radius(points, random);
    const std::vector<double> radii = {radius, 2 * radius};
    const Surface surface = rbpa::surface(points, normals, radius);
    const SurfaceComponents components = rbpa::surface_components(points, surface);
    std::vector<bool> kept(components.all.size());
    for (std::size_t c = 0; c < kept.size(); ++c) kept[c] = random.chance(0.5);
    const Surface part = rbpa::keep_components(surface, components, kept);
    CHECK(part.distinct == surface.distinct);
    std::vector<std::size_t> from;  // for each triangle of the part
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      if (kept[components.number[t]]) from.push_back(t);
    dropped += surface.triangles.size() - from.size();
    REQUIRE(part.triangles.size() == from.size());
    REQUIRE(part.neighbors.size() == from.size());
    for (std::size_t t = 0; t < from.size(); ++t) {
      CHECK(part.triangles[t] == surface.triangles[from[t]]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t now = part.neighbors[t][k], before = surface.neighbors[from[t]][k];
        CHECK((now == Surface::none ? Surface::none : from.at(now)) == before);
      }
    }
  }
  CHECK(dropped > 100);
}

TEST_CASE("some triangles stay glued among each other, and have boundary next to removed ones") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Surface surface = rbpa::exposed_triangles(points, 10);
  REQUIRE(surface.triangles.size() == 4);
  for (std::size_t dropped = 0; dropped < 4; ++dropped) {
    CAPTURE(dropped);
    std::vector<bool> kept(4, true);
    kept[dropped] = false;
    const Surface part = rbpa::keep_triangles(surface, kept);
    REQUIRE(part.triangles.size() == 3);
    CHECK(part.distinct == 4);
    for (std::size_t t = 0; t < 3; ++t) {
      const std::size_t before = t < dropped ? t : t + 1;
      CHECK(part.triangles[t] == surface.triangles[before]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t now = part.neighbors[t][k], then = surface.neighbors[before][k];
        if (then == dropped) {
          CHECK(now == Surface::none);
        } else {
          CHECK(now == then - (then > dropped));
        }
      }
    }
    CHECK(rbpa::surface_components(points, part).all[0].boundary_curves == 1);
  }
  CHECK_THROWS_AS(rbpa::keep_triangles(surface, {true}), meshops::ContractViolation);
}

TEST_CASE("an empty surface has no component, and wrong sizes are refused") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Surface none;
  const SurfaceComponents nothing = rbpa::surface_components(points, none);
  CHECK(nothing.all.empty());
  CHECK(rbpa::keep_components(none, nothing, {}).triangles.empty());
  const Surface surface = rbpa::exposed_triangles(points, 1);
  const SurfaceComponents components = rbpa::surface_components(points, surface);
  REQUIRE(components.all.size() == 1);
  CHECK(components.all[0].volume == 0);
  CHECK(components.all[0].area == 1);
  CHECK_THROWS_AS(rbpa::keep_components(surface, components, {}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::keep_components(surface, nothing, {}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::surface_components({}, surface), meshops::ContractViolation);
}

TEST_SUITE_END();
