#include "rbpa/space/solid/solid_boundary.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "space/solid/solid_model.h"
#include "support/arguments.h"
#include "support/for_space_sets.h"
#include "support/infinity.h"
#include "support/order.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::solid;
using rbpa::SolidBoundary;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

bool has(const Tetrahedron& t, std::uint32_t i) { return std::find(t.begin(), t.end(), i) != t.end(); }

/// Returns the directed side of a triangle across from its corner k.
std::array<std::uint32_t, 2> side(const Surface& s, std::uint32_t t, std::size_t k) {
  return {s.triangles[t][(k + 1) % 3], s.triangles[t][(k + 2) % 3]};
}

/// Returns the tetrahedra at an edge that are reached from one of them through faces at the edge.
std::set<std::uint32_t> wedge(const Solid& s, std::uint32_t from, std::uint32_t p, std::uint32_t q) {
  std::set<std::uint32_t> all = {from};
  std::vector<std::uint32_t> waiting = {from};
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t next = s.neighbors[t][k], across = s.simplices[t][k];
      if (next != Solid::none && across != p && across != q && all.insert(next).second) waiting.push_back(next);
    }
  }
  return all;
}

/// Checks that triangles are the faces of one tetrahedron, outward, in order; that neighbors bound the same wedge; and
/// that the mesh is sound.
void check_boundary(const Points3& points, const Solid& s, const SolidBoundary& b) {
  const auto faces = tetrahedra_of_faces(s);
  const auto& triangles = b.surface.triangles;
  REQUIRE(b.tetrahedra.size() == triangles.size());
  REQUIRE(b.surface.neighbors.size() == triangles.size());
  CHECK(std::is_sorted(triangles.begin(), triangles.end()));
  std::set<Face> found;
  std::size_t wrong = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Face& corners = triangles[t];
    wrong += *std::min_element(corners.begin(), corners.end()) != corners[0];
    wrong += !found.insert(sorted(corners)).second;
    REQUIRE(faces.count(sorted(corners)) == 1);
    REQUIRE(faces.at(sorted(corners)) == std::vector<std::uint32_t>{b.tetrahedra[t]});
    for (const std::uint32_t i : s.simplices[b.tetrahedra[t]])
      if (std::find(corners.begin(), corners.end(), i) == corners.end())
        wrong +=
            rbpa::space::exact::orientation(points[corners[0]], points[corners[1]], points[corners[2]], points[i]) >= 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = b.surface.neighbors[t][k];
      REQUIRE(other < triangles.size());
      const auto [p, q] = side(b.surface, t, k);
      bool back = false;
      for (std::size_t j = 0; j < 3; ++j)
        back = back || (side(b.surface, other, j) == std::array{q, p} && b.surface.neighbors[other][j] == t);
      wrong += !back || other == t;
      wrong += wedge(s, b.tetrahedra[t], p, q).count(b.tetrahedra[other]) == 0;
      wrong += !has(s.simplices[b.tetrahedra[other]], p) || !has(s.simplices[b.tetrahedra[other]], q);
    }
  }
  CHECK(wrong == 0);
  std::size_t open = 0;
  for (const auto& [face, of] : faces) open += of.size() == 1;
  CHECK(found.size() == open);
  const rbpa::SurfaceMesh mesh = rbpa::surface_mesh(points, b.surface);
  CHECK(meshops::validate(mesh.mesh).empty());
  CHECK(mesh.mesh.n_faces() == triangles.size());
  const rbpa::SplitFans fans = rbpa::split_fans(b.surface);
  CHECK(fans.point == mesh.input_index);
}

