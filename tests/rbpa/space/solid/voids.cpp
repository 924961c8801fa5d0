#include "rbpa/space/solid/voids.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/space/solid/solid_components.h"
#include "rbpa/space/solid/solid_topology.h"
#include "rbpa/space/surface/surface_components.h"
#include "space/solid/solid_model.h"
#include "support/arguments.h"
#include "support/for_space_sets.h"
#include "support/infinity.h"
#include "support/order.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::solid;
using rbpa::SolidBoundary;
using rbpa::SolidCounts;
using rbpa::SolidVoid;
using rbpa::Voids;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns the tetrahedra whose corners are all in a set of points.
Solid part_on(const Solid& delaunay, std::size_t points, const std::vector<bool>& in) {
  std::vector<bool> kept;
  for (const Tetrahedron& t : delaunay.simplices)
    kept.push_back(std::all_of(t.begin(), t.end(), [&](std::uint32_t i) { return in[i]; }));
  return part_of(delaunay, points, kept);
}

/// Chambers with walls of thickness 1, each with a cube of side 1 in its middle, on integer points of a multiple of 6,
/// and two more in each direction. Returns whether a point is in a wall or a cube.
bool is_in_chambers(const Point3& p) {
  const auto layer = [](double x) { return static_cast<int>(x) % 6; };
  const std::array at = {layer(p.x), layer(p.y), layer(p.z)};
  return std::any_of(at.begin(), at.end(), [](int x) { return x < 2; }) ||
         std::all_of(at.begin(), at.end(), [](int x) { return x == 3 || x == 4; });
}

void check_counts(const Solid& s, const SolidBoundary& b, const SolidCounts& counts) {
  const Betti betti = betti_by_ranks(s);
  CHECK(counts.points == betti.points);
  CHECK(counts.edges == betti.edges);
  CHECK(counts.triangles == betti.triangles);
  CHECK(counts.tetrahedra == s.simplices.size());
  CHECK(counts.boundary_triangles == b.tetrahedra.size());
  CHECK(counts.solid_components == pieces(s, 3).size());
  CHECK(counts.components == pieces(s, 1).size());
  CHECK(counts.components == betti.numbers[0]);
  CHECK(counts.tunnels == betti.numbers[1]);
  CHECK(counts.voids == betti.numbers[2]);
}

/// Checks the voids. Requires: a part of this Delaunay triangulation. `exact`: measures are compared too.
void check_voids(const Points3& points, const Solid& delaunay, const Solid& s, const SolidBoundary& b,
                 const Voids& voids, bool exact) {
  const std::vector<ModelVoid> expected = voids_by_triangulation(points, delaunay, s);
  REQUIRE(voids.all.size() == expected.size());
  CHECK(voids.counts.voids == expected.size());
  REQUIRE(voids.number.size() == b.tetrahedra.size());
  std::map<std::vector<Face>, const ModelVoid*> by_faces;
  for (const ModelVoid& v : expected) by_faces[v.faces] = &v;
  std::vector<std::uint32_t> number(voids.number.size(), Voids::none);
  for (std::uint32_t v = 0; v < voids.all.size(); ++v) {
    const SolidVoid& found = voids.all[v];
    std::vector<Face> faces;
    std::set<std::uint32_t> corners;
    for (const std::uint32_t t : found.triangles) {
      REQUIRE(number[t] == Voids::none);
      number[t] = v;
      faces.push_back(sorted(b.surface.triangles[t]));
      corners.insert(faces.back().begin(), faces.back().end());
    }
    CHECK(std::is_sorted(found.triangles.begin(), found.triangles.end()));
    CHECK(found.points == std::vector<std::uint32_t>(corners.begin(), corners.end()));
    std::sort(faces.begin(), faces.end());
    REQUIRE(by_faces.count(faces) == 1);
    if (exact) CHECK(is_near(found.volume, by_faces.at(faces)->six_volumes / 6));
    if (exact) CHECK(found.volume > 0);
    if (v > 0) CHECK(voids.all[v - 1].volume >= found.volume);
  }
  CHECK(number == voids.number);
}

}  // namespace

