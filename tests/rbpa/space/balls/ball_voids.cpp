#include "rbpa/space/balls/ball_voids.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/far_points.h"
#include "rbpa/space/balls/full/outside_of_balls.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/balls/measure_balls.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/ball_sets.h"
#include "support/data_folder.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::ball_voids;
using rbpa::BallMouth;
using rbpa::BallVoid;
using rbpa::BallVoids;
using rbpa::Point3;
using rbpa::RegularTriangulation;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;
using Row = std::array<std::uint32_t, 4>;

BallVoids find(const Balls& balls, bool pockets = true) {
  return ball_voids(balls.centers, balls.radii, rbpa::regular_triangulation(balls.centers, balls.radii),
                    {.pockets = pockets});
}

double distance(const Point3& p, const Point3& q) { return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z); }
Point3 minus(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Point3 plus(const Point3& p, double s, const Point3& q) { return {p.x + s * q.x, p.y + s * q.y, p.z + s * q.z}; }
double det(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

/// Returns the least distance of x from a ball, except from ball `but`.
double clearance(const Balls& balls, const Point3& x, std::size_t but = std::numeric_limits<std::size_t>::max()) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < balls.radii.size(); ++i)
    if (i != but) least = std::min(least, distance(x, balls.centers[i]) - balls.radii[i]);
  return least;
}

bool is_in(const Point3& x, const Balls& balls, const Row& row) {
  const auto& [a, b, c, d] = row;
  const auto volume = [&](const Point3& p, const Point3& q, const Point3& r, const Point3& s) {
    return det(minus(q, p), minus(r, p), minus(s, p));
  };
  const Point3 &p = balls.centers[a], &q = balls.centers[b], &r = balls.centers[c], &s = balls.centers[d];
  return volume(x, q, r, s) >= 0 && volume(p, x, r, s) >= 0 && volume(p, q, x, s) >= 0 && volume(p, q, r, x) >= 0;
}
bool is_in(const Point3& x, const Balls& balls, const BallVoid& of, const RegularTriangulation& regular) {
  return std::any_of(of.tetrahedra.begin(), of.tetrahedra.end(),
                     [&](std::uint32_t t) { return is_in(x, balls, regular.simplices[t]); });
}