/// Checks that sides are glued to those that bound the same wedge of left-out tetrahedra, or of the outside of the
/// hull. Returns how many walks passed the hull.
std::size_t check_glued_outside(const Solid& delaunay, const Solid& part, const SolidBoundary& b,
                                const Surface& outside) {
  std::map<Tetrahedron, std::uint32_t> number;
  for (std::uint32_t t = 0; t < delaunay.simplices.size(); ++t) number[delaunay.simplices[t]] = t;
  std::map<Face, std::uint32_t> boundary;
  for (std::uint32_t t = 0; t < b.surface.triangles.size(); ++t) boundary[sorted(b.surface.triangles[t])] = t;
  std::vector<bool> is_solid(delaunay.simplices.size(), false);
  for (const Tetrahedron& t : part.simplices) is_solid[number.at(t)] = true;
  std::size_t wrong = 0, hull = 0;
  for (std::uint32_t t = 0; t < b.surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [p, q] = side(b.surface, t, k);
      // Walks around the edge, away from the tetrahedron behind, until a tetrahedron is solid again.
      std::uint32_t at = number.at(part.simplices[b.tetrahedra[t]]), last = b.surface.triangles[t][k];
      bool wrapped = false;
      for (;;) {
        // Leaves through the face p, q, last.
        std::size_t j = 0;
        while (delaunay.simplices[at][j] == p || delaunay.simplices[at][j] == q || delaunay.simplices[at][j] == last)
          ++j;
        const std::uint32_t next = delaunay.neighbors[at][j];
        if (next == Solid::none) {
          // At the hull: finds the face at the edge at which the walk would come in from outside, by walking back.
          if (wrapped) break;
          wrapped = true;
          ++hull;
          at = number.at(part.simplices[b.tetrahedra[t]]);
          last = b.surface.triangles[t][k];
          for (;;) {
            std::uint32_t corner = 0;
            for (const std::uint32_t i : delaunay.simplices[at])
              if (i != p && i != q && i != last) corner = i;
            std::size_t m = 0;
            while (delaunay.simplices[at][m] != last) ++m;
            const std::uint32_t before = delaunay.neighbors[at][m];
            last = corner;
            if (before == Solid::none) break;
            at = before;
          }
          // `at` is the tetrahedron at the hull, behind the face p, q, last.
          if (is_solid[at]) break;
          for (const std::uint32_t i : delaunay.simplices[at])
            if (i != p && i != q && i != last) {
              last = i;
              break;
            }
          continue;
        }
        if (is_solid[next]) break;
        for (const std::uint32_t i : delaunay.simplices[next])
          if (i != p && i != q && i != last) {
            last = i;
            break;
          }
        at = next;
      }
      const auto expected = boundary.find(sorted({p, q, last}));
      REQUIRE(expected != boundary.end());
      wrong += outside.neighbors[t][k] != expected->second;
    }
  CHECK(wrong == 0);
  return hull;
}

}  // namespace

TEST_CASE(
    "the boundary of a solid has the open faces, outward, glued through wedges, and the volume of the tetrahedra") {
  Random random(401);
  std::size_t with_several_wedges = 0, with_several_fans = 0, passed_hull = 0;
  for_space_sets(trials(24), 4, 29, random, [&](const Points3& points, SpaceKind kind, int trial) {
    const Solid all = solid(points, infinity);
    const Solid s = trial % 2 == 0 ? solid(points, space_radius(points, random))
                                   : random_part(all, points.size(), 0.2 + 0.1 * double(random.below(8)), random);
    const SolidBoundary b = rbpa::solid_boundary(s);
    check_boundary(points, s, b);
    const rbpa::BoundaryMeasures of = rbpa::measure(points, b.surface);
    if (kind != SpaceKind::extreme) CHECK(is_near(of.volume, volume(points, s)));
    const Surface outside = rbpa::glued_outside(points, b.surface);
    rbpa::require_linked({outside.triangles, outside.neighbors}, points.size());
    passed_hull += check_glued_outside(all, s, b, outside);
    with_several_wedges += outside.neighbors != b.surface.neighbors;
    std::set<std::uint32_t> used;
    for (const auto& t : b.surface.triangles) used.insert(t.begin(), t.end());
    with_several_fans += rbpa::split_fans(b.surface).point.size() > used.size();
  });
  CHECK(with_several_wedges > static_cast<std::size_t>(trials(40)));
  CHECK(passed_hull > 0);
  CHECK(with_several_fans > static_cast<std::size_t>(trials(60)));
}

