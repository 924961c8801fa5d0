#include "rbpa/plane/triangles_by_level.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include "far_sets.h"
#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/hrbpa.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/levels.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/shrink.h"

using namespace rbpa_test;

TEST_SUITE_BEGIN("hierarchy");

namespace {

/// Returns the first difference from hrbpa() or alpha_complex(); "" when there is none.
std::string difference_from_mesh(const Points& points, double alpha, std::size_t leaf_capacity, unsigned threads) {
  const rbpa::TrianglesByLevel made = rbpa::triangles_by_level(
      points, alpha, {.leaf_capacity = leaf_capacity, .neighbors = true, .boundary = true, .threads = threads});
  const rbpa::Hierarchy mesh = hierarchy(points, alpha, leaf_capacity);
  const rbpa::AlphaComplex direct =
      rbpa::alpha_complex(points, alpha, {.neighbors = true, .boundary = true, .threads = 1});
  if (made.complex.triangles != direct.triangles) return "triangles";
  if (made.complex.neighbors != direct.neighbors) return "neighbors";
  if (made.complex.boundary != direct.boundary) return "boundary";
  if (made.complex.isolated != direct.isolated || made.complex.duplicates != direct.duplicates ||
      made.complex.distinct != direct.distinct)
    return "points";
  if (made.least_radius != mesh.least_radius) return "least radius";
  if (made.levels.size() != mesh.levels.size()) return "number of levels";
  if (made.level.size() != made.complex.triangles.size()) return "levels of triangles";
  std::vector<std::size_t> before(made.levels.size(), 0);
  for (std::size_t i = 0; i < made.levels.size(); ++i) {
    const rbpa::Level& level = mesh.levels[i];
    if (made.levels[i] != rbpa::ArrayLevel{level.alpha, level.number, level.triangles})
      return "level " + std::to_string(i);
    std::vector<Triangle> until;
    for (std::size_t t = 0; t < made.level.size(); ++t)
      if (made.level[t] <= i) until.push_back(made.complex.triangles[t]);
    if (until != triangles_after(mesh, i)) return "triangles until level " + std::to_string(i);
  }
  return "";
}

void check_levels(const Points& points, double alpha, std::size_t leaf_capacity, unsigned threads = 1) {
  CAPTURE(alpha);
  CAPTURE(leaf_capacity);
  CAPTURE(threads);
  const std::string wrong = difference_from_mesh(points, alpha, leaf_capacity, threads);
  if (wrong.empty()) return;
  const Points few = shrink(
      points, [&](const Points& some) { return !difference_from_mesh(some, alpha, leaf_capacity, threads).empty(); });
  FAIL_CHECK(wrong, "\nshrunk: ", difference_from_mesh(few, alpha, leaf_capacity, threads), "\n", literal(few));
}

}  // namespace

TEST_CASE("levels in arrays equal those of the mesh, for generated sets, alphas and leaves") {
  Random random(31);
  std::size_t sets = 0;
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (points.size() > 3000) continue;
    ++sets;
    CAPTURE(set.name);
    for (const double alpha : set.alphas) check_levels(points, alpha, std::size_t{1} << random.below(7));
    check_levels(points, infinity, std::size_t{1} << random.below(7));
  }
  CHECK(sets > 20);
}

TEST_CASE("levels in arrays by several threads, with tiles, equal those of the mesh") {
  const Points points = uniform(30000, 32);
  for (const double alpha : {0.005, infinity}) check_levels(points, alpha, 16, 4);
}

TEST_CASE("levels in arrays equal those of the mesh where doubles are far apart") {
  for_each_far_set([&](std::string_view name, const Points& points, const Points& far) {
    CAPTURE(name);
    Points both = points;
    both.insert(both.end(), far.begin(), far.end());
    for (const Points& some : {far, both}) check_levels(some, infinity, 4);
  });
}

TEST_CASE("levels in arrays of trivial input are empty, and wrong calls are refused") {
  CHECK(rbpa::triangles_by_level({}, 1).levels.empty());
  const Points line = {{0, 0}, {1, 1}, {2, 2}, {1, 1}};
  const rbpa::TrianglesByLevel made = rbpa::triangles_by_level(line, infinity);
  CHECK(made.levels.empty());
  CHECK(made.least_radius == 0);
  CHECK(made.complex.isolated == rbpa::alpha_complex(line, infinity).isolated);
  CHECK(made.complex.duplicates.size() == 1);
  CHECK_THROWS_AS(rbpa::triangles_by_level(line, 0), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::triangles_by_level(line, 1, {.leaf_capacity = 0}), meshops::ContractViolation);
  const Points square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK_THROWS_AS(rbpa::triangles_by_level(square, 1, {.progress = [](const rbpa::Progress&) { return false; }}),
                  rbpa::Cancelled);
}

TEST_SUITE_END();
