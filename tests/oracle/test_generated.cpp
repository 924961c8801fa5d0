// Checks rbpa() on every generated set, against CGAL and against itself.
//   --largest=N   only sets with at most that many points
//   --paper=N     the paper's method, which is slow, only on sets with at most that many points
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "oracle/check.h"
#include "oracle/delaunay.h"
#include "rbpa/paper.h"
#include "support/arguments.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

bool of_asked_size(const Points& points) { return points.size() <= argument("largest", 1000000); }

std::vector<double> all_alphas(const NamedSet& set, const Points& points) {
  std::vector<double> alphas = usual_alphas(points);
  alphas.insert(alphas.end(), set.alphas.begin(), set.alphas.end());
  std::sort(alphas.begin(), alphas.end());
  return alphas;
}

TEST_CASE("the solid alpha complex is the Delaunay triangles of circumradius at most alpha") {
  std::size_t empty = 0, whole = 0, between = 0;
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (!of_asked_size(points)) continue;
    const DelaunayOracle oracle(points);
    const std::size_t all = oracle.triangles(INFINITY).size();
    for (const double alpha : all_alphas(set, points)) {
      INFO(set.name, ", ", points.size(), " points, alpha ", literal(alpha));
      const std::vector<Triangle> expected = oracle.triangles(alpha);
      ++(expected.empty() ? empty : expected.size() == all ? whole : between);
      const std::string wrong = wrong_with(rbpa::rbpa(points, alpha), points, expected);
      CHECK_MESSAGE(wrong.empty(), report(wrong, points, alpha));
    }
  }
  // The sets and radii are worth their time only if all three sorts occur.
  CHECK(empty > 30);
  CHECK(whole > 30);
  CHECK(between > 60);
}

TEST_CASE("the order of the input does not matter") {
  Random random(11);
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (!of_asked_size(points)) continue;
    for (const double alpha : all_alphas(set, points)) {
      INFO(set.name, ", ", points.size(), " points, alpha ", literal(alpha));
      Points shuffled = points;
      random.shuffle(shuffled);
      const auto original = triangles(rbpa::rbpa(points, alpha));
      const auto other = translated(triangles(rbpa::rbpa(shuffled, alpha)), shuffled, points);
      const std::string wrong = difference(original, other);
      CHECK_MESSAGE(wrong.empty(), wrong);
    }
  }
}

TEST_CASE("the paper's RBPA finds the same complex") {
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (!of_asked_size(points) || points.size() > argument("paper", 1000000)) continue;
    const DelaunayOracle oracle(points);
    for (const double alpha : all_alphas(set, points)) {
      // Cells of side 2α hold all points in this case.
      if (std::isinf(alpha) && points.size() > 1000) continue;
      INFO(set.name, ", ", points.size(), " points, alpha ", literal(alpha));
      const std::string wrong = wrong_with(rbpa::paper::rbpa(points, alpha), points, oracle.triangles(alpha));
      CHECK_MESSAGE(wrong.empty(), report(wrong, points, alpha, rbpa::paper::rbpa));
    }
  }
}

TEST_CASE("a smaller alpha gives a subset") {
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (!of_asked_size(points)) continue;
    std::vector<Triangle> smaller;
    for (const double alpha : all_alphas(set, points)) {
      INFO(set.name, ", ", points.size(), " points, alpha ", literal(alpha));
      std::vector<Triangle> larger = triangles(rbpa::rbpa(points, alpha));
      CHECK(std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end()));
      smaller = std::move(larger);
    }
  }
}

}  // namespace
}  // namespace rbpa_test
