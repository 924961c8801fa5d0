#include "rbpa/plane/alpha_complex.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "rbpa/base/error.h"
#include "rbpa/rbpa.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/spacing.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::ComplexKind;
using rbpa::Point;

TEST_SUITE_BEGIN("arrays");

namespace {

using Edge = std::array<std::uint32_t, 2>;

rbpa::AlphaComplexOptions all_of(unsigned threads = 1, ComplexKind complex = ComplexKind::solid) {
  rbpa::AlphaComplexOptions options;
  options.complex = complex;
  options.neighbors = options.boundary = true;
  options.threads = threads;
  return options;
}

/// Checks that neighbors and boundary belong to the triangles.
void check_connected(const AlphaComplex& of) {
  REQUIRE(of.neighbors.size() == of.triangles.size());
  std::map<Edge, std::uint32_t> at_side;
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) at_side[{of.triangles[t][i], of.triangles[t][(i + 1) % 3]}] = t;
  std::vector<Edge> boundary;
  std::size_t wrong = 0;
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge side = {of.triangles[t][(k + 1) % 3], of.triangles[t][(k + 2) % 3]};
      const auto beyond = at_side.find({side[1], side[0]});
      wrong += of.neighbors[t][k] != (beyond == at_side.end() ? AlphaComplex::none : beyond->second);
      if (beyond == at_side.end()) boundary.push_back(side);
    }
  CHECK(wrong == 0);
  std::sort(boundary.begin(), boundary.end());
  CHECK(of.boundary == boundary);
}

/// Checks that triangles, isolated points and duplicates equal those of the mesh.
void check_same(const Points& points, double alpha, unsigned threads) {
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
  const AlphaComplex arrays = rbpa::alpha_complex(points, alpha, all_of(threads));
  CHECK(arrays.triangles == rbpa::triangles(complex));
  CHECK(arrays.isolated == complex.isolated);
  CHECK(arrays.duplicates == complex.duplicates);
  CHECK(arrays.distinct == complex.distinct);
  CHECK(arrays.edges.empty());
  CHECK(arrays.points.empty());
  check_connected(arrays);
  const AlphaComplex plain = rbpa::alpha_complex(points, alpha, {.threads = threads});
  CHECK(plain.triangles == arrays.triangles);
  CHECK(plain.neighbors.empty());
  CHECK(plain.boundary.empty());
}

}  // namespace

TEST_CASE("the arrays have the triangles of the mesh, on sets of every kind and for every radius") {
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    std::vector<double> alphas = set.alphas;
    for (const double spacings : {0.6, 1.0, 4.0}) alphas.push_back(spacings * mean_spacing(points));
    for (const double alpha : alphas) {
      if (!(alpha > 0)) continue;
      CAPTURE(alpha);
      check_same(points, alpha, 1);
    }
    check_same(points, infinity, 2);
  }
}

TEST_CASE("many points give the same arrays, in any order and with any number of threads") {
  Points points = uniform(30000, 1);
  const AlphaComplex expected = rbpa::alpha_complex(points, 1.1, all_of(1));
  const AlphaComplex other = rbpa::alpha_complex(points, 1.1, all_of(2));
  CHECK(other.triangles == expected.triangles);
  CHECK(other.neighbors == expected.neighbors);
  CHECK(other.boundary == expected.boundary);
  // A hub with a long star, and indices that are unrelated to the places.
  Points star = integer_circle(32045);
  star.push_back({0.1, 0.2});
  Random random(2);
  random.shuffle(star);
  check_same(star, infinity, 2);
  random.shuffle(points);
  check_same(points, 0.7, 2);
}

TEST_CASE("no points, one point, points on a line and duplicates have no triangles") {
  CHECK(rbpa::alpha_complex({}, 1).triangles.empty());
  const AlphaComplex one = rbpa::alpha_complex(Points{{1, 2}, {1, 2}}, 1, all_of());
  CHECK(one.isolated == std::vector<std::uint32_t>{0});
  CHECK(one.distinct == 1);
  CHECK(one.duplicates == std::vector<rbpa::Duplicate>{{1, 0}});
  const AlphaComplex line = rbpa::alpha_complex(collinear_run(30, 3, 7, 1), infinity, all_of());
  CHECK(line.triangles.empty());
  CHECK(line.neighbors.empty());
  CHECK(line.isolated.size() == 30);
}

