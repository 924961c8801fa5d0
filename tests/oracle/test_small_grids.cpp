// Compares rbpa() and hrbpa() with brute force and CGAL on tiny sets of integer points, where nearly everything is a
// tie.
//   --count=N    number of random sets (2,000)
//   --first=N    the number of the first of them (0): a failure names its number
//   --rows=N     all subsets of a grid of 4 columns and N rows (3)
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>

#include "oracle/brute_force.h"
#include "oracle/check.h"
#include "oracle/delaunay.h"
#include "rbpa/paper.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/levels.h"
#include "support/random.h"
#include "support/shrink.h"

namespace rbpa_test {
namespace {

constexpr std::size_t max_for_brute_force = 12;

/// Returns the circumradius of three of the points, or the double before or after it.
double circumradius_of_some(const Points& points, Random& random) {
  const auto some = [&] { return points[random.below(points.size())]; };
  const rbpa::Point a = some(), b = some(), c = some();
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const auto square = [](const rbpa::Point& p, const rbpa::Point& q) {
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
  };
  if (area == 0) return 1;
  const double radius = std::sqrt(square(a, b) * square(b, c) * square(c, a)) / (2 * std::abs(area));
  const double beside[] = {radius, radius, std::nextafter(radius, 0.0), std::nextafter(radius, INFINITY)};
  return beside[random.below(4)];
}

double some_alpha(const Points& points, Random& random) {
  switch (random.below(5)) {
    case 0:
      return INFINITY;
    case 1:
      return 0.5 * random.integer(1, 12);
    case 2:
      return random.between(0.5, 4);
    default:
      return circumradius_of_some(points, random);
  }
}

Points some_points(Random& random) {
  const int columns = random.integer(2, 8);
  const auto count = static_cast<std::size_t>(random.integer(3, static_cast<int>(max_for_brute_force)));
  return random_grid(columns, count, random.chance(0.2), random.bits());
}

/// Map of the plane that keeps integers exact, and its factor for radii.
struct Map {
  double xx = 1, xy = 0, yx = 0, yy = 1;  ///< a quarter turn, or its mirror image
  double dx = 0, dy = 0;
  int exponent = 0;  ///< exponent of a power of two, applied last

  rbpa::Point operator()(const rbpa::Point& p) const {
    return {std::ldexp(xx * p.x + xy * p.y + dx, exponent), std::ldexp(yx * p.x + yy * p.y + dy, exponent)};
  }
};

Points image(const Points& points, const Map& map) {
  Points images;
  for (const rbpa::Point& p : points) images.push_back(map(p));
  return images;
}

void check_against_brute_force(const Points& points, double alpha) {
  const std::vector<Triangle> expected = brute_force(points, alpha);
  REQUIRE_MESSAGE(DelaunayOracle(points).triangles(alpha) == expected, "the oracles disagree");
  std::string wrong;
  try {
    wrong = wrong_with(rbpa::rbpa(points, alpha), points, expected);
  } catch (const std::exception& error) {
    wrong = error.what();
  }
  REQUIRE_MESSAGE(wrong.empty(), report(wrong, points, alpha));
}

void check_against_cgal(const Points& points, double alpha, Rbpa compute = rbpa::rbpa) {
  const std::string wrong = wrong_with_rbpa(points, alpha, compute);
  REQUIRE_MESSAGE(wrong.empty(), report(wrong, points, alpha, compute));
}

/// Checks the final complex, and the mesh after every level. Returns: the number of levels.
template <typename Compute>
std::size_t check_hierarchy(Compute compute, const Points& points, double alpha, std::size_t capacity,
                            const DelaunayOracle& oracle) {
  INFO("leaf capacity ", capacity, ", alpha ", literal(alpha));
  const rbpa::Hierarchy h = compute(points, alpha, capacity);
  const std::string wrong = wrong_with(h.complex, points, oracle.triangles(alpha));
  REQUIRE_MESSAGE(wrong.empty(), wrong);
  const std::string wrong_levels = wrong_numbers(h, alpha);
  REQUIRE_MESSAGE(wrong_levels.empty(), wrong_levels);
  for (std::size_t i = 0; i < h.levels.size(); ++i) {
    INFO("after level ", h.levels[i].number, ", alpha ", literal(h.levels[i].alpha));
    REQUIRE(triangles_after(h, i) == oracle.triangles(h.levels[i].alpha));
  }
  return h.levels.size();
}

constexpr std::array<double, 4> even{0, 1, 2, 3}, stretched{0, 1, 4, 20};

/// Calls check(points) for every subset of a grid with these coordinates.
template <typename Check>
void for_subsets(const std::array<double, 4>& coordinates, const Check& check) {
  Points grid;
  for (std::size_t y = 0; y < std::min<std::size_t>(argument("rows", 3), coordinates.size()); ++y)
    for (const double x : coordinates) grid.push_back({x, coordinates[y]});
  for (std::uint32_t subset = 0; subset < std::uint32_t{1} << grid.size(); ++subset) {
    Points points;
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (subset >> i & 1U) points.push_back(grid[i]);
    INFO(literal(points));
    check(points);
  }
}

template <typename Check>
void for_random_sets(std::uint64_t seed, const Check& check) {
  const std::uint64_t first = argument("first", 0), count = argument("count", 2000);
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed + 1000003 * number);
    const Points points = some_points(random);
    const double alpha = some_alpha(points, random);
    INFO("set number ", number, ": ", literal(points), ", alpha ", literal(alpha));
    check(points, alpha, random);
  }
}

