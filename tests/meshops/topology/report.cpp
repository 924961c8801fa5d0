#include "meshops/topology/report.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

#include "meshops/core/contract.h"
#include "meshops/handle/separate_fans.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/count.h"
#include "support/arguments.h"
#include "support/bowties.h"
#include "support/corpus.h"
#include "support/on_corpus.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Returns a report as text, for messages.
std::string text(const TopologyReport& r) {
  std::string all;
  for (const std::size_t n :
       {r.vertices, r.edges, r.faces, r.components, r.solid_components, r.boundary_curves, r.pinches, r.isolated})
    all += std::to_string(n) + ' ';
  all += r.genus ? std::to_string(*r.genus) : "none";
  for (const long b : r.betti) all += ' ' + std::to_string(b);
  for (const ComponentReport& c : r.per_component) {
    all += " |";
    for (const std::size_t n : {c.vertices, c.edges, c.faces, c.boundary_curves, c.first_face})
      all += ' ' + std::to_string(n);
    all += c.orientable ? " orientable" : " flat";
  }
  return all;
}

void check_euler(const TopologyReport& r) {
  CHECK(r.euler() == r.betti[0] - r.betti[1] + r.betti[2]);
  for (const ComponentReport& c : r.per_component) {
    CHECK(c.euler() == c.betti()[0] - c.betti()[1] + c.betti()[2]);
    if (c.orientable) CHECK(c.euler() == 2 - 2 * *c.genus() - static_cast<long>(c.boundary_curves));
  }
}

/// Returns whether the soup becomes a mesh with only a vertex for each fan.
bool is_oriented(const PolygonSoup& s) {
  for (const SoupDefect& defect : find_defects(s))
    if (defect.kind != SoupDefectKind::pinch) return false;
  return true;
}

}  // namespace

