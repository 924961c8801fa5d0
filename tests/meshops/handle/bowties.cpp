// Handle operators at vertices where fans touch, and at faces that touch themselves: all are refused, with nothing
// changed.
#include <doctest/doctest.h>

#include "meshops/handle/close_curve.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/separate_fans.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "support/bowties.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

const char* const several_fans = "has several fans (separate_fans() gives each a vertex)";

/// Bowtie as OpenMesh makes it, of the triangles 0 1 2 and 0 3 4.
struct Bowtie {
  TestMesh mesh;
  Bowtie() {
    for (int i = 0; i < 5; ++i) mesh.new_vertex();
    mesh.add_face(Vertex(0), Vertex(1), Vertex(2));
    mesh.add_face(Vertex(0), Vertex(3), Vertex(4));
  }
  Halfedge between(int from, int to) const { return mesh.find_halfedge(Vertex(from), Vertex(to)); }
};

/// Makes a sphere of one face: two edges in a row, with the face on both sides of each.
void fold(TestMesh& mesh) {
  const auto b = separate_triangles(mesh, 2);
  glue(mesh, b[0], b[3]);
  const Face quadrangle = close_curve(mesh, b[1]).face;
  remove_triangle(mesh, Face(0));
  remove_triangle(mesh, Face(1));
  const Halfedge side = mesh.opposite_halfedge_handle(mesh.halfedge_handle(quadrangle));
  const Halfedge next = mesh.next_halfedge_handle(side), third = mesh.next_halfedge_handle(next);
  const Halfedge last = mesh.next_halfedge_handle(third);
  REQUIRE(glue(mesh, side, next).what == GlueCase::zip);
  REQUIRE(glue(mesh, third, last).what == GlueCase::close);
}

}  // namespace

