// Compares validate() with the definition of a sound mesh: on meshes of random soups, and on records changed at random.
#include <doctest/doctest.h>

#include <OpenMesh/Core/System/omstream.hh>
#include <random>
#include <set>

#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/repair.h"
#include "support/arguments.h"
#include "support/bowties.h"
#include "support/corpus.h"
#include "support/soundness.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Returns the vertices for which validate() reports several fans. It may report nothing else.
std::set<int> vertices_of_several_fans(const Connectivity& mesh) {
  std::set<int> vertices;
  for (const Defect& defect : validate(mesh)) {
    CHECK_MESSAGE(defect.kind == DefectKind::vertex_has_several_fans, describe(defect));
    vertices.insert(defect.index);
  }
  return vertices;
}

/// Adds the faces that OpenMesh accepts.
void add_faces(TestMesh& mesh, const PolygonSoup& soup) {
  for (std::size_t p = 0; p < soup.points; ++p) mesh.new_vertex();
  omerr().disable();  // it prints what it refuses
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    std::vector<Vertex> corners;
    for (const std::uint32_t c : soup.face(f)) corners.emplace_back(static_cast<int>(c));
    const std::set<Vertex> distinct(corners.begin(), corners.end());
    if (corners.size() > 2 && distinct.size() == corners.size() &&
        distinct.rbegin()->idx() < static_cast<int>(soup.points))
      mesh.add_face(corners);
  }
  omerr().enable();
}

/// Returns any handle: of an element, deleted or not, just past the last, far out of range, or invalid.
template <typename Handle>
Handle any(std::size_t count, std::mt19937& random) {
  switch (random() % 12) {
    case 0:
      return Handle(-1);
    case 1:
      return Handle(static_cast<int>(count + random() % 3));
    case 2:
      return Handle(random() % 2 ? 1 << 30 : -7);
    default:
      return Handle(static_cast<int>(random() % (count + 1)));
  }
}

/// Changes one record at random.
void spoil(TestMesh& mesh, std::mt19937& random) {
  const auto pick = [&](std::size_t count) { return static_cast<int>(random() % count); };
  const Halfedge h(pick(mesh.n_halfedges()));
  const Vertex v(pick(mesh.n_vertices()));
  const Face f(pick(mesh.n_faces()));
  switch (random() % 10) {
    case 0:
      return mesh.set_vertex_handle(h, any<Vertex>(mesh.n_vertices(), random));
    case 1:
      return mesh.set_face_handle(h, any<Face>(mesh.n_faces(), random));
    case 2:
      return mesh.set_halfedge_handle(v, any<Halfedge>(mesh.n_halfedges(), random));
    case 3:
      return mesh.set_halfedge_handle(f, any<Halfedge>(mesh.n_halfedges(), random));
    case 4:
      mesh.status(v).set_deleted(random() % 2);
      return;
    case 5:
      mesh.status(f).set_deleted(random() % 2);
      return;
    case 6:
      mesh.status(mesh.edge_handle(h)).set_deleted(random() % 2);
      return;
    case 7: {  // next and prev together: two loops become one, or one becomes two
      const Halfedge g(pick(mesh.n_halfedges())), next = mesh.next_halfedge_handle(h);
      mesh.set_next_halfedge_handle(h, mesh.next_halfedge_handle(g));
      return mesh.set_next_halfedge_handle(g, next);
    }
    case 8: {  // a face lends its loop to another and is marked deleted
      const Face other(pick(mesh.n_faces()));
      for_each_halfedge(mesh, [&](Halfedge x) {
        if (mesh.face_handle(x) == f) mesh.set_face_handle(x, other);
      });
      if (f != other) mesh.status(f).set_deleted(true);
      return;
    }
    default:  // OpenMesh asserts that these two are in range
      if (random() % 2)
        mesh.set_prev_halfedge_handle(h, Halfedge(pick(mesh.n_halfedges())));
      else
        mesh.set_next_halfedge_handle(h, Halfedge(pick(mesh.n_halfedges())));
  }
}

}  // namespace

TEST_SUITE("validate") {
  TEST_CASE("validate() of random soups is empty exactly if the definition holds, and otherwise lists the pinches") {
    std::mt19937 random(14);
    int sound = 0, bowties = 0, by_openmesh = 0;
    for (int round = 0; round < rbpa_test::trials(100000); ++round) {
      const PolygonSoup given = round % 16 ? random_soup(random) : broken_surface(random);
      INFO(text(given));
      const Repair repaired = repair(given);
      TestMesh mesh;
      build_mesh(mesh, repaired.soup);
      REQUIRE(validate(mesh).empty());
      REQUIRE(is_sound_by_definition(mesh));
      // With a vertex for each fan the mesh is sound; with all fans of a point on one vertex it is not.
      tie_points(mesh, repaired.stands_on);
      std::set<int> tied;
      for (std::size_t p = given.points; p < repaired.stands_on.size(); ++p)
        tied.insert(static_cast<int>(repaired.stands_on[p]));
      REQUIRE(vertices_of_several_fans(mesh) == tied);
      REQUIRE(is_sound_by_definition(mesh) == tied.empty());
      ++(tied.empty() ? sound : bowties);

      TestMesh added;
      add_faces(added, given);
      const auto several = vertices_of_several_fans(added);
      REQUIRE(is_sound_by_definition(added) == several.empty());
      by_openmesh += !several.empty();
    }
    CHECK(sound > rbpa_test::trials(20000));
    CHECK(bowties > rbpa_test::trials(20000));
    CHECK(by_openmesh > rbpa_test::trials(10000));
  }

  TEST_CASE("validate() of records changed at random is empty exactly if the definition holds") {
    std::mt19937 random(15);
    int sound = 0, bad = 0;
    std::set<DefectKind> seen;
    for (int round = 0; round < rbpa_test::trials(100000); ++round) {
      TestMesh mesh;
      const Repair repaired = repair(random_soup(random));
      if (repaired.soup.faces() == 0) continue;
      build_mesh(mesh, repaired.soup);
      for (auto changes = 1 + random() % 3; changes > 0; --changes) spoil(mesh, random);
      const auto defects = validate(mesh);
      INFO(text(repaired.soup), defects.empty() ? "" : describe(defects.front()));
      REQUIRE(is_sound_by_definition(mesh) == defects.empty());
      for (const Defect& defect : defects) seen.insert(defect.kind);
      ++(defects.empty() ? sound : bad);
    }
    CHECK(sound > rbpa_test::trials(2000));
    CHECK(bad > rbpa_test::trials(50000));
    CHECK(seen.size() == 13);
  }
}