TEST_CASE("Betti numbers of any part of a triangulation are those of its matrices, and voids are left-out pieces") {
  Random random(411);
  std::size_t several_voids = 0, tunnels = 0, pinched = 0;
  for_space_sets(trials(60), 5, 29, random, [&](const Points3& points, SpaceKind kind, int trial) {
    const Solid all = solid(points, infinity);
    const Solid s = trial % 4 == 0 ? solid(points, space_radius(points, random))
                                   : random_part(all, points.size(), 0.2 + 0.1 * double(random.below(8)), random);
    const SolidBoundary b = rbpa::solid_boundary(s);
    const Voids voids = rbpa::voids(points, s, b);
    check_counts(s, b, voids.counts);
    CHECK(rbpa::count(points, s, b) == voids.counts);
    check_voids(points, all, s, b, voids, kind != SpaceKind::extreme);
    several_voids += voids.all.size() > 1;
    tunnels += voids.counts.tunnels > 0;
    pinched += voids.counts.components < voids.counts.solid_components;
  });
  CHECK(several_voids > static_cast<std::size_t>(trials(60)));
  CHECK(tunnels > static_cast<std::size_t>(trials(100)));
  CHECK(pinched > static_cast<std::size_t>(trials(100)));
}

TEST_CASE("voids of parts of grids, where most points are in a plane with most others, are right") {
  Random random(412);
  std::size_t voids_found = 0;
  const Points3 points = corners_of_bricks(5, 5, 5);
  const Solid all = solid(points, infinity);
  for (int trial = 0; trial < trials(60); ++trial) {
    CAPTURE(trial);
    const Solid s = random_part(all, points.size(), 0.15 + 0.1 * double(random.below(8)), random);
    const SolidBoundary b = rbpa::solid_boundary(s);
    const Voids voids = rbpa::voids(points, s, b);
    check_counts(s, b, voids.counts);
    check_voids(points, all, s, b, voids, true);
    voids_found += voids.all.size();
  }
  CHECK(voids_found > static_cast<std::size_t>(trials(300)));
}

TEST_CASE("tetrahedra around one point, in any pattern, are one piece without tunnels and voids") {
  Random random(413);
  std::size_t several_fans = 0;
  for (const SpaceKind kind : {SpaceKind::near_sphere, SpaceKind::cospherical})
    for (int trial = 0; trial < trials(120); ++trial) {
      CAPTURE(name(kind));
      CAPTURE(trial);
      Points3 points = space_set(kind, 20 + random.below(60), random);
      // A second one of the same shape, so that a part of one may be within the other.
      const Point3 center = kind == SpaceKind::near_sphere ? Point3{0, 0, 0} : points.front();
      points.push_back(center);
      const Solid all = solid(points, infinity);
      const auto at = static_cast<std::uint32_t>(std::find(points.begin(), points.end(), center) - points.begin());
      std::vector<bool> kept;
      const double probability = 0.2 + 0.1 * double(random.below(7));
      for (const Tetrahedron& t : all.simplices)
        kept.push_back(std::find(t.begin(), t.end(), at) != t.end() && random.chance(probability));
      const Solid s = part_of(all, points.size(), kept);
      if (s.simplices.empty()) continue;
      const SolidCounts counts = rbpa::count(points, s, rbpa::solid_boundary(s));
      CHECK(counts.components == 1);
      CHECK(counts.tunnels == 0);
      CHECK(counts.voids == 0);
      several_fans += counts.solid_components > 3;
    }
  CHECK(several_fans > static_cast<std::size_t>(trials(80)));
}

