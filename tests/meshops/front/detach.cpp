// Front::detach(): the inverse of attach() and create().
#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "meshops/core/contract.h"
#include "meshops/front/front.h"
#include "meshops/topology/count.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/front_on_mesh.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

std::size_t fans_at(const Front& front, Site s) {
  std::size_t fans = 0;
  front.for_each_fan(s, [&](Vertex) { ++fans; });
  return fans;
}

}  // namespace

TEST_SUITE("front") {
  TEST_CASE("detaching the last triangle restores the mesh, up to handles") {
    // Each triangle of a closed ring around site 0: new vertex, neighbor on the curve, and the last that closes it.
    auto [mesh, front] = FrontOnMesh(6);
    front.create(0, 1, 2);
    std::vector<std::array<Site, 3>> more = {{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}};
    for (const auto& t : more) {
      const TopologyCounts before = count_topology(mesh);
      const std::string shape = isomorphism_class(mesh);
      const Face f = front.create(t[0], t[1], t[2]).face;
      const DetachedTriangle detached = front.detach(f);
      CHECK(detached.corners == t);
      CHECK(count_topology(mesh) == before);
      CHECK(isomorphism_class(mesh) == shape);
      front.create(t[0], t[1], t[2]);
    }
    CHECK_FALSE(front.is_on_boundary(0));
  }

  TEST_CASE("finish() removes the vertices that only detached triangles had") {
    TestMesh mesh;
    Front front(mesh, 8);  // 0 and 7 are on no triangle
    front.create(1, 2, 3);
    front.detach(front.create(4, 5, 6).face);
    CHECK(front.finish() == std::vector<Site>{1, 2, 3});
    check_sound(mesh);
  }

  TEST_CASE("the last triangle leaves free sites, whose vertices serve the next") {
    auto [mesh, front] = FrontOnMesh(3);
    const Face f = front.create(0, 1, 3).face;  // 3 is a new site
    const Vertex on_new = mesh.from_vertex_handle(front.edge_between(3, 0));
    const DetachedTriangle detached = front.detach(f);
    for (const Halfedge h : detached.side) CHECK_FALSE(h.is_valid());
    CHECK(front.faces() == 0);
    CHECK(front.edges() == 0);
    for (Site s = 0; s < 4; ++s) CHECK(front.is_free(s));
    CHECK_FALSE(front.pop().is_valid());
    front.create(3, 1, 0);
    CHECK(mesh.from_vertex_handle(front.edge_between(3, 1)) == on_new);
    check_sound(mesh);
  }

  TEST_CASE("the vertex of a new site waits for that site, whatever else needs a vertex") {
    auto [mesh, front] = FrontOnMesh(6);
    const Face f = front.create(0, 1, 6).face;  // 6 is a new site
    const Vertex on_new = mesh.from_vertex_handle(front.edge_between(6, 0));
    front.detach(f);
    front.create(0, 1, 2);
    front.create(2, 3, 4);  // a second fan on 2
    const Halfedge on_six = front.create(6, 4, 5).side[0];
    CHECK(mesh.from_vertex_handle(on_six) == on_new);
    check_sound(mesh);
  }

  TEST_CASE("a fan becomes two when a triangle in its middle is detached") {
    auto [mesh, front] = FrontOnMesh(5);
    front.create(0, 1, 2);
    const Face middle = front.attach(front.boundary_between(0, 2), 3).face;
    front.attach(front.boundary_between(0, 3), 4);
    REQUIRE(fans_at(front, 0) == 1);
    const DetachedTriangle detached = front.detach(middle);
    CHECK(fans_at(front, 0) == 2);
    CHECK(fans_at(front, 2) == 1);
    CHECK(front.faces() == 2);
    CHECK(front.edges() == 6);
    CHECK(count_topology(mesh).components == 2);
    int active = 0;
    for (const Halfedge h : detached.side)
      if (h.is_valid()) {
        ++active;
        CHECK(front.is_active(h));
      }
    CHECK(active == 2);
    check_sound(mesh);
  }

  TEST_CASE("a second vertex on a site has the properties of the first") {
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_halfedge_status();
    mesh.request_face_status();
    Front front(mesh, 5);
    for (int v = 0; v < 5; ++v) mesh.set_point(Vertex(v), {static_cast<float>(v), 1, 2});
    front.create(0, 1, 2);
    front.create(2, 3, 4);
    REQUIRE(mesh.n_vertices() == 6);
    CHECK(mesh.point(Vertex(5)) == mesh.point(Vertex(2)));
  }

  TEST_CASE("a site that was left behind is carried again when it is on the boundary again, or free") {
    auto [mesh, front] = FrontOnMesh(4);
    const Face first = front.create(0, 1, 2).face;
    const Face second = front.create(0, 2, 3).face;
    const Face third = front.create(0, 3, 1).face;
    CHECK(front.next_level().carried == std::vector<Site>{1, 2, 3});
    front.detach(second);
    CHECK(front.next_level().carried == std::vector<Site>{0, 1, 2, 3});
    front.create(0, 2, 3);
    const LevelTransfer closed = front.next_level();
    CHECK(closed.carried == std::vector<Site>{1, 2, 3});
    CHECK(closed.left_behind == 1);
    front.detach(first);
    front.detach(third);
    front.detach(Face(static_cast<int>(mesh.n_faces()) - 1));
    CHECK(front.is_free(0));
    CHECK(front.next_level().carried == std::vector<Site>{0, 1, 2, 3});
  }

  TEST_CASE("only a live triangle with a side on the boundary is detached") {
    TestMesh mesh;
    Front front(mesh, 6);
    const Face inner = front.create(0, 1, 2).face;
    front.attach(front.boundary_between(1, 0), 3);
    front.attach(front.boundary_between(2, 1), 4);
    const Face last = front.attach(front.boundary_between(0, 2), 5).face;
    const auto refused = [&](Face f, const Refusal& reason) {
      CHECK(front.detach_blocker(f) == reason);
      check_refused(mesh, describe(reason), [&] { front.detach(f); });
    };
    refused(inner, {RefusalKind::not_at_front, 0, 0, inner.idx()});
    refused(Face(-1), {RefusalKind::no_such_face, 0, 0, -1});
    refused(Face(99), {RefusalKind::no_such_face, 0, 0, 99});
    front.detach(last);
    refused(last, {RefusalKind::no_such_face, 0, 0, last.idx()});
    OpenMesh::TriMesh_ArrayKernelT<> plain;
    Front without_status(plain, 3);
    const Face f = without_status.create(0, 1, 2).face;
    CHECK_THROWS_WITH_AS(without_status.detach(f),
                         "detach: the mesh needs status to mark what is deleted (request_status() requests every kind)",
                         ContractViolation);
    CHECK(without_status.faces() == 1);
  }
}
