#include "rbpa/space/normals/sides/side_confidence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/normals/sides/compare_normals.h"
#include "rbpa/space/surface/neighbors/fit_plane.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::EstimatedNormals;
using rbpa::Point3;
using namespace rbpa::space;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns, for each vertex of the tree, whether it is below `top`, which is included.
std::vector<bool> below(const OrientationTree& tree, std::uint32_t top) {
  std::vector<bool> is_below(tree.parent.size(), false);
  is_below[top] = true;
  for (const std::uint32_t v : tree.order)
    is_below[v] = is_below[v] || (tree.parent[v] != v && is_below[tree.parent[v]]);
  return is_below;
}

/// Computes the confidence cut by cut, each over all edges of the graph.
std::vector<double> by_every_cut(const Neighborhoods& near, const Points3& normals, const OrientationTree& tree,
                                 const OuterSides& sides) {
  const auto root = static_cast<std::uint32_t>(near.points.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t i = 0; i < root; ++i)
    for (const std::uint32_t j : near.around(i)) edges.insert(std::minmax(i, j));
  const auto cut = [&](std::uint32_t top) {
    const std::vector<bool> inside = below(tree, top);
    double sum = 0, all = 0;
    for (const auto& [i, j] : edges) {
      if (inside[i] == inside[j]) continue;
      const auto c = compare_normals<double>(near.points[i], normals[i], near.points[j], normals[j]);
      double weight = std::max(0.0, std::abs(c.agreement) - c.tilt);
      if (weight < 0x1p-20) weight = 0;  // a rounding error is not a vote
      sum += c.agreement > 0 ? weight : -weight;
      all += weight;
    }
    return all > 0 ? std::max(0.0, sum / all) : 0.0;
  };
  std::vector<double> confidence(root, 1);
  for (std::uint32_t seed = 0; seed < root; ++seed) {
    if (tree.parent[seed] != root) continue;
    const std::vector<bool> part = below(tree, seed);
    const auto size = std::count(part.begin(), part.end(), true);
    // The middle is the lowest vertex with more than half of the part below it.
    std::vector<bool> has_middle = part;
    for (std::uint32_t v = 0; v < root; ++v) {
      const std::vector<bool> inside = below(tree, v);
      if (part[v] && 2 * std::count(inside.begin(), inside.end(), true) > size)
        for (std::uint32_t w = 0; w < root; ++w) has_middle[w] = has_middle[w] && inside[w];
    }
    std::uint32_t middle = seed;
    for (const std::uint32_t v : tree.order)
      if (v != root && has_middle[v]) {
        middle = v;
        break;
      }
    for (std::uint32_t v = 0; v < root; ++v) {
      if (!part[v]) continue;
      if (!sides.empty() && sides.side[seed] != 0) confidence[v] = sides.vote[seed];
      for (std::uint32_t w = 0; w < root; ++w)
        if (part[w] && w != seed && below(tree, w)[v] != below(tree, w)[middle])
          confidence[v] = std::min(confidence[v], cut(w));
    }
  }
  return confidence;
}

Points3 ball(std::size_t count, double noise, std::uint64_t seed) {
  Random random(seed);
  Points3 points;
  while (points.size() < count) {
    const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double size = length(p), out = (1 + noise * random.between(-1, 1)) / size;
    if (size > 0.1 && size < 1) points.push_back(out * p);
  }
  return points;
}

}  // namespace

