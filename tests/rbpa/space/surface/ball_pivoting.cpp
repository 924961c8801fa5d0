// Ball pivoting of the example, on the advancing-front engine, compared with rbpa::surface().
#include "examples/ball_pivoting.h"

#include <doctest/doctest.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "examples/surface_arrays.h"
#include "meshops/core/validate.h"
#include "rbpa/space/surface/surface_levels.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "support/arguments.h"
#include "support/for_space_sets.h"
#include "support/space_sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// Ball pivoting without glues(): sites decide which sides are glued.
struct BySites {
  BallPivoting policy;
  std::optional<BallPivoting::Triangle> seed(const meshops::Front& front) { return policy.seed(front); }
  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) const {
    return policy.propose(front, h);
  }
};
static_assert(meshops::GluingFrontPolicy<BallPivoting> && !meshops::GluingFrontPolicy<BySites>);

struct Watcher : meshops::FrontVisitor {
  std::size_t refusals = 0;
  std::size_t glued_seeds = 0;  // seeds attached to the front along a side, at every level
  void seeded(const meshops::Front& front, const meshops::InsertedTriangle& t) {
    for (const meshops::Halfedge side : t.side)
      glued_seeds += !front.mesh().is_boundary(front.mesh().opposite_halfedge_handle(side));
  }
  void refused(const meshops::Front&, meshops::Halfedge, const meshops::Refusal&) { ++refusals; }
  void seed_refused(const meshops::Front&, const BallPivoting::Triangle&, const meshops::Refusal&) { ++refusals; }
};

struct Advanced {
  Surface surface;
  std::vector<meshops::Site> site;  // for each vertex
};

template <typename Policy = BallPivoting>
Advanced advanced(Mesh& mesh, const Points3& points, const Points3& normals, const std::vector<double>& radii,
                  Watcher& watcher) {
  meshops::Front front(mesh, points.size(), 100);
  for (const double radius : radii) {
    const rbpa::RollingBall ball(points, normals, radius);
    Policy policy{BallPivoting(ball, front, front.next_level().carried)};
    meshops::advance(front, policy, watcher);
  }
  std::vector<meshops::Site> site = front.finish();
  Surface surface = arrays(front, site);
  return {std::move(surface), std::move(site)};
}

/// Returns normals that mostly agree with each other, so that there is a surface with a boundary.
Points3 some_normals(const Points3& points, Random& random) {
  Points3 normals = random_normals(points.size(), random);
  if (random.chance(0.8))
    for (rbpa::Point3& n : normals) n = random.chance(0.9) ? rbpa::Point3{0.1 * n.x, 0.1 * n.y, 1} : n;
  return normals;
}

/// Returns two to four radii.
std::vector<double> some_radii(const Points3& points, Random& random) {
  std::set<double> radii;
  for (std::size_t tries = 0, count = 2 + random.below(3); radii.size() < count && tries < 20; ++tries)
    radii.insert(space_radius(points, random));
  return {radii.begin(), radii.end()};
}

/// A set of two or three densities, on which triangles of several radii meet.
struct Uneven {
  std::string name;
  Points3 points, normals;
  std::vector<double> radii;
};

Uneven uneven_sphere(Random& random) {
  Uneven set{"sphere", {}, {}, {}};
  const std::size_t dense = 40 + random.below(40), sparse = 8 + random.below(12);
  for (std::size_t i = 0; i < dense + sparse; ++i) {
    const double side = i < dense ? 1 : -1, z = side * random.between(0, 1), turn = random.between(0, 2 * M_PI),
                 ring = std::sqrt(1 - z * z), out = random.chance(0.7) ? 1 : random.between(0.9, 1.1);
    set.points.push_back({out * ring * std::cos(turn), out * ring * std::sin(turn), out * z});
  }
  set.normals = set.points;
  set.radii = {0.2, 0.3, 0.5, 0.8};
  return set;
}
/// Returns a plane of which one half is dense; some points lie a little above or below, where they obstruct a ball.
Uneven uneven_plane(Random& random, bool is_grid) {
  Uneven set{is_grid ? "grid of two densities" : "plane of two densities", {}, {}, {}};
  const auto put = [&](double x, double y) {
    const double z = random.chance(0.8) ? 0 : is_grid ? (random.chance(0.5) ? 1 : -1) : random.between(-0.8, 0.8);
    set.points.push_back({x, y, z});
    set.normals.push_back(random.chance(0.9) ? rbpa::Point3{0, 0, 1} : rbpa::Point3{0, 0, -1});
  };
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 6; ++j) {
      const double x = is_grid ? i : random.between(0, i < 5 ? 4 : 10), y = is_grid ? j : random.between(0, 6);
      if (!is_grid || i < 5 || (i % 2 == 1 && j % 2 == 0)) put(x, y);
    }
  set.radii = is_grid ? std::vector<double>{0.75, 1, 1.5, 2} : std::vector<double>{0.6, 1, 1.5, 2.5};
  return set;
}
/// Returns clusters on a sphere, each of its own width.
Uneven clusters_on_a_sphere(Random& random) {
  Uneven set{"clusters on a sphere", {}, {}, {}};
  const auto on_sphere = [](rbpa::Point3 p) {
    const double length = std::hypot(p.x, p.y, p.z);
    return rbpa::Point3{p.x / length, p.y / length, p.z / length};
  };
  for (int cluster = 0; cluster < 5; ++cluster) {
    const Points3 center = random_normals(1, random);
    const double width = std::pow(2, -random.between(0, 4));
    for (const rbpa::Point3& d : random_normals(14, random)) {
      const rbpa::Point3 c = on_sphere(center[0]), e = on_sphere(d);
      set.points.push_back(on_sphere({c.x + width * e.x, c.y + width * e.y, c.z + width * e.z}));
    }
  }
  set.normals = set.points;
  set.radii = {0.05, 0.15, 0.4, 0.9};
  return set;
}
constexpr std::size_t uneven_kinds = 4;

