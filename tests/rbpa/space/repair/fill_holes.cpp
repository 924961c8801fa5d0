#include "rbpa/space/repair/fill_holes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::HoleOutcome;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

using Row = std::array<std::uint32_t, 3>;

struct Mesh {
  Points3 points;
  std::vector<Row> triangles;
};

/// Returns the unit squares of a grid, each as two triangles, without those left out; heights are arbitrary.
template <typename LeftOut, typename Height>
Mesh grid(std::uint32_t size, const LeftOut& is_left_out, const Height& height) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= size; ++y)
    for (std::uint32_t x = 0; x <= size; ++x) mesh.points.push_back({double(x), double(y), height(x, y)});
  for (std::uint32_t y = 0; y < size; ++y)
    for (std::uint32_t x = 0; x < size; ++x) {
      if (is_left_out(x, y)) continue;
      const std::uint32_t a = y * (size + 1) + x, b = a + 1, c = b + size + 1, d = c - 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

/// Returns an octahedron each of whose faces is cut into four, `times` times, on the unit sphere.
Mesh sphere(int times) {
  Mesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (; times > 0; --times) {
    std::vector<Row> cut;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const Point3 m = unit(mesh.points[std::min(a, b)] + mesh.points[std::max(a, b)]);
      const auto found = std::find(mesh.points.begin(), mesh.points.end(), m);
      if (found == mesh.points.end())
        mesh.points.push_back(m);
      else
        return static_cast<std::uint32_t>(found - mesh.points.begin());
      return static_cast<std::uint32_t>(mesh.points.size() - 1);
    };
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      cut.insert(cut.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = cut;
  }
  return mesh;
}

/// Returns the new triangles as points, each starting with its least.
std::multiset<std::array<Point3, 3>> new_triangles(const Mesh& mesh, const rbpa::HoleFilling& filling) {
  std::multiset<std::array<Point3, 3>> result;
  for (std::size_t t = mesh.triangles.size(); t < filling.triangles.size(); ++t) {
    const Row& row = filling.triangles[t];
    std::array<Point3, 3> corners = {mesh.points[row[0]], mesh.points[row[1]], mesh.points[row[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

Mesh shuffled(const Mesh& mesh, Random& random) {
  const auto shuffle = [&](auto& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
  };
  std::vector<std::uint32_t> number(mesh.points.size());
  for (std::uint32_t v = 0; v < number.size(); ++v) number[v] = v;
  shuffle(number);
  Mesh result{Points3(mesh.points.size()), mesh.triangles};
  for (std::size_t v = 0; v < number.size(); ++v) result.points[number[v]] = mesh.points[v];
  for (Row& row : result.triangles) {
    for (std::uint32_t& v : row) v = number[v];
    std::rotate(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(random.below(3)), row.end());
  }
  shuffle(result.triangles);
  return result;
}

}  // namespace

TEST_CASE("a hole in a plane is filled with exactly its area, though its sides have corners on a line") {
  for (const std::uint32_t wide : {1U, 2U, 5U, 9U}) {
    const Mesh mesh = grid(
        12, [&](auto x, auto y) { return x >= 2 && x < 2 + wide && y >= 1 && y < 4; }, [](auto, auto) { return 0.0; });
    const auto loops = rbpa::boundary_loops(mesh.triangles);
    REQUIRE(loops.size() == 2);
    const auto& hole = loops[0].size() < loops[1].size() ? loops[0] : loops[1];
    const rbpa::HoleFilling filling =
        rbpa::fill_holes(mesh.points, mesh.triangles, std::vector<std::vector<std::uint32_t>>{hole});
    CHECK(filling.loops.front() == rbpa::HoleFill{HoleOutcome::filled, hole.size() - 2, 3.0 * wide});
    CHECK(rbpa::boundary_loops(filling.triangles).size() == 1);
    CHECK(rbpa::crossing_triangles(mesh.points, filling.triangles, 10).empty());
  }
}

TEST_CASE(
    "caps cut off a sphere are closed, always by the same triangles in any order and with any number of threads") {
  Random random(29);
  int closed = 0;
  for (int trial = 0; trial < 12; ++trial) {
    Mesh mesh = sphere(3);
    const double around = 0.5 * trial, share = 0.75 + 0.01 * trial;
    std::erase_if(mesh.triangles, [&](const Row& row) {
      return std::any_of(row.begin(), row.end(), [&](std::uint32_t v) {
        const Point3& p = mesh.points[v];
        return p.z > 0.85 || 0.8 * (p.x * std::cos(around) + p.y * std::sin(around)) - 0.6 * p.z > share;
      });
    });
    std::vector<std::vector<std::uint32_t>> loops;
    try {
      loops = rbpa::boundary_loops(mesh.triangles);
    } catch (const meshops::ContractViolation&) {
      continue;  // two holes touch
    }
    ++closed;
    REQUIRE(!loops.empty());
    const rbpa::HoleFilling filling = rbpa::fill_holes(mesh.points, mesh.triangles, loops, {.threads = 1});
    std::size_t added = 0;
    for (const rbpa::HoleFill& fill : filling.loops) {
      CHECK(fill.outcome == HoleOutcome::filled);
      added += fill.triangles;
    }
    CHECK(filling.triangles.size() == mesh.triangles.size() + added);
    CHECK(std::equal(mesh.triangles.begin(), mesh.triangles.end(), filling.triangles.begin()));
    CHECK(rbpa::boundary_loops(filling.triangles).empty());
    CHECK(rbpa::crossing_triangles(mesh.points, filling.triangles, 10).empty());
    const auto expected = new_triangles(mesh, filling);
    for (const unsigned threads : {1U, 2U}) {
      const Mesh other = shuffled(mesh, random);
      const auto others = rbpa::boundary_loops(other.triangles);
      CHECK(new_triangles(other, rbpa::fill_holes(other.points, other.triangles, others, {.threads = threads})) ==
            expected);
    }
  }
  CHECK(closed > 5);
}

TEST_CASE("a hole stays open, with the reason, where its only triangles cross the mesh or need an edge that exists") {
  // A hole of three edges in a plane, and a triangle that stands in it.
  Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-2, -2, 0}, {6, -2, 0}, {-2, 6, 0}}, {}};
  mesh.triangles = {{0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
  const std::vector<std::vector<std::uint32_t>> hole = {{0, 1, 2}};
  CHECK(rbpa::fill_holes(mesh.points, mesh.triangles, hole).loops.front() == rbpa::HoleFill{HoleOutcome::filled, 1, 8});
  Mesh pierced = mesh;
  pierced.points.insert(pierced.points.end(), {{1, 1, -1}, {1.5, 1, 1}, {1, 1.5, 1}});
  pierced.triangles.push_back({6, 7, 8});
  const rbpa::HoleFilling left = rbpa::fill_holes(pierced.points, pierced.triangles, hole);
  CHECK(left.loops.front() == rbpa::HoleFill{HoleOutcome::crosses, 0, 0});
  CHECK(left.triangles == pierced.triangles);
  // The back of a single triangle coincides with its front.
  const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK(rbpa::fill_holes(one.points, one.triangles, rbpa::boundary_loops(one.triangles)).loops.front().outcome ==
        HoleOutcome::crosses);
  // A tetrahedron without two faces: one diagonal of the hole exists; the other one closes it.
  const Mesh half{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}}};
  const auto loops = rbpa::boundary_loops(half.triangles);
  REQUIRE(loops.size() == 1);
  const rbpa::HoleFilling closed = rbpa::fill_holes(half.points, half.triangles, loops);
  CHECK(closed.loops.front().outcome == HoleOutcome::filled);
  CHECK(rbpa::boundary_loops(closed.triangles).empty());
  CHECK(rbpa::crossing_triangles(half.points, closed.triangles, 1).empty());
}

TEST_CASE("each of thousands of holes at one edge has its reason, work is limited, and the run can be cancelled") {
  const auto book = [](std::uint32_t pages) {  // each triangle separate, with vertices of its own
    Mesh mesh;
    for (std::uint32_t i = 0; i < pages; ++i) {
      const double turn = 2 * std::acos(-1.0) * i / pages;
      mesh.points.insert(mesh.points.end(), {{0, 0, 0}, {0, 0, 1}, {std::cos(turn), std::sin(turn), 0.5}});
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
  };
  const auto looks_at = [&](std::uint32_t pages) {
    const Mesh mesh = book(pages);
    std::size_t looks = 0;
    const auto count = [&](const rbpa::Progress&) {
      ++looks;
      return true;
    };
    const auto loops = rbpa::boundary_loops(mesh.triangles);
    REQUIRE(loops.size() == pages);
    const rbpa::HoleFilling filling =
        rbpa::fill_holes(mesh.points, mesh.triangles, loops, {.threads = 1, .progress = count});
    CHECK(filling.triangles == mesh.triangles);
    std::size_t too_much = 0;
    for (const rbpa::HoleFill& fill : filling.loops) {
      CHECK((fill.outcome == HoleOutcome::crosses || fill.outcome == HoleOutcome::too_much_work));
      too_much += fill.outcome == HoleOutcome::too_much_work;
    }
    CHECK(too_much > 0);
    // Any call can cancel: the first, some in the middle, the last.
    for (const std::size_t last : {std::size_t{1}, looks / 3, looks / 2, looks - 1}) {
      std::size_t left = last;
      CHECK_THROWS_AS(rbpa::fill_holes(mesh.points, mesh.triangles, loops,
                                       {.threads = 1, .progress = [&](const rbpa::Progress&) { return left-- > 1; }}),
                      rbpa::Cancelled);
    }
    return looks;
  };
  const std::size_t some = looks_at(1000), twice = looks_at(2000);
  CHECK(twice > some);
  CHECK(twice < 4 * some);
}

TEST_CASE("a loop that visits a point twice, at two vertices, is closed on both sides, and the vertices are merged") {
  // Two square holes that touch at a corner; the two fans between them there are two vertices.
  Mesh mesh = grid(
      6, [](auto x, auto y) { return (x == 2 && y == 2) || (x == 3 && y == 3); },
      [](std::uint32_t x, std::uint32_t y) { return 0.01 * x * y; });
  const std::uint32_t pinch = 3 * 7 + 3, twin = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(mesh.points[pinch]);
  for (Row& row : mesh.triangles) {
    double x = 0, y = 0;
    for (const std::uint32_t v : row) x += mesh.points[v].x / 3, y += mesh.points[v].y / 3;
    for (std::uint32_t& v : row)
      if (v == pinch && x > 3 && y < 3) v = twin;
  }
  std::vector<std::vector<std::uint32_t>> holes;
  for (const auto& loop : rbpa::boundary_loops(mesh.triangles))
    if (loop.size() < 20) holes.push_back(loop);
  REQUIRE(holes.size() == 1);
  REQUIRE(holes.front().size() == 8);
  const rbpa::HoleFilling filling = rbpa::fill_holes(mesh.points, mesh.triangles, holes);
  CHECK(filling.loops.front().outcome == HoleOutcome::filled);
  CHECK(filling.loops.front().triangles == 4);
  CHECK(rbpa::boundary_loops(filling.triangles).size() == 1);
  for (const Row& row : filling.triangles) CHECK(std::count(row.begin(), row.end(), twin) == 0);
}

TEST_CASE("a hole around islands in a plane is closed around them, with exactly its area, in any order of the points") {
  Random random(77);
  for (int islands = 1; islands <= 3; ++islands) {
    const auto is_in = [](auto x, auto y, std::uint32_t x0, std::uint32_t x1, std::uint32_t y0, std::uint32_t y1) {
      return x >= x0 && x < x1 && y >= y0 && y < y1;
    };
    const Mesh mesh = grid(
        14,
        [&](auto x, auto y) {
          return is_in(x, y, 2, 12, 2, 12) && !is_in(x, y, 4, 6, 4, 7) && !(islands > 1 && is_in(x, y, 8, 10, 8, 10)) &&
                 !(islands > 2 && is_in(x, y, 8, 11, 3, 5));
        },
        [](auto, auto) { return 0.0; });
    double area = 100 - 6;
    if (islands > 1) area -= 4;
    if (islands > 2) area -= 6;
    for (const Mesh& of : {mesh, shuffled(mesh, random)}) {
      std::vector<std::vector<std::uint32_t>> loops;
      for (const auto& loop : rbpa::boundary_loops(of.triangles))
        if (loop.size() != 56) loops.push_back(loop);
      REQUIRE(loops.size() == static_cast<std::size_t>(1 + islands));
      const rbpa::HoleFilling filling = rbpa::fill_holes(of.points, of.triangles, loops);
      double sum = 0;
      std::size_t triangles = 0;
      for (const rbpa::HoleFill& fill : filling.loops) {
        CHECK(fill.outcome == HoleOutcome::filled);
        sum += fill.area;
        triangles += fill.triangles;
      }
      CHECK(sum == doctest::Approx(area));
      CHECK(filling.triangles.size() == of.triangles.size() + triangles);
      CHECK(rbpa::boundary_loops(filling.triangles).size() == 1);
      CHECK(rbpa::crossing_triangles(of.points, filling.triangles, 10).empty());
    }
  }
}

TEST_CASE("wrong calls are refused") {
  const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto fill = [&](const std::vector<std::uint32_t>& loop) {
    return rbpa::fill_holes(one.points, one.triangles, std::vector<std::vector<std::uint32_t>>{loop});
  };
  CHECK_THROWS_AS(fill({0, 1, 2}), meshops::ContractViolation);  // the triangle is on the wrong side, to the left
  CHECK_THROWS_AS(fill({0, 1, 7}), meshops::ContractViolation);
  CHECK_THROWS_AS(fill({0}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::boundary_loops(std::vector<Row>{{0, 1, 2}, {0, 1, 3}}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::boundary_loops(std::vector<Row>{{0, 1, 2}, {0, 3, 4}}), meshops::ContractViolation);
  Points3 infinite = one.points;
  infinite[1].x = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(rbpa::fill_holes(infinite, one.triangles, {}), rbpa::InvalidInput);
}

TEST_SUITE_END();