TEST_SUITE("report") {
  TEST_CASE("classical surfaces have their numbers") {
    struct Known {
      PolygonSoup soup;
      std::size_t curves;
      std::optional<long> genus;
      BettiNumbers betti;
    };
    const PolygonSoup torus = grid_soup(5, 4, true, true);
    for (const auto& [s, curves, genus, betti] : {
             Known{soup(3, {{0, 1, 2}}), 1, 0, {1, 0, 0}},
             Known{soup(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), 0, 0, {1, 0, 1}},
             Known{grid_soup(5, 4, true, false), 2, 0, {1, 1, 0}},
             Known{torus, 0, 1, {1, 2, 1}},
             Known{moebius_band(), 1, std::nullopt, {1, 1, 0}},
             Known{grid_soup(5, 4, true, false, true), 1, std::nullopt, {1, 1, 0}},
             Known{klein_bottle(), 0, std::nullopt, {1, 2, 1}},
             Known{projective_plane(), 0, std::nullopt, {1, 1, 1}},
         }) {
      const TopologyReport r = report(s);
      INFO(text(r));
      CHECK(r.vertices == s.points);
      CHECK(r.faces == s.faces());
      CHECK(r.components == 1);
      CHECK(r.solid_components == 1);
      CHECK(r.boundary_curves == curves);
      CHECK(r.genus == genus);
      CHECK(r.betti == betti);
      CHECK(r.pinches == 0);
      CHECK(r.isolated == 0);
      REQUIRE(r.per_component.size() == 1);
      CHECK(r.per_component[0].betti() == betti);
      CHECK(r.per_component[0].genus() == genus);
      CHECK(r.per_component[0].orientable == genus.has_value());
      check_euler(r);
    }
  }

  TEST_CASE("an empty soup and isolated points have their numbers") {
    TopologyReport nothing;
    nothing.genus = 0;
    CHECK(report(PolygonSoup{}) == nothing);
    const TopologyReport r = report(soup(3, {}));
    CHECK(r.vertices == 3);
    CHECK(r.isolated == 3);
    CHECK(r.components == 3);
    CHECK(r.solid_components == 0);
    CHECK(r.genus == 0L);
    CHECK(r.betti == BettiNumbers{3, 0, 0});
  }

  TEST_CASE("pieces that touch in a point are one component and two solid ones") {
    const TopologyReport r = report(soup(6, {{0, 1, 2}, {0, 3, 4}}));
    CHECK(r.components == 2);
    CHECK(r.isolated == 1);
    CHECK(r.solid_components == 2);
    CHECK(r.boundary_curves == 2);
    CHECK(r.pinches == 1);
    CHECK(r.betti == BettiNumbers{2, 0, 0});
  }

  TEST_CASE("a ring of triangles that touch has a hole that no piece has") {
    const TopologyReport r = report(soup(6, {{0, 1, 2}, {2, 3, 4}, {4, 5, 0}}));
    CHECK(r.pinches == 3);
    CHECK(r.genus == 0L);
    CHECK(r.betti == BettiNumbers{1, 1, 0});
    for (const ComponentReport& c : r.per_component) CHECK(c.betti() == BettiNumbers{1, 0, 0});
  }

  TEST_CASE("pieces end at the common edge of two tetrahedra, and cavities are counted") {
    const TopologyReport edge =
        report(soup(6, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}}));
    CHECK(edge.betti == BettiNumbers{1, 0, 2});
    CHECK(edge.solid_components == 2);
    CHECK(edge.boundary_curves == 2);
    CHECK(edge.genus == std::nullopt);
    CHECK(edge.edges == 11);
    const TopologyReport face =
        report(soup(5, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 0}}));
    CHECK(face.betti == BettiNumbers{1, 0, 2});
    CHECK(face.solid_components == 3);
    CHECK(face.pinches == 0);
  }

  TEST_CASE("a book of pages has a piece for each, and no holes") {
    const TopologyReport r = report(soup(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
    CHECK(r.solid_components == 3);
    CHECK(r.boundary_curves == 3);
    CHECK(r.edges == 7);
    CHECK(r.pinches == 0);
    CHECK(r.betti == BettiNumbers{1, 0, 0});
  }

  TEST_CASE("reports of random soups agree with the boundary matrices and searches") {
    std::mt19937 random(4);
    int cut = 0, flat = 0, pinched = 0, cavities = 0, isolated = 0, holes = 0;
    for (int round = 0; round < rbpa_test::trials(5000); ++round) {
      const PolygonSoup s = round % 4 ? random_soup(random) : broken_surface(random);
      const TopologyReport r = report(s);
      INFO(meshops::test::text(s));
      REQUIRE(text(r) == text(report_by_brute_force(s)));
      REQUIRE(r == report_by_brute_force(s));
      check_euler(r);
      for (const ComponentReport& c : r.per_component) flat += !c.orientable;
      for (const SoupDefect& d : find_defects(s)) cut += d.kind == SoupDefectKind::non_manifold_edge;
      pinched += r.pinches > 0;
      cavities += r.betti[2] > 0;
      holes += r.betti[1] > 1;
      isolated += r.isolated > 0;
    }
    for (const int times : {cut, flat, pinched, cavities, isolated, holes}) CHECK(times > rbpa_test::trials(200));
  }

  TEST_CASE("a mesh has the report of its soup, pinched or not") {
    std::mt19937 random(5);
    int pinched = 0, plain = 0;
    for (int round = 0; round < rbpa_test::trials(6000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      if (!is_oriented(s)) continue;
      TestMesh mesh;
      const auto points = build_mesh(mesh, s);
      const TopologyReport r = report(s);
      INFO(meshops::test::text(s));
      REQUIRE(text(report(mesh, points)) == text(r));
      REQUIRE(report(mesh, points) == r);
      ++(r.pinches > 0 ? pinched : plain);
      // Each vertex stands on a point of its own.
      const TopologyReport apart = report(mesh);
      CHECK(apart.per_component == r.per_component);
      CHECK(apart.components == r.solid_components + r.isolated);
      CHECK(apart.pinches == 0);
      check_euler(apart);
    }
    CHECK(pinched > rbpa_test::trials(100));
    CHECK(plain > rbpa_test::trials(200));
  }

  TEST_CASE("a mesh with bowties has the report of its faces: fans are separate, and no curve passes a pinch") {
    TestMesh two;
    for (int i = 0; i < 5; ++i) two.new_vertex();
    two.add_face(Vertex(0), Vertex(1), Vertex(2));
    two.add_face(Vertex(0), Vertex(3), Vertex(4));
    const TopologyReport r = report(two);
    CHECK(r.solid_components == 2);
    CHECK(r.components == 1);
    CHECK(r.boundary_curves == 2);
    CHECK(r.pinches == 1);
    CHECK(r.genus == 0L);
    CHECK(r.betti == BettiNumbers{1, 0, 0});

    std::mt19937 random(7);
    int pinched = 0;
    for (int round = 0; round < rbpa_test::trials(8000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      if (!is_oriented(s)) continue;
      TestMesh mesh;
      tie_points(mesh, build_mesh(mesh, s));
      INFO(meshops::test::text(s));
      REQUIRE(text(report(mesh)) == text(report(s)));
      REQUIRE(report(mesh) == report(s));
      pinched += report(s).pinches > 0;
      // Half of the points stand on the other half.
      std::vector<std::uint32_t> points(mesh.n_vertices());
      for (std::uint32_t v = 0; v < points.size(); ++v) points[v] = v / 2;
      TestMesh apart = mesh;
      std::vector<std::uint32_t> points_of_fans = points;
      for (const Vertex v : separate_fans(apart)) points_of_fans.push_back(points[static_cast<std::size_t>(v.idx())]);
      CHECK(report(mesh, points) == report(apart, points_of_fans));
    }
    CHECK(pinched > rbpa_test::trials(200));
  }

  TEST_CASE("counting a mesh with bowties terminates, whatever it counts") {
    std::mt19937 random(8);
    for (int round = 0; round < rbpa_test::trials(300); ++round) {
      TestMesh mesh;
      separate_triangles(mesh, 6);
      tie_at_random(mesh, 10, random);
      CHECK(count_topology(mesh).faces == 6);
      CHECK(count_topology(mesh).edges == 18);
    }
    TestMesh spoilt;
    const auto b = separate_triangles(spoilt, 2);
    spoilt.set_next_halfedge_handle(b[0], b[3]);  // three halfedges lead into a loop without a way back
    CHECK(count_topology(spoilt).faces == 2);
  }

  TEST_CASE("the corpus has the numbers listed for it, and those of count_topology()") {
    on_corpus([&](const Specimen& specimen, TestMesh& mesh) {
      mesh.new_vertex();
      const TopologyReport r = report(mesh);
      CHECK(r.solid_components == static_cast<std::size_t>(specimen.components));
      CHECK(r.components == r.solid_components + 1);
      CHECK(r.boundary_curves == static_cast<std::size_t>(specimen.boundary_curves));
      CHECK(r.genus == static_cast<long>(specimen.genus));
      CHECK(r.isolated == 1);
      const TopologyCounts counts = count_topology(mesh);
      CHECK(r.vertices == counts.vertices);
      CHECK(r.edges == counts.edges);
      CHECK(r.faces == counts.faces);
      CHECK(r.components == counts.components);
      CHECK(r.genus == counts.genus());
      check_euler(r);
    });
  }

  TEST_CASE("deleted elements of a mesh are not counted") {
    TestMesh mesh;
    const auto points = build_mesh(mesh, grid_soup(5, 4, true, true));
    mesh.delete_face(Face(7), true);
    mesh.delete_vertex(Vertex(3), true);
    const TopologyReport r = report(mesh, points);
    CHECK(r.vertices == 19);
    CHECK(r.genus == 1L);
    CHECK(r.isolated == 0);
    mesh.garbage_collection();
    TopologyReport compact = report(mesh);
    CHECK(compact.per_component.size() == 1);
    CHECK(compact == r);
  }

  TEST_CASE("a mesh with a wrong number of points is refused") {
    TestMesh mesh;
    build_mesh(mesh, soup(3, {{0, 1, 2}}));
    CHECK_THROWS_AS(report(mesh, std::vector<std::uint32_t>{0, 1}), ContractViolation);
    CHECK_THROWS_AS(report(mesh, std::vector<std::uint32_t>{0, 1, 0x80000000}), ContractViolation);
  }

  TEST_CASE("the numbering of points and faces does not matter") {
    std::mt19937 random(6);
    for (int round = 0; round < rbpa_test::trials(1000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      TopologyReport a = report(s), b = report(shuffled(s, random, true).soup);
      const auto by_counts = [](TopologyReport& r) {
        for (ComponentReport& c : r.per_component) c.first_face = 0;
        std::sort(r.per_component.begin(), r.per_component.end(), [](const auto& c, const auto& d) {
          return std::tie(c.vertices, c.edges, c.faces, c.boundary_curves, c.orientable) <
                 std::tie(d.vertices, d.edges, d.faces, d.boundary_curves, d.orientable);
        });
      };
      by_counts(a);
      by_counts(b);
      INFO(meshops::test::text(s));
      REQUIRE(text(a) == text(b));
    }
  }
}
