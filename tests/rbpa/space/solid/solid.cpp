#include "rbpa/space/solid/solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "oracle/rational.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/exact.h"
#include "space/solid/solid_model.h"
#include "support/arguments.h"
#include "support/infinity.h"
#include "support/order.h"
#include "support/refusal_of.h"
#include "support/solid_sets.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;
using rbpa::solid;

TEST_SUITE_BEGIN("space");

namespace {

template <typename Number, std::size_t n>
Number determinant(const std::array<std::array<Number, n>, n>& m) {
  if constexpr (n == 1) {
    return m[0][0];
  } else {
    Number sum = 0;
    for (std::size_t column = 0; column < n; ++column) {
      if (m[0][column] == 0) continue;
      std::array<std::array<Number, n - 1>, n - 1> rest;
      for (std::size_t i = 1; i < n; ++i)
        for (std::size_t j = 0, k = 0; j < n; ++j)
          if (j != column) rest[i - 1][k++] = m[i][j];
      const Number term = m[0][column] * determinant<Number, n - 1>(rest);
      if (column % 2 == 0)
        sum += term;
      else
        sum -= term;
    }
    return sum;
  }
}

std::array<Rational, 3> coordinates(const Point3& p) { return {rational(p.x), rational(p.y), rational(p.z)}; }

/// A point, multiplied by a power of two that makes all points integers.
using Whole = boost::multiprecision::cpp_int;
using WholePoint = std::array<Whole, 3>;

std::vector<WholePoint> whole(const Points3& points) {
  Rational unit = 1;
  for (const Point3& p : points)
    for (const Rational& c : coordinates(p)) unit = std::max(unit, Rational(denominator(c)));
  std::vector<WholePoint> result;
  for (const Point3& p : points) {
    const auto c = coordinates(p);
    result.push_back(
        {numerator(Rational(c[0] * unit)), numerator(Rational(c[1] * unit)), numerator(Rational(c[2] * unit))});
  }
  return result;
}

/// Returns the sign of the in-sphere determinant of five points whose heights are raised by infinitesimals; that of the
/// lexicographically larger point outweighs the others. The determinant is linear in each.
int perturbed_sign(const std::array<WholePoint, 5>& p) {
  const auto sign_with_heights = [&](auto height) {
    std::array<std::array<Whole, 4>, 4> m;
    for (std::size_t i = 0; i < 4; ++i)
      m[i] = {p[i][0] - p[4][0], p[i][1] - p[4][1], p[i][2] - p[4][2], height(i) - height(4)};
    return determinant<Whole, 4>(m).sign();
  };
  const auto square = [&](std::size_t i) -> Whole { return p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]; };
  if (const int sign = sign_with_heights(square); sign != 0) return sign;
  std::array<std::size_t, 5> by_size = {0, 1, 2, 3, 4};
  std::sort(by_size.begin(), by_size.end(), [&](std::size_t i, std::size_t j) { return p[j] < p[i]; });
  for (const std::size_t largest : by_size)
    if (const int sign = sign_with_heights([&](std::size_t i) { return Whole(i == largest ? 1 : 0); }); sign != 0)
      return sign;
  return 0;
}

/// Returns the corners with the two least first, by an even permutation.
Tetrahedron canonical(Tetrahedron t) {
  bool is_odd = false;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (t[j] < t[i]) {
        std::swap(t[i], t[j]);
        is_odd = !is_odd;
      }
  if (is_odd) std::swap(t[2], t[3]);
  return t;
}

std::vector<std::uint32_t> lowest_of_equal(const Points3& points) {
  std::vector<std::uint32_t> lowest;
  for (const Point3& p : points)
    lowest.push_back(static_cast<std::uint32_t>(std::find(points.begin(), points.end(), p) - points.begin()));
  return lowest;
}

/// Tests every four points against every fifth.
std::vector<Tetrahedron> by_definition(const Points3& points, double alpha) {
  const std::vector<std::uint32_t> lowest = lowest_of_equal(points);
  std::vector<std::uint32_t> distinct;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] == i) distinct.push_back(i);
  const std::vector<WholePoint> p = whole(points);
  WholePoint far = {1, 1, 1};  // outside of all spheres of such points: the integers have less than 200 bits
  for (Whole& coordinate : far) coordinate <<= 2000;
  std::vector<Tetrahedron> found;
  const std::size_t n = distinct.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        for (std::size_t l = k + 1; l < n; ++l) {
          Tetrahedron t = {distinct[i], distinct[j], distinct[k], distinct[l]};
          const int side = six_volumes(points, t).sign();
          if (side == 0) continue;
          if (side < 0) std::swap(t[2], t[3]);
          const auto sign_of = [&](const WholePoint& q) {
            return perturbed_sign({p[t[0]], p[t[1]], p[t[2]], p[t[3]], q});
          };
          const int outside = sign_of(far);
          if (std::any_of(distinct.begin(), distinct.end(), [&](std::uint32_t q) {
                return std::find(t.begin(), t.end(), q) == t.end() && sign_of(p[q]) != outside;
              }))
            continue;
          if (!std::isinf(alpha) && rbpa::space::exact::compare_circumradius(points[t[0]], points[t[1]], points[t[2]],
                                                                             points[t[3]], alpha) > 0)
            continue;
          found.push_back(canonical(t));
        }
  std::sort(found.begin(), found.end());
  return found;
}