Point3 on_sphere(Random& random) {
  const double z = random.between(-1, 1), angle = random.between(-pi, pi), r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Returns balls near a sphere around 0 of radius 1, spread evenly, some left out, and some within.
Balls shell(int count, int within, double least, double greatest, double left_out, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (int i = 0; i < count; ++i) {
    if (random.chance(left_out)) continue;
    const double z = (2 * i + 1.0) / count - 1, angle = 2.399963 * i, r = std::sqrt(1 - z * z);
    const Point3 even = {r * std::cos(angle), r * std::sin(angle), z};
    balls.centers.push_back(plus(even, random.between(0, 0.05), on_sphere(random)));
    balls.radii.push_back(random.between(least, greatest));
  }
  for (int i = 0; i < within; ++i) {
    balls.centers.push_back(plus({}, random.between(0, 0.5), on_sphere(random)));
    balls.radii.push_back(random.between(0, 0.2));
  }
  return balls;
}

Balls lysozyme(double probe) {
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

/// Compares with random points: volume and area outside of the balls in each void, area and perimeter of each mouth.
/// Deviations in standard errors must not exceed five, and the sum of their squares must be about their number.
void check_by_random_points(const Balls& balls, int samples, std::uint64_t seed) {
  Random random(seed);
  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  const BallVoids found = ball_voids(balls.centers, balls.radii, regular, {.pockets = true});
  double squares = 0;
  int counted = 0;
  const auto check = [&](double share, double whole, int inside, int of) {
    const double p = static_cast<double>(inside) / of;
    const double variance = std::max(p * (1 - p), 1.0 / of) / of * whole * whole;
    CHECK(std::abs(share - p * whole) <= 5 * std::sqrt(variance));
    if (inside < 20 || of - inside < 20) return;
    squares += (share - p * whole) * (share - p * whole) / variance;
    ++counted;
  };
  for (const BallVoid& hollow : found.voids) {
    std::vector<double> up_to;
    double sum = 0, area = 0;
    for (const std::uint32_t t : hollow.tetrahedra) {
      const auto& row = regular.simplices[t];
      const auto to = [&](std::size_t k) { return minus(balls.centers[row[k]], balls.centers[row[0]]); };
      up_to.push_back(sum += det(to(1), to(2), to(3)) / 6);
    }
    CHECK(hollow.volume_of_tetrahedra == Approx(sum).epsilon(1e-12));
    int outside = 0;
    for (int i = 0; i < samples; ++i) {
      const auto at = std::upper_bound(up_to.begin(), up_to.end(), sum * random.unit()) - up_to.begin();
      std::array<double, 4> weight{};
      double all = 0;
      for (double& w : weight) all += w = -std::log(1 - random.unit());
      Point3 x;
      for (std::size_t k = 0; k < 4; ++k)
        x = plus(x, weight[k] / all,
                 balls.centers[regular.simplices[hollow.tetrahedra[static_cast<std::size_t>(at)]][k]]);
      outside += clearance(balls, x) > 0 ? 1 : 0;
    }
    check(hollow.volume, sum, outside, samples);
    for (const auto& [i, part] : hollow.balls) {
      const double r = balls.radii[i];
      int facing = 0;
      for (int sample = 0; sample < samples / 4; ++sample) {
        const Point3 x = plus(balls.centers[i], r, on_sphere(random));
        facing += clearance(balls, x, i) > 0 && is_in(x, balls, hollow, regular) ? 1 : 0;
      }
      check(part, 4 * pi * r * r, facing, samples / 4);
      area += part;
    }
    CHECK(hollow.area == Approx(area).epsilon(1e-12));
  }
  for (const BallVoid& pocket : found.pockets)
    for (const BallMouth& mouth : pocket.mouths) {
      double sum = 0, left = 0, variance = 0, length = 0, error = 0;
      for (const auto& [a, b, c] : mouth.triangles) {
        const Point3 p = balls.centers[a], u = minus(balls.centers[b], p), v = minus(balls.centers[c], p);
        const Point3 cross = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        const double twice = distance(cross, {});
        int outside = 0;
        for (int sample = 0; sample < samples; ++sample) {
          double s = random.unit(), t = random.unit();
          if (s + t > 1) s = 1 - s, t = 1 - t;
          outside += clearance(balls, plus(plus(p, s, u), t, v)) > 0 ? 1 : 0;
        }
        const double share = static_cast<double>(outside) / samples;
        sum += twice / 2;
        left += share * twice / 2;
        variance += std::max(share * (1 - share), 1.0 / samples) / samples * twice * twice / 4;
        // The border: points of all circles in the plane, in the triangle and outside of other balls.
        const Point3 n = plus({}, 1 / twice, cross), e = plus({}, 1 / distance(u, {}), u);
        const Point3 f = {n.y * e.z - n.z * e.y, n.z * e.x - n.x * e.z, n.x * e.y - n.y * e.x};
        for (std::size_t i = 0; i < balls.radii.size(); ++i) {
          const Point3 to = minus(balls.centers[i], p);
          const double height = to.x * n.x + to.y * n.y + to.z * n.z;
          if (std::abs(height) >= balls.radii[i]) continue;
          const double radius = std::sqrt(balls.radii[i] * balls.radii[i] - height * height);
          const Point3 foot = plus(balls.centers[i], -height, n);
          int on = 0;
          for (int sample = 0; sample < samples; ++sample) {
            const double angle = 2 * pi * (sample + random.unit()) / samples;
            const Point3 x = plus(plus(foot, radius * std::cos(angle), e), radius * std::sin(angle), f),
                         q = minus(x, p);
            const double s = det(q, v, n) / det(u, v, n), t = det(u, q, n) / det(u, v, n);
            on += s >= 0 && t >= 0 && s + t <= 1 && clearance(balls, x, i) > 0 ? 1 : 0;
          }
          length += 2 * pi * radius * on / samples;
          error += 2 * pi * radius * 8 / samples;  // an arc's ends are seen to within a sample
        }
      }
      CHECK(mouth.area_of_triangles == Approx(sum).epsilon(1e-12));
      CHECK(std::abs(mouth.area - left) <= 5 * std::sqrt(variance));
      CHECK(std::abs(mouth.perimeter - length) <= error);
    }
  if (counted > 0) CHECK(std::abs(squares - counted) <= 5 * std::sqrt(2.0 * counted));
}

/// Checks that what the balls leave of all tetrahedra outside of the complex is what the union leaves, ball by ball, in
/// a triangulation with further points of radius 0 around all balls.
void check_sums(Balls balls) {
  const auto reach = *std::max_element(balls.radii.begin(), balls.radii.end());
  Point3 low = balls.centers[0], high = low;
  for (const Point3& p : balls.centers) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double size = 8 * (reach + high.x - low.x + high.y - low.y + high.z - low.z);
  for (const Point3& p : {Point3{low.x - size, low.y - size, low.z - size}, Point3{high.x + 4 * size, low.y, low.z},
                          Point3{low.x, high.y + 4 * size, low.z}, Point3{low.x, low.y, high.z + 4 * size}}) {
    balls.centers.push_back(p);
    balls.radii.push_back(0);
  }
  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  const rbpa::space::Triangulated cells(balls.centers, regular);
  rbpa::Threads one(1);
  const rbpa::space::FacesWithin faces(cells, balls.radii, one);
  std::vector<std::uint32_t> region;
  double in_complex = 0, whole = 0;
  for (std::uint32_t t = 0; t < regular.simplices.size(); ++t) {
    const double volume = rbpa::space::volume<double>(balls.centers, regular.simplices[t]);
    in_complex += faces.has_tetrahedron(t) ? volume : 0;
    whole += volume;
    region.push_back(faces.has_tetrahedron(t) ? rbpa::space::BallRegions::none : t % 3);  // cut anywhere
  }
  std::vector<bool> is_end(balls.radii.size(), false);
  rbpa::space::for_each_edge(
      cells, rbpa::space::PointStars(cells), one,
      [&](std::uint32_t, std::uint32_t, std::span<const rbpa::space::EdgeAt> ring) { return faces.has_edge(ring); },
      [&](std::uint32_t a, std::uint32_t b) { is_end[a] = is_end[b] = true; });
  const auto is_in_complex = [&](std::uint32_t i) {
    const auto ball = [&](std::uint32_t k) { return rbpa::space::Ball{balls.centers[k], balls.radii[k]}; };
    bool is_alone = true;
    for (std::uint32_t k = 0; k < is_end.size(); ++k)
      is_alone &= k == i || balls.centers[k] == balls.centers[i] || !rbpa::space::is_conflict(ball(i), ball(k));
    return is_end[i] || is_alone;
  };
  const rbpa::space::RegionMeasures measures = rbpa::space::outside_of_balls(
      {cells, balls.centers, balls.radii, region, 3,
       [&](std::uint32_t t, std::size_t k) { return faces.has_triangle(t, k); },
       [&](std::span<const rbpa::space::EdgeAt> ring) { return faces.has_edge(ring); }, is_in_complex},
      one);
  const rbpa::BallMeasures expected = rbpa::measure_balls(balls.centers, balls.radii, regular, {});
  double outside = 0, tetrahedra = 0;
  for (const auto& of : measures.all) {
    outside += of.volume;
    tetrahedra += of.tetrahedra;
  }
  CHECK(tetrahedra + in_complex == Approx(whole).epsilon(1e-12));
  CHECK(std::abs(whole - outside - expected.volume) <= 1e-13 * whole);
  std::vector<double> areas(balls.radii.size(), 0);
  for (const auto& share : measures.shares) areas[share.ball] += share.area;
  for (std::size_t i = 0; i < areas.size(); ++i)
    CHECK(std::abs(areas[i] - expected.areas[i]) <= 1e-11 * balls.radii[i] * balls.radii[i]);
}

/// The definition of pockets in rational numbers.
class Definition {
 public:
  using Rational = boost::multiprecision::cpp_rational;
  using Vector = std::array<Rational, 3>;

  Definition(const Balls& balls, const RegularTriangulation& regular, bool by_flow)
      : balls_(balls), rows_(regular.simplices) {
    for (std::uint32_t t = 0; t < rows_.size(); ++t)
      for (std::size_t k = 0; k < 4; ++k) at_[face(t, k)].push_back({t, k});
    find_complex();
    std::vector<bool> is_outside(rows_.size(), false);
    for (bool changes = true; changes;) {
      changes = false;
      for (std::uint32_t t = 0; t < rows_.size(); ++t)
        for (std::size_t k = 0; k < 4; ++k) {
          if (is_outside[t] || complex_.contains(face(t, k)) || (by_flow && !is_beyond(t, k))) continue;
          const auto& sides = at_[face(t, k)];
          const bool leads_out = sides.size() == 1 || is_outside[sides[0].first] || is_outside[sides[1].first];
          is_outside[t] = leads_out;
          changes |= leads_out;
        }
    }
    std::vector<bool> is_seen(rows_.size(), false);
    for (std::uint32_t first = 0; first < rows_.size(); ++first) {
      if (is_outside[first] || is_seen[first] || has_tetrahedron(first)) continue;
      std::vector<std::uint32_t> all = {first};
      is_seen[first] = true;
      std::set<std::set<std::uint32_t>> open;
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) {
          const std::set<std::uint32_t> triangle = face(all[i], k);
          if (complex_.contains(triangle)) continue;
          const auto& sides = at_[triangle];
          const std::uint32_t other = sides.size() == 1 ? all[i] : sides[sides[0].first == all[i] ? 1 : 0].first;
          if (other == all[i] || is_outside[other]) {
            open.insert(triangle);
          } else if (!is_seen[other]) {
            is_seen[other] = true;
            all.push_back(other);
          }
        }
      std::sort(all.begin(), all.end());
      regions[all] = mouths(std::move(open));
    }
  }

  /// For the tetrahedra of each void or pocket, its mouths as sets of triangles.
  std::map<std::vector<std::uint32_t>, std::set<std::set<std::set<std::uint32_t>>>> regions;

 private:
  using Simplex = std::set<std::uint32_t>;

  Simplex face(std::uint32_t t, std::size_t k) const {
    Simplex corners(rows_[t].begin(), rows_[t].end());
    corners.erase(rows_[t][k]);
    return corners;
  }
  bool has_tetrahedron(std::uint32_t t) const { return complex_.contains(Simplex(rows_[t].begin(), rows_[t].end())); }

  Rational power(const Vector& x, std::uint32_t i) const {
    const Point3& c = balls_.centers[i];
    const Rational dx = x[0] - Rational(c.x), dy = x[1] - Rational(c.y), dz = x[2] - Rational(c.z);
    return dx * dx + dy * dy + dz * dz - Rational(balls_.radii[i]) * Rational(balls_.radii[i]);
  }
  /// Solves for the point c0 + Σ s_k e_k with the same power to all.
  Vector orthocenter(const Simplex& simplex) const {
    const std::vector<std::uint32_t> of(simplex.begin(), simplex.end());
    const auto center = [&](std::uint32_t i) {
      const Point3& c = balls_.centers[i];
      return Vector{Rational(c.x), Rational(c.y), Rational(c.z)};
    };
    Vector x = center(of[0]);
    const std::size_t n = of.size() - 1;
    std::vector<Vector> edges;
    for (std::size_t k = 1; k <= n; ++k) {
      Vector e = center(of[k]);
      for (std::size_t axis = 0; axis < 3; ++axis) e[axis] -= x[axis];
      edges.push_back(e);
    }
    std::vector<std::vector<Rational>> m(n, std::vector<Rational>(n + 1));
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l)
        m[k][l] = 2 * (edges[k][0] * edges[l][0] + edges[k][1] * edges[l][1] + edges[k][2] * edges[l][2]);
      m[k][n] = power(x, of[k + 1]) - power(x, of[0]);
    }
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      while (m[pivot][k] == 0) ++pivot;
      std::swap(m[k], m[pivot]);
      for (std::size_t r = 0; r < n; ++r) {
        if (r == k) continue;
        const Rational factor = m[r][k] / m[k][k];
        for (std::size_t c = k; c <= n; ++c) m[r][c] -= factor * m[k][c];
      }
    }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += m[k][n] / m[k][k] * edges[k][axis];
    return x;
  }
  /// Returns whether the orthocenter of a tetrahedron and the corner across are on different sides of a face.
  bool is_beyond(std::uint32_t t, std::size_t k) const {
    const Vector x = orthocenter(Simplex(rows_[t].begin(), rows_[t].end()));
    const Simplex triangle = face(t, k);
    const std::vector<std::uint32_t> of(triangle.begin(), triangle.end());
    const auto side = [&](const Vector& p) {
      std::array<Vector, 3> to;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3& c = balls_.centers[of[i]];
        to[i] = {Rational(c.x) - p[0], Rational(c.y) - p[1], Rational(c.z) - p[2]};
      }
      const Rational volume = to[0][0] * (to[1][1] * to[2][2] - to[1][2] * to[2][1]) -
                              to[0][1] * (to[1][0] * to[2][2] - to[1][2] * to[2][0]) +
                              to[0][2] * (to[1][0] * to[2][1] - to[1][1] * to[2][0]);
      return volume.sign();
    };
    const Point3& c = balls_.centers[rows_[t][k]];
    return side(x) * side({Rational(c.x), Rational(c.y), Rational(c.z)}) < 0;
  }
  void find_complex() {
    for (const Row& row : rows_)
      for (unsigned bits = 15; bits > 0; --bits) {
        Simplex simplex;
        for (std::size_t k = 0; k < 4; ++k)
          if ((bits >> k & 1U) != 0) simplex.insert(row[k]);
        if (complex_.contains(simplex)) continue;
        const Vector x = orthocenter(simplex);
        const Rational least = power(x, *simplex.begin());
        bool is_in = least <= 0;
        for (std::uint32_t i = 0; i < balls_.radii.size() && is_in; ++i) is_in = power(x, i) >= least;
        if (is_in) add(simplex);
      }
  }
  void add(const Simplex& simplex) {
    if (simplex.empty() || !complex_.insert(simplex).second) return;
    for (const std::uint32_t corner : simplex) {
      Simplex face = simplex;
      face.erase(corner);
      add(face);
    }
  }
  std::set<std::set<Simplex>> mouths(std::set<Simplex> open) const {
    std::set<std::set<Simplex>> result;
    while (!open.empty()) {
      std::vector<Simplex> mouth = {*open.begin()};
      open.erase(open.begin());
      for (std::size_t i = 0; i < mouth.size(); ++i)
        for (auto at = open.begin(); at != open.end();) {
          Simplex common;
          for (const std::uint32_t corner : *at)
            if (mouth[i].contains(corner)) common.insert(corner);
          if (common.size() == 2 && !complex_.contains(common)) {
            mouth.push_back(*at);
            at = open.erase(at);
          } else {
            ++at;
          }
        }
      result.insert(std::set<Simplex>(mouth.begin(), mouth.end()));
    }
    return result;
  }

  const Balls& balls_;
  std::vector<Row> rows_;
  std::map<Simplex, std::vector<std::pair<std::uint32_t, std::size_t>>> at_;
  std::set<Simplex> complex_;
};

