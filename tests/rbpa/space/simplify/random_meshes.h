// What: small random surfaces of triangles: with boundaries, handles, several components, pinches, flat parts and ties.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "meshops/topology/repair.h"
#include "space/simplify/triangle_sets.h"

namespace rbpa_test {

/// A torus: a grid of n × m squares, each cut in two.
inline Triangles torus(std::uint32_t n, std::uint32_t m) {
  Triangles t;
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % n * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 6.283185307179586 * i / n, v = 6.283185307179586 * j / m, r = 2 + std::cos(v);
      t.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      t.corners.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      t.corners.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return t;
}

/// The boundary of random cubes of a grid of n³. Where cubes touch along edges or at corners, it is no manifold.
inline Triangles cubes(std::uint32_t n, std::mt19937& random) {
  Triangles t;
  const auto at = [&](std::array<std::uint32_t, 3> p) { return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]; };
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    t.points.push_back({double(i / (n + 1) / (n + 1)), double(i / (n + 1) % (n + 1)), double(i % (n + 1))});
  std::vector<bool> is_full(t.points.size(), false);
  const unsigned share = 2 + static_cast<unsigned>(random() % 4);
  for (std::uint32_t i = 0; i < n * n * n; ++i)
    is_full[at({i / n / n, i / n % n, i % n})] = random() % share > 0 && i % 7 != share;
  for (std::uint32_t i = 0; i < n * n * n; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool is_upper : {false, true}) {
        std::array<std::uint32_t, 3> cell = {i / n / n, i / n % n, i % n}, beyond = cell;
        beyond[axis] = is_upper ? beyond[axis] + 1 : beyond[axis] - 1;
        if (!is_full[at(cell)] || (beyond[axis] < n && is_full[at(beyond)])) continue;
        const std::size_t right = (axis + (is_upper ? 1 : 2)) % 3, up = 3 - axis - right;
        if (is_upper) ++cell[axis];
        std::array<std::uint32_t, 4> side{};
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<std::uint32_t, 3> corner = cell;
          corner[right] += k == 1 || k == 2;
          corner[up] += k >= 2;
          side[k] = at(corner);
        }
        std::rotate(side.begin(), side.begin() + random() % 2, side.end());
        t.corners.push_back({side[0], side[1], side[2]});
        t.corners.push_back({side[0], side[2], side[3]});
      }
  return t;
}

/// Returns a surface of up to some hundreds of triangles, a function of the seed. Where it was no manifold it is cut,
/// so that several points are at one place.
inline Triangles random_surface(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned limit) { return static_cast<std::uint32_t>(random() % limit); };
  const auto piece = [&]() -> Triangles {
    switch (below(4)) {
      case 0:
        return sheet(2 + below(5), below(1000));
      case 1:
        return sphere(1 + static_cast<int>(below(2)));
      case 2:
        return torus(3 + below(5), 3 + below(4));
      default:
        return cubes(2 + below(2), random);
    }
  };
  Triangles t;
  const double apart = below(3) == 0 ? 1 : 8;  // pieces may cross
  for (unsigned pieces = below(3) == 0 ? 2 : 1; pieces > 0; --pieces) append(t, piece(), apart * pieces);
  const double noise = std::array{0.0, 0.0, 0.1, 0.5}[below(4)];
  std::uniform_real_distribution<double> shift(-noise, noise);
  for (Point3& p : t.points)
    if (noise > 0) p = {p.x + shift(random), p.y + shift(random), p.z + shift(random)};
  if (below(16) == 0)
    for (Point3& p : t.points) p.z = 0;
  if (const unsigned holes = std::array{0U, 60U, 12U, 5U}[below(4)]; holes > 0)
    std::erase_if(t.corners, [&](const auto&) { return below(holes) == 0; });
  meshops::PolygonSoup soup;
  soup.points = t.points.size();
  for (const auto& corners : t.corners) soup.add_face(corners);
  const meshops::Repair parted = meshops::repair(soup);
  Triangles result;
  for (const std::uint32_t point : parted.stands_on) result.points.push_back(t.points[point]);
  for (std::size_t f = 0; f < parted.soup.faces(); ++f) {
    const auto corners = parted.soup.face(f);
    result.corners.push_back({corners[0], corners[1], corners[2]});
  }
  return result;
}

}  // namespace rbpa_test
