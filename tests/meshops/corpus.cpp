#include "support/corpus.h"
#include "support/check_sound.h"
#include "support/on_corpus.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "meshops/topology/count.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("corpus") {
  TEST_CASE("every specimen is sound and has the topology that is listed for it") {
    on_corpus([&](const Specimen& specimen, TestMesh& mesh) {
      check_sound(mesh);
      const TopologyCounts counts = count_topology(mesh);
      CHECK(counts.isolated == 0);
      CHECK(static_cast<int>(counts.components) == specimen.components);
      CHECK(static_cast<int>(counts.boundary_curves) == specimen.boundary_curves);
      CHECK(counts.genus() == specimen.genus);
      std::vector<std::pair<int, int>> ends;
      for (int e = 0; e < static_cast<int>(mesh.n_edges()); ++e) {
        if (mesh.status(Edge(e)).deleted()) continue;
        const Halfedge h(2 * e);
        ends.emplace_back(std::minmax({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx()}));
      }
      std::sort(ends.begin(), ends.end());
      CHECK((std::adjacent_find(ends.begin(), ends.end()) == ends.end()) == specimen.simplicial);
    });
  }

  TEST_CASE("the isomorphism class distinguishes the specimens and does not depend on handles") {
    std::vector<std::string> classes;
    on_corpus([&](const Specimen&, TestMesh& mesh) { classes.push_back(isomorphism_class(mesh)); });
    TestMesh mirrored;
    add_triangles(mirrored, 4, {{2, 3, 1}, {1, 3, 0}, {3, 2, 0}, {1, 0, 2}});
    CHECK(isomorphism_class(mirrored) == classes[5]);
    std::sort(classes.begin(), classes.end());
    CHECK(std::adjacent_find(classes.begin(), classes.end()) == classes.end());
  }
}