TEST_CASE("sets that were once wrong stay right") {
  struct {
    Points points;
    double alpha;
  } const cases[] = {
      // The ball comes to rest on three points at once: a square whose circumradius is alpha.
      {{{2, 2}, {3, 1}, {2, 0}, {0, 1}, {1, 1}}, 1},
      {{{3, 4}, {5, 4}, {4, 5}, {1, 0}, {4, 3}}, 1},
      {{{-5, 3}, {-5, 5}, {-6, 4}, {-4, 4}, {-3, 3}, {-5, 2}}, 1},
      {{{0, 2}, {1, 0}, {1, 1}, {1, 3}, {2, 2}, {3, 1}}, 1},
      {{{0, 0}, {0, 3}, {1, 1}, {1, 3}, {3, 0}, {3, 2}}, 1.25},
      // Points are collinear with the edge that is pivoted.
      {{{0, -5}, {3, 0}, {0, -3}, {0, -4}, {3, -4}}, 3.8645399530840949},
      {{{2, 3}, {0, 1}, {2, 4}, {2, 0}}, 2.5},
  };
  for (const auto& [points, alpha] : cases) {
    check_against_brute_force(points, alpha);
    check_against_cgal(points, alpha, rbpa::paper::rbpa);
  }
}

TEST_CASE("the complex of random sets on small grids is that of the definition") {
  for_random_sets(1, [](const Points& points, double alpha, Random&) { check_against_brute_force(points, alpha); });
}

TEST_CASE("the paper's RBPA finds the same complex of random sets on small grids") {
  for_random_sets(
      2, [](const Points& points, double alpha, Random&) { check_against_cgal(points, alpha, rbpa::paper::rbpa); });
}

TEST_CASE("after every level of hrbpa() of random sets on small grids the mesh is the complex of its radius") {
  for_random_sets(7, [](const Points& points, double alpha, Random& random) {
    check_hierarchy(hierarchy, points, alpha, random.below(5) + 1, DelaunayOracle(points));
  });
}

TEST_CASE(
    "after every level of the paper's HRBPA of random sets on small grids the mesh is the complex of its radius") {
  for_random_sets(8, [](const Points& points, double alpha, Random& random) {
    check_hierarchy(hierarchy_by_paper, points, alpha, random.below(5) + 1, DelaunayOracle(points));
  });
}

TEST_CASE("the order of the input does not matter in random sets on small grids") {
  for_random_sets(3, [](const Points& points, double alpha, Random& random) {
    Points shuffled = points;
    random.shuffle(shuffled);
    const auto original = triangles(rbpa::rbpa(points, alpha));
    REQUIRE(translated(triangles(rbpa::rbpa(shuffled, alpha)), shuffled, points) == original);
  });
}

TEST_CASE("integer translations and powers of two keep the triangles of random sets on small grids") {
  for_random_sets(4, [](const Points& points, double alpha, Random& random) {
    Map map;
    map.dx = random.integer(-1000000, 1000000);
    map.dy = random.integer(-1000000, 1000000);
    // Also beyond 2^±1000, as long as integers of 20 bits stay exact.
    map.exponent = random.chance(0.5) ? random.integer(-1000, 1000) : random.integer(-30, 30);
    const Points images = image(points, map);
    const double radius = std::ldexp(alpha, map.exponent);
    INFO("their images: ", literal(images), ", alpha ", literal(radius));
    REQUIRE(triangles(rbpa::rbpa(images, radius)) == triangles(rbpa::rbpa(points, alpha)));
  });
}

TEST_CASE("the complex of turned and mirrored random sets on small grids is that of the definition") {
  // The perturbation follows the coordinates, so that cocircular points may be cut in another way: the oracle
  // determines how.
  for_random_sets(5, [](const Points& points, double alpha, Random& random) {
    constexpr Map maps[] = {{0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}, {-1, 0, 0, 1}, {0, 1, 1, 0}};
    check_against_cgal(image(points, maps[random.below(std::size(maps))]), alpha);
  });
}

TEST_CASE("a smaller alpha gives a subset in random sets on small grids") {
  for_random_sets(6, [](const Points& points, double alpha, Random& random) {
    const double other = some_alpha(points, random);
    const auto smaller = triangles(rbpa::rbpa(points, std::min(alpha, other)));
    const auto larger = triangles(rbpa::rbpa(points, std::max(alpha, other)));
    REQUIRE(std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end()));
  });
}

TEST_CASE("the complex of every subset of a small grid is that of the definition") {
  for_subsets(even, [](const Points& points) {
    for (const double alpha : {0.5, 0.75, 1.0, 1.25, 2.5, double(INFINITY)}) {
      INFO("alpha ", literal(alpha));
      check_against_cgal(points, alpha, rbpa::paper::rbpa);
      if (points.size() <= 8)
        check_against_brute_force(points, alpha);
      else
        check_against_cgal(points, alpha);
    }
  });
}

TEST_CASE("after every level of hrbpa() of every subset of a small grid the mesh is the complex of its radius") {
  std::size_t most = 0;
  for (const auto& coordinates : {even, stretched})
    for_subsets(coordinates, [&](const Points& points) {
      const DelaunayOracle oracle(points);
      for (const std::size_t capacity : {1u, 2u, 5u})
        for (const double alpha : {0.75, 1.25, 10.0, double(INFINITY)}) {
          most = std::max(most, check_hierarchy(hierarchy, points, alpha, capacity, oracle));
          check_hierarchy(hierarchy_by_paper, points, alpha, capacity, oracle);
        }
    });
  CHECK(most >= 5);
}

}  // namespace
}  // namespace rbpa_test