TEST_CASE("walled-in tetrahedra around one point bound the voids that the triangulation shows") {
  Random random(419);
  std::size_t voids_found = 0;
  for (int trial = 0; trial < trials(800); ++trial) {
    CAPTURE(trial);
    Points3 points = {{0, 0, 0}};
    for (const auto& [radius, count] : {std::pair(1.0, 40), {2.0, 60}}) {
      for (int i = 0; i < count;) {
        const Point3 p = {2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
        if (length(p) > 1 || length(p) < 0.1) continue;
        points.push_back(radius * p / length(p));
        ++i;
      }
    }
    const Solid all = solid(points, infinity);
    std::vector<bool> kept;
    const double probability = 0.2 + 0.1 * double(random.below(6));
    for (const Tetrahedron& t : all.simplices) kept.push_back(random.chance(t[0] == 0 ? probability : 0.9));
    const Solid s = part_of(all, points.size(), kept);
    const SolidBoundary b = rbpa::solid_boundary(s);
    const Voids voids = rbpa::voids(points, s, b);
    check_voids(points, all, s, b, voids, false);
    voids_found += voids.all.size();
  }
  CHECK(voids_found > static_cast<std::size_t>(trials(2000)));
}

TEST_CASE("chambers with a floating cube in each are voids with islands, also where walls are broken through") {
  Random random(414);
  std::size_t islands = 0, open = 0, several = 0;
  const Points3 points = corners_of_bricks(14, 8, 8);
  const Solid all = solid(points, infinity);
  for (int trial = 0; trial < trials(40); ++trial) {
    CAPTURE(trial);
    std::vector<bool> in;
    const double noise = trial == 0 ? 0 : std::array{0.003, 0.01, 0.03, 0.1}[random.below(4)];
    for (const Point3& p : points) in.push_back(is_in_chambers(p) != random.chance(noise));
    const Solid s = part_on(all, points.size(), in);
    const SolidBoundary b = rbpa::solid_boundary(s);
    const Voids voids = rbpa::voids(points, s, b);
    check_voids(points, all, s, b, voids, true);
    if (trial % 8 == 0) check_counts(s, b, voids.counts);
    for (const SolidVoid& v : voids.all) {
      islands += v.islands;
      several += v.islands > 1;
    }
    open += voids.all.size() < 2;
    if (trial != 0) continue;
    REQUIRE(voids.all.size() == 2);
    CHECK(voids.counts.components == 3);
    // Tetrahedra along the edges of a chamber have all their corners in its walls.
    for (const SolidVoid& v : voids.all) {
      CHECK(v.islands == 1);
      CHECK(v.volume < 125 - 1);
      CHECK(v.volume > 100);
    }
    CHECK(voids.all[0].low == Point3{1, 1, 1});
    CHECK(voids.all[0].high == Point3{6, 6, 6});
    CHECK(voids.all[1].low == Point3{7, 1, 1});
  }
  CHECK(islands > static_cast<std::size_t>(trials(16)));
  CHECK(several > 0);
  CHECK(open > 0);
}

TEST_CASE("a box in a box in a box lies in the inner void, not in the outer, in any order") {
  Random random(420);
  Points3 points = corners_of_bricks(11, 11, 11);
  for (int trial = 0; trial < 4; ++trial) {
    if (trial > 0) random.shuffle(points);
    // By the greatest distance from the middle, walls are between 5 and 4, 3 and 2, and 1 and 0.
    const auto distance = [&](std::uint32_t i) {
      const Point3& p = points[i];
      return std::max({std::abs(p.x - 5), std::abs(p.y - 5), std::abs(p.z - 5)});
    };
    const Solid all = solid(points, infinity);
    std::vector<bool> kept;
    for (const Tetrahedron& t : all.simplices) {
      const double most = std::max({distance(t[0]), distance(t[1]), distance(t[2]), distance(t[3])});
      kept.push_back(most != 4 && most != 2);
    }
    const Solid s = part_of(all, points.size(), kept);
    const SolidBoundary b = rbpa::solid_boundary(s);
    const Voids voids = rbpa::voids(points, s, b);
    REQUIRE(voids.all.size() == 2);
    CHECK(voids.counts.components == 3);
    CHECK(voids.counts.tunnels == 0);
    CHECK(voids.all[0].volume == 512 - 216);
    CHECK(voids.all[1].volume == 64 - 8);
    CHECK(voids.all[0].islands == 1);
    CHECK(voids.all[1].islands == 1);
    CHECK(voids.all[0].area == 6 * (64 + 36));
    check_voids(points, all, s, b, voids, true);
  }
}

TEST_CASE(
    "a plate with holes has as many tunnels, and its boundary that genus; closed on both sides the holes are voids") {
  const Points3 points = corners_of_bricks(8, 4, 4);
  const Solid all = solid(points, infinity);
  for (const bool closed : {false, true}) {
    std::vector<bool> kept;
    for (const Tetrahedron& t : all.simplices) {
      // The unit cube that contains the tetrahedron.
      Point3 low = points[t[0]];
      for (const std::uint32_t i : t)
        low = {std::min(low.x, points[i].x), std::min(low.y, points[i].y), std::min(low.z, points[i].z)};
      const bool in_hole = low.y == 1 && static_cast<int>(low.x) % 2 == 1;
      kept.push_back(closed ? !in_hole || low.z != 1 : !in_hole && low.z == 1);
    }
    const Solid s = part_of(all, points.size(), kept);
    const SolidBoundary b = rbpa::solid_boundary(s);
    const Voids voids = rbpa::voids(points, s, b);
    const auto pieces = rbpa::surface_components(points, b.surface);
    const auto genus = rbpa::genus_of(b.surface, pieces);
    const auto& surfaces = pieces.all;
    CHECK(voids.counts.components == 1);
    if (closed) {
      CHECK(voids.counts.tunnels == 0);
      REQUIRE(voids.all.size() == 3);
      for (const SolidVoid& v : voids.all) CHECK(v.volume == 1);
      CHECK(voids.all[0].low == Point3{1, 1, 1});  // the least of equal ones is first
      CHECK(voids.all[2].low == Point3{5, 1, 1});
      REQUIRE(surfaces.size() == 4);
      CHECK(surfaces[3].volume == -1);
      CHECK(genus[3] == 0);
    } else {
      CHECK(voids.counts.tunnels == 3);
      CHECK(voids.all.empty());
      REQUIRE(surfaces.size() == 1);
      CHECK(genus[0] == 3);
      CHECK(rbpa::measure(points, b.surface).volume == 21 - 3);
    }
  }
}

TEST_CASE("the void in a spherical shell lies between its inner ball, and that ball less what triangles cut off") {
  Random random(415);
  Points3 points;
  for (const double radius : {1.0, 1.1})
    for (int i = 0; i < 3000; ++i) {
      Point3 p{};
      do {
        p = {2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
      } while (length(p) > 1 || length(p) < 0.1);
      points.push_back(radius * p / length(p));
    }
  const double alpha = 0.2;
  const Solid s = solid(points, alpha);
  const SolidBoundary b = rbpa::solid_boundary(s);
  const Voids voids = rbpa::voids(points, s, b);
  REQUIRE(!voids.all.empty());
  const double ball = 4 * std::acos(-1.0) / 3;
  CHECK(voids.all[0].volume < ball);
  CHECK(voids.all[0].volume > ball * std::pow(1 - alpha * alpha, 1.5));
  CHECK(voids.counts.components == 1);
  // Without other voids, the solid is the inside of the outer surface less the void.
  double all_voids = 0, faced = 0;
  for (const SolidVoid& v : voids.all) all_voids += v.volume;
  std::vector<std::uint32_t> outer;
  for (std::uint32_t t = 0; t < voids.number.size(); ++t) faced += voids.number[t] == Voids::none;
  CHECK(faced > 3000);
  CHECK(rbpa::measure(points, b.surface).volume + all_voids < ball * 1.331);
  CHECK(rbpa::measure(points, b.surface).volume + all_voids > ball * std::pow(1.21 - alpha * alpha, 1.5));
}

TEST_CASE("shuffled points have the same voids and components, in the same order, to the last bit") {
  Random random(416);
  std::size_t voids_found = 0;
  for (int trial = 0; trial < 6; ++trial) {
    Points3 points = trial < 3 ? corners_of_bricks(6, 6, 6) : space_set(SpaceKind::cube, 600, random);
    std::vector<bool> in;
    const Solid all = solid(points, infinity);
    const Solid s = trial < 3 ? random_part(all, points.size(), 0.8, random) : solid(points, 0.12);
    // The tetrahedra by their corners' coordinates.
    const std::vector<std::uint32_t> order = random_order(points.size(), random);
    std::vector<std::uint32_t> place(points.size());
    Points3 shuffled;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      shuffled.push_back(points[order[i]]);
      place[order[i]] = i;
    }
    const auto by_name = [](Tetrahedron t) {
      std::sort(t.begin(), t.end());
      return t;
    };
    std::set<Tetrahedron> names;
    for (const Tetrahedron& t : s.simplices)
      names.insert(by_name({place[t[0]], place[t[1]], place[t[2]], place[t[3]]}));
    const Solid other_all = solid(shuffled, infinity);
    std::vector<bool> kept;
    for (const Tetrahedron& t : other_all.simplices) kept.push_back(names.count(by_name(t)) != 0);
    const Solid other = part_of(other_all, points.size(), kept);
    REQUIRE(other.simplices.size() == s.simplices.size());

    const SolidBoundary b = rbpa::solid_boundary(s), other_b = rbpa::solid_boundary(other);
    const Voids voids = rbpa::voids(points, s, b), others = rbpa::voids(shuffled, other, other_b);
    CHECK(voids.counts == others.counts);
    REQUIRE(voids.all.size() == others.all.size());
    voids_found += voids.all.size();
    for (std::size_t v = 0; v < voids.all.size(); ++v) {
      const SolidVoid &a = voids.all[v], &c = others.all[v];
      CHECK(a.volume == c.volume);
      CHECK(a.area == c.area);
      CHECK(a.low == c.low);
      CHECK(a.high == c.high);
      CHECK(a.islands == c.islands);
      std::set<std::uint32_t> named;
      for (const std::uint32_t i : c.points) named.insert(order[i]);
      CHECK(std::vector<std::uint32_t>(named.begin(), named.end()) == a.points);
    }
    for (const auto through : {rbpa::Connection::triangles, rbpa::Connection::points}) {
      const auto components = rbpa::solid_components(points, s, b, through);
      const auto other_components = rbpa::solid_components(shuffled, other, other_b, through);
      REQUIRE(components.all.size() == other_components.all.size());
      for (std::size_t c = 0; c < components.all.size(); ++c) {
        CHECK(components.all[c].volume == other_components.all[c].volume);
        CHECK(components.all[c].area == other_components.all[c].area);
        CHECK(components.all[c].tetrahedra == other_components.all[c].tetrahedra);
        CHECK(components.all[c].low == other_components.all[c].low);
      }
    }
  }
  CHECK(voids_found > 30);
}

TEST_CASE("components are pieces connected through triangles or points, with their volumes; the largest first") {
  Random random(417);
  std::size_t differ = 0;
  for (int trial = 0; trial < trials(80); ++trial) {
    CAPTURE(trial);
    const Points3 points = trial % 2 == 0 ? corners_of_bricks(4, 4, 4) : space_set(SpaceKind::cube, 40, random);
    const Solid s = random_part(solid(points, infinity), points.size(), 0.1 + 0.1 * double(random.below(8)), random);
    const SolidBoundary b = rbpa::solid_boundary(s);
    std::array<std::size_t, 2> sizes{};
    for (const auto& [through, shared] : {std::pair(rbpa::Connection::triangles, 3u), {rbpa::Connection::points, 1u}}) {
      const auto expected = pieces(s, shared);
      const rbpa::SolidComponents components = rbpa::solid_components(points, s, b, through);
      REQUIRE(components.all.size() == expected.size());
      REQUIRE(components.number.size() == s.simplices.size());
      sizes[shared == 1] = expected.size();
      std::set<std::uint32_t> seen;
      for (const auto& piece : expected) {
        const std::uint32_t number = components.number[piece.front()];
        REQUIRE(seen.insert(number).second);
        REQUIRE(number < expected.size());
        Rational six = 0;
        for (const std::uint32_t t : piece) {
          CHECK(components.number[t] == number);
          six += six_volumes(points, s.simplices[t]);
        }
        const rbpa::SolidComponent& c = components.all[number];
        CHECK(c.tetrahedra == piece.size());
        CHECK(is_near(c.volume, six / 6));
        std::size_t open = 0;
        for (const std::uint32_t t : b.tetrahedra) open += components.number[t] == number;
        CHECK(c.boundary_triangles == open);
      }
      for (std::size_t c = 1; c < components.all.size(); ++c)
        CHECK(components.all[c - 1].volume >= components.all[c].volume);
    }
    differ += sizes[0] != sizes[1];
  }
  CHECK(differ > static_cast<std::size_t>(trials(40)));
}

TEST_CASE("a boundary of another solid, and a solid without neighbors, are refused") {
  Random random(418);
  const Points3 points = space_set(SpaceKind::cube, 60, random);
  const Solid s = solid(points, infinity);
  const SolidBoundary b = rbpa::solid_boundary(s);
  using meshops::ContractViolation;
  CHECK_THROWS_AS(rbpa::voids(points, solid(points, infinity, {.neighbors = false}), b), ContractViolation);
  CHECK_THROWS_AS(rbpa::count(std::span(points).first(4), s, b), ContractViolation);
  CHECK_THROWS_AS(rbpa::count(points, Solid(), b), ContractViolation);
  CHECK_THROWS_AS(rbpa::solid_components(points, Solid(), b), ContractViolation);
  SolidBoundary open = b;
  open.surface = rbpa::Surface();
  CHECK_THROWS_AS(rbpa::voids(points, s, open), ContractViolation);
  CHECK(rbpa::voids(points, solid({}, 1), rbpa::solid_boundary(solid({}, 1))).counts == SolidCounts());
}

TEST_SUITE_END();
