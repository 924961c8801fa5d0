#include "meshops/core/live_range.h"

#include <doctest/doctest.h>

#include <vector>

#include "meshops/handle/destroy.h"
#include "support/corpus.h"
#include "support/on_corpus.h"

using namespace meshops;
using namespace meshops::test;

static_assert(std::forward_iterator<LiveRange<Face>::Iterator>);

TEST_SUITE("live ranges") {
  TEST_CASE("a range has the elements that for_each_…() visits, in the same order") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      for (int i = 0; i < static_cast<int>(mesh.n_faces()); i += 3)  // the first and others are deleted
        if (!remove_triangle_blocker(mesh, Face(i))) remove_triangle(mesh, Face(i));
      const auto same = [&](auto range, auto for_each) {
        using Element = std::remove_cvref_t<decltype(*range.begin())>;
        std::vector<Element> visited, in_range(range.begin(), range.end());
        for_each([&](Element element) { visited.push_back(element); });
        CHECK(in_range == visited);
        CHECK(range.empty() == visited.empty());
      };
      same(live_vertices(mesh), [&](auto visit) { for_each_vertex(mesh, visit); });
      same(live_halfedges(mesh), [&](auto visit) { for_each_halfedge(mesh, visit); });
      same(live_edges(mesh), [&](auto visit) { for_each_edge(mesh, visit); });
      same(live_faces(mesh), [&](auto visit) { for_each_face(mesh, visit); });
    });
  }

  TEST_CASE("a loop that deletes and adds elements visits neither deleted nor added ones") {
    TestMesh mesh = built(corpus()[6]);
    const std::size_t vertices = mesh.n_vertices();
    std::size_t removed = 0;
    for (const Face f : live_faces(mesh)) {
      REQUIRE(is_live(mesh, f));
      remove_triangle(mesh, f);
      ++removed;
    }
    CHECK(removed == mesh.n_faces());
    CHECK(live_faces(mesh).empty());
    for (const Vertex v : live_vertices(mesh)) CHECK_MESSAGE(false, "vertex " << v.idx() << " is left");
    std::size_t visited = 0;
    TestMesh fresh;
    for (int i = 0; i < 3; ++i) fresh.new_vertex();
    for ([[maybe_unused]] const Vertex v : live_vertices(fresh)) {
      fresh.new_vertex();
      ++visited;
    }
    CHECK(visited == 3);
    CHECK(vertices > 3);
  }
}
