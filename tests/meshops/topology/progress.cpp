// Long computations on soups call go_on(), and end when it returns false. examine() equals report() and find_defects().
#include "meshops/core/progress.h"

#include <doctest/doctest.h>
#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "meshops/topology/build_mesh.h"
#include "meshops/topology/examine.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/repair.h"
#include "support/arguments.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Corners = std::vector<std::uint32_t>;
constexpr std::size_t faces = 60000;

PolygonSoup made_of(std::size_t points, const std::function<Corners(std::uint32_t)>& face) {
  PolygonSoup made;
  made.points = points;
  for (std::uint32_t f = 0; f < faces; ++f) made.add_face(face(f));
  return made;
}

/// Returns soups on which some step has much to do.
std::vector<std::pair<std::string, PolygonSoup>> large_soups() {
  PolygonSoup polygon;
  polygon.points = 3 * faces;
  Corners cycle(polygon.points);
  for (std::uint32_t i = 0; i < cycle.size(); ++i) cycle[i] = i * 7919U % static_cast<std::uint32_t>(cycle.size());
  polygon.add_face(cycle);
  return {{"torus", grid_soup(300, 100, true, true)},
          {"degenerate", made_of(3,
                                 [](std::uint32_t) {
                                   return Corners{0, 1, 1};
                                 })},
          {"duplicates", made_of(3,
                                 [](std::uint32_t) {
                                   return Corners{0, 1, 2};
                                 })},
          {"book", made_of(faces + 2,
                           [](std::uint32_t f) {
                             return Corners{0, 1, f + 2};
                           })},
          {"apart", made_of(3 * faces,
                            [](std::uint32_t f) {
                              return Corners{3 * f, 3 * f + 1, 3 * f + 2};
                            })},
          {"one point", made_of(2 * faces + 1,
                                [](std::uint32_t f) {
                                  return Corners{0, 2 * f + 1, 2 * f + 2};
                                })},
          {"either way", made_of(faces + 2,
                                 [](std::uint32_t f) {
                                   return Corners{f, f + 1, f + 2};
                                 })},
          {"polygon", polygon}};
}

/// Checks work(go_on) on data with this number of corners: it calls go_on at least once for each 16384 of them, and
/// ends whenever go_on returns false.
void is_watched(std::size_t corners, const std::function<void(const GoOn&)>& work) {
  std::size_t asked = 0;
  work([&] {
    ++asked;
    return true;
  });
  CHECK(asked >= corners / 16384);
  for (const std::size_t last : {std::size_t{1}, asked / 2, asked}) {
    std::size_t left = last;
    CHECK_THROWS_AS(work([&] { return --left > 0; }), Cancelled);
    CHECK(left == 0);  // it was not called again
  }
}

}  // namespace

TEST_SUITE("progress") {
  TEST_CASE("every computation on a soup can be watched and cancelled, whatever its defects") {
    for (const auto& named : large_soups()) {
      CAPTURE(named.first);
      const auto& given = named.second;
      const std::size_t corners = given.corners.size();
      is_watched(corners, [&](const GoOn& go_on) { find_defects(given, go_on); });
      is_watched(corners, [&](const GoOn& go_on) { report(given, go_on); });
      is_watched(corners, [&](const GoOn& go_on) { examine(given, go_on); });
      is_watched(corners, [&](const GoOn& go_on) { repair(given, go_on); });
    }
  }

  TEST_CASE("a mesh whose construction was cancelled is empty, and can be built again") {
    const PolygonSoup torus = grid_soup(300, 100, true, true);
    is_watched(torus.corners.size(), [&](const GoOn& go_on) {
      OpenMesh::PolyConnectivity fresh;
      try {
        build_mesh(fresh, torus, go_on);
      } catch (const Cancelled&) {
        CHECK(fresh.n_vertices() + fresh.n_edges() + fresh.n_faces() == 0);
        build_mesh(fresh, torus);
        CHECK(fresh.n_faces() == torus.faces());
        throw;
      }
    });
  }

  TEST_CASE("the computation of generators can be watched and cancelled") {
    OpenMesh::PolyConnectivity mesh;
    build_mesh(mesh, grid_soup(300, 100, true, true));
    is_watched(3 * faces, [&](const GoOn& go_on) { homology(mesh, go_on); });
    const std::vector<double> lengths(mesh.n_edges(), 1.5);
    is_watched(3 * faces, [&](const GoOn& go_on) { homology(mesh, lengths, go_on); });
  }

  TEST_CASE("the report of a mesh can be watched and cancelled, whatever its boundary") {
    for (const auto& named : large_soups()) {
      CAPTURE(named.first);
      const auto& given = named.second;
      if (!find_defects(given).empty()) continue;
      OpenMesh::PolyConnectivity mesh;
      const std::vector<std::uint32_t> point_of = build_mesh(mesh, given);
      // Every vertex, edge and halfedge is visited at least once, and most of them several times.
      const std::size_t passed = mesh.n_vertices() + 3 * mesh.n_halfedges();
      is_watched(passed, [&](const GoOn& go_on) { report(mesh, point_of, go_on); });
    }
  }
}

TEST_SUITE("examine") {
  TEST_CASE("examine() equals report() and find_defects()") {
    for (const auto& named : large_soups()) {
      CAPTURE(named.first);
      const auto& given = named.second;
      const Examination both = examine(given);
      CHECK(both.report == report(given));
      CHECK(both.defects == find_defects(given));
    }
    std::mt19937 random(8);
    for (int round = 0; round < rbpa_test::trials(300); ++round) {
      const PolygonSoup given = round % 2 ? random_soup(random) : broken_surface(random);
      const Examination both = examine(given);
      CHECK(both.report == report(given));
      CHECK(both.defects == find_defects(given));
    }
  }
}
