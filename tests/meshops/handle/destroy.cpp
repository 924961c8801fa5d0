#include "meshops/handle/destroy.h"

#include <doctest/doctest.h>

#include <random>

#include "meshops/core/live.h"
#include "meshops/handle/create.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/insert_triangle.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/laws.h"
#include "support/on_corpus.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("destroy") {
  TEST_CASE("a triangle that was created can be destroyed, and nothing is left of it") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      const auto before = live_snapshot(mesh);
      const Face f = create_triangle(mesh).face;
      const TopologyCounts counts = count_topology(mesh);
      const Delta delta = destroy_triangle(mesh, f);
      CHECK(delta == -delta_of_create());
      check_changed_by(delta, counts, mesh);
      CHECK(live_snapshot(mesh) == before);
    });
  }

  TEST_CASE("a refusal names its reason and leaves the mesh as it was") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    glue(mesh, b[0], b[3]);
    CHECK(destroy_triangle_blocker(mesh, Face(0))->kind == BlockerKind::not_on_boundary);
    CHECK(destroy_triangle_blocker(mesh, Face(2))->kind == BlockerKind::missing);
    check_refused(mesh, "is not on the boundary", [&] { destroy_triangle(mesh, Face(0)); });
    TestMesh polygon;
    std::vector<OpenMesh::SmartVertexHandle> corner;
    for (int i = 0; i < 4; ++i) corner.push_back(polygon.new_vertex());
    polygon.add_face(corner[0], corner[1], corner[2], corner[3]);
    CHECK(destroy_triangle_blocker(polygon, Face(0))->kind == BlockerKind::not_triangle);
    check_refused(polygon, "face 0 is not a triangle", [&] { remove_triangle(polygon, Face(0)); });
  }
}

TEST_SUITE("remove_triangle") {
  TEST_CASE("remove_triangle removes any triangle from any specimen, and returns the change of the counts") {
    for (const Specimen& specimen : corpus()) {
      CAPTURE(specimen.name);
      TestMesh whole;
      specimen.build(whole);
      const TopologyCounts counts = count_topology(whole);
      for (int i = 0; i<static_cast<int>(whole.n_faces()); i += whole.n_faces()> 300 ? 37 : 1) {
        TestMesh mesh = whole;
        const Delta delta = remove_triangle(mesh, Face(i));
        CHECK(delta.faces == -1);
        check_changed_by(delta, counts, mesh);
      }
    }
  }

  TEST_CASE("remove_triangle undoes insert_triangle in every attach case") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      int tried = 0;
      for (int i = 0; i < static_cast<int>(mesh.n_halfedges()) && tried < 40; ++i) {
        const Halfedge h(i);
        if (!is_live(mesh, h) || !mesh.is_boundary(h)) continue;
        ++tried;
        const std::string before = isomorphism_class(mesh);
        TriangleSides one;
        one.side[0] = h;
        one.corner[2] = mesh.new_vertex();
        remove_triangle(mesh, insert_triangle(mesh, one).face);
        CHECK(isomorphism_class(mesh) == before);
        const Halfedge next = mesh.next_halfedge_handle(h);
        if (mesh.next_halfedge_handle(next) == h) continue;
        TriangleSides two;
        two.side = {h, next, Halfedge()};
        remove_triangle(mesh, insert_triangle(mesh, two).face);
        CHECK(isomorphism_class(mesh) == before);
        check_sound(mesh);
      }
    });
  }

  TEST_CASE("a mesh is emptied triangle by triangle, in any order, and sound at each step") {
    std::mt19937 random(3);
    for (const Specimen& specimen : corpus()) {
      if (specimen.name == "perforated disc" || specimen.name == "random gluings") continue;
      TestMesh mesh;
      specimen.build(mesh);
      std::vector<int> faces;
      for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i) faces.push_back(i);
      std::shuffle(faces.begin(), faces.end(), random);
      for (const int f : faces) {
        const TopologyCounts counts = count_topology(mesh);
        check_changed_by(remove_triangle(mesh, Face(f)), counts, mesh);
      }
      CHECK(count_topology(mesh) == TopologyCounts());
    }
  }
}
