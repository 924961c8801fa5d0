#include "meshops/handle/separate_fans.h"

#include <doctest/doctest.h>

#include <random>

#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/repair.h"
#include "support/arguments.h"
#include "support/bowties.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/on_corpus.h"
#include "support/snapshot.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("separate_fans") {
  TEST_CASE("a sound mesh is not touched") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      const auto before = snapshot(mesh);
      CHECK(separate_fans(mesh).empty());
      CHECK(snapshot(mesh) == before);
    });
  }

  TEST_CASE(
      "tied fans are separated: a vertex for each fan, the same faces, each copy on the point of its old vertex") {
    std::mt19937 random(3);
    int copies = 0;
    for (int round = 0; round < rbpa_test::trials(3000); ++round) {
      const Repair repaired = repair(round % 4 ? random_soup(random) : broken_surface(random));
      TestMesh mesh;
      build_mesh(mesh, repaired.soup);
      const std::string apart = isomorphism_class(mesh);
      const std::size_t vertices = mesh.n_vertices();
      tie_points(mesh, repaired.stands_on);
      for (int v = 0; v < static_cast<int>(vertices); ++v) mesh.set_point(Vertex(v), {float(v), 0, 0});
      const auto fans = separate_fans(mesh);
      check_sound(mesh);
      CHECK(isomorphism_class(mesh) == apart);
      CHECK(mesh.n_vertices() == vertices + fans.size());
      for (std::size_t i = 0; i < fans.size(); ++i)
        CHECK(mesh.point(Vertex(static_cast<int>(vertices + i))) == mesh.point(fans[i]));
      copies += static_cast<int>(fans.size());
    }
    CHECK(copies > 1000);
  }

  TEST_CASE("several fans are found where there are several, and only there") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 3);
    mesh.new_vertex();
    for_each_vertex(mesh, [&](Vertex v) { CHECK_FALSE(has_several_fans(mesh, v)); });
    const Vertex at = mesh.from_vertex_handle(b[0]);
    tie(mesh, at, mesh.from_vertex_handle(b[3]));
    tie(mesh, at, mesh.from_vertex_handle(b[6]));
    for_each_vertex(mesh, [&](Vertex v) { CHECK(has_several_fans(mesh, v) == (v == at)); });
    CHECK(separate_fans(mesh) == std::vector<Vertex>{at, at});
    for_each_vertex(mesh, [&](Vertex v) { CHECK_FALSE(has_several_fans(mesh, v)); });
    check_sound(mesh);
  }
}
