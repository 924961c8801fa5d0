// What: sets of balls with voids and pockets, and the geometry that the tests of voids share.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "rbpa/space/balls/ball_voids.h"
#include "support/ball_sets.h"
#include "support/data_folder.h"
#include "support/random.h"

namespace rbpa_test {

using rbpa::ball_voids;
using rbpa::BallMouth;
using rbpa::BallVoid;
using rbpa::BallVoids;
using rbpa::Point3;
using rbpa::RegularTriangulation;

inline BallVoids find_voids(const Balls& balls, bool pockets = true) {
  return ball_voids(balls.centers, balls.radii, rbpa::regular_triangulation(balls.centers, balls.radii),
                    {.pockets = pockets});
}

inline double distance(const Point3& p, const Point3& q) { return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z); }
inline Point3 minus(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
inline Point3 plus(const Point3& p, double s, const Point3& q) { return {p.x + s * q.x, p.y + s * q.y, p.z + s * q.z}; }
inline double det(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

/// Returns the least distance of x from a ball, except from ball `but`.
inline double clearance(const Balls& balls, const Point3& x,
                        std::size_t but = std::numeric_limits<std::size_t>::max()) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < balls.radii.size(); ++i)
    if (i != but) least = std::min(least, distance(x, balls.centers[i]) - balls.radii[i]);
  return least;
}

inline bool is_in(const Point3& x, const Balls& balls, const std::array<std::uint32_t, 4>& row) {
  const auto& [a, b, c, d] = row;
  const auto volume = [&](const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
    return det(minus(q, p), minus(r, p), minus(s, p));
  };
  const Point3 &p = balls.centers[a], &q = balls.centers[b], &r = balls.centers[c], &s = balls.centers[d];
  return volume(x, q, r, s) >= 0 && volume(p, x, r, s) >= 0 && volume(p, q, x, s) >= 0 && volume(p, q, r, x) >= 0;
}
inline bool is_in(const Point3& x, const Balls& balls, const BallVoid& of, const RegularTriangulation& regular) {
  return std::any_of(of.tetrahedra.begin(), of.tetrahedra.end(),
                     [&](std::uint32_t t) { return is_in(x, balls, regular.simplices[t]); });
}

inline Point3 on_sphere(Random& random) {
  const double z = random.between(-1, 1), angle = random.between(-std::numbers::pi, std::numbers::pi),
               r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Returns balls near a sphere around 0 of radius 1, spread evenly, some left out, and some within.
inline Balls shell(int count, int within, double least, double greatest, double left_out, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (int i = 0; i < count; ++i) {
    if (random.chance(left_out)) continue;
    const double z = (2 * i + 1.0) / count - 1, angle = 2.399963 * i, r = std::sqrt(1 - z * z);
    const Point3 even = {r * std::cos(angle), r * std::sin(angle), z};
    const Point3 direction = on_sphere(random);
    balls.centers.push_back(plus(even, random.between(0, 0.05), direction));
    balls.radii.push_back(random.between(least, greatest));
  }
  for (int i = 0; i < within; ++i) {
    const Point3 direction = on_sphere(random);
    balls.centers.push_back(plus({}, random.between(0, 0.5), direction));
    balls.radii.push_back(random.between(0, 0.2));
  }
  return balls;
}

inline Balls lysozyme(double probe) {
  const std::map<std::string, double> bondi = {{"C", 1.7}, {"N", 1.55}, {"O", 1.52}, {"S", 1.8}};
  std::ifstream file(bundled_data() / "mol3_2lyz.pdb");
  Balls balls;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("ATOM", 0) != 0) continue;
    const auto number = [&](std::size_t column) { return std::stod(line.substr(column, 8)); };
    balls.centers.push_back({number(30), number(38), number(46)});
    balls.radii.push_back(bondi.at(line.substr(13, 1)) + probe);
  }
  REQUIRE(balls.centers.size() == 1001);
  return balls;
}

}  // namespace rbpa_test