/// Returns the radius of the largest ball that touches four lining balls, meets none of any, and has its center in the
/// void: by trying all quadruples.
double largest_by_trial(const Balls& balls, const BallVoid& of, const RegularTriangulation& regular) {
  double best = 0;
  const std::size_t n = of.balls.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        for (std::size_t l = k + 1; l < n; ++l) {
          const std::array<std::uint32_t, 4> b = {of.balls[i].ball, of.balls[j].ball, of.balls[k].ball,
                                                  of.balls[l].ball};
          const Point3& origin = balls.centers[b[0]];
          const double r0 = balls.radii[b[0]];
          std::array<Point3, 3> u;
          std::array<double, 3> constant{}, slope{};
          for (std::size_t m = 0; m < 3; ++m) {
            u[m] = minus(balls.centers[b[m + 1]], origin);
            const double r = balls.radii[b[m + 1]];
            constant[m] = (u[m].x * u[m].x + u[m].y * u[m].y + u[m].z * u[m].z + r0 * r0 - r * r) / 2;
            slope[m] = r0 - r;
          }
          const double volume = det(u[0], u[1], u[2]);
          if (std::abs(volume) < 1e-9) continue;
          const auto solve = [&](const std::array<double, 3>& right) {
            const auto column = [&](double Point3::*axis) {
              std::array<Point3, 3> m = u;
              for (std::size_t r = 0; r < 3; ++r) m[r].*axis = right[r];
              return det(m[0], m[1], m[2]) / volume;
            };
            return Point3{column(&Point3::x), column(&Point3::y), column(&Point3::z)};
          };
          const Point3 p = solve(constant), q = solve(slope);
          const double a = q.x * q.x + q.y * q.y + q.z * q.z - 1, c = p.x * p.x + p.y * p.y + p.z * p.z - r0 * r0,
                       half = p.x * q.x + p.y * q.y + p.z * q.z - r0, root = std::sqrt(half * half - a * c);
          for (const double s : {(-half + root) / a, (-half - root) / a}) {
            const Point3 x = plus(plus(origin, 1, p), s, q);
            if (s > best && clearance(balls, x) > s - 1e-9 && is_in(x, balls, of, regular)) best = s;
          }
        }
  return best;
}