Uneven uneven_set(std::size_t kind, Random& random) {
  Uneven set = kind == 0   ? uneven_sphere(random)
               : kind == 1 ? uneven_plane(random, false)
               : kind == 2 ? uneven_plane(random, true)
                           : clusters_on_a_sphere(random);
  while (set.radii.size() > 2 && random.chance(0.4))
    set.radii.erase(set.radii.begin() + static_cast<long>(random.below(set.radii.size())));
  return set;
}

/// Counts of the cases of the rule of docs/explanation/surfaces.md, section 17.
struct Compared {
  std::size_t triangles = 0;      ///< of levels beyond the first
  std::size_t apart = 0;          ///< seeds among these: not adjacent to an earlier triangle
  std::size_t rolled_over = 0;    ///< glued to a triangle of an earlier level, from which the ball rolls
  std::size_t rests_no_more = 0;  ///< glued to one on which the ball no longer rests
};

void check_same(const Points3& points, const Points3& normals, const std::vector<double>& radii, Compared& compared) {
  const Surface expected = rbpa::surface(points, normals, radii);
  Mesh mesh;
  Watcher watcher;
  const Surface found = advanced(mesh, points, normals, radii, watcher).surface;
  CHECK(watcher.refusals == 0);
  CHECK(watcher.glued_seeds == 0);
  CHECK(meshops::validate(mesh).empty());
  CHECK(found.triangles == expected.triangles);
  CHECK(found.neighbors == expected.neighbors);
  CHECK(found.levels == expected.levels);
  CHECK(mesh.n_vertices() == rbpa::surface_mesh(points, expected).mesh.n_vertices());

  std::vector<std::vector<BallPivoting::Triangle>> resting;
  for (const double radius : radii) resting.push_back(rbpa::surface(points, normals, radius).triangles);
  for (std::size_t t = 0; t < found.triangles.size(); ++t) {
    const std::uint32_t level = found.levels[t];
    bool is_beside = false;
    for (const std::uint32_t other : found.neighbors[t]) {
      if (other == Surface::none || found.levels[other] >= level) continue;
      is_beside = true;
      const bool rests = std::ranges::binary_search(resting[level], found.triangles[other]);
      ++(rests ? compared.rolled_over : compared.rests_no_more);
    }
    compared.triangles += level > 0;
    compared.apart += level > 0 && !is_beside;
  }
}

/// Counts the edges beyond the first between the same vertices.
template <typename AnyMesh>
std::size_t parallel_edges(const AnyMesh& mesh) {
  std::set<std::pair<int, int>> ends;
  std::size_t found = 0;
  for (const auto e : mesh.edges()) found += !ends.insert(std::minmax({e.v0().idx(), e.v1().idx()})).second;
  return found;
}

}  // namespace

