// Triangles with points: read from files, built, shuffled.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

using rbpa::Point3;

/// Triangles with points, as a file has them.
struct Triangles {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
};

inline Triangles read_off(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::string magic;
  std::size_t points = 0, faces = 0, edges = 0;
  stream >> magic >> points >> faces >> edges;
  Triangles t{std::vector<Point3>(points), std::vector<std::array<std::uint32_t, 3>>(faces)};
  for (Point3& p : t.points) stream >> p.x >> p.y >> p.z;
  for (auto& [a, b, c] : t.corners) stream >> edges >> a >> b >> c;
  REQUIRE(stream);
  return t;
}

inline Triangles shuffled(const Triangles& t, std::mt19937& random) {
  std::vector<std::uint32_t> number(t.points.size());
  std::iota(number.begin(), number.end(), 0U);
  std::shuffle(number.begin(), number.end(), random);
  Triangles result{std::vector<Point3>(t.points.size()), t.corners};
  for (std::size_t v = 0; v < number.size(); ++v) result.points[number[v]] = t.points[v];
  for (auto& corners : result.corners) {
    for (std::uint32_t& corner : corners) corner = number[corner];
    std::rotate(corners.begin(), corners.begin() + random() % 3, corners.end());
  }
  std::shuffle(result.corners.begin(), result.corners.end(), random);
  return result;
}

/// Returns triangles as points, each in the least of its rotations, sorted.
inline std::vector<std::array<Point3, 3>> sorted_triangles(const std::vector<Point3>& points,
                                                           const std::vector<std::array<std::uint32_t, 3>>& corners) {
  std::vector<std::array<Point3, 3>> all;
  for (const auto& [a, b, c] : corners) {
    const Point3 &p = points[a], &q = points[b], &r = points[c];
    all.push_back(std::min({std::array{p, q, r}, {q, r, p}, {r, p, q}}));
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Adds the triangles of `more`, with its points moved along the x axis.
inline void append(Triangles& all, const Triangles& more, double shift = 0) {
  const auto first = static_cast<std::uint32_t>(all.points.size());
  for (const Point3& p : more.points) all.points.push_back({p.x + shift, p.y, p.z});
  for (const auto& [a, b, c] : more.corners) all.corners.push_back({a + first, b + first, c + first});
}

/// A grid of squares, each cut in two, in the plane z = 0, with inner points moved at random.
inline Triangles sheet(std::uint32_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  Triangles t;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      t.points.push_back({i + (inner ? shift(random) : 0), j + (inner ? shift(random) : 0), 0});
      if (i == n || j == n) continue;
      t.corners.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      t.corners.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return t;
}

/// A sphere of radius 1: an octahedron, subdivided `times` times.
inline Triangles sphere(int times) {
  Triangles t{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
              {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};
  for (; times > 0; --times) {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [slot, is_new] = middle.insert({{std::min(a, b), std::max(a, b)}, 0});
      if (is_new) {
        const Point3 p = t.points[a], q = t.points[b];
        const Point3 m = {p.x + q.x, p.y + q.y, p.z + q.z};
        const double length = std::hypot(m.x, m.y, m.z);
        slot->second = static_cast<std::uint32_t>(t.points.size());
        t.points.push_back({m.x / length, m.y / length, m.z / length});
      }
      return slot->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : t.corners) {
      const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      for (const auto& corners : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
        finer.push_back(corners);
    }
    t.corners = std::move(finer);
  }
  return t;
}

}  // namespace rbpa_test