TEST_CASE("volume and area of boxes are exact at any place and however flat, and 0 without tetrahedra") {
  for (const double at : {0.0, 1e6, 0x1p40})
    for (const double height : {1.0, 0x1p-12}) {
      Points3 points;
      for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 3; ++y)
          for (int z = 0; z < 2; ++z) points.push_back({at + x, at + y, at + height * z});
      const rbpa::BoundaryMeasures of = rbpa::measure(points, rbpa::solid_boundary(solid(points, infinity)).surface);
      CHECK(of.volume == 6 * height);
      CHECK(of.area == 2 * (6 + 2 * height + 3 * height));
    }
  const SolidBoundary none = rbpa::solid_boundary(solid({}, 1));
  CHECK(none.surface.triangles.empty());
  CHECK(rbpa::measure({}, none.surface).volume == 0);
  CHECK(rbpa::glued_outside({}, none.surface).triangles.empty());
}

TEST_CASE(
    "volumes of thin and scaled sets are within 2^-52 where coordinates are of very different sizes, axis by axis") {
  Random random(402);
  for (const std::array<double, 3>& scale :
       {std::array{0x1p900, 0x1p-900, 1.0}, {0x1p-500, 0x1p-600, 0x1p300}, {0x1p1000, 0x1p-1000, 0x1p-1000}}) {
    Points3 points = space_set(SpaceKind::cube, 30, random);
    const SolidBoundary b = rbpa::solid_boundary(solid(points, 0.5));
    Rational expected = volume(points, solid(points, 0.5));
    for (Point3& p : points) p = {scale[0] * p.x, scale[1] * p.y, scale[2] * p.z};
    for (const double s : scale) expected *= rational(s);
    const double measured = rbpa::measure(points, b.surface).volume;
    if (expected < rational(0x1p-1020)) continue;
    CHECK(is_near(measured, expected));
  }
}

TEST_CASE("shuffled points have the same boundary, volume and area, to the last bit") {
  Random random(403);
  for (const auto& [kind, alpha] : {std::pair(SpaceKind::cube, 0.3),
                                    {SpaceKind::grid, 0.9},
                                    {SpaceKind::near_sphere, infinity},
                                    {SpaceKind::noisy_sphere, 0.9},
                                    {SpaceKind::clusters, infinity}}) {
    const auto set = name(kind);
    CAPTURE(set);
    Points3 points = space_set(kind, 200, random);
    sort_distinct(points);
    const SolidBoundary expected = rbpa::solid_boundary(solid(points, alpha));
    const std::vector<std::uint32_t> order = random_order(points.size(), random);
    const Points3 shuffled = in_order(points, order);
    const SolidBoundary b = rbpa::solid_boundary(solid(shuffled, alpha));
    REQUIRE(b.tetrahedra.size() == expected.tetrahedra.size());
    std::map<Face, std::set<Face>> neighbors, renamed;  // around each triangle
    const auto list = [](const Surface& s, std::map<Face, std::set<Face>>& into, const auto& name_of) {
      for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        const auto named = [&](Face f) { return sorted({name_of(f[0]), name_of(f[1]), name_of(f[2])}); };
        for (const std::uint32_t other : s.neighbors[t]) into[named(s.triangles[t])].insert(named(s.triangles[other]));
      }
    };
    for (const bool outside : {false, true}) {
      neighbors.clear();
      renamed.clear();
      list(outside ? rbpa::glued_outside(points, expected.surface) : expected.surface, neighbors,
           [](std::uint32_t i) { return i; });
      list(outside ? rbpa::glued_outside(shuffled, b.surface) : b.surface, renamed,
           [&](std::uint32_t i) { return order[i]; });
      CHECK(neighbors == renamed);
    }
    const auto of = rbpa::measure(shuffled, b.surface), before = rbpa::measure(points, expected.surface);
    CHECK(of.volume == before.volume);
    CHECK(of.area == before.area);
    CHECK(of.area > 0);
  }
}