TEST_CASE("the confidence at a point is the least of the cuts between it and the middle, each over all edges") {
  Random random(61);
  double least = 1, most = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(static_cast<std::size_t>(SpaceKind::nearest)));
    const Points3 any = space_set(kind, 4 + random.below(30), random);
    const std::set<Point3> distinct(any.begin(), any.end());
    rbpa::Threads threads(1);
    auto [near, normals, flatness] =
        fit_planes<double>({distinct.begin(), distinct.end()}, 2 + random.below(6), threads, {});
    OuterSides sides;
    if (trial % 2 == 1)
      for (std::size_t i = 0; i < normals.size(); ++i) {
        sides.side.push_back(random.chance(0.9)   ? std::int8_t{0}
                             : random.chance(0.5) ? std::int8_t{1}
                                                  : std::int8_t{-1});
        sides.vote.push_back(sides.side[i] == 0 ? 0 : random.between(0.35, 1));
      }
    const OrientationTree tree = orient_normals<double>(near, normals, {}, sides.side);
    const std::vector<double> found = side_confidence<double>(near, normals, tree, sides, {});
    const std::vector<double> expected = by_every_cut(near, normals, tree, sides);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CAPTURE(trial);
      CHECK(std::abs(found[i] - expected[i]) < 1e-4);
      least = std::min(least, found[i]);
      most = std::max(most, found[i]);
    }
  }
  CHECK(least == 0);
  CHECK(most == 1);
}

TEST_CASE("the tree has all points, each after its parent") {
  Random random(62);
  const Points3 any = space_set(SpaceKind::clusters, 300, random);
  const std::set<Point3> distinct(any.begin(), any.end());
  rbpa::Threads threads(1);
  auto [near, normals, flatness] = fit_planes<double>({distinct.begin(), distinct.end()}, 5, threads, {});
  const OrientationTree tree = orient_normals<double>(near, normals, {});
  REQUIRE(tree.order.size() == near.points.size() + 1);
  CHECK(tree.order.front() == near.points.size());
  CHECK(tree.parent.back() == near.points.size());
  std::set<std::uint32_t> before = {tree.order.front()};
  for (std::size_t k = 1; k < tree.order.size(); ++k) {
    CHECK(before.count(tree.parent[tree.order[k]]) == 1);
    CHECK(before.insert(tree.order[k]).second);
  }
}

TEST_CASE("every normal of a smooth ball is confident, and those on the wrong side of noise are in doubt") {
  for (const double spacings : {0.0, 0.5, 2.0, 3.0}) {
    CAPTURE(spacings);
    const Points3 points = ball(4000, spacings * std::sqrt(4 * 3.14159265358979 / 4000), 63);
    const EstimatedNormals found = rbpa::estimate_normals_and_confidence(points);
    CHECK(found.normals == rbpa::estimate_normals(points));
    std::size_t wrong = 0, sure = 0, wrong_and_sure = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point3 &p = points[i], &n = found.normals[i];
      const bool is_wrong = dot(p, n) < 0, is_sure = found.confidence[i] >= rbpa::least_confidence;
      CHECK((found.confidence[i] >= 0 && found.confidence[i] <= 1));
      wrong += is_wrong;
      sure += is_sure;
      wrong_and_sure += is_wrong && is_sure;
    }
    if (spacings == 0) {
      CHECK(sure == points.size());
      CHECK(wrong == 0);
    } else if (spacings < 1) {
      CHECK(20 * sure > 19 * points.size());
      CHECK(wrong < 3);
    } else {
      CHECK(wrong > 50);
      CHECK(10 * wrong_and_sure < wrong);
      CHECK((spacings > 2 || sure > points.size() / 4));
    }
  }
}

TEST_CASE("outliers are in doubt themselves, and do not make other points doubtful") {
  Points3 points = ball(3000, 0, 64);
  Random random(65);
  for (int i = 0; i < 150; ++i) points.push_back({random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)});
  const EstimatedNormals found = rbpa::estimate_normals_and_confidence(points);
  const auto sure = [&](std::size_t first, std::size_t last) {
    std::size_t count = 0;
    for (std::size_t i = first; i < last; ++i) count += found.confidence[i] >= rbpa::least_confidence;
    return static_cast<double>(count) / static_cast<double>(last - first);
  };
  CHECK(sure(0, 3000) > 0.98);
  CHECK(sure(3000, 3150) < 0.5);
}

