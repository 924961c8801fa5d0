#include "rbpa/plane/patches/skipped_tiles.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <functional>
#include <set>
#include <vector>

#include "rbpa/plane/alpha_complex.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::SkippedTiles;

TEST_SUITE_BEGIN("patches");

namespace {

/// Returns the tiles that are joined, of `tiles` tiles, each of which owns 80 sites and settles settled(tile) stars.
std::set<std::size_t> joined(std::size_t tiles, const std::function<std::size_t(std::size_t)>& settled) {
  SkippedTiles skipped;
  std::set<std::size_t> joined;
  for (std::size_t i = 0; i < tiles; ++i) {
    if (skipped.contains(i)) continue;
    joined.insert(i);
    skipped.joined(i, 80, settled(i));
  }
  return joined;
}

}  // namespace

TEST_CASE("no tile is skipped while tiles settle a few of their stars, or fewer than four in a row do not") {
  CHECK(joined(100, [](std::size_t) { return 2; }).size() == 100);
  CHECK(joined(100, [](std::size_t i) { return i % 4 == 0 ? 2 : 0; }).size() == 100);
}

TEST_CASE("after four tiles in vain four are skipped, then eight, 16, … 64") {
  const std::vector<std::size_t> expected = {0, 1, 2, 3, 8, 17, 34, 67, 132, 197};
  const std::set<std::size_t> found = joined(200, [](std::size_t) { return 1; });
  CHECK(std::vector<std::size_t>(found.begin(), found.end()) == expected);
}

TEST_CASE("a tile that settles more ends the skipping") {
  const std::set<std::size_t> found = joined(40, [](std::size_t i) { return i == 17 ? 2 : 1; });
  const std::vector<std::size_t> expected = {0, 1, 2, 3, 8, 17, 18, 19, 20, 21, 26, 35};
  CHECK(std::vector<std::size_t>(found.begin(), found.end()) == expected);
}

TEST_CASE("tiles without sites do not cause skipping") {
  SkippedTiles skipped;
  for (std::size_t i = 0; i < 10; ++i) skipped.joined(i, 0, 0);
  CHECK_FALSE(skipped.contains(10));
}

TEST_CASE("a cloud next to a curve has the same mesh by any number of threads, with the triangles of the arrays") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Points points = along_a_curve(60000);
    for (const rbpa::Point& p : uniform(60000, seed + 7)) points.push_back({p.x + 2, p.y});
    const rbpa::SolidAlphaComplex one = rbpa::rbpa(points, 0.3, {.threads = 1});
    for (const unsigned threads : {2u, 4u}) {
      const rbpa::SolidAlphaComplex some = rbpa::rbpa(points, 0.3, {.threads = threads});
      REQUIRE(some.mesh.n_faces() == one.mesh.n_faces());
      for (const auto face : one.mesh.faces())
        REQUIRE(some.mesh.halfedge_handle(face) == one.mesh.halfedge_handle(face));
    }
    CHECK(rbpa::triangles(one) == rbpa::alpha_complex(points, 0.3).triangles);
  }
}

TEST_SUITE_END();