TEST_CASE("a solid of the usual size is measured equally if a far point is added") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const double far : {0x1p300, 0x1p900, 0x1p1020})
    for (const double size : {1.0, 0x1p-300}) {
      Points3 all;
      for (const Point3& p : points) all.push_back({size * p.x, size * p.y, size * p.z});
      all.push_back({far, -far, far});
      const SolidBoundary b = rbpa::solid_boundary(solid(all, size));
      REQUIRE(b.tetrahedra.size() == 4);
      const rbpa::BoundaryMeasures of = rbpa::measure(all, b.surface), alone = rbpa::measure(points, b.surface);
      CHECK(of.volume == size * size * size / 6);
      CHECK(of.area == size * size * alone.area);
    }
}

TEST_CASE("triangles that begin at any corner are glued outside like those in canonical order") {
  Random random(405);
  const Points3 points = space_set(SpaceKind::cube, 40, random);
  const SolidBoundary b = rbpa::solid_boundary(random_part(solid(points, infinity), points.size(), 0.5, random));
  const Surface expected = rbpa::glued_outside(points, b.surface);
  Surface turned = b.surface;
  std::vector<std::size_t> turns;
  for (std::size_t t = 0; t < turned.triangles.size(); ++t) {
    turns.push_back(random.below(3));
    for (auto* row : {&turned.triangles[t], &turned.neighbors[t]})
      std::rotate(row->begin(), row->begin() + static_cast<std::ptrdiff_t>(turns[t]), row->end());
  }
  const Surface outside = rbpa::glued_outside(points, turned);
  for (std::size_t t = 0; t < turned.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) CHECK(outside.neighbors[t][k] == expected.neighbors[t][(k + turns[t]) % 3]);
  CHECK(expected.neighbors != b.surface.neighbors);
}

TEST_CASE("arrays that are not a solid are refused") {
  Random random(404);
  const Points3 points = space_set(SpaceKind::cube, 40, random);
  const Solid right = solid(points, infinity);
  const SolidBoundary boundary = rbpa::solid_boundary(right);
  using meshops::ContractViolation;
  CHECK_THROWS_AS(rbpa::solid_boundary(solid(points, infinity, {.neighbors = false})), ContractViolation);
  CHECK_THROWS_AS(rbpa::measure(std::span(points).first(3), boundary.surface), ContractViolation);
  CHECK_THROWS_AS(rbpa::glued_outside(std::span(points).first(3), boundary.surface), ContractViolation);
  // Whatever the neighbors are, the walk ends, and its result is linked.
  std::size_t refused = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    Solid wrong = right;
    for (int change = 0; change < 1 + trial % 3; ++change) {
      auto& row = wrong.neighbors[random.below(wrong.neighbors.size())];
      if (trial % 3 == 1) std::swap(row[random.below(4)], row[random.below(4)]);
      row[random.below(4)] = trial % 2 == 0 ? static_cast<std::uint32_t>(random.below(right.simplices.size() + 2))
                                            : right.neighbors[random.below(right.neighbors.size())][random.below(4)];
    }
    try {
      const SolidBoundary b = rbpa::solid_boundary(wrong);
      rbpa::require_linked({b.surface.triangles, b.surface.neighbors}, points.size());
    } catch (const ContractViolation&) {
      ++refused;
    }
  }
  CHECK(refused > static_cast<std::size_t>(trials(100)));
  Solid mirrored = right;
  for (Tetrahedron& t : mirrored.simplices) std::swap(t[0], t[1]);
  for (auto& row : mirrored.neighbors) std::swap(row[0], row[1]);
  CHECK(rbpa::measure(points, rbpa::solid_boundary(mirrored).surface).volume < 0);
  Solid one = right;
  std::swap(one.simplices[boundary.tetrahedra[0]][0], one.simplices[boundary.tetrahedra[0]][1]);
  CHECK_THROWS_AS(rbpa::solid_boundary(one), ContractViolation);
  Solid far;  // corners are not checked; a great one costs no memory
  far.simplices = {{0, 1, 2, 0xfffffff0}};
  far.neighbors = {{Solid::none, Solid::none, Solid::none, Solid::none}};
  CHECK(rbpa::solid_boundary(far).surface.triangles.size() == 4);
}

TEST_SUITE_END();