TEST_SUITE("bowties") {
  TEST_CASE_FIXTURE(Bowtie, "no triangle of a bowtie is destroyed or removed") {
    CHECK(destroy_triangle_blocker(mesh, Face(0))->kind == BlockerKind::several_fans);
    CHECK(remove_triangle_blocker(mesh, Face(0))->kind == BlockerKind::several_fans);
    check_refused(mesh, several_fans, [&] { destroy_triangle(mesh, Face(1)); });
    check_refused(mesh, several_fans, [&] { remove_triangle(mesh, Face(1)); });
    separate_fans(mesh);
    destroy_triangle(mesh, Face(0));
    destroy_triangle(mesh, Face(1));
    CHECK(count_topology(mesh) == TopologyCounts());
  }

  TEST_CASE("an edge that ends at a bowtie is neither glued nor unglued, whichever end it is") {
    for (const unsigned corner : {0u, 1u}) {
      TestMesh mesh;
      const auto b = separate_triangles(mesh, 4);
      glue(mesh, b[0], b[9]);  // an inner edge from the first triangle to the last
      const Halfedge inner = b[0];
      const Vertex at = corner == 0 ? mesh.from_vertex_handle(inner) : mesh.to_vertex_handle(inner);
      const Halfedge boundary = b[3];
      const Halfedge other = b[6];
      tie(mesh, at, corner == 0 ? mesh.from_vertex_handle(other) : mesh.to_vertex_handle(other));
      for (const Halfedge h : {inner, mesh.opposite_halfedge_handle(inner)}) {
        CHECK(unglue_blocker(mesh, h)->kind == BlockerKind::several_fans);
        check_refused(mesh, several_fans, [&] { unglue(mesh, h); });
        check_refused(mesh, several_fans, [&] { unglue_case(mesh, h); });
      }
      CHECK(glue_blocker(mesh, boundary, other)->kind == BlockerKind::several_fans);
      CHECK(glue_blocker(mesh, other, boundary)->kind == BlockerKind::several_fans);
      check_refused(mesh, several_fans, [&] { glue(mesh, boundary, other); });
      check_refused(mesh, several_fans, [&] { glue(mesh, other, boundary, GlueCase::join); });
      check_refused(mesh, several_fans, [&] { glue_case(mesh, other, boundary); });
    }
  }

  TEST_CASE("edges that OpenMesh's ring makes neighbors at a bowtie are not zipped") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    tie(mesh, mesh.from_vertex_handle(b[0]), mesh.from_vertex_handle(b[3]));
    const Halfedge next = mesh.next_halfedge_handle(mesh.prev_halfedge_handle(b[0]));
    REQUIRE(next == b[0]);
    const Halfedge before = mesh.prev_halfedge_handle(b[0]);
    CHECK(glue_blocker(mesh, before, b[0])->kind == BlockerKind::several_fans);
    CHECK(glue_blocker(mesh, b[0], before)->kind == BlockerKind::several_fans);
  }

  TEST_CASE_FIXTURE(Bowtie, "a curve through a bowtie is neither closed nor sewn") {
    const Halfedge h = between(1, 0);
    REQUIRE(mesh.is_boundary(h));
    CHECK(close_curve_blocker(mesh, h)->kind == BlockerKind::several_fans);
    check_refused(mesh, several_fans, [&] { close_curve(mesh, h); });
    const auto b = separate_triangles(mesh, 2);
    glue(mesh, b[0], b[3]);
    const Halfedge curve = b[1];  // a curve of four edges; the bowtie has one of six
    CHECK(*zip_curves_blocker(mesh, h, curve) == Blocker(BlockerKind::curve_length, curve, 4));
    const auto c = separate_triangles(mesh, 3);
    tie(mesh, mesh.from_vertex_handle(c[0]), mesh.from_vertex_handle(c[3]));
    CHECK(zip_curves_blocker(mesh, h, c[0])->kind == BlockerKind::several_fans);
    const auto d = separate_triangles(mesh, 4);
    for (const unsigned t : {0u, 3u, 6u}) glue(mesh, d[t], d[t + 5]);
    REQUIRE(zip_curves_blocker(mesh, d[1], c[0])->kind == BlockerKind::several_fans);
    check_refused(mesh, several_fans, [&] { zip_curves(mesh, c[0], d[1]); });
  }

  TEST_CASE("a face on both sides of an edge is not removed, because the edge would have no face") {
    TestMesh mesh;
    fold(mesh);
    check_sound(mesh);
    Face face;
    for (const Face f : mesh.faces()) face = f;
    CHECK(open_curve_blocker(mesh, face)->kind == BlockerKind::face_on_both_sides);
    check_refused(mesh, "lies on both sides of an edge", [&] { open_curve(mesh, face); });
  }

  TEST_CASE("a face that passes an inner vertex twice is not removed, because two fans would be left there") {
    // A wheel of six triangles around 0. The triangles 0 1 2 and 0 4 5 and the region between them become one polygon.
    TestMesh mesh;
    for (int i = 0; i < 9; ++i) mesh.new_vertex();
    const auto v = [](int i) { return Vertex(i); };
    mesh.add_face({v(0), v(2), v(3)});
    mesh.add_face({v(0), v(3), v(4)});
    mesh.add_face({v(0), v(5), v(6)});
    mesh.add_face({v(0), v(6), v(1)});
    // The bowtie that OpenMesh makes of these is closed around 0 by the rest of the sphere, a face of eight sides.
    std::vector<Halfedge> rim;
    Halfedge h = mesh.find_halfedge(v(3), v(2));
    do {
      rim.push_back(h);
      h = mesh.next_halfedge_handle(h);
    } while (h != rim.front());
    REQUIRE(rim.size() == 8);
    REQUIRE(close_curve_blocker(mesh, h));
    const Face around = mesh.new_face();
    mesh.set_halfedge_handle(around, h);
    for (const Halfedge side : rim) mesh.set_face_handle(side, around);
    mesh.delete_isolated_vertices();
    check_sound(mesh);
    CHECK(open_curve_blocker(mesh, around)->kind == BlockerKind::corner_repeated);
    check_refused(mesh, "is a corner of the face twice", [&] { open_curve(mesh, around); });
  }
}
