// The example's ball pivoting on the advancing-front engine, against rbpa::surface().
#include "examples/ball_pivoting.h"

#include <doctest/doctest.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "examples/surface_arrays.h"
#include "meshops/core/validate.h"
#include "rbpa/space/surface_mesh.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// The same, but for who has no say in what is glued.
struct BySites {
  BallPivoting policy;
  std::optional<BallPivoting::Triangle> seed(const meshops::Front& front) { return policy.seed(front); }
  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) const {
    return policy.propose(front, h);
  }
};
static_assert(meshops::GluingFrontPolicy<BallPivoting> && !meshops::GluingFrontPolicy<BySites>);

struct Refusals : meshops::FrontVisitor {
  std::size_t count = 0;
  void refused(const meshops::Front&, meshops::Halfedge, const meshops::Refusal&) { ++count; }
  void seed_refused(const meshops::Front&, const BallPivoting::Triangle&, const meshops::Refusal&) { ++count; }
};

template <typename Policy>
std::vector<meshops::Site> advanced(Mesh& mesh, const rbpa::RollingBall& ball, Policy policy, Refusals& refusals) {
  meshops::Front front(mesh, ball.points(), 100);
  meshops::advance(front, policy, refusals);
  return front.finish();
}

/// Normals that mostly agree with each other, so that there is a surface with a boundary.
Points3 some_normals(const Points3& points, Random& random) {
  Points3 normals = random_normals(points.size(), random);
  if (random.chance(0.8))
    for (rbpa::Point3& n : normals) n = random.chance(0.9) ? rbpa::Point3{0.1 * n.x, 0.1 * n.y, 1} : n;
  return normals;
}

/// Edges beyond the first between the same vertices.
template <typename AnyMesh>
std::size_t parallel_edges(const AnyMesh& mesh) {
  std::set<std::pair<int, int>> ends;
  std::size_t found = 0;
  for (const auto e : mesh.edges()) found += !ends.insert(std::minmax({e.v0().idx(), e.v1().idx()})).second;
  return found;
}

}  // namespace

TEST_CASE("ball pivoting on the engine is the surface: triangles, gluing, and a vertex for each fan") {
  Random random(97);
  std::size_t triangles = 0, boundary = 0, fans = 0, by_sites_differs = 0, refused_by_sites = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < 40; ++trial) {
      CAPTURE(name(static_cast<SpaceKind>(k)));
      CAPTURE(trial);
      const Points3 points = space_set(static_cast<SpaceKind>(k), 3 + random.below(40), random);
      const Points3 normals = some_normals(points, random);
      const double radius = space_radius(points, random);
      const Surface expected = rbpa::surface(points, normals, radius);

      const rbpa::RollingBall ball(points, normals, radius);
      Mesh mesh;
      Refusals refusals;
      const std::vector<meshops::Site> site = advanced(mesh, ball, BallPivoting(ball), refusals);
      CHECK(refusals.count == 0);
      CHECK(meshops::validate(mesh).empty());
      const Surface found = arrays(mesh, site);
      CHECK(found.triangles == expected.triangles);
      CHECK(found.neighbors == expected.neighbors);
      CHECK(mesh.n_vertices() == rbpa::surface_mesh(points, expected).mesh.n_vertices());
      triangles += found.triangles.size();
      for (const auto& across : found.neighbors)
        boundary += static_cast<std::size_t>(std::count(across.begin(), across.end(), Surface::none));
      fans += mesh.n_vertices() - std::set(site.begin(), site.end()).size();

      Mesh other;
      Refusals told;
      const std::vector<meshops::Site> of = advanced(other, ball, BySites{BallPivoting(ball)}, told);
      by_sites_differs += arrays(other, of).neighbors != expected.neighbors;
      refused_by_sites += told.count > 0;
    }
  CHECK(triangles > 3000);
  CHECK(boundary > 1000);
  CHECK(fans > 100);
  CHECK(by_sites_differs > 20);  // sites do not tell what is glued
  CHECK(refused_by_sites > 20);
}

TEST_CASE("what hangs over an edge parts the triangles beside it: a slit, of two edges between the same vertices") {
  Points3 points;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) points.push_back({double(x), double(y), 0});
  points.push_back({2.5, 2, 1.1});  // the ball fits beside it, and not under it
  Points3 normals(points.size(), {0, 0, 1});
  normals.back() = {0, 0, -1};
  const Surface expected = rbpa::surface(points, normals, 0.75);
  REQUIRE(expected.triangles.size() == 50);

  const rbpa::RollingBall ball(points, normals, 0.75);
  Mesh mesh;
  Refusals refusals;
  const std::vector<meshops::Site> site = advanced(mesh, ball, BallPivoting(ball), refusals);
  CHECK(arrays(mesh, site).neighbors == expected.neighbors);
  CHECK(parallel_edges(mesh) == 1);
  CHECK(meshops::boundary_curves(mesh).size() == 2);
  CHECK(parallel_edges(rbpa::surface_mesh(points, expected).mesh) == 1);

  Mesh closed;
  const std::vector<meshops::Site> of = advanced(closed, ball, BySites{BallPivoting(ball)}, refusals);
  CHECK(arrays(closed, of).triangles == expected.triangles);
  CHECK(meshops::boundary_curves(closed).size() == 1);
}

TEST_SUITE_END();
