#include "rbpa/space/balls/full/faces_within.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "rbpa/space/balls/regular_triangulation.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/random.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::space::Ball;
using rbpa::space::FacesWithin;

TEST_SUITE_BEGIN("space");

namespace {

using Simplex = std::vector<std::uint32_t>;

/// Returns the tetrahedra, triangles and edges of the complex.
std::set<Simplex> simplices(const FacesWithin& faces, const rbpa::space::Triangulated& cells) {
  std::set<Simplex> found;
  const auto add = [&](Simplex simplex) {
    std::sort(simplex.begin(), simplex.end());
    found.insert(simplex);
  };
  for (std::uint32_t t = 0; t < cells.simplices.size(); ++t) {
    const auto& row = cells.simplices[t];
    if (faces.has_tetrahedron(t)) add({row.begin(), row.end()});
    for (std::size_t k = 0; k < 4; ++k)
      if (faces.has_triangle(t, k)) add({row[(k + 1) % 4], row[(k + 2) % 4], row[(k + 3) % 4]});
  }
  rbpa::Threads threads(1);
  rbpa::space::for_each_edge(
      cells, rbpa::space::PointStars(cells), threads,
      [&](std::uint32_t, std::uint32_t, auto ring) { return faces.has_edge(ring); },
      [&](std::uint32_t a, std::uint32_t b) {
        add({a, b});
      });
  return found;
}

}  // namespace

TEST_CASE("with equal radii the dual complex of balls is the full alpha complex") {
  for (const SolidSet& set : solid_sets(120)) {
    CAPTURE(set.name);
    const rbpa::Solid delaunay = rbpa::solid(set.points, std::numeric_limits<double>::infinity());
    const std::vector<double> radii = rbpa::circumradii(set.points, delaunay.simplices);
    const rbpa::space::Triangulated cells(set.points, delaunay);
    rbpa::Threads threads(1);
    std::vector<double> alphas = radii;
    std::sort(alphas.begin(), alphas.end());
    for (const std::size_t part : {1U, 3U, 6U, 9U}) {
      if (alphas.empty()) continue;
      const double alpha = alphas[alphas.size() * part / 10];
      const std::vector<double> all(set.points.size(), alpha);
      CHECK(simplices(FacesWithin(cells, all, threads), cells) ==
            simplices(FacesWithin(cells, radii, alpha, threads), cells));
    }
  }
}

TEST_CASE("a simplex is in the dual complex if no ball conflicts and its least power is not positive, or as a face") {
  Random random(2);
  for (int set = 0; set < 300; ++set) {
    Points3 centers;
    std::vector<double> radii;
    const bool is_grid = set % 2 == 0;
    for (int i = 0; i < 12; ++i) {
      const auto number = [&] { return is_grid ? random.integer(0, 3) : random.between(0, 3); };
      centers.push_back({number(), number(), number()});
      radii.push_back(is_grid ? 0.5 * random.integer(0, 3) : random.between(0, 1.5));
    }
    const rbpa::RegularTriangulation regular = rbpa::regular_triangulation(centers, radii);
    const rbpa::space::Triangulated cells(centers, regular);
    rbpa::Threads threads(1);
    const std::set<Simplex> found = simplices(FacesWithin(cells, radii, threads), cells);
    std::set<Simplex> expected;
    const auto ball = [&](std::uint32_t i) { return Ball{centers[i], radii[i]}; };
    const auto no_conflict = [&](const auto&... of) {
      for (std::uint32_t q = 0; q < centers.size(); ++q)
        if (is_conflict(of..., ball(q))) return false;
      return true;
    };
    for (const auto& row : regular.simplices) {
      const auto [a, b, c, d] = std::array{ball(row[0]), ball(row[1]), ball(row[2]), ball(row[3])};
      if (least_power_sign(a, b, c, d) <= 0) {
        for (unsigned bits = 0; bits < 16; ++bits) {
          Simplex face;
          for (std::size_t k = 0; k < 4; ++k)
            if ((bits >> k & 1U) != 0) face.push_back(row[k]);
          std::sort(face.begin(), face.end());
          if (face.size() > 1) expected.insert(face);
        }
        continue;
      }
      for (std::size_t k = 0; k < 4; ++k) {
        Simplex face = {row[(k + 1) % 4], row[(k + 2) % 4], row[(k + 3) % 4]};
        std::sort(face.begin(), face.end());
        const Ball e = ball(face[0]), f = ball(face[1]), g = ball(face[2]);
        if (least_power_sign(e, f, g) <= 0 && no_conflict(e, f, g))
          for (const Simplex& of : {face, Simplex{face[0], face[1]}, {face[0], face[2]}, {face[1], face[2]}})
            expected.insert(of);
        for (const Simplex& edge : {Simplex{face[0], face[1]}, {face[0], face[2]}, {face[1], face[2]}})
          if (least_power_sign(ball(edge[0]), ball(edge[1])) <= 0 && no_conflict(ball(edge[0]), ball(edge[1])))
            expected.insert(edge);
      }
    }
    CHECK(found == expected);
  }
}

TEST_SUITE_END();
