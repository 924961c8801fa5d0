#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "rbpa/base/triangle.h"
#include "rbpa/space/balls/ball_voids.h"
#include "support/ball_sets.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::ball_voids;
using rbpa::BallMouth;
using rbpa::BallVoid;
using rbpa::BallVoids;
using rbpa::Point3;
using rbpa::RegularTriangulation;

TEST_SUITE_BEGIN("space");

namespace {

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
    for (const auto& row : rows_)
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
  std::vector<std::array<std::uint32_t, 4>> rows_;
  std::map<Simplex, std::vector<std::pair<std::uint32_t, std::size_t>>> at_;
  std::set<Simplex> complex_;
};

}  // namespace

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

TEST_SUITE_END();