TEST_CASE("ball pivoting on the engine is the surface, with its triangles, gluing, and a vertex for each fan") {
  Random random(97);
  std::size_t triangles = 0, boundary = 0, fans = 0, by_sites_differs = 0, refused_by_sites = 0;
  for_space_sets(trials(40), 3, 39, random, [&](const Points3& points) {
    const Points3 normals = some_normals(points, random);
    const double radius = space_radius(points, random);
    const Surface expected = rbpa::surface(points, normals, radius);

    Mesh mesh;
    Watcher watcher;
    const auto [found, site] = advanced(mesh, points, normals, {radius}, watcher);
    CHECK(watcher.refusals == 0);
    CHECK(watcher.glued_seeds == 0);
    CHECK(meshops::validate(mesh).empty());
    CHECK(found.triangles == expected.triangles);
    CHECK(found.neighbors == expected.neighbors);
    CHECK(mesh.n_vertices() == rbpa::surface_mesh(points, expected).mesh.n_vertices());
    triangles += found.triangles.size();
    for (const auto& across : found.neighbors)
      boundary += static_cast<std::size_t>(std::count(across.begin(), across.end(), Surface::none));
    fans += mesh.n_vertices() - std::set(site.begin(), site.end()).size();

    Mesh other;
    Watcher compared;
    by_sites_differs +=
        advanced<BySites>(other, points, normals, {radius}, compared).surface.neighbors != expected.neighbors;
    refused_by_sites += compared.refusals > 0;
  });
  CHECK(triangles > trials(3000));
  CHECK(boundary > 1000);
  CHECK(fans > 100);
  CHECK(by_sites_differs > trials(20));  // sites do not determine what is glued
  CHECK(refused_by_sites > trials(20));
}

TEST_CASE("ball pivoting by several radii, each a level of the front, is the surface by several radii") {
  Random random(98);
  Compared compared;
  for_space_sets(trials(25), 5, 29, random, [&](const Points3& points) {
    check_same(points, some_normals(points, random), some_radii(points, random), compared);
  });
  for (std::size_t kind = 0; kind < uneven_kinds; ++kind)
    for (int trial = 0; trial < trials(40); ++trial) {
      const Uneven set = uneven_set(kind, random);
      CAPTURE(set.name);
      CAPTURE(trial);
      check_same(set.points, set.normals, set.radii, compared);
    }
  CHECK(compared.triangles > trials(4000));
  CHECK(compared.apart > trials(2000));
  CHECK(compared.rolled_over > trials(2000));
  CHECK(compared.rests_no_more > trials(100));
}

TEST_CASE("the front has the same surface by several radii in any order of the points") {
  Random random(99);
  std::size_t triangles = 0;
  for (std::size_t kind = 0; kind < uneven_kinds; ++kind)
    for (int trial = 0; trial < 3; ++trial) {
      const Uneven set = uneven_set(kind, random);
      CAPTURE(set.name);
      std::vector<std::uint32_t> order(set.points.size());
      std::iota(order.begin(), order.end(), 0u);
      const auto all_glued = [&] {
        Points3 points, normals;
        std::vector<std::uint32_t> name;  // equal points share one
        for (const std::uint32_t i : order) {
          points.push_back(set.points[i]);
          normals.push_back(set.normals[i]);
          name.push_back(static_cast<std::uint32_t>(std::ranges::find(set.points, set.points[i]) - set.points.begin()));
        }
        Mesh mesh;
        Watcher watcher;
        const Surface surface = advanced(mesh, points, normals, set.radii, watcher).surface;
        const auto triangle = [&](std::uint32_t t) {
          return t == Surface::none ? Triangle{} : renumbered({surface.triangles[t]}, name)[0];
        };
        // Sides from each corner to the next, with the level and the triangle across.
        std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, Triangle>> sides;
        for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
          for (std::size_t i = 0; i < 3; ++i) {
            const Triangle& corners = surface.triangles[t];
            sides.emplace(name[corners[(i + 1) % 3]], name[corners[(i + 2) % 3]], name[corners[i]], surface.levels[t],
                          triangle(surface.neighbors[t][i]));
          }
        return sides;
      };
      const auto expected = all_glued();
      triangles += expected.size() / 3;
      random.shuffle(order);
      CHECK(all_glued() == expected);
    }
  CHECK(triangles > 500);
}

TEST_CASE("a point that hangs over an edge separates the triangles on both sides, which makes a slit") {
  Points3 points = corners_of_bricks(6, 6, 1);
  points.push_back({2.5, 2, 1.1});  // the ball fits next to it, and not under it
  Points3 normals(points.size(), {0, 0, 1});
  normals.back() = {0, 0, -1};
  const Surface expected = rbpa::surface(points, normals, 0.75);
  REQUIRE(expected.triangles.size() == 50);

  Mesh mesh;
  Watcher watcher;
  CHECK(advanced(mesh, points, normals, {0.75}, watcher).surface.neighbors == expected.neighbors);
  CHECK(parallel_edges(mesh) == 1);
  CHECK(meshops::boundary_curves(mesh).size() == 2);
  CHECK(parallel_edges(rbpa::surface_mesh(points, expected).mesh) == 1);

  Mesh closed;
  CHECK(advanced<BySites>(closed, points, normals, {0.75}, watcher).surface.triangles == expected.triangles);
  CHECK(meshops::boundary_curves(closed).size() == 1);
}

TEST_SUITE_END();
