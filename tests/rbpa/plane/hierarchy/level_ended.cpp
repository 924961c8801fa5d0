// The view of a visitor of levels while hrbpa() runs.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "meshops/core/validate.h"
#include "rbpa/hrbpa.h"
#include "rbpa/plane/level_topology.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/levels.h"
#include "support/sets.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::EndedLevel;
using rbpa::Hierarchy;
using rbpa::Level;

TEST_SUITE_BEGIN("hierarchy");

namespace {

/// The state when a level ended.
struct Seen {
  Level level;
  std::vector<Triangle> triangles;  ///< in the order of their faces, smallest index first
  std::vector<std::uint32_t> isolated;
  std::size_t curves;
  bool all_frozen;
};

Seen look(const EndedLevel& ended) {
  const meshops::Front& front = ended.front;
  const auto point = [&](meshops::Site s) { return ended.input_index[static_cast<std::size_t>(s)]; };
  Seen seen{.level = ended.level, .triangles = {}, .isolated = {}, .curves = front.curves().size(), .all_frozen = true};
  for (std::size_t f = 0; f < front.faces(); ++f) {
    meshops::Halfedge h = front.mesh().halfedge_handle(meshops::Face(static_cast<int>(f)));
    Triangle& corners = seen.triangles.emplace_back();
    for (std::uint32_t& corner : corners) {
      corner = point(front.from_site(h));
      h = front.mesh().next_halfedge_handle(h);
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  for (std::size_t s = 0; s < front.sites(); ++s)
    if (front.is_free(static_cast<meshops::Site>(s))) seen.isolated.push_back(point(static_cast<meshops::Site>(s)));
  std::sort(seen.isolated.begin(), seen.isolated.end());
  for (const meshops::BoundaryCurve& curve : front.curves())
    for (const meshops::Halfedge h : curve)
      seen.all_frozen &= std::find(front.frozen().begin(), front.frozen().end(), h) != front.frozen().end();
  return seen;
}

struct Watched {
  Hierarchy hierarchy;
  std::vector<Seen> seen;
};

Watched watch(const Points& points, double alpha, std::size_t leaf_capacity) {
  Watched watched;
  watched.hierarchy = rbpa::hrbpa(
      points, alpha,
      {.leaf_capacity = leaf_capacity, .level_ended = [&](const auto& ended) { watched.seen.push_back(look(ended)); }});
  return watched;
}

/// Compares all numbers except the time.
bool same_numbers(const Level& a, const Level& b) {
  return a.alpha == b.alpha && a.number == b.number && a.transferred == b.transferred &&
         a.taking_part == b.taking_part && a.advancing == b.advancing && a.triangles == b.triangles;
}

/// The corners of each face, smallest index first, in the order of the faces.
std::vector<Triangle> faces(const rbpa::SolidAlphaComplex& complex) {
  std::vector<Triangle> all;
  for (const auto face : complex.mesh.faces()) {
    Triangle& corners = all.emplace_back();
    std::size_t i = 0;
    for (const auto v : face.vertices()) corners[i++] = complex.input_index[static_cast<std::size_t>(v.idx())];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  return all;
}

void check_same(const Hierarchy& watched, const Hierarchy& alone) {
  CHECK(watched.least_radius == alone.least_radius);
  CHECK(watched.looked_in_vain == alone.looked_in_vain);
  CHECK(
      std::equal(watched.levels.begin(), watched.levels.end(), alone.levels.begin(), alone.levels.end(), same_numbers));
  CHECK(faces(watched.complex) == faces(alone.complex));
  CHECK(watched.complex.isolated == alone.complex.isolated);
  CHECK(watched.complex.duplicates == alone.complex.duplicates);
  CHECK(watched.complex.distinct == alone.complex.distinct);
  for (const Hierarchy* h : {&watched, &alone}) CHECK(meshops::validate(h->complex.mesh).empty());
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Calls check() with at most a hundred points of every generated set.
template <typename Check>
void for_small_sets(const Check& check) {
  for (const NamedSet& set : generated_sets()) {
    Points points = set.first(100);
    CAPTURE(set.name);
    for (const std::size_t k : {1u, 8u}) check(points, k);
  }
}

}  // namespace

TEST_CASE("the reported levels are those of the result, each with as many faces as it has triangles") {
  std::size_t levels = 0, in_vain = 0;
  for_small_sets([&](const Points& points, std::size_t k) {
    const auto& [hierarchy, seen] = watch(points, infinity, k);
    REQUIRE(seen.size() == hierarchy.levels.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      CHECK(same_numbers(seen[i].level, hierarchy.levels[i]));
      CHECK(seen[i].level.seconds == hierarchy.levels[i].seconds);
      CHECK(seen[i].triangles.size() == hierarchy.levels[i].triangles);
    }
    levels += seen.size();
    in_vain += hierarchy.looked_in_vain;
  });
  CHECK(levels > 100);
  CHECK(in_vain == 0);  // otherwise some level was left out
}

TEST_CASE("the mesh at the end of a level is the complex of its radius") {
  for_small_sets([](const Points& points, std::size_t k) {
    const auto& [hierarchy, seen] = watch(points, infinity, k);
    const auto topology = rbpa::level_topology(hierarchy);
    const std::size_t step = seen.size() / 10 + 1;  // some levels, for sets with very many
    for (std::size_t i = 0; i < seen.size(); i += step) {
      const rbpa::SolidAlphaComplex direct = rbpa::rbpa(points, seen[i].level.alpha);
      CHECK(sorted(seen[i].triangles) == rbpa::triangles(direct));
      CHECK(seen[i].isolated == direct.isolated);
      CHECK(seen[i].curves == topology[i].boundary_curves);
      CHECK(seen[i].all_frozen);
    }
  });
}

TEST_CASE("faces keep their numbers to the end") {
  const auto& [hierarchy, seen] = watch(clusters(20, 3), infinity, 2);
  REQUIRE(seen.size() > 3);
  const std::vector<Triangle>& last = seen.back().triangles;
  for (const Seen& earlier : seen) CHECK(std::equal(earlier.triangles.begin(), earlier.triangles.end(), last.begin()));
  CHECK(faces(hierarchy.complex) == last);
}

TEST_CASE("a run with a visitor has the same result as one without, faces in the same order") {
  for (const double alpha : {infinity, 0.8})
    for_small_sets([alpha](const Points& points, std::size_t k) {
      CAPTURE(alpha);
      CAPTURE(k);
      check_same(watch(points, alpha, k).hierarchy, hierarchy(points, alpha, k));
    });
}

TEST_CASE("a run with a visitor has the same result where tiles find the triangles, by any number of threads") {
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    CAPTURE(set.name);
    const Hierarchy watched = watch(points, infinity, 16).hierarchy;
    for (const unsigned threads : {1u, 3u})
      check_same(watched, rbpa::hrbpa(points, infinity, {.leaf_capacity = 16, .threads = threads}));
  }
}

TEST_CASE("a run without a visitor reports its time on the first level") {
  const Hierarchy alone = hierarchy(clusters(20, 3), infinity, 2);
  REQUIRE(alone.levels.size() > 3);
  CHECK(alone.levels.front().seconds > 0);
  for (std::size_t i = 1; i < alone.levels.size(); ++i) CHECK(alone.levels[i].seconds == 0);
}

TEST_CASE("an exception of the visitor ends the run at that level") {
  const Points points = uniform(500, 4);
  const std::size_t all = hierarchy(points, infinity, 1).levels.size();
  REQUIRE(all > 3);
  for (std::size_t last = 1; last <= all; ++last) {
    std::size_t calls = 0;
    CHECK_THROWS_AS(rbpa::hrbpa(points, infinity,
                                {.leaf_capacity = 1,
                                 .level_ended =
                                     [&](const EndedLevel&) {
                                       if (++calls == last) throw std::string("seen enough");
                                     }}),
                    std::string);
    CHECK(calls == last);
  }
}

TEST_CASE("nothing is reported where there are no levels") {
  for (const Points& points : {Points{}, Points{{1, 2}, {3, 4}}, Points{{0, 0}, {1, 1}, {3, 3}}})
    CHECK(watch(points, infinity, 1).seen.empty());
}

TEST_SUITE_END();
