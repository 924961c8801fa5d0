// A front that begins on a mesh of the user.
#include <doctest/doctest.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/destroy.h"
#include "meshops/topology/count.h"
#include "meshops/topology/report.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/on_corpus.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Policy that fills a hole: the apex of every edge is the vertex after the next.
struct Ears {
  std::optional<std::array<Site, 3>> seed(const Front&) { return std::nullopt; }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    if (boundary_curve_at(front.mesh(), front.mesh().from_vertex_handle(h))->length() > 8) return std::nullopt;
    return front.to_site(front.mesh().next_halfedge_handle(h));
  }
};

}  // namespace

TEST_SUITE("front") {
  TEST_CASE("a front begins with the boundary curves of the mesh, all active, and keeps every handle") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      const std::vector<int> before = snapshot(mesh);
      const TopologyCounts counts = count_topology(mesh);
      Front front(mesh);
      CHECK(snapshot(mesh) == before);
      CHECK(front.faces() == counts.faces);
      CHECK(front.edges() == counts.edges);
      CHECK(front.curves().size() == counts.boundary_curves);
      std::size_t active = 0;
      for (const BoundaryCurve& curve : boundary_curves(mesh))
        for (const Halfedge h : curve) active += front.is_active(h);
      std::size_t popped = 0;
      while (front.pop().is_valid()) ++popped;
      CHECK(popped == active);
      const std::vector<Site> sites = front.finish();
      CHECK(snapshot(mesh) == before);
      for (std::size_t v = 0; v < sites.size(); ++v) CHECK(sites[v] == v);
    });
  }

  TEST_CASE("a front fills a hole in a mesh, whose faces, points and handles stay") {
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_halfedge_status();
    mesh.request_face_status();
    constexpr int side = 6;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) mesh.add_vertex({static_cast<float>(x), static_cast<float>(y), 0});
    for (int y = 0; y + 1 < side; ++y)
      for (int x = 0; x + 1 < side; ++x) {
        const int v = y * side + x;
        mesh.add_face(Vertex(v), Vertex(v + 1), Vertex(v + side + 1));
        mesh.add_face(Vertex(v), Vertex(v + side + 1), Vertex(v + side));
      }
    for (const int f : {22, 23, 25}) remove_triangle(mesh, Face(f));
    REQUIRE(count_topology(mesh).boundary_curves == 2);
    const auto points = mesh.n_vertices();
    Front front(mesh);
    Ears policy;
    advance(front, policy);
    front.finish();
    check_sound(mesh);
    const TopologyCounts counts = count_topology(mesh);
    CHECK(counts.boundary_curves == 1);
    CHECK(counts.faces == 2 * (side - 1) * (side - 1));
    CHECK(mesh.n_vertices() == points);
    for (int v = 0; v < side * side; ++v)
      CHECK(mesh.point(Vertex(v)) == OpenMesh::Vec3f(static_cast<float>(v % side), static_cast<float>(v / side), 0));
    CHECK_FALSE(mesh.status(Face(0)).deleted());
  }

  TEST_CASE("a front continues a complex with pinches by its map of sites, and fans merge") {
    TestMesh mesh;
    std::vector<Site> site_of;
    {
      Front front(mesh, 7);
      front.create(0, 1, 2);
      front.create(0, 3, 4);
      site_of = front.finish();
    }
    REQUIRE(site_of == std::vector<Site>{0, 1, 2, 3, 4, 0});
    Front front(mesh, site_of);
    CHECK(front.sites() == 5);
    int fans = 0;
    front.for_each_fan(0, [&](Vertex) { ++fans; });
    CHECK(fans == 2);
    const InsertedTriangle t = front.create(0, 2, 3);
    CHECK(t.merged == 1);
    CHECK(mesh.status(t.left_over[0]).deleted());
    check_sound(mesh);
    CHECK(front.finish().size() == 6);
    CHECK(count_topology(mesh).components == 1);
    // Without the map, the same point is two sites.
    TestMesh apart;
    {
      Front other(apart, 7);
      other.create(0, 1, 2);
      other.create(0, 3, 4);
      other.finish();
    }
    Front on_vertices(apart);
    CHECK(on_vertices.sites() == 6);
  }

  TEST_CASE("an isolated vertex of the mesh waits for a triangle on its site; a deleted one is not a site") {
    TestMesh mesh;
    for (int i = 0; i < 6; ++i) mesh.new_vertex();
    mesh.status(Vertex(4)).set_deleted(true);
    Front front(mesh);
    CHECK(front.create_blocker(0, 1, 4) == Refusal{RefusalKind::no_such_site, 4});
    front.create(0, 1, 5);
    CHECK(mesh.n_vertices() == 6);
    CHECK_FALSE(mesh.is_isolated(Vertex(5)));
    CHECK(front.next_level().carried == std::vector<Site>{0, 1, 2, 3, 5});
    front.finish();
    CHECK(mesh.n_vertices() == 6);
    // It also holds with a map.
    TestMesh other;
    for (int i = 0; i < 4; ++i) other.new_vertex();
    Front mapped(other, std::vector<Site>{7, 3, 5, 7});
    CHECK(mapped.sites() == 8);
    mapped.create(3, 5, 7);
    CHECK(other.n_vertices() == 4);
    CHECK(other.is_isolated(Vertex(3)));
    check_sound(other);
    // A deleted vertex is not a vertex of its site.
    TestMesh dead;
    for (int i = 0; i < 3; ++i) dead.new_vertex();
    dead.status(Vertex(1)).set_deleted(true);
    Front on_dead(dead, std::vector<Site>{0, 1, 2});
    on_dead.create(0, 1, 2);
    CHECK(dead.n_vertices() == 4);
    CHECK(dead.status(Vertex(1)).deleted());
    check_sound(dead);
  }

  TEST_CASE("an unsound mesh, one without status, and a map that does not fit are refused") {
    TestMesh unsound;
    separate_triangles(unsound, 1);
    unsound.set_halfedge_handle(Vertex(0), unsound.halfedge_handle(Vertex(1)));
    CHECK_THROWS_WITH_AS(Front{unsound}, "Front: the mesh is not sound: vertex 0: vertex halfedge elsewhere",
                         ContractViolation);
    TestMesh bowtie;
    for (int i = 0; i < 5; ++i) bowtie.new_vertex();
    bowtie.add_face(Vertex(0), Vertex(1), Vertex(2));
    bowtie.add_face(Vertex(0), Vertex(3), Vertex(4));
    CHECK_THROWS_WITH_AS(Front{bowtie}, "Front: the mesh is not sound: vertex 0: vertex has several fans",
                         ContractViolation);
    OpenMesh::PolyMesh_ArrayKernelT<> plain;
    CHECK_THROWS_AS(Front{plain}, ContractViolation);
    TestMesh mesh;
    separate_triangles(mesh, 1);
    CHECK_THROWS_AS(Front(mesh, std::vector<Site>{0, 1}), ContractViolation);
    CHECK_THROWS_WITH_AS(Front(mesh, std::vector<Site>{0, 1, 1}), "Front: an edge joins two vertices on one site",
                         ContractViolation);
  }

  TEST_CASE("the results of finish() fit report() and the map of a front") {
    TestMesh mesh;
    Front front(mesh, 5);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    const std::vector<Site> site_of = front.finish();
    const TopologyReport topology = report(mesh, site_of);
    CHECK(topology.pinches == 1);
    CHECK(topology.vertices == 5);
  }
}