/// Returns the same for any order of balls: corners by coordinates.
auto by_coordinates(const Balls& balls, const RegularTriangulation& regular, const std::vector<BallVoid>& all) {
  std::vector<std::pair<std::set<std::vector<Point3>>, std::vector<std::set<std::vector<Point3>>>>> result;
  const auto points = [&](const auto& simplex) {
    std::vector<Point3> corners;
    for (const std::uint32_t i : simplex) corners.push_back(balls.centers[i]);
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (const BallVoid& of : all) {
    auto& [tetrahedra, mouths] = result.emplace_back();
    for (const std::uint32_t t : of.tetrahedra) tetrahedra.insert(points(regular.simplices[t]));
    for (const BallMouth& mouth : of.mouths) {
      mouths.emplace_back();
      for (const rbpa::Triangle& triangle : mouth.triangles) mouths.back().insert(points(triangle));
    }
  }
  return result;
}

Balls box(std::initializer_list<double> radius_by_height) {
  Balls balls;
  double z = 0;
  for (const double radius : radius_by_height) {
    for (const double x : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) {
        balls.centers.push_back({x, y, z});
        balls.radii.push_back(radius);
      }
    ++z;
  }
  return balls;
}

}  // namespace

TEST_CASE("the void between four balls has the volume and area of the formula") {
  const Points3 centers = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const double edge = std::sqrt(8.0), whole = edge * edge * edge / (6 * std::sqrt(2.0));
  for (const double r : {1.64, 1.7, 1.73}) {  // faces close at 1.633; the void fills at 1.732
    const BallVoids found = find({centers, std::vector<double>(4, r)});
    REQUIRE(found.voids.size() == 1);
    CHECK(found.pockets.empty());
    const BallVoid& hollow = found.voids[0];
    const auto sizes = [&](std::size_t count) {
      const auto of = rbpa::measure_balls(std::span(centers).first(count), std::vector<double>(count, r));
      return std::array{of.volume, of.area};
    };
    const std::array<double, 2> one = sizes(1), two = sizes(2), three = sizes(3);
    std::array<double, 2> left = {whole, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      const double lens = 2 * one[k] - two[k], common = three[k] - 3 * two[k] + 3 * one[k];
      const double inside = std::acos(23.0 / 27) / pi * one[k] - 3 * std::acos(1.0 / 3) / pi * lens + 2 * common;
      left[k] = k == 0 ? whole - inside : inside;
    }
    CHECK(hollow.volume_of_tetrahedra == Approx(whole).epsilon(1e-14));
    CHECK(std::abs(hollow.volume - left[0]) <= 1e-12);
    CHECK(std::abs(hollow.area - left[1]) <= 1e-12);
    CHECK(found.volume == hollow.volume);
    CHECK(hollow.power == Approx(3 - r * r).epsilon(1e-12));
    CHECK(hollow.radius == Approx(std::sqrt(3.0) - r).epsilon(1e-10));
    CHECK(distance(hollow.center, {}) < 1e-14);
    REQUIRE(hollow.balls.size() == 4);
    for (const rbpa::LiningBall& ball : hollow.balls) CHECK(ball.area == Approx(left[1] / 4).epsilon(1e-10));
  }
  CHECK(find({centers, std::vector<double>(4, 1.74)}).voids.empty());
}

