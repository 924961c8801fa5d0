// The paper's RBPA, compared with rbpa(), which finds the same triangles by tiles.
#include "rbpa/paper.h"
#include "rbpa/rbpa.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "meshops/core/validate.h"
#include "meshops/front/engine.h"
#include "paper/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/base/mesh.h"
#include "rbpa/paper/pivoting.h"
#include "support/arguments.h"
#include "support/check_ascending.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::SolidAlphaComplex;

TEST_SUITE_BEGIN("paper");

namespace {

SolidAlphaComplex by_the_paper(const Points& points, double alpha) { return rbpa::paper::rbpa(points, alpha); }

std::string wrong_with_paper(const Points& points, double alpha) {
  const SolidAlphaComplex paper = by_the_paper(points, alpha), direct = rbpa::rbpa(points, alpha);
  if (std::string wrong = difference(rbpa::triangles(direct), rbpa::triangles(paper)); !wrong.empty()) return wrong;
  if (paper.isolated != direct.isolated) return "isolated points";
  if (paper.duplicates != direct.duplicates || paper.distinct != direct.distinct) return "duplicates";
  if (paper.mesh.n_vertices() != direct.mesh.n_vertices() || paper.mesh.n_edges() != direct.mesh.n_edges())
    return "vertices or edges";
  if (const auto defects = meshops::validate(paper.mesh); !defects.empty()) return meshops::describe(defects.front());
  return "";
}

/// Returns the number of triangles.
std::size_t check(const Points& points, double alpha) {
  CAPTURE(alpha);
  const std::string wrong = wrong_with_paper(points, alpha);
  if (wrong.empty()) return rbpa::rbpa(points, alpha).mesh.n_faces();
  const Points few = shrink(points, [&](const Points& some) { return !wrong_with_paper(some, alpha).empty(); });
  FAIL_CHECK(wrong, "\nshrunk: ", wrong_with_paper(few, alpha), "\n", literal(few));
  return 0;
}

}  // namespace

TEST_CASE("Theorem 1: RBPA finds the solid alpha complex of every kind of set") {
  std::size_t triangles = 0;
  for (const NamedSet& set : generated_sets()) {
    const std::size_t most = all_trials() ? 150 : 80;
    const Points points = set.first(most), some = set.some(most);
    CAPTURE(set.name);
    for (const Points& part : {points, some}) {
      for (const double alpha : usual_alphas(part)) triangles += check(part, alpha);
      for (const double alpha : set.alphas) triangles += check(part, alpha);
    }
  }
  CHECK(triangles > (all_trials() ? 100000U : 50000U));
}

TEST_CASE("RBPA is right on every subset of a grid of 3 by 3") {
  for (std::uint32_t subset = 0; subset < 512; ++subset) {
    Points points;
    for (std::uint32_t i = 0; i < 9; ++i)
      if (subset >> i & 1U) points.push_back({double(i % 3), double(i / 3)});
    for (const double alpha : {0.5, std::sqrt(0.5), 0.75, 1.0, std::sqrt(1.25), 1.25, 1.5, 2.5, infinity})
      check(points, alpha);
  }
}

TEST_CASE("the order of the input changes only the order of the faces") {
  for (const Points& points : {uniform(200, 1), random_grid(12, 100, true, 2), tiny_components(30, 3), star(325)})
    for (const double alpha : {0.7, 1.0, 3.0, 165.0, infinity}) {
      CAPTURE(alpha);
      const auto triangles = rbpa::triangles(by_the_paper(points, alpha));
      Random random(4);
      for (int order = 0; order < 3; ++order) {
        Points shuffled = points;
        random.shuffle(shuffled);
        CHECK(translated(rbpa::triangles(by_the_paper(shuffled, alpha)), shuffled, points) == triangles);
      }
    }
}

TEST_CASE("a visitor that throws leaves a sound mesh and a front, from which the run continues to the same end") {
  struct Stop {};
  struct Stopping : meshops::FrontVisitor {
    explicit Stopping(std::size_t last_event) : last(last_event) {}
    void seeded(const meshops::Front&, const meshops::InsertedTriangle&) { count(); }
    void attached(const meshops::Front&, meshops::Halfedge, const meshops::InsertedTriangle&) { count(); }
    void frozen(const meshops::Front&, meshops::Halfedge) { count(); }
    void count() {
      if (events++ == last) throw Stop();
    }
    std::size_t last, events = 0;
  };
  Random random(102);
  const Points points = distinct(random_grid(6, 25, false, 5), random);
  const std::vector<Triangle> complex = complex_by_definition(points, 1.25);
  bool is_whole = false;
  for (std::size_t last = 0; !is_whole; ++last) {
    rbpa::Mesh mesh;
    meshops::Front front(mesh, points.size());
    rbpa::paper::RestrictedBallPivoting policy(points, all_sites(points), rbpa::Radius(1.25));
    is_whole = true;
    try {
      meshops::advance(front, policy, Stopping(last));
    } catch (const Stop&) {
      is_whole = false;
    }
    CHECK(meshops::validate(mesh).empty());
    meshops::advance(front, policy);
    REQUIRE(front.faces() == complex.size());
    REQUIRE(last < 1000);
  }
}

TEST_CASE("progress ascends, is called while there are no triangles, and false or an exception ends the run") {
  // Nearly all points are isolated: the run mainly searches for seeds.
  Points sparse;
  for (int i = 0; i < 40000; ++i) sparse.push_back({100.0 * (i % 200), 100.0 * (i / 200)});
  sparse.push_back({0.5, 0});
  sparse.push_back({0, 0.5});
  for (const auto& [points, alpha] : {std::pair(sparse, 1.0), std::pair(jittered_grid(150, 0.8, 1), 2.0)}) {
    std::vector<rbpa::Progress> seen;
    const auto watched = rbpa::paper::rbpa(points, alpha, {.progress = [&](const rbpa::Progress& p) {
                                             seen.push_back(p);
                                             return true;
                                           }});
    check_ascending(seen, points.size(), watched.mesh.n_faces());
    for (const std::size_t last : {1u, 2u}) {
      std::size_t calls = 0;
      CHECK_THROWS_AS(
          rbpa::paper::rbpa(points, alpha, {.progress = [&](const rbpa::Progress&) { return ++calls < last; }}),
          rbpa::Cancelled);
      CHECK(calls == last);
    }
    CHECK_THROWS_AS(rbpa::paper::rbpa(points, alpha,
                                      {.progress = [](const rbpa::Progress&) -> bool { throw std::string("stop"); }}),
                    std::string);
  }
}

TEST_CASE("both searches refuse the same input and find the same empty complexes") {
  CHECK_THROWS_AS(by_the_paper({{0, 0}, {1, 0}, {0, 1}}, 0), rbpa::InvalidInput);
  CHECK_THROWS_AS(by_the_paper({{0, 0}, {infinity, 0}, {0, 1}}, 1), rbpa::InvalidInput);
  for (const Points& points : {Points{}, Points{{1, 2}}, Points{{1, 2}, {3, 4}}, Points(9, Point{0.1, 0.2})})
    for (const double alpha : {1e-300, 1.0, 1e300, infinity}) check(points, alpha);
  check(collinear_run(20, 3, -7, 1), infinity);
}

TEST_SUITE_END();
