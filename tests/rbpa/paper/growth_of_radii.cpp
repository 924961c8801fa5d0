// The paper's HRBPA, level by level, compared with rbpa() at the radius of the level and with hrbpa() by tiles.
#include "rbpa/hrbpa.h"
#include "rbpa/paper.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "far_sets.h"
#include "meshops/core/validate.h"
#include "paper/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/base/mesh.h"
#include "rbpa/paper/growth_of_radii.h"
#include "rbpa/plane/triangles_by_level.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/levels.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"

using namespace rbpa_test;
using rbpa::EndedLevel;
using rbpa::Hierarchy;
using rbpa::Level;
using rbpa::Point;

TEST_SUITE_BEGIN("paper");

namespace {

Hierarchy by_the_paper(const Points& points, double alpha, std::size_t leaf_capacity) {
  return rbpa::paper::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity});
}

bool admits(const Point& a, const Point& b, const Point& c, double alpha) {
  return radius_of(alpha).admits<long double>(a, b, c);
}

/// Returns how the levels of both differ, except in the points visited.
std::string differing_levels(const Hierarchy& paper, const Hierarchy& direct) {
  if (paper.least_radius != direct.least_radius) return "least radius";
  if (paper.levels.size() != direct.levels.size()) return "number of levels";
  for (std::size_t i = 0; i < paper.levels.size(); ++i) {
    const Level &p = paper.levels[i], &d = direct.levels[i];
    if (p.alpha != d.alpha || p.number != d.number || p.triangles != d.triangles || p.transferred != d.transferred ||
        p.advancing != d.advancing)
      return "level " + std::to_string(i);
  }
  return "";
}

std::string wrong_with_paper(const Points& points, double alpha, std::size_t leaf_capacity) {
  const Hierarchy paper = by_the_paper(points, alpha, leaf_capacity);
  const rbpa::SolidAlphaComplex direct = rbpa::rbpa(points, alpha);
  if (std::string wrong = difference(rbpa::triangles(direct), rbpa::triangles(paper.complex)); !wrong.empty())
    return wrong;
  if (paper.complex.isolated != direct.isolated) return "isolated points";
  if (paper.complex.duplicates != direct.duplicates || paper.complex.distinct != direct.distinct) return "duplicates";
  if (paper.complex.mesh.n_vertices() != direct.mesh.n_vertices() ||
      paper.complex.mesh.n_edges() != direct.mesh.n_edges())
    return "vertices or edges";
  if (const auto defects = meshops::validate(paper.complex.mesh); !defects.empty())
    return meshops::describe(defects.front());
  if (std::string wrong = wrong_numbers(paper, alpha); !wrong.empty()) return wrong;
  for (const Level& level : paper.levels)
    if (level.taking_part != level.transferred) return "taking part";
  // Each face came on the first level that admits it. So each level was the complex of its radius.
  if (std::string wrong = wrong_level(paper, points, admits); !wrong.empty()) return wrong;
  if (is_lost_in_rounding(paper.least_radius, points)) return "";
  return differing_levels(paper, hierarchy(points, alpha, leaf_capacity));
}

/// Returns the number of levels.
std::size_t check(const Points& points, double alpha, std::size_t leaf_capacity) {
  CAPTURE(alpha);
  CAPTURE(leaf_capacity);
  const std::string wrong = wrong_with_paper(points, alpha, leaf_capacity);
  if (wrong.empty()) return by_the_paper(points, alpha, leaf_capacity).levels.size();
  const Points few =
      shrink(points, [&](const Points& some) { return !wrong_with_paper(some, alpha, leaf_capacity).empty(); });
  FAIL_CHECK(wrong, "\nshrunk: ", wrong_with_paper(few, alpha, leaf_capacity), "\n", literal(few));
  return 0;
}

/// A run of paper::hrbpa() alone, with everything that it reports.
struct PaperRun {
  double least_radius = 0;
  std::vector<rbpa::paper::Level> levels;
  std::vector<std::size_t> triangles;  ///< number after each level
};

PaperRun run(const Points& points, double alpha, std::size_t leaf_capacity) {
  PaperRun recorded;
  rbpa::Mesh mesh;
  meshops::Front front(mesh, points.size());
  const std::function<bool(const rbpa::Progress&)> no_progress;
  rbpa::Monitor monitor(no_progress, points.size());
  recorded.least_radius =
      rbpa::paper::hrbpa(points, radius_of(alpha), leaf_capacity, front, monitor, [&](const rbpa::paper::Level& level) {
        recorded.levels.push_back(level);
        recorded.triangles.push_back(front.faces());
        for (const auto& curve : front.curves())
          for (const meshops::Halfedge h : curve) CHECK(front.is_frozen(h));
      });
  return recorded;
}

}  // namespace