TEST_CASE("bad input is refused before the run, and a run can be cancelled") {
  CHECK_THROWS_AS(rbpa::alpha_complex(Points{{0, 0}}, 0), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::alpha_complex(Points{{0, infinity}}, 1), rbpa::InvalidInput);
  rbpa::AlphaComplexOptions options;
  int asked = 0;
  options.progress = [&](const rbpa::Progress&) { return ++asked < 3; };
  CHECK_THROWS_AS(rbpa::alpha_complex(uniform(30000, 3), infinity, options), rbpa::Cancelled);
  CHECK(asked == 3);
  // It can be cancelled also while the triangles are sorted.
  std::size_t most = 0, since = 0;
  options.neighbors = options.boundary = true;
  options.progress = [&](const rbpa::Progress& now) {
    since = now.triangles > most ? 0 : since + 1;
    most = std::max(most, now.triangles);
    return true;
  };
  CHECK(rbpa::alpha_complex(uniform(30000, 3), infinity, options).triangles.size() == most);
  CHECK(since > 10);
  options.progress = [&](const rbpa::Progress& now) { return now.triangles < most || since-- > 4; };
  CHECK_THROWS_AS(rbpa::alpha_complex(uniform(30000, 3), infinity, options), rbpa::Cancelled);
}

namespace {

/// Checks the edges and points of the alpha complex that are in no triangle, by the definition, on Delaunay edges.
void check_full(const Points& points, double alpha) {
  CAPTURE(alpha);
  const AlphaComplex full = rbpa::alpha_complex(points, alpha, all_of(1, ComplexKind::full));
  const AlphaComplex solid = rbpa::alpha_complex(points, alpha, all_of());
  CHECK(full.triangles == solid.triangles);
  CHECK(full.neighbors == solid.neighbors);
  CHECK(full.boundary == solid.boundary);
  CHECK(full.isolated == solid.isolated);
  std::set<Edge> delaunay, in_triangles, expected;
  const auto add = [](std::set<Edge>& edges, const auto& t) {
    for (std::size_t i = 0; i < 3; ++i) edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
  };
  for (const auto& t : rbpa::alpha_complex(points, infinity).triangles) add(delaunay, t);
  for (const auto& t : solid.triangles) add(in_triangles, t);
  const bool on_line = delaunay.empty();
  std::set<std::uint32_t> repeated;
  for (const auto& d : solid.duplicates) repeated.insert(d.index);
  for (std::uint32_t a = 0; a < points.size(); ++a)
    for (std::uint32_t b = a + 1; b < points.size(); ++b) {
      if (repeated.contains(a) || repeated.contains(b)) continue;
      if (in_triangles.contains({a, b}) || (!on_line && !delaunay.contains({a, b}))) continue;
      if (!std::isinf(alpha) && exact::compare_to_diameter(points[a], points[b], alpha) > 0) continue;
      const bool is_empty = std::none_of(points.begin(), points.end(), [&](const Point& p) {
        return p != points[a] && p != points[b] && exact::dot_sign(p, points[a], points[b]) < 0;
      });
      if (is_empty) expected.insert({a, b});
    }
  CHECK(full.edges == std::vector<Edge>(expected.begin(), expected.end()));
  std::set<std::uint32_t> left(full.isolated.begin(), full.isolated.end());
  for (const Edge& e : full.edges) {
    left.erase(e[0]);
    left.erase(e[1]);
  }
  CHECK(full.points == std::vector<std::uint32_t>(left.begin(), left.end()));
}

}  // namespace

TEST_CASE(
    "the full complex has, in addition to triangles, the empty edges within alpha, and the points that are left") {
  for (const Points& points : {uniform(60, 4), perfect_grid(7, 1), integer_circle(65), collinear_run(20, 2, 5, 5),
                               star(65), chain_of_triangles(6), duplicates(20, 3, 6), with_strangers(40, 6, 7),
                               mixed_exponents(8, 8), Points{{0, 0}, {1, 0}}})
    for (const double alpha : {1e-310, 0.3, 0.5, 0.8, 1.0, 2.0, 30.0, 1e200, infinity}) check_full(points, alpha);
}

TEST_SUITE_END();