/// Checks that rows are canonical, oriented, and linked.
void check_laws(const Points3& points, const Solid& s) {
  CHECK(std::is_sorted(s.simplices.begin(), s.simplices.end()));
  CHECK(std::adjacent_find(s.simplices.begin(), s.simplices.end()) == s.simplices.end());
  REQUIRE(s.neighbors.size() == s.simplices.size());
  std::size_t wrong = 0;
  for (std::uint32_t t = 0; t < s.simplices.size(); ++t) {
    const Tetrahedron& corners = s.simplices[t];
    wrong += canonical(corners) != corners;
    wrong += rbpa::space::exact::orientation(points[corners[0]], points[corners[1]], points[corners[2]],
                                             points[corners[3]]) <= 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t other = s.neighbors[t][k];
      if (other == Solid::none) continue;
      REQUIRE(other < s.simplices.size());
      // The neighbor has the same three corners, and its fourth corner is not one of this row.
      std::size_t back = 4, common = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        if (s.neighbors[other][j] == t) back = j;
        common += std::count(corners.begin(), corners.end(), s.simplices[other][j]) > 0;
      }
      REQUIRE(back < 4);
      wrong += common != 3 || std::count(corners.begin(), corners.end(), s.simplices[other][back]) != 0;
      wrong += std::count(s.simplices[other].begin(), s.simplices[other].end(), corners[k]) != 0;
    }
  }
  CHECK(wrong == 0);
  // Faces without a neighbor are those of one tetrahedron only.
  std::vector<std::array<std::uint32_t, 3>> faces, open;
  for (std::size_t t = 0; t < s.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      Tetrahedron c = s.simplices[t];
      c[k] = Solid::none;
      std::sort(c.begin(), c.end());
      faces.push_back({c[0], c[1], c[2]});
      if (s.neighbors[t][k] == Solid::none) open.push_back(faces.back());
    }
  std::sort(faces.begin(), faces.end());
  for (const auto& face : open) {
    const auto [first, last] = std::equal_range(faces.begin(), faces.end(), face);
    CHECK(last - first == 1);
  }
  // Isolated points, corners and duplicates are all points, once each.
  std::vector<int> seen(points.size(), 0);
  for (const Tetrahedron& t : s.simplices)
    for (const std::uint32_t corner : t) seen[corner] = 1;
  const std::vector<std::uint32_t> lowest = lowest_of_equal(points);
  for (const std::uint32_t i : s.isolated) CHECK(seen[i]++ == 0);
  CHECK(std::is_sorted(s.isolated.begin(), s.isolated.end()));
  for (const rbpa::Duplicate& d : s.duplicates) {
    CHECK(seen[d.index]++ == 0);
    CHECK(d.stands_for == lowest[d.index]);
    CHECK(d.stands_for < d.index);
  }
  CHECK(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
  CHECK(s.distinct + s.duplicates.size() == points.size());
}

/// Returns the volume from the faces without a neighbor alone (divergence theorem).
Rational volume_within(const Points3& points, const Solid& s) {
  static constexpr std::array<std::array<std::size_t, 3>, 4> outward = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  Rational sum = 0;
  for (std::size_t t = 0; t < s.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      if (s.neighbors[t][k] != Solid::none) continue;
      std::array<std::array<Rational, 3>, 3> m;
      for (std::size_t i = 0; i < 3; ++i) m[i] = coordinates(points[s.simplices[t][outward[k][i]]]);
      sum += determinant<Rational, 3>(m);
    }
  return sum / 6;
}

}  // namespace

