#include "meshops/core/validate.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "meshops/handle/insert_triangle.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Two triangles joined along an edge; halfedges 0…5 and 6…11 before, edge 3 (halfedges 6, 7) glued away.
struct Pair {
  TestMesh mesh;
  Pair() { strip(mesh, 1); }
  bool has(DefectKind kind) const {
    const auto defects = validate(mesh);
    return std::any_of(defects.begin(), defects.end(), [&](const Defect& d) { return d.kind == kind; });
  }
  Halfedge boundary() const {
    for (const auto h : mesh.halfedges())
      if (mesh.is_boundary(h)) return h;
    return Halfedge();
  }
};

}  // namespace

TEST_SUITE("validate") {
  TEST_CASE_FIXTURE(Pair, "a sound mesh has no defect") { CHECK(validate(mesh).empty()); }

  TEST_CASE_FIXTURE(Pair, "isolated vertices are not defects") {
    mesh.new_vertex();
    CHECK(validate(mesh).empty());
  }

  TEST_CASE_FIXTURE(Pair, "a handle out of range is found, and no other handle is followed") {
    mesh.set_vertex_handle(boundary(), Vertex(1000));
    REQUIRE(validate(mesh).size() == 1);
    CHECK(has(DefectKind::handle_out_of_range));
  }

  TEST_CASE_FIXTURE(Pair, "a halfedge that ends elsewhere is found") {
    const Halfedge h = boundary();
    mesh.set_vertex_handle(h, mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
    CHECK(has(DefectKind::halfedges_do_not_meet));
  }

  TEST_CASE_FIXTURE(Pair, "next without prev is found") {
    const Halfedge h = boundary();
    const Halfedge next = mesh.next_halfedge_handle(h);
    mesh.set_prev_halfedge_handle(next, next);
    CHECK(has(DefectKind::next_and_prev_disagree));
  }

  TEST_CASE_FIXTURE(Pair, "a loop that changes its face is found") {
    mesh.set_face_handle(boundary(), Face(0));
    CHECK(has(DefectKind::face_changes_along_loop));
  }

  TEST_CASE_FIXTURE(Pair, "a face whose halfedge belongs to another face is found") {
    mesh.set_halfedge_handle(Face(0), mesh.halfedge_handle(Face(1)));
    CHECK(has(DefectKind::face_halfedge_elsewhere));
  }

  TEST_CASE_FIXTURE(Pair, "a boundary vertex must be entered by its boundary") {
    const Vertex v = mesh.from_vertex_handle(boundary());
    mesh.set_halfedge_handle(v, mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(boundary())));
    CHECK(has(DefectKind::vertex_halfedge_inner));
  }

  TEST_CASE_FIXTURE(Pair, "a vertex whose halfedge starts elsewhere is found") {
    const Halfedge h = boundary();
    mesh.set_halfedge_handle(mesh.from_vertex_handle(h), mesh.next_halfedge_handle(h));
    CHECK(has(DefectKind::vertex_halfedge_elsewhere));
  }

  TEST_CASE("two fans on one vertex are found") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    const Vertex keep = mesh.from_vertex_handle(b[0]), drop = mesh.from_vertex_handle(b[3]);
    detail::move_fan(mesh, mesh.halfedge_handle(drop), keep);
    mesh.set_isolated(drop);
    const auto defects = validate(mesh);
    REQUIRE(defects.size() == 1);
    CHECK(defects[0] == Defect{DefectKind::vertex_has_several_fans, ElementKind::vertex, keep.idx()});
    CHECK(describe(defects[0]) == "vertex " + std::to_string(keep.idx()) + ": vertex has several fans");
  }

  TEST_CASE("two fans that OpenMesh links in one ring are found, and named by describe()") {
    TestMesh mesh;
    for (int i = 0; i < 5; ++i) mesh.new_vertex();
    mesh.add_face(Vertex(0), Vertex(1), Vertex(2));
    mesh.add_face(Vertex(0), Vertex(3), Vertex(4));
    const auto defects = validate(mesh);
    REQUIRE(defects.size() == 1);
    CHECK(defects[0] == Defect{DefectKind::vertex_has_several_fans, ElementKind::vertex, 0});
  }

  TEST_CASE("a face that has a second loop is found") {
    TestMesh mesh;
    separate_triangles(mesh, 2);
    Halfedge h = mesh.halfedge_handle(Face(1));
    for (int i = 0; i < 3; ++i, h = mesh.next_halfedge_handle(h)) mesh.set_face_handle(h, Face(0));
    mesh.status(Face(1)).set_deleted(true);
    const auto defects = validate(mesh);
    REQUIRE(defects.size() == 1);
    CHECK(defects[0] == Defect{DefectKind::face_has_several_loops, ElementKind::face, 0});
  }

  TEST_CASE("an edge without faces, a loop and a face of two sides are found") {
    TestMesh mesh;
    const Vertex a = mesh.new_vertex(), b = mesh.new_vertex();
    const Halfedge h = mesh.new_edge(a, b), back = mesh.opposite_halfedge_handle(h);
    mesh.set_next_halfedge_handle(h, back);
    mesh.set_next_halfedge_handle(back, h);
    mesh.set_halfedge_handle(a, h);
    mesh.set_halfedge_handle(b, back);
    REQUIRE(validate(mesh).size() == 1);
    CHECK(validate(mesh)[0].kind == DefectKind::dangling_edge);

    const Face f = mesh.new_face();
    mesh.set_halfedge_handle(f, h);
    mesh.set_face_handle(h, f);
    mesh.set_face_handle(back, f);
    REQUIRE(validate(mesh).size() == 1);
    CHECK(validate(mesh)[0].kind == DefectKind::face_too_short);

    mesh.set_vertex_handle(h, a);
    mesh.set_isolated(b);
    const auto defects = validate(mesh);
    CHECK(std::any_of(defects.begin(), defects.end(), [](const Defect& d) { return d.kind == DefectKind::loop_edge; }));
  }
}