TEST_CASE("the votes of cells are the confidence where cells decide") {
  for (const double half : {0.005, 0.01, 0.02}) {
    CAPTURE(half);
    Points3 plate;
    Random random(66);
    for (int i = 0; i < 6000; ++i)
      plate.push_back({random.between(-1, 1), random.between(-1, 1), (random.chance(0.5) ? 1 : -1) * half});
    const EstimatedNormals found = rbpa::estimate_normals_and_confidence(plate);
    std::size_t wrong = 0, wrong_and_sure = 0, sure = 0;
    for (std::size_t i = 0; i < plate.size(); ++i) {
      const bool is_sure = found.confidence[i] >= rbpa::least_confidence;
      sure += is_sure;
      if (found.normals[i].z * plate[i].z > 0) continue;
      ++wrong;
      wrong_and_sure += is_sure;
    }
    CHECK(sure > (half < 0.015 ? 5000U : 3500U));
    CHECK(wrong < 10);
    CHECK(5 * wrong_and_sure <= wrong);
  }
}

TEST_CASE("the confidence does not depend on the order of the points, the threads or a power of two") {
  Random random(67);
  for (const SpaceKind kind :
       {SpaceKind::cube, SpaceKind::grid, SpaceKind::noisy_sphere, SpaceKind::plate, SpaceKind::extreme}) {
    const Points3 points = space_set(kind, 1500, random);
    const auto expected = rbpa::estimate_normals_and_confidence(points, {.threads = 1}).confidence;
    const std::vector<std::uint32_t> order = random_order(points.size(), random);
    Points3 shuffled;
    for (const std::uint32_t i : order)
      shuffled.push_back({std::ldexp(points[i].x, 3), std::ldexp(points[i].y, 3), std::ldexp(points[i].z, 3)});
    const auto found = rbpa::estimate_normals_and_confidence(shuffled, {.threads = 2}).confidence;
    REQUIRE(found.size() == order.size());
    for (std::size_t k = 0; k < order.size(); ++k) CHECK(found[k] == expected[order[k]]);
  }
}

TEST_CASE("points on a line, in all directions, or alone have no plane and no confidence") {
  for (const double c : rbpa::estimate_normals_and_confidence({{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}}).confidence)
    CHECK(c == 0);
  CHECK(rbpa::estimate_normals_and_confidence({{{5, 5, 5}}}).confidence == std::vector<double>{0});
  CHECK(rbpa::estimate_normals_and_confidence({}).confidence.empty());
  const Points3 star = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const double c : rbpa::estimate_normals_and_confidence(star).confidence) CHECK(c < 1e-12);
  const Points3 square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  CHECK(rbpa::estimate_normals_and_confidence(square).confidence == std::vector<double>(5, 1));
  // An ellipsoid of points: the ratio of the variances is 1/4.
  const Points3 box = {{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const double c : rbpa::estimate_normals_and_confidence(box, {.viewpoints = {{{0.5, 0.25, 9}}}}).confidence)
    CHECK(std::abs(c - 0.75) < 1e-12);
}

TEST_CASE("a plane seen at a grazing angle may be seen from either side") {
  Points3 level;
  for (int i = 0; i < 100; ++i) level.push_back({double(i % 10), double(i / 10), 0});
  const std::vector<Point3> above = {{4, 4, 100}}, grazing = {{1000, 0, 125}}, within = {{1000, 0, 0}},
                            at = {{0, 0, 0}};
  const auto seen_from = [&](const std::vector<Point3>& viewpoints) {
    return rbpa::estimate_normals_and_confidence(level, {.viewpoints = viewpoints}).confidence;
  };
  for (const double c : seen_from(above)) CHECK(c == 1);
  for (const double c : seen_from(grazing)) CHECK(std::abs(c - 0.5) < 0.01);  // four times 125 of about 1000
  for (const double c : seen_from(within)) CHECK(c == 0);
  CHECK(seen_from(at).front() == 0);  // a point is seen from where it is
}

TEST_SUITE_END();