TEST_CASE("an open box is a pocket whose mouth has the sizes of the formula") {
  const double r = 0.65, wide = 0.85;
  const Balls balls = box({wide, r});
  const BallVoids found = find(balls);
  CHECK(found.voids.empty());
  REQUIRE(found.pockets.size() == 1);
  const BallVoid& pocket = found.pockets[0];
  CHECK(pocket.volume_of_tetrahedra == Approx(1).epsilon(1e-14));
  CHECK(pocket.power == Approx(0.5 + 0.65 * 0.65 - wide * wide).epsilon(1e-12));
  double low = 0.5, high = 1;  // the height at which both layers are equally near
  for (int i = 0; i < 60; ++i) {
    const double z = (low + high) / 2;
    (std::sqrt(0.5 + z * z) - wide < std::sqrt(0.5 + (1 - z) * (1 - z)) - r ? low : high) = z;
  }
  CHECK(distance(pocket.center, {0.5, 0.5, low}) < 1e-12);
  CHECK(pocket.radius == Approx(std::sqrt(0.5 + low * low) - wide).epsilon(1e-12));
  REQUIRE(pocket.mouths.size() == 1);
  const BallMouth& mouth = pocket.mouths[0];
  CHECK(mouth.triangles.size() == 2);
  CHECK(mouth.balls == std::vector<std::uint32_t>{4, 5, 6, 7});
  const double angle = std::acos(0.5 / r), lens = 2 * r * r * angle - 0.5 * std::sqrt(4 * r * r - 1);
  CHECK(mouth.area_of_triangles == Approx(1).epsilon(1e-14));
  CHECK(mouth.area == Approx(1 - pi * r * r + 2 * lens).epsilon(1e-12));
  CHECK(mouth.perimeter == Approx(4 * r * (pi / 2 - 2 * angle)).epsilon(1e-12));
  CHECK(mouth.power == Approx(0.5 - r * r).epsilon(1e-12));
  CHECK(mouth.radius == Approx(std::sqrt(0.5) - r).epsilon(1e-12));
  CHECK(distance(mouth.center, {0.5, 0.5, 1}) < 1e-14);
  // Above the power of the mouth it is a void, above that of the pocket nothing.
  const auto grown = [&](double power) {
    Balls wider = balls;
    for (double& radius : wider.radii) radius = std::sqrt(radius * radius + power);
    return find(wider);
  };
  CHECK(grown(mouth.power - 1e-9).pockets.size() == 1);
  CHECK(grown(mouth.power + 1e-9).voids.size() == 1);
  CHECK(grown(pocket.power - 1e-9).voids.size() == 1);
  CHECK(grown(pocket.power + 1e-9).voids.empty());
}

