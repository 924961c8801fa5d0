// Seeds are ideal: while a triangle is missing beyond the front, one is found; and no seed is a triangle that the front
// would reach.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "meshops/front/engine.h"
#include "paper/small_sets.h"
#include "rbpa/base/mesh.h"
#include "rbpa/paper/pivoting.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/shrink.h"

using namespace rbpa_test;
using meshops::Front;
using meshops::Site;
using rbpa::paper::RestrictedBallPivoting;

TEST_SUITE_BEGIN("paper");

namespace {

std::vector<Triangle> triangles_of(const Front& front) {
  std::vector<Triangle> found;
  for (std::size_t f = 0; f < front.faces(); ++f) {
    meshops::Halfedge h = front.mesh().halfedge_handle(meshops::Face(static_cast<int>(f)));
    Triangle& corners = found.emplace_back();
    for (std::uint32_t& corner : corners) {
      corner = front.from_site(h);
      h = front.mesh().next_halfedge_handle(h);
    }
  }
  return canonical(std::move(found));
}

/// RBPA with a check of every answer.
class Judged {
 public:
  Judged(RestrictedBallPivoting& rbpa, std::vector<Triangle> complex) : rbpa_(rbpa), complex_(std::move(complex)) {}

  std::optional<std::array<Site, 3>> seed(const Front& front) {
    const auto seed = rbpa_.seed(front);
    const bool is_whole = front.faces() == complex_.size();
    CHECK(seed.has_value() == !is_whole);
    if (!seed) return seed;
    ++seeds;
    CHECK(std::binary_search(complex_.begin(), complex_.end(), canonical({*seed})[0]));
    for (std::size_t i = 0; i < 3; ++i) CHECK_FALSE(front.edge_between((*seed)[i], (*seed)[(i + 1) % 3]).is_valid());
    return seed;
  }
  std::optional<Site> propose(const Front& front, meshops::Halfedge h) {
    const auto apex = rbpa_.propose(front, h);
    if (apex)
      CHECK(std::binary_search(complex_.begin(), complex_.end(),
                               canonical({{front.from_site(h), front.to_site(h), *apex}})[0]));
    return apex;
  }
  int seeds = 0;

 private:
  RestrictedBallPivoting& rbpa_;
  std::vector<Triangle> complex_;
};

/// Returns the number of seeds.
int check(const Points& points, double alpha) {
  INFO("alpha ", literal(alpha), ", points ", literal(points));
  rbpa::Mesh mesh;
  Front front(mesh, points.size());
  RestrictedBallPivoting rbpa(points, all_sites(points), radius_of(alpha));
  const std::vector<Triangle> complex = complex_by_definition(points, alpha);
  Judged judged(rbpa, complex);
  struct NothingRefused : meshops::FrontVisitor {
    void refused(const Front&, meshops::Halfedge, const meshops::Refusal&) { FAIL("refused"); }
    void seed_refused(const Front&, const std::array<Site, 3>&, const meshops::Refusal&) { FAIL("refused"); }
  };
  meshops::advance(front, judged, NothingRefused{});
  CHECK(difference(complex, triangles_of(front)) == "");
  return judged.seeds;
}

}  // namespace

TEST_CASE(
    "a seed is a triangle of the complex without an edge in the mesh, and there is one while a triangle is missing") {
  int seeds = 0;
  for_small_sets_of_every_kind(97, 30, 10,
                               [&](const Points& points, double alpha, Random&) { seeds += check(points, alpha); });
  CHECK(seeds > trials(120));
  Random random(98);
  for (const Points& points : {tiny_components(8, 1), chain_of_triangles(8), pairs_at_distance_2(8, 2), star(65)})
    for (const double alpha : {0.4, 1.0, 3.0, 33.0, 35.0}) {
      Points some = points;
      if (some.size() > 30) some.resize(24);
      seeds += check(distinct(some, random), alpha);
    }
}

TEST_CASE("a seed is found once where the ball meets several points at once") {
  // From its dangling edge, the ball around (−5, 0) reaches four points of the circle of radius alpha at once.
  check({{-6, 0}, {-5, 0}, {5, 0}, {4, 3}, {3, 4}, {0, 5}}, 5);
  // The perturbation cuts off (0, −5) as an ear: it has no edge to (−4, 3).
  check({{0, -6}, {0, -5}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}}, 5);
  Points rectangles;
  for (const double x : {0.0, 6.0, 12.0})
    for (const double y : {-8.0, 0.0, 8.0}) rectangles.push_back({x, y});
  check(rectangles, 5);
  // Arcs of circles of radius 5 and 25 with centers on a grid, and a few other points.
  Random random(99);
  for (int trial = 0; trial < trials(250); ++trial) {
    const int radius = random.chance(0.5) ? 5 : 25;
    Points points;
    const auto anywhere = [&] { return double(random.integer(-2 * radius, 2 * radius)); };
    for (int arc = random.integer(1, 2); arc > 0; --arc) {
      const double x = anywhere(), y = anywhere();
      for (const rbpa::Point& p : integer_circle(radius))
        if (random.chance(0.45)) points.push_back({x + p.x, y + p.y});
    }
    for (int stray = random.integer(1, 3); stray > 0; --stray) {
      const double x = anywhere();
      points.push_back({x, anywhere()});
    }
    points = distinct(points, random);
    if (points.size() > 14) points.resize(13);
    if (points.size() >= 3) check(points, radius);
  }
}

TEST_SUITE_END();
