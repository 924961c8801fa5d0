// The life of a front: a mesh has one front, and no other code changes the mesh until the front is finished. Violations
// are refused with the cause, and no memory outside the mesh is read.
#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "meshops/patch/assembler.h"
#include "support/check_sound.h"
#include "support/meshes.h"
#include "support/refusal.h"

using namespace meshops;
using namespace meshops::test;

namespace {

static_assert(!std::is_copy_constructible_v<Front> && !std::is_copy_assignable_v<Front>);
static_assert(!std::is_move_constructible_v<Front> && !std::is_move_assignable_v<Front>);
static_assert(!std::is_copy_constructible_v<SiteVertices> && std::is_nothrow_move_constructible_v<SiteVertices>);
static_assert(!std::is_copy_constructible_v<AssembledPatches> && std::is_move_constructible_v<AssembledPatches>);
static_assert(!std::is_copy_constructible_v<PatchAssembler>);

/// Returns every member that reads or changes the mesh.
const std::vector<std::pair<const char*, std::function<void(Front&)>>>& entries() {
  static const std::vector<std::pair<const char*, std::function<void(Front&)>>> all = {
      {"add_site", [](Front& f) { f.add_site(); }},
      {"site", [](Front& f) { (void)f.site(Vertex(0)); }},
      {"from_site", [](Front& f) { (void)f.from_site(Halfedge(0)); }},
      {"to_site", [](Front& f) { (void)f.to_site(Halfedge(0)); }},
      {"is_free", [](Front& f) { (void)f.is_free(0); }},
      {"is_on_boundary", [](Front& f) { (void)f.is_on_boundary(0); }},
      {"for_each_fan", [](Front& f) { f.for_each_fan(0, [](Vertex) {}); }},
      {"edge_between", [](Front& f) { (void)f.edge_between(0, 1); }},
      {"edges_between", [](Front& f) { (void)f.edges_between(0, 1); }},
      {"boundary_between", [](Front& f) { (void)f.boundary_between(1, 0); }},
      {"triangle_on", [](Front& f) { (void)f.triangle_on(0, 1, 2); }},
      {"create_blocker", [](Front& f) { (void)f.create_blocker(0, 3, 4); }},
      {"attach_blocker", [](Front& f) { (void)f.attach_blocker(Halfedge(1), 9); }},
      {"create", [](Front& f) { f.create(0, 3, 4); }},
      {"attach", [](Front& f) { f.attach(Halfedge(1), 9); }},
      {"fit with glues", [](Front& f) { (void)f.fit(0, 3, 4, [](Halfedge, Site) { return true; }); }},
      {"insert",
       [](Front& f) {
         f.insert(Fit({6, 7, 8}));
       }},
      {"detach_blocker", [](Front& f) { (void)f.detach_blocker(Face(0)); }},
      {"detach", [](Front& f) { f.detach(Face(0)); }},
      {"pop", [](Front& f) { f.pop(); }},
      {"is_boundary", [](Front& f) { (void)f.is_boundary(Halfedge(1)); }},
      {"is_active", [](Front& f) { (void)f.is_active(Halfedge(1)); }},
      {"is_frozen", [](Front& f) { (void)f.is_frozen(Halfedge(1)); }},
      {"activate", [](Front& f) { f.activate(Halfedge(1)); }},
      {"freeze", [](Front& f) { f.freeze(Halfedge(1)); }},
      {"curves", [](Front& f) { (void)f.curves(); }},
      {"curves_at", [](Front& f) { (void)f.curves_at(0); }},
      {"next_level", [](Front& f) { f.next_level(); }},
      {"finish", [](Front& f) { f.finish(); }}};
  return all;
}

/// Inserts two triangles and leaves some sites free.
void begin(Front& front) {
  front.create(0, 1, 2);
  front.create(2, 1, 5);
}

}  // namespace