TEST_CASE("two chambers with a window are one void, and two where the window is closed") {
  const BallVoids open = find(box({0.85, 0.65, 0.85}));
  REQUIRE(open.voids.size() == 1);
  CHECK(open.pockets.empty());
  const BallVoids closed = find(box({0.85, 0.7072, 0.85}));
  REQUIRE(closed.voids.size() == 2);
  CHECK(closed.voids[0].volume == Approx(closed.voids[1].volume).epsilon(1e-10));
  CHECK(closed.voids[0].center.z == Approx(2 - closed.voids[1].center.z).epsilon(1e-9));
}

TEST_CASE("equal radii give the voids of the full alpha complex") {
  std::size_t voids = 0;
  for (const SolidSet& set : solid_sets(150)) {
    CAPTURE(set.name);
    const rbpa::Solid delaunay = rbpa::solid(set.points, std::numeric_limits<double>::infinity());
    if (delaunay.simplices.empty()) continue;
    const std::vector<double> radii = rbpa::circumradii(set.points, delaunay.simplices);
    std::vector<double> alphas = radii;
    std::sort(alphas.begin(), alphas.end());
    for (const std::size_t part : {3U, 5U, 7U, 9U}) {
      const double alpha = alphas[alphas.size() * part / 10];
      const rbpa::FullVoids expected =
          rbpa::full_voids(set.points, rbpa::void_space(set.points, delaunay, radii, alpha), alpha);
      const BallVoids found = find({set.points, std::vector<double>(set.points.size(), alpha)}, false);
      REQUIRE(found.voids.size() == expected.all.size());
      voids += found.voids.size();
      for (std::size_t i = 0; i < found.voids.size(); ++i) {
        CHECK(found.voids[i].volume_of_tetrahedra == Approx(expected.all[i].volume).epsilon(1e-9));
        CHECK(found.voids[i].volume == Approx(*expected.all[i].outside_balls).epsilon(1e-9));
        if (std::isfinite(alpha) && set.name != "clusters")
          CHECK(std::sqrt(alpha * alpha + found.voids[i].power) - alpha == Approx(found.voids[i].radius).epsilon(1e-6));
      }
    }
  }
  CHECK(voids > 40);
}