TEST_CASE("HRBPA ends in the complex of every kind of set, and its levels are those of the default search") {
  std::size_t levels = 0;
  for (const NamedSet& set : generated_sets()) {
    const std::size_t most = all_trials() ? 60 : 32;
    const Points points = set.first(most), some = set.some(most);
    CAPTURE(set.name);
    for (const std::size_t k : {1u, 6u, 32u}) levels += check(points, infinity, k);
    for (const double alpha : set.alphas) levels += check(points, alpha, 4);
    for (const double alpha : usual_alphas(points)) levels += check(points, alpha, 2);
    levels += check(some, infinity, 3);
    for (const double alpha : set.alphas) levels += check(some, alpha, 16);
  }
  CHECK(levels > 1000);
}

TEST_CASE("after each level the mesh is that of rbpa() with its radius") {
  struct Seen {
    double alpha;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> isolated;
  };
  for (const Points& points : {uniform(300, 1), sparse_grid(18, 0.4, 2), clusters(15, 3), star(325), far_and_tiny(8, 4),
                               mixed_exponents(15, 5), denormals(9, 40, 6)}) {
    std::vector<Seen> seen;
    rbpa::paper::hrbpa(points, infinity, {.leaf_capacity = 2, .level_ended = [&](const EndedLevel& ended) {
                                            const meshops::Front& front = ended.front;
                                            Seen& now = seen.emplace_back(Seen{ended.level.alpha, {}, {}});
                                            for (std::size_t f = 0; f < front.faces(); ++f) {
                                              meshops::Halfedge h =
                                                  front.mesh().halfedge_handle(meshops::Face(static_cast<int>(f)));
                                              Triangle& corners = now.triangles.emplace_back();
                                              for (std::uint32_t& corner : corners) {
                                                corner = ended.input_index[front.from_site(h)];
                                                h = front.mesh().next_halfedge_handle(h);
                                              }
                                            }
                                            now.triangles = canonical(std::move(now.triangles));
                                            for (meshops::Site s = 0; s < front.sites(); ++s)
                                              if (front.is_free(s)) now.isolated.push_back(ended.input_index[s]);
                                            std::sort(now.isolated.begin(), now.isolated.end());
                                          }});
    REQUIRE(seen.size() >= 3);
    for (const Seen& level : seen) {
      const rbpa::SolidAlphaComplex direct = rbpa::rbpa(points, level.alpha);
      CHECK(difference(rbpa::triangles(direct), level.triangles) == "");
      CHECK(level.isolated == direct.isolated);
    }
  }
}

TEST_CASE("HRBPA is right on every subset of a grid of 3 by 3, even and stretched") {
  for (const auto& at : {std::array{0.0, 1.0, 2.0}, std::array{0.0, 1.0, 5.0}})
    for (std::uint32_t subset = 0; subset < 512; ++subset) {
      Points points;
      for (std::uint32_t i = 0; i < 9; ++i)
        if (subset >> i & 1U) points.push_back({at[i % 3], at[i / 3]});
      for (const double alpha : {0.75, 1.25, 2.5, infinity})
        for (const std::size_t k : {1u, 3u}) check(points, alpha, k);
    }
}

TEST_CASE("at extreme exponents triangles and levels equal those of the same points scaled to moderate ones") {
  for_each_far_set([&](std::string_view name, const Points& points, const Points& far) {
    if (points.size() > (all_trials() ? 400 : 150)) return;
    const double spacing = mean_spacing(points);
    for (const double alpha : {3 * spacing, infinity}) {
      INFO(name, ", alpha ", alpha);
      const Hierarchy near_run = by_the_paper(points, alpha, 4),
                      far_run = by_the_paper(far, std::ldexp(alpha, far_exponent), 4);
      CHECK(rbpa::triangles(near_run.complex) == rbpa::triangles(far_run.complex));
      REQUIRE(near_run.levels.size() == far_run.levels.size());
      for (std::size_t i = 0; i < near_run.levels.size(); ++i) {
        CHECK(near_run.levels[i].triangles == far_run.levels[i].triangles);
        if (i + 1 < near_run.levels.size())
          CHECK(std::ldexp(near_run.levels[i].alpha, far_exponent) == far_run.levels[i].alpha);
      }
    }
  });
}

TEST_CASE("levels ascend, each is the complex of its radius, and the last is that of alpha") {
  Random random(103);
  const Points points = distinct(clusters(12, 7), random);
  for (const double alpha : {1e-4, 3.0, infinity}) {
    const PaperRun recorded = run(points, alpha, 1);
    REQUIRE(recorded.levels.size() > 3);
    CHECK(recorded.levels.front().number == 0);
    CHECK(recorded.levels.front().transferred == points.size());
    CHECK(recorded.levels.front().advancing == 0);
    for (std::size_t i = 0; i < recorded.levels.size(); ++i) {
      const rbpa::paper::Level& level = recorded.levels[i];
      const bool is_last = i + 1 == recorded.levels.size();
      CHECK(level.is_last == is_last);
      if (i > 0) CHECK(level.number > recorded.levels[i - 1].number);
      if (is_last)
        CHECK(level.radius.is_infinite() == std::isinf(alpha));
      else
        CHECK(level.radius.value() == std::ldexp(recorded.least_radius, level.number));
      CHECK(recorded.triangles[i] ==
            rbpa::rbpa(points, level.radius.is_infinite() ? infinity : level.radius.value()).mesh.n_faces());
    }
    if (!std::isinf(alpha)) CHECK(recorded.levels.back().radius.value() == alpha);
  }
}

