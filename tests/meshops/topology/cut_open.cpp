#include "meshops/topology/cut_open.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "meshops/core/contract.h"
#include "meshops/core/live_range.h"
#include "meshops/topology/report.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/laws.h"
#include "support/on_corpus.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("cut_open") {
  TEST_CASE("cut along the cut graph every component is a disc, and gluing back restores every live record") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      const auto before = live_snapshot(mesh, Named::any);
      const TopologyCounts counts = count_topology(mesh);
      const std::vector<UnglueEffect> cuts = cut_open(mesh, homology(mesh));
      Delta delta;
      for (const UnglueEffect& cut : cuts) delta = delta + cut.delta();
      check_changed_by(delta, counts, mesh);
      const TopologyReport cut = report(mesh);
      CHECK(cut.per_component.size() == counts.components);
      for (const ComponentReport& piece : cut.per_component) {
        CHECK(piece.euler() == 1);
        CHECK(piece.boundary_curves == 1);
      }
      glue_back(mesh, cuts);
      check_sound(mesh);
      CHECK(live_snapshot(mesh, Named::any) == before);
    });
  }

  TEST_CASE("new vertices have the points of the old ones, and edges cut in any order give the same pieces") {
    TestMesh mesh, backwards;
    for (TestMesh* m : {&mesh, &backwards}) corpus()[6].build(*m);
    for (const Vertex v : live_vertices(mesh)) mesh.set_point(v, {static_cast<float>(v.idx()), 1, 2});
    std::vector<Edge> edges = homology(mesh).cut_graph;
    const std::size_t vertices = mesh.n_vertices();
    for (const UnglueEffect& cut : cut_open(mesh, edges)) {
      for (const auto& [copy, of] : {std::pair(cut.new_start, mesh.from_vertex_handle(cut.first)),
                                     {cut.new_end, mesh.to_vertex_handle(cut.first)}})
        if (copy.is_valid()) CHECK(mesh.point(copy)[1] == 1);
    }
    CHECK(mesh.n_vertices() >= vertices);
    std::reverse(edges.begin(), edges.end());
    cut_open(backwards, edges);
    CHECK(isomorphism_class(mesh) == isomorphism_class(backwards));
  }

  TEST_CASE("edges that cannot be cut are refused with the edge named, and the mesh untouched") {
    TestMesh mesh;
    separate_triangles(mesh, 1);
    const std::vector<Edge> on_boundary = {Edge(0)}, none = {Edge(99)};
    check_refused(mesh, "cut_open: edge 0 is on the boundary", [&] { cut_open(mesh, on_boundary); });
    check_refused(mesh, "cut_open: edge 99 does not exist or is deleted", [&] { cut_open(mesh, none); });
    TestMesh closed;
    corpus()[6].build(closed);
    Edge inner;
    for (const Edge e : live_edges(closed))
      if (!closed.is_boundary(e)) inner = e;
    const std::vector<Edge> twice = {inner, inner};
    check_refused(closed, "is named twice", [&] { cut_open(closed, twice); });
    CHECK(*cut_open_blocker(closed, twice) == Blocker(BlockerKind::named_twice, inner));
  }
}