TEST_CASE("voids and mouths agree with random points: shells with balls within") {
  std::size_t voids = 0, pockets = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Balls balls = shell(60, static_cast<int>(seed % 3 * 3), 0.33, 0.48, seed % 2 == 0 ? 0 : 0.04, seed);
    const BallVoids found = find(balls);
    voids += found.voids.size();
    pockets += found.pockets.size();
    check_by_random_points(balls, 4000, seed);
  }
  CHECK(voids >= 4);
  CHECK(pockets >= 2);
}

TEST_CASE("what the balls leave of all tetrahedra sums up to what their union leaves") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) check_sums(shell(40, 5, 0.1, 0.5, 0.1, seed));
  Random random(3);
  for (int set = 0; set < 200; ++set) {
    const auto kind = static_cast<RadiusKind>(set % radius_kinds);
    const Balls balls = ball_set(set % 2 == 0 ? SpaceKind::grid : SpaceKind::cube, kind, 20, random);
    CAPTURE(text(balls));
    check_sums(balls);
  }
}

TEST_CASE("voids, pockets and mouths are those of the definition, in rational numbers") {
  Random random(5);
  std::size_t voids = 0, mouths = 0;
  for (int set = 0; set < 30; ++set) {
    Balls balls;
    if (set % 5 == 4) {  // a grid with a hole in its middle
      for (int i = 0; i < 27; ++i) {
        if (i == 13) continue;
        balls.centers.push_back({1.0 * (i / 9), 1.0 * (i / 3 % 3), 1.0 * (i % 3)});
        balls.radii.push_back(random.chance(0.1) ? 0.5 : 0.75 + 0.0625 * random.integer(0, 2));
      }
    } else {
      for (int i = 0; i < 16; ++i) {
        const auto number = [&] { return set % 3 != 0 ? random.integer(0, 3) : random.between(0, 3); };
        balls.centers.push_back({number(), number(), number()});
        balls.radii.push_back(set % 3 != 0 ? 0.25 * random.integer(0, 4) : random.between(0, 1));
      }
    }
    CAPTURE(text(balls));
    const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    for (const bool pockets : {false, true}) {
      const BallVoids found = ball_voids(balls.centers, balls.radii, regular, {.pockets = pockets});
      voids += found.voids.size();
      decltype(Definition::regions) regions;
      for (const auto* all : {&found.voids, &found.pockets})
        for (const BallVoid& of : *all) {
          auto& of_region = regions[of.tetrahedra];
          for (const BallMouth& mouth : of.mouths) {
            std::set<std::set<std::uint32_t>> triangles;
            for (const rbpa::Triangle& triangle : mouth.triangles) triangles.insert({triangle.begin(), triangle.end()});
            of_region.insert(triangles);
          }
          mouths += of.mouths.size();
        }
      CHECK(regions == Definition(balls, regular, pockets).regions);
    }
  }
  CHECK(voids >= 4);
  CHECK(mouths >= 40);
}

TEST_CASE("the largest ball of a void touches four balls, and no quadruple has a larger one") {
  std::size_t voids = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const Balls balls = shell(40, static_cast<int>(seed % 2 * 3), 0.42, 0.6, 0, seed);
    const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    for (const BallVoid& of : ball_voids(balls.centers, balls.radii, regular, {}).voids) {
      ++voids;
      CHECK(of.radius > 0);
      CHECK(clearance(balls, of.center) == Approx(of.radius).epsilon(1e-12));
      CHECK(is_in(of.center, balls, of, regular));
      CHECK(of.radius == Approx(largest_by_trial(balls, of, regular)).epsilon(1e-8));
    }
  }
  CHECK(voids >= 8);
}

