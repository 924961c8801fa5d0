#include "meshops/topology/build_mesh.h"

#include <doctest/doctest.h>

#include <map>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/topology/soup_defects.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/laws.h"
#include "support/on_corpus.h"
#include "support/snapshot.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

bool same(const PolygonSoup& a, const PolygonSoup& b) {
  return a.points == b.points && a.corners == b.corners && a.begin == b.begin;
}

std::vector<SoupDefect> all_but_pinches(const PolygonSoup& s) {
  auto defects = find_defects(s);
  std::erase_if(defects, [](const SoupDefect& d) { return d.kind == SoupDefectKind::pinch; });
  return defects;
}

/// Checks everything that the header promises of the handles.
void check_built(const TestMesh& mesh, const std::vector<std::uint32_t>& points, const PolygonSoup& s) {
  check_sound(mesh);
  REQUIRE(points.size() == mesh.n_vertices());
  std::map<std::uint32_t, std::size_t> vertices_on;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (v < s.points) CHECK(points[v] == v);
    ++vertices_on[points[v]];
  }
  std::map<std::uint32_t, std::size_t> fans;
  for (const SoupDefect& d : find_defects(s)) {
    REQUIRE(d.kind == SoupDefectKind::pinch);
    fans[d.points[0]] = d.faces.size();
    // The first fan keeps the number of the point, and the others follow in the order of their first faces.
    for (std::size_t i = 0; i < d.faces.size(); ++i) {
      Vertex at;
      for (const Vertex v : mesh.fv_range(Face(static_cast<int>(d.faces[i]))))
        if (points[static_cast<std::size_t>(v.idx())] == d.points[0]) at = v;
      CHECK((static_cast<std::size_t>(at.idx()) < s.points) == (i == 0));
    }
  }
  for (const auto& [point, count] : vertices_on) CHECK(count == (fans.contains(point) ? fans[point] : 1));
  REQUIRE(mesh.n_faces() == s.faces());
  for (std::size_t f = 0; f < s.faces(); ++f) {
    std::vector<std::uint32_t> corners;
    const Halfedge first = mesh.halfedge_handle(Face(static_cast<int>(f)));
    Halfedge h = first;
    do {
      corners.push_back(points[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())]);
      CHECK(mesh.face_handle(h) == Face(static_cast<int>(f)));
      h = mesh.next_halfedge_handle(h);
    } while (h != first);
    const auto face = s.face(f);
    CHECK(corners == std::vector<std::uint32_t>(face.begin(), face.end()));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (int e = 0; e < static_cast<int>(mesh.n_edges()); ++e) {
    const Halfedge h = mesh.halfedge_handle(OpenMesh::EdgeHandle(e), 0);
    const std::uint32_t a = points[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())],
                        b = points[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
    ends.push_back({std::min(a, b), std::max(a, b)});
  }
  for (std::size_t e = 1; e < ends.size(); ++e) CHECK(ends[e - 1] < ends[e]);
}

}  // namespace

TEST_SUITE("build_mesh") {
  TEST_CASE("faces, vertices and edges have the numbers that the header promises") {
    for (const PolygonSoup& s : {PolygonSoup{}, soup(3, {}), soup(3, {{0, 1, 2}}), soup(7, {{2, 3, 1, 5}, {2, 5, 0}}),
                                 grid_soup(5, 4, true, true), beside(grid_soup(2, 2, false, false), soup(1, {})),
                                 soup(5, {{0, 1, 2, 3}, {3, 2, 1, 4}}), soup(4, {{0, 1, 2}, {0, 2, 1, 3}})}) {
      TestMesh mesh;
      INFO(text(s));
      check_built(mesh, build_mesh(mesh, s), s);
    }
  }

  TEST_CASE("a pinch has a vertex for each fan") {
    const PolygonSoup s = soup(8, {{0, 1, 2}, {3, 4, 0}, {0, 2, 7}, {5, 6, 0}});
    TestMesh mesh;
    const auto points = build_mesh(mesh, s);
    CHECK(points == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 0, 0});
    check_built(mesh, points, s);
  }

  TEST_CASE("a mesh that has no status is built as well") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    build_mesh(mesh, grid_soup(4, 3, true, false));
    check_sound(mesh);
  }

  TEST_CASE("every soup whose only defects are pinches is built, and all others are refused with the first defect") {
    std::mt19937 random(7);
    int built = 0, pinched = 0, refused = 0;
    for (int round = 0; round < rbpa_test::trials(6000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      INFO(text(s));
      TestMesh mesh;
      const auto bad = all_but_pinches(s);
      if (bad.empty()) {
        const auto points = build_mesh(mesh, s);
        check_built(mesh, points, s);
        CHECK(same(soup_of(mesh, points), s));
        ++built;
        pinched += points.size() > s.points;
      } else {
        check_refused(mesh, "build_mesh: " + describe(bad.front()), [&] { build_mesh(mesh, s); });
        CHECK(mesh.n_vertices() + mesh.n_edges() + mesh.n_faces() == 0);
        ++refused;
      }
    }
    CHECK(built > rbpa_test::trials(500));
    CHECK(pinched > rbpa_test::trials(100));
    CHECK(refused > 500);
  }

  TEST_CASE("a mesh that is not empty is refused, and stays as it was") {
    TestMesh mesh;
    mesh.new_vertex();
    check_refused(mesh, "build_mesh: the mesh is not empty", [&] { build_mesh(mesh, soup(3, {{0, 1, 2}})); });
  }

  TEST_CASE("the corpus converted to soups and back is the same up to handles, and gives the same soups again") {
    int there_and_back = 0;
    on_corpus([&](const Specimen& specimen, TestMesh& mesh) {
      mesh.new_vertex();
      const PolygonSoup s = soup_of(mesh);
      CHECK(find_defects(s).empty() == specimen.simplicial);
      if (!specimen.simplicial) return;
      mesh.garbage_collection();
      TestMesh again;
      const auto points = build_mesh(again, s);
      check_sound(again);
      CHECK(isomorphism_class(again) == isomorphism_class(mesh));
      CHECK(same(soup_of(again, points), s));
      ++there_and_back;
    });
    CHECK(there_and_back >= 8);
  }

  TEST_CASE("fans that were merged in a point get separate vertices again") {
    // Three copies of a specimen with a boundary, all standing on one point of it.
    on_corpus([&](const Specimen& specimen, TestMesh& mesh) {
      if (!specimen.simplicial || mesh.n_faces() > 100) return;
      const PolygonSoup one = soup_of(mesh);
      const PolygonSoup apart = beside(beside(one, one), one);
      PolygonSoup merged = apart;
      for (std::uint32_t& corner : merged.corners)
        if (corner % one.points == 0) corner = 0;
      TestMesh expected, found;
      build_mesh(expected, apart);
      const auto points = build_mesh(found, merged);
      CHECK(points.size() == apart.points + 2);  // the two points that no face names are isolated now
      CHECK(std::count(points.begin(), points.end(), 0U) == 3);
      for (int i = 0; i < 2; ++i) expected.new_vertex();
      CHECK(isomorphism_class(found) == isomorphism_class(expected));
    });
  }

  TEST_CASE("the soup of a mesh with deletions has the live faces, and a deleted vertex is a point without a face") {
    TestMesh mesh;
    build_mesh(mesh, soup(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    mesh.delete_face(Face(0), true);
    const PolygonSoup left = soup_of(mesh);
    CHECK(same(left, soup(5, {{0, 2, 3}, {0, 3, 4}})));
    CHECK_THROWS_AS(soup_of(mesh, {0, 1}), ContractViolation);
  }
}