TEST_CASE("the tetrahedra of few points of every kind follow the definition, in rational numbers") {
  Random random(91);
  std::size_t tetrahedra = 0, filtered = 0;
  for (int k = 0; k < space_kinds; ++k) {
    if (static_cast<SpaceKind>(k) == SpaceKind::extreme) continue;  // rationals of 10,000 bits: CGAL compares those
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (int trial = 0; trial < trials(40); ++trial) {
      const Points3 points = space_set(static_cast<SpaceKind>(k), 4 + random.below(5), random);
      const Solid all = solid(points, infinity);
      CHECK(all.simplices == by_definition(points, infinity));
      check_laws(points, all);
      const double alpha = space_radius(points, random);
      const Solid some = solid(points, alpha);
      CHECK(some.simplices == by_definition(points, alpha));
      check_laws(points, some);
      tetrahedra += all.simplices.size();
      filtered += some.simplices.size();
    }
  }
  CHECK(tetrahedra > static_cast<std::size_t>(trials(1000)));
  CHECK(filtered > static_cast<std::size_t>(trials(200)));
  CHECK(filtered < tetrahedra);
}

TEST_CASE("ties of integers too large for double follow the definition") {
  Random random(90);
  const Points3 grid_points = turned_grid(27, 1);
  for (int trial = 0; trial < trials(60); ++trial) {
    Points3 points = grid_points;
    random.shuffle(points);
    points.resize(8);
    CHECK(solid(points, infinity).simplices == by_definition(points, infinity));
  }
}

TEST_CASE("shuffled and scaled points have the same solid") {
  Random random(92);
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < 6; ++trial) {
      CAPTURE(name(static_cast<SpaceKind>(k)));
      Points3 points = space_set(static_cast<SpaceKind>(k), 60, random);
      sort_distinct(points);
      const double alpha = trial == 0 ? infinity : space_radius(points, random);
      const Solid expected = solid(points, alpha);
      check_laws(points, expected);

      const std::vector<std::uint32_t> order = random_order(points.size(), random);
      const Points3 shuffled = in_order(points, order);
      std::vector<Tetrahedron> renamed = solid(shuffled, alpha).simplices;
      for (Tetrahedron& t : renamed) {
        for (std::uint32_t& corner : t) corner = order[corner];
        t = canonical(t);
      }
      std::sort(renamed.begin(), renamed.end());
      CHECK(renamed == expected.simplices);

      if (static_cast<SpaceKind>(k) == SpaceKind::extreme) continue;
      for (const double scale : {0x1p-900, 0x1p-100, 0x1p300, 0x1p1000}) {
        Points3 scaled;
        for (const Point3& p : points) scaled.push_back({scale * p.x, scale * p.y, scale * p.z});
        const Solid other = solid(scaled, scale * alpha);
        CHECK(other.simplices == expected.simplices);
        CHECK(other.neighbors == expected.neighbors);
      }
    }
}

TEST_CASE("the solid of alpha has the tetrahedra of the triangulation whose exact circumradius is at most alpha") {
  Random random(93);
  for (const SpaceKind kind : {SpaceKind::cube, SpaceKind::grid, SpaceKind::near_sphere, SpaceKind::clusters}) {
    const Points3 points = space_set(kind, 120, random);
    const Solid all = solid(points, infinity);
    std::vector<Tetrahedron> before;
    for (const double alpha : {0.05, 0.2, 0.5, std::sqrt(0.5), 0.75, std::sqrt(0.75), 1.0, 1.5, 10.0}) {
      const Solid some = solid(points, alpha);
      CHECK(std::includes(some.simplices.begin(), some.simplices.end(), before.begin(), before.end()));
      before = all.simplices;
      std::erase_if(before, [&](const Tetrahedron& t) {
        return rbpa::space::exact::compare_circumradius(points[t[0]], points[t[1]], points[t[2]], points[t[3]], alpha) >
               0;
      });
      CHECK(some.simplices == before);
      CHECK(volume(points, some) == volume_within(points, some));
    }
  }
}

TEST_CASE("the condition is closed: boxes of diagonal 9 are full at alpha 4.5, and empty a double below") {
  for (const double scale : {1.0, 0x1p-40, 0x1p500}) {
    const Points3 points = corners_of_bricks(3, 4, 3, {scale * 6, scale * 6, scale * 3});
    const Solid at = solid(points, scale * 4.5);
    CHECK(at.simplices == solid(points, infinity).simplices);
    CHECK(at.isolated.empty());
    if (scale == 1) CHECK(volume(points, at) == 12 * 18 * 6);
    const Solid below = solid(points, std::nextafter(scale * 4.5, 0));
    CHECK(below.simplices.empty());
    CHECK(below.isolated.size() == points.size());
  }
}

TEST_CASE("grids fill their box, whatever the last bits of their pitch") {
  for (const double pitch : {1.0, 0.1, 0x1.fffffffffffffp-3}) {
    const Points3 points = corners_of_bricks(6, 6, 6, {pitch, pitch, pitch});
    const Solid s = solid(points, infinity);
    check_laws(points, s);
    const Rational side = rational(pitch * 5);
    CHECK(volume(points, s) == side * side * side);
    CHECK(volume_within(points, s) == side * side * side);
  }
}