TEST_CASE("a radius equal to a dyadic one is run once") {
  Random random(104);
  const Points points = distinct(uniform(100, 8), random);
  const double least = run(points, 1e-9, 2).least_radius;
  for (const int i : {0, 1, 2, 3}) {
    const PaperRun recorded = run(points, std::ldexp(least, i), 2);
    CHECK(recorded.levels.size() == static_cast<std::size_t>(i + 1));
    CHECK(recorded.levels.back().number == i);
  }
  CHECK(run(points, std::nextafter(least, 0.0), 2).levels.size() == 1);
  CHECK(run(points, std::nextafter(least, 1.0), 2).levels.size() == 2);
}

TEST_CASE("of levels without a triangle only logarithmically many are visited, and none beyond is missed") {
  Random random(105);
  Points points = distinct(uniform(60, 9), random);
  points.push_back({100, 0});
  for (const double distance : {1e-12, 1e-100, 1e-300}) {
    // The pair waits for a third point through all levels up to that of the other points.
    points.back() = {0, distance};
    points.push_back({0, 0});
    const PaperRun recorded = run(points, infinity, 1);
    points.pop_back();
    const double doublings = std::log2(1 / recorded.least_radius);
    CHECK(doublings > -std::log2(distance) - 2);
    CHECK(recorded.levels.size() < 2 * std::log2(doublings) + 16);
    const Hierarchy direct = [&] {
      Points both = points;
      both.push_back({0, 0});
      return hierarchy(both, infinity, 1);
    }();
    // Every level that changes something was run, and separately.
    std::size_t next = 0;
    for (std::size_t i = 0; i < direct.levels.size(); ++i) {
      while (next < recorded.levels.size() && recorded.levels[next].number < direct.levels[i].number) ++next;
      REQUIRE(next < recorded.levels.size());
      CHECK(recorded.levels[next].number == direct.levels[i].number);
      CHECK(recorded.triangles[next] == direct.levels[i].triangles);
    }
  }
}

TEST_CASE("any number of levels may lie between two levels that change something") {
  // A small triangle, and one 2 to the power of `apart` times as large: any gap, and so any path of the search.
  for (int apart = 1; apart < 70; ++apart) {
    CAPTURE(apart);
    const double size = std::ldexp(1.0, apart);
    const Points points = {{0, 0}, {1, 0}, {0, 1}, {4 * size, 0}, {5 * size, 0}, {4 * size, size}};
    check(points, infinity, 1);
    check(points, size, 1);
  }
}

TEST_CASE("points visited without result on a level are counted") {
  Points points = uniform(60, 10);
  points.push_back({points[7].x, points[7].y + 1e-9});
  const Hierarchy paper = by_the_paper(points, infinity, 1);
  CHECK(paper.looked_in_vain > 3 * points.size());
  CHECK(paper.looked_in_vain % points.size() == 0);  // no triangle before
  CHECK(paper.looked_in_vain < 16 * points.size());
}

TEST_CASE("the usual capacity of leaves equals a small one, as the grid of the first level is as coarse") {
  const Points points = uniform(3000, 11);
  const double least = rbpa::paper::hrbpa(points, 3).least_radius;
  CHECK(least == by_the_paper(points, 3, rbpa::paper::usual_leaf_capacity).least_radius);
  CHECK(least < 4);
  CHECK(rbpa::hrbpa(points, 3).least_radius == hierarchy(points, 3, rbpa::usual_leaf_capacity).least_radius);
}

TEST_CASE("an exception of a visitor of levels or progress ends the run") {
  const Points points = uniform(500, 12);
  const std::size_t all = by_the_paper(points, infinity, 1).levels.size();
  REQUIRE(all > 3);
  for (std::size_t last = 1; last <= all; ++last) {
    std::size_t calls = 0;
    const auto stop = [&](const EndedLevel&) {
      if (++calls == last) throw std::string("seen enough");
    };
    CHECK_THROWS_AS(rbpa::paper::hrbpa(points, infinity, {.leaf_capacity = 1, .level_ended = stop}), std::string);
    CHECK(calls == last);
  }
  const auto cancel = [](const rbpa::Progress&) { return false; };
  CHECK_THROWS_AS(rbpa::paper::hrbpa(uniform(20000, 13), 2, {.progress = cancel}), rbpa::Cancelled);
  CHECK_THROWS(by_the_paper(points, 1, 0));
}

TEST_CASE("fewer than three points, or points on a line, have no levels") {
  for (const Points& points : {Points{}, Points{{1, 2}}, Points(9, Point{0.1, 0.2}), collinear_run(20, 3, -7, 1)}) {
    const Hierarchy h = by_the_paper(points, infinity, 1);
    CHECK(h.levels.empty());
    CHECK(h.least_radius == 0);
    CHECK(h.complex.mesh.n_faces() == 0);
  }
}

TEST_SUITE_END();