TEST_CASE("the order of balls, threads and scales do not matter") {
  Random random(9);
  const Balls balls = lysozyme(0.7);
  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  const BallVoids expected = ball_voids(balls.centers, balls.radii, regular, {.pockets = true});
  CHECK(expected.voids.size() + expected.pockets.size() > 20);
  std::vector<std::size_t> order(balls.radii.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (const double scale : {1.0, 0x1p-300, 1e100}) {
    random.shuffle(order);
    Balls other, same;
    for (const std::size_t i : order) {
      other.centers.push_back(plus({}, scale, balls.centers[i]));
      other.radii.push_back(scale * balls.radii[i]);
      same.centers.push_back(balls.centers[i]);
    }
    const RegularTriangulation theirs = rbpa::regular_triangulation(other.centers, other.radii);
    const BallVoids found = ball_voids(other.centers, other.radii, theirs, {.pockets = true, .threads = 2});
    CHECK(by_coordinates(same, theirs, found.voids) == by_coordinates(balls, regular, expected.voids));
    CHECK(by_coordinates(same, theirs, found.pockets) == by_coordinates(balls, regular, expected.pockets));
    for (const auto& [all, of] : {std::pair(&found.voids, &expected.voids), {&found.pockets, &expected.pockets}})
      for (std::size_t i = 0; i < all->size(); ++i) {
        const BallVoid &a = (*all)[i], &b = (*of)[i];
        CHECK(std::abs(a.volume / scale / scale / scale - b.volume) < 1e-9);
        CHECK(std::abs(a.area / scale / scale - b.area) < 1e-9);
        CHECK(a.radius / scale == Approx(b.radius).epsilon(1e-10));
        for (std::size_t k = 0; k < a.mouths.size(); ++k) {
          CHECK(std::abs(a.mouths[k].area / scale / scale - b.mouths[k].area) < 1e-9);
          CHECK(std::abs(a.mouths[k].perimeter / scale - b.mouths[k].perimeter) < 1e-6);
          CHECK(a.mouths[k].radius / scale == Approx(b.mouths[k].radius).epsilon(1e-10));
        }
      }
  }
}

TEST_CASE("balls of every kind have voids and pockets with sizes, which do not depend on their order") {
  Random random(11);
  std::size_t regions = 0;
  for (int set = 0; set < 2 * space_kinds * radius_kinds; ++set) {
    Balls balls = ball_set(static_cast<SpaceKind>(set % space_kinds),
                           static_cast<RadiusKind>(set / space_kinds % radius_kinds), 30, random);
    CAPTURE(text(balls));
    const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    const BallVoids found = ball_voids(balls.centers, balls.radii, regular, {.pockets = true});
    std::vector<std::size_t> order(balls.radii.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    random.shuffle(order);
    Balls other;
    for (const std::size_t i : order) {
      other.centers.push_back(balls.centers[i]);
      other.radii.push_back(balls.radii[i]);
    }
    const RegularTriangulation theirs = rbpa::regular_triangulation(other.centers, other.radii);
    const BallVoids again = ball_voids(other.centers, other.radii, theirs, {.pockets = true});
    CHECK(by_coordinates(other, theirs, again.voids) == by_coordinates(balls, regular, found.voids));
    CHECK(by_coordinates(other, theirs, again.pockets) == by_coordinates(balls, regular, found.pockets));
    for (const auto* all : {&found.voids, &found.pockets})
      for (const BallVoid& of : *all) {
        ++regions;
        CHECK(!std::isnan(of.volume));  // at 1e150 it is infinite
        CHECK(!std::isnan(of.area));
        CHECK(std::isfinite(of.radius));
        CHECK(of.radius >= 0);
        for (const BallMouth& mouth : of.mouths) {
          CHECK(std::isfinite(mouth.area));
          CHECK(mouth.area <= mouth.area_of_triangles);
          CHECK(std::isfinite(mouth.perimeter));
          CHECK(std::isfinite(mouth.radius));
        }
      }
  }
  CHECK(regions > 40);
}

TEST_CASE("lysozyme has ten voids for a probe of 1.4") {
  const Balls atoms = lysozyme(1.4);
  const BallVoids found = find(atoms);
  CHECK(found.voids.size() == 10);
  CHECK(found.pockets.size() == 7);
  CHECK(found.voids[0].volume == Approx(4.75455).epsilon(1e-5));
  check_by_random_points(atoms, 2000, 1);
}

TEST_CASE("balls in a plane have no voids, and invalid arguments are refused") {
  CHECK(find({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0.6, 0.6, 0.7, 0}}).voids.empty());
  CHECK(find({{}, {}}).voids.empty());
  const Balls balls = box({0.85, 0.65});
  RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  CHECK_THROWS_AS(ball_voids(balls.centers, std::vector<double>{1}, regular), meshops::ContractViolation);
  CHECK_THROWS_AS(ball_voids(std::span(balls.centers).first(7), std::span(balls.radii).first(7), regular),
                  meshops::ContractViolation);
  CHECK_THROWS_AS(
      ball_voids(balls.centers, balls.radii, regular, {.progress = [](const rbpa::Progress&) { return false; }}),
      rbpa::Cancelled);
  regular.neighbors.clear();
  CHECK_THROWS_AS(ball_voids(balls.centers, balls.radii, regular), meshops::ContractViolation);
}

TEST_SUITE_END();