TEST_CASE("a point in the middle of many on a sphere is inserted into one cavity that holds nearly everything") {
  Random random(94);
  Points3 points = space_set(SpaceKind::near_sphere, 2000, random);
  const Solid hollow = solid(points, 0.5);
  CHECK(hollow.simplices.size() < points.size());
  points.push_back({0, 0, 0});
  const Solid full = solid(points, infinity);
  check_laws(points, full);
  // Nearly all tetrahedra contain the center, so that their circumradius is little above 1/2.
  CHECK(solid(points, 0.51).simplices.size() > 3 * points.size() / 2);
}

TEST_CASE("points of a plane or a line, and few points, have no tetrahedron") {
  Random random(95);
  for (const SpaceKind kind : {SpaceKind::plane, SpaceKind::plane_grid, SpaceKind::line})
    for (const std::size_t count : {1u, 2u, 3u, 4u, 50u}) {
      const Points3 points = space_set(kind, count, random);
      const Solid s = solid(points, infinity);
      CHECK(s.simplices.empty());
      CHECK(s.isolated.size() == s.distinct);
      check_laws(points, s);
    }
  const Solid none = solid({}, 1);
  CHECK(none.simplices.empty());
  CHECK(none.distinct == 0);
  CHECK(solid(Points3(7, Point3{1, 2, 3}), 1).duplicates.size() == 6);
}

TEST_CASE("the lowest index represents duplicates, and isolated points are in no tetrahedron") {
  const Points3 points = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  const Solid s = solid(points, 1);
  CHECK(s.simplices == std::vector<Tetrahedron>{{1, 2, 3, 5}});
  CHECK(s.neighbors == std::vector<Tetrahedron>{{Solid::none, Solid::none, Solid::none, Solid::none}});
  CHECK(s.duplicates == std::vector<rbpa::Duplicate>{{4, 1}, {6, 2}});
  CHECK(s.isolated == std::vector<std::uint32_t>{0});
  CHECK(s.distinct == 5);
}

TEST_CASE("a solid has the same bytes with any number of threads; a run can be watched and cancelled") {
  Random random(96);
  const Points3 points = space_set(SpaceKind::cube, 30000, random);
  std::size_t calls = 0, last = 0;
  const auto watch = [&](const rbpa::Progress& p) {
    ++calls;
    CHECK(p.triangles >= last);
    CHECK(p.triangles <= p.points);
    CHECK(p.points == points.size());
    last = p.triangles;
    return true;
  };
  const Solid one = solid(points, 0.1, {.threads = 1, .progress = watch});
  CHECK(calls > 3);
  CHECK(last > points.size() / 2);
  CHECK(one.simplices.size() > points.size());
  for (const unsigned threads : {2u, 0u}) {
    const Solid several = solid(points, 0.1, {.threads = threads});
    CHECK(several.simplices == one.simplices);
    CHECK(several.neighbors == one.neighbors);
  }
  const Solid without = solid(points, 0.1, {.neighbors = false});
  CHECK(without.simplices == one.simplices);
  CHECK(without.neighbors.empty());
  Points3 grid;  // of which many spheres pass through eight points, so that triples are given up for insertion
  for (int i = 0; i < 30 * 30 * 30; ++i)
    grid.push_back({static_cast<double>(i % 30), static_cast<double>(i / 30 % 30), static_cast<double>(i / 900)});
  last = 0;
  solid(grid, 1, {.threads = 1, .progress = [&](const rbpa::Progress& p) {
                    CHECK(p.triangles >= last);
                    last = p.triangles;
                    return true;
                  }});
  CHECK(last == grid.size());
  for (const std::size_t calls_before : {0u, 1u, 3u}) {
    std::size_t left = calls_before;
    CHECK_THROWS_AS(solid(points, 1, {.progress = [&](auto) { return left-- > 0; }}), rbpa::Cancelled);
  }
}

TEST_CASE("invalid input is refused by name") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto refusal = [](auto call) -> std::string { return refusal_of<rbpa::InvalidInput>(call); };
  CHECK(refusal([&] { solid(points, 0); }) == "alpha is 0, expected a radius above 0, or infinity");
  CHECK(refusal([&] { solid(points, -1); }) == "alpha is -1, expected a radius above 0, or infinity");
  CHECK(refusal([&] { solid(points, none); }) == "alpha is nan, expected a radius above 0, or infinity");
  CHECK(refusal([&] {
          solid(Points3{{0, 0, 0}, {1, none, 0}}, 1);
        }) == "point 1 is (1, nan, 0), expected finite coordinates");
  CHECK(refusal([&] {
          solid(Points3{{0, -infinity, 0}}, 1);
        }) == "point 0 is (0, -inf, 0), expected finite coordinates");
}

TEST_SUITE_END();