TEST_SUITE("life of a front") {
  TEST_CASE("every member of a finished front reports that it is finished, and leaves the mesh alone") {
    for (const auto& named : entries()) {
      CAPTURE(named.first);
      TestMesh mesh;
      Front front(mesh, 30);
      begin(front);
      front.finish();
      CHECK(refusal([&] { named.second(front); }) == "Front: the front is finished");
      check_sound(mesh);
      CHECK(mesh.n_faces() == 2);
      // These members read no mesh.
      CHECK(&front.mesh() == static_cast<Connectivity*>(&mesh));
      CHECK(front.faces() == 2);
      CHECK(front.edges() == 5);
      CHECK(front.sites() == 0);
      CHECK(front.frozen().empty());
      CHECK(front.level() == 0);
      CHECK(front.level(Face(1)) == 0);
    }
  }

  TEST_CASE("every member reports the found and the expected counts if other code changed the mesh") {
    for (const auto& named : entries()) {
      CAPTURE(named.first);
      TestMesh mesh;
      Front front(mesh, 30);
      begin(front);
      for (int i = 3; i < 30; ++i)
        if (i != 5) mesh.status(Vertex(i)).set_deleted(true);
      mesh.garbage_collection();
      CHECK(
          refusal([&] { named.second(front); }) ==
          "Front: the mesh was changed by others: it has 4 vertices, 5 edges, 2 faces; expected 30 vertices, 5 edges, "
          "2 faces");
    }
  }

  TEST_CASE("an additional vertex, edge or face is detected") {
    for (const int what : {0, 1, 2}) {
      TestMesh mesh;
      Front front(mesh, 30);
      begin(front);
      if (what == 0) mesh.new_vertex();
      if (what == 1) mesh.new_edge(Vertex(0), Vertex(7));
      if (what == 2) mesh.new_face();
      CHECK(refusal([&] { front.create(6, 7, 8); }).starts_with("Front: the mesh was changed by others: it has "));
    }
  }

  TEST_CASE("the front's own changes are accepted: supply, further vertices, detached triangles") {
    for (const std::size_t supply : {std::size_t{1}, std::size_t{5}}) {
      TestMesh mesh;
      Front front(mesh, 9, supply);
      front.create(0, 1, 2);
      front.create(0, 3, 4);  // a further vertex
      front.create(0, 5, 6);
      front.attach(front.boundary_between(1, 0), static_cast<Site>(front.sites()));
      front.detach(Face(1));
      front.detach(Face(0));  // a fan becomes two, or disappears
      front.create(0, 3, 4);
      front.next_level();
      CHECK_NOTHROW(front.finish());
      check_sound(mesh);
    }
  }

  TEST_CASE("a mesh collected while fans are visited, or by a policy or a visitor, ends the run with the cause") {
    struct Growing {
      TestMesh& mesh;
      int at;  // number of the call that changes the mesh
      int calls = 0;
      void change(int what) {
        if (what == at && ++calls == 3) mesh.garbage_collection();
      }
      std::optional<std::array<Site, 3>> seed(const Front& front) {
        if (at == 0) calls = 2;
        change(0);
        return front.faces() == 0 ? std::optional(std::array<Site, 3>{0, 1, 2}) : std::nullopt;
      }
      std::optional<Site> propose(const Front& front, Halfedge) {
        change(1);
        return front.sites() < 40 ? std::optional(static_cast<Site>(front.sites())) : std::nullopt;
      }
      int key(const Front&, Halfedge) {
        change(2);
        return 0;
      }
      bool glues(const Front&, Halfedge, Site) {
        calls = 2;
        change(3);
        return true;
      }
    };
    struct Gluing : Growing {  // an existing apex, so that glues() is called
      std::optional<Site> propose(const Front& front, Halfedge h) {
        return front.to_site(front.mesh().next_halfedge_handle(h));
      }
    };
    struct Collecting : CurveVisitor {
      TestMesh* mesh = nullptr;
      int in = 0, seen = 0;
      void collect(int event) {
        if (event == in && ++seen == 3) mesh->garbage_collection();
      }
      void seeded(const Front&, const InsertedTriangle&) {
        if (in == 5) mesh->garbage_collection();
      }
      void attached(const Front&, Halfedge, const InsertedTriangle&) { collect(4); }
      void curve_begun(const Front&, Halfedge) {
        if (in == 6) mesh->garbage_collection();
      }
      void frozen(const Front&, Halfedge) { collect(7); }
    };
    for (int at = 0; at < 8; ++at) {
      CAPTURE(at);
      TestMesh mesh;
      Front front(mesh, 4);
      mesh.status(Vertex(3)).set_deleted(true);
      Collecting visitor;
      visitor.mesh = &mesh;
      visitor.in = at;
      const auto run = [&](auto policy) { advance(front, policy, visitor); };
      const std::string message = refusal([&] { at == 3 ? run(Gluing{{mesh, at}}) : run(Growing{mesh, at}); });
      CHECK(message.starts_with("Front: the mesh was changed by others: it has "));
    }
    TestMesh mesh;
    Front front(mesh, 9);
    front.create(0, 1, 2);
    front.create(0, 3, 4);
    mesh.status(Vertex(8)).set_deleted(true);
    CHECK(refusal([&] {
            front.for_each_fan(0, [&](Vertex) { mesh.garbage_collection(); });
          }).starts_with("Front: the mesh was changed by others: it has "));
  }

  TEST_CASE("elements marked deleted by other code are detected where the front meets them") {
    TestMesh mesh;
    Front front(mesh, 9);
    front.create(0, 1, 2);
    front.create(0, 3, 4);  // stands on vertex 9
    mesh.delete_face(Face(1), true);
    CHECK(refusal([&] { front.for_each_fan(0, [](Vertex) {}); }) ==
          "Front: the mesh was changed by others: a vertex has lost its faces");
    CHECK(refusal([&] { front.create(3, 5, 6); }) == "create: there is no site 3");
    const auto pop_all = [&] {
      while (front.pop().is_valid()) {
      }
    };
    CHECK(refusal(pop_all) == "Front: the mesh was changed by others: an edge of the front is marked deleted");
    CHECK(refusal([&] { front.next_level(); }) ==
          "Front: the mesh was changed by others: an edge of the front is marked deleted");
  }

  TEST_CASE("a vertex that waits for a triangle, marked deleted by others, is not used") {
    TestMesh mesh;
    Front front(mesh, 3);
    const Face placed = front.create(0, 1, 3).face;  // a site of its own number, but not of the first vertices
    front.detach(placed);
    for (const auto v : mesh.vertices()) mesh.status(v).set_deleted(true);
    CHECK(refusal([&] {
            front.insert(Fit({3, 4, 5}));
          }) == "Front: the mesh was changed by others: a vertex that waits is marked deleted");
  }

  TEST_CASE("assembled patches are finished once, or continued by one front") {
    const auto assembled = [](TestMesh& mesh) {
      PatchAssembler assembler(mesh, 4);
      Patch patch;
      patch.triangles = {{0, 1, 2}};
      patch.across = {{Patch::open, Patch::open, Patch::open}};
      assembler.lay(patch);
      return std::move(assembler).join();
    };
    constexpr const char* gone = "AssembledPatches: finished, or moved to a front already";
    {
      TestMesh mesh;
      AssembledPatches patches = assembled(mesh);
      Front front(std::move(patches));
      CHECK(refusal([&] { Front another(std::move(patches)); }) == gone);
      CHECK(refusal([&] { std::move(patches).finish(); }) == gone);
      CHECK(refusal([&] { (void)patches.is_free(3); }) == "Front: site 3 does not exist");
      front.create(1, 0, 3);
      check_sound(mesh);
    }
    {
      TestMesh mesh;
      AssembledPatches patches = assembled(mesh);
      CHECK(std::move(patches).finish() == std::vector<Site>{0, 1, 2});
      CHECK(refusal([&] { std::move(patches).finish(); }) == gone);
      check_sound(mesh);
    }
    {
      TestMesh mesh;
      AssembledPatches patches = assembled(mesh);
      mesh.status(Vertex(3)).set_deleted(true);
      mesh.garbage_collection();
      CHECK(
          refusal([&] { Front front(std::move(patches)); }) ==
          "AssembledPatches: the mesh was changed by others: it has 3 vertices, 3 edges, 1 faces; expected 4 vertices, "
          "3 edges, 1 faces");
    }
  }
}
