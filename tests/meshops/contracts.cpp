// Handles that name nothing, and effects that no operator returned, given to every function that has such arguments: a contract
// violation that names the function, and not a bit of the mesh is changed.
#include "meshops/core/contract.h"

#include <doctest/doctest.h>

#include <functional>

#include "meshops/core/reach.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "meshops/topology/tracker.h"
#include "support/corpus.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

template <typename Handle>
using Calls = std::vector<std::pair<const char*, std::function<void(TestMesh&, Handle)>>>;

/// An annulus in which an element of each kind is marked deleted.
struct Annulus {
  TestMesh mesh;
  Vertex dead_vertex;
  Edge dead_edge;
  Face dead_face;
  Halfedge boundary;  // live

  Annulus() {
    corpus()[4].build(mesh);
    const WeldEffect gone = collapse(mesh, mesh.halfedge_handle(Vertex(7)));
    dead_vertex = gone.removed.vertex;
    dead_edge = gone.removed.edge[0];
    dead_face = gone.removed.face[0];
    boundary = boundary_curves(mesh)[0].front();
  }

  std::vector<Vertex> no_vertices() const { return wrong(dead_vertex, mesh.n_vertices()); }
  std::vector<Edge> no_edges() const { return wrong(dead_edge, mesh.n_edges()); }
  std::vector<Face> no_faces() const { return wrong(dead_face, mesh.n_faces()); }
  std::vector<Halfedge> no_halfedges() const {
    auto all = wrong(mesh.halfedge_handle(dead_edge, 0), mesh.n_halfedges());
    all.push_back(mesh.halfedge_handle(dead_edge, 1));
    return all;
  }

  template <typename Handle>
  static std::vector<Handle> wrong(Handle dead, std::size_t count) {
    return {Handle(), Handle(-5), dead, Handle(static_cast<int>(count)), Handle(1 << 30)};
  }

  template <typename Handle>
  void check(const std::vector<Handle>& handles, const Calls<Handle>& calls) {
    const auto before = snapshot(mesh);
    for (const auto& named : calls)
      for (const Handle handle : handles) {
        const auto& [name, call] = named;
        CAPTURE(std::string(named.first));
        CAPTURE(handle.idx());
        std::string message;
        try {
          call(mesh, handle);
        } catch (const ContractViolation& violation) {
          message = violation.what();
        }
        CHECK_MESSAGE(message.starts_with(name), message);
        CHECK(snapshot(mesh) == before);
      }
  }
};

GlueEffect made_up(GlueCase what, Halfedge survivor, Halfedge removed) {
  const GlueEffect::Ends none{Vertex(), Vertex()};
  return {what, survivor, removed, none, none};
}

}  // namespace

TEST_SUITE("contracts") {
  TEST_CASE_FIXTURE(Annulus, "no function follows a halfedge that is not there") {
    const Halfedge good = boundary;
    check<Halfedge>(no_halfedges(),
                    {{"glue:", [&](TestMesh& m, Halfedge h) { glue(m, h, good); }},
                     {"glue:", [&](TestMesh& m, Halfedge h) { glue(m, good, h, GlueCase::zip); }},
                     {"glue_case:", [&](TestMesh& m, Halfedge h) { glue_case(m, h, good); }},
                     {"glue_case:", [&](TestMesh& m, Halfedge h) { glue_case(m, good, h); }},
                     {"unglue:", [](TestMesh& m, Halfedge h) { unglue(m, h); }},
                     {"unglue_case:", [](TestMesh& m, Halfedge h) { unglue_case(m, h); }},
                     {"close_curve:", [](TestMesh& m, Halfedge h) { close_curve(m, h); }},
                     {"zip_curves:", [&](TestMesh& m, Halfedge h) { zip_curves(m, h, good); }},
                     {"zip_curves:", [&](TestMesh& m, Halfedge h) { zip_curves(m, good, h); }},
                     {"split_edge:", [](TestMesh& m, Halfedge h) { split_edge(m, h); }},
                     {"weld_edge:", [](TestMesh& m, Halfedge h) { weld_edge(m, h); }},
                     {"collapse:", [](TestMesh& m, Halfedge h) { collapse(m, h); }},
                     {"split_vertex:", [&](TestMesh& m, Halfedge h) { split_vertex(m, h, good); }},
                     {"split_vertex:", [&](TestMesh& m, Halfedge h) { split_vertex(m, std::nullopt, h); }},
                     {"on_same_curve:", [&](TestMesh& m, Halfedge h) { on_same_curve(m, good, h); }},
                     {"on_same_curve:", [&](TestMesh& m, Halfedge h) { on_same_curve(m, h, h); }},
                     {"on_same_curve:", [&](TestMesh& m, Halfedge h) { boundary_curves(m)[0].contains(h); }},
                     {"BoundaryCurve:", [](TestMesh& m, Halfedge h) { BoundaryCurve(m, h); }},
                     {"TopologyTracker:", [](TestMesh& m, Halfedge h) { TopologyTracker(m).note_created(h); }},
                     {"glue:", [&](TestMesh& m, Halfedge h) { TopologyTracker(m).glue(h, good); }},
                     {"zip_curves:", [&](TestMesh& m, Halfedge h) { TopologyTracker(m).zip_curves(good, h); }}});
    // Of a view, an edge that was deleted still has ends.
    const auto out_of_range = std::vector<Halfedge>{Halfedge(), Halfedge(-5), Halfedge(1 << 30)};
    check<Halfedge>(out_of_range, {{"graph view:", [](TestMesh& m, Halfedge h) { source(h, PrimalGraph(m)); }},
                                   {"graph view:", [](TestMesh& m, Halfedge h) { target(h, DualGraph(m)); }},
                                   {"graph view:", [](TestMesh& m, Halfedge h) { target(h, BoundaryGraph(m)); }},
                                   {"length_map:", [](TestMesh& m, Halfedge h) { get(length_map(m), h); }}});
  }

  TEST_CASE_FIXTURE(Annulus, "no function follows a vertex, an edge or a face that is not there") {
    check<Vertex>(
        no_vertices(),
        {{"weld_face:", [](TestMesh& m, Vertex v) { weld_face(m, v); }},
         {"remove_vertex:", [](TestMesh& m, Vertex v) { remove_vertex(m, v); }},
         {"boundary_curve_at:", [](TestMesh& m, Vertex v) { boundary_curve_at(m, v); }},
         {"graph view:", [](TestMesh& m, Vertex v) { out_edges(v, PrimalGraph(m)); }},
         {"graph view:", [](TestMesh& m, Vertex v) { in_edges(v, directed(PrimalGraph(m))); }},
         {"graph view:", [](TestMesh& m, Vertex v) { adjacent_vertices(v, BoundaryGraph(m)); }},
         {"TopologyTracker:", [](TestMesh& m, Vertex v) { TopologyTracker(m).in_same_component(Vertex(0), v); }}});
    check<Edge>(no_edges(), {{"split_edge:", [](TestMesh& m, Edge e) { split_edge(m, e); }},
                             {"flip:", [](TestMesh& m, Edge e) { flip(m, e); }},
                             {"undo:", [](TestMesh& m, Edge e) {
                                undo(m, FlipEffect{e, {Halfedge(), Halfedge()}});
                              }}});
    check<Face>(no_faces(), {{"destroy_triangle:", [](TestMesh& m, Face f) { destroy_triangle(m, f); }},
                             {"remove_triangle:", [](TestMesh& m, Face f) { remove_triangle(m, f); }},
                             {"open_curve:", [](TestMesh& m, Face f) { open_curve(m, f); }},
                             {"split_face:", [](TestMesh& m, Face f) { split_face(m, f); }},
                             {"smaller_part:", [](TestMesh& m, Face f) { smaller_part(m, f, Face(0)); }},
                             {"smaller_part:", [](TestMesh& m, Face f) { in_same_component(m, Face(0), f); }},
                             {"graph view:", [](TestMesh& m, Face f) { out_edges(f, DualGraph(m)); }}});
  }

  TEST_CASE("on_same_curve and BoundaryCurve require boundary halfedges") {
    Annulus annulus;
    const Halfedge inner = annulus.mesh.opposite_halfedge_handle(annulus.boundary);
    check_refused(annulus.mesh, "not a boundary halfedge",
                  [&] { on_same_curve(annulus.mesh, annulus.boundary, inner); });
    check_refused(annulus.mesh, "not a boundary halfedge",
                  [&] { on_same_curve(annulus.mesh, inner, annulus.boundary); });
    TestMesh closed;
    corpus()[5].build(closed);
    CHECK_THROWS_AS(out_edges(Vertex(0), BoundaryGraph(closed)), ContractViolation);
  }

  TEST_CASE("operators that need status to delete name themselves without it") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    const auto b = separate_triangles(mesh, 2);
    const auto message = [](auto operate) -> std::string {
      try {
        operate();
      } catch (const ContractViolation& violation) {
        return violation.what();
      }
      return "";
    };
    const std::pair<std::string, std::string> all[] = {
        {"collapse", message([&] { collapse(mesh, b[0]); })},
        {"weld_edge", message([&] { weld_edge(mesh, b[0]); })},
        {"weld_face", message([&] { weld_face(mesh, Vertex(0)); })},
        {"remove_vertex", message([&] { remove_vertex(mesh, Vertex(0)); })},
        {"undo", message([&] { undo(mesh, WeldEffect()); })},
        {"glue", message([&] { glue(mesh, b[0], b[3]); })},
        {"unglue", message([&] { unglue(mesh, made_up(GlueCase::zip, b[0], b[3])); })},
        {"zip_curves", message([&] { zip_curves(mesh, b[0], b[3]); })},
        {"destroy_triangle", message([&] { destroy_triangle(mesh, Face(0)); })},
        {"remove_triangle", message([&] { remove_triangle(mesh, Face(0)); })},
        {"open_curve", message([&] { open_curve(mesh, Face(0)); })}};
    for (const auto& found : all)
      CHECK_MESSAGE(found.second.starts_with(found.first + ": the mesh needs "), found.second);
  }

  TEST_CASE("a tracker that is notified of what did not happen refuses it and counts nothing") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 2);
    TopologyTracker tracker(mesh);
    const TopologyCounts counts = tracker.counts();
    CHECK_THROWS_AS(tracker.note(made_up(GlueCase::join, b[0], b[3])), ContractViolation);
    CHECK_THROWS_AS(tracker.note(UnglueEffect{GlueCase::zip, Halfedge(), b[3], Vertex(), Vertex()}), ContractViolation);
    CHECK_THROWS_AS(tracker.note(UnglueEffect{GlueCase::join, b[0], b[1], Vertex(), Vertex()}), ContractViolation);
    CHECK_THROWS_AS(tracker.note(UnglueEffect{GlueCase::zip, b[0], b[3], Vertex(99), Vertex()}), ContractViolation);
    CHECK_THROWS_AS(tracker.note(SplitEffect()), ContractViolation);
    CHECK_THROWS_AS(tracker.note_undone(WeldEffect()), ContractViolation);
    const Vertex unknown = mesh.new_vertex();
    CHECK_THROWS_AS(tracker.in_same_component(unknown, Vertex(0)), ContractViolation);
    CHECK(tracker.counts() == counts);
  }

  TEST_CASE("an effect of glue() that was made up is refused where it would revive one vertex twice") {
    TestMesh mesh;
    const auto b = separate_triangles(mesh, 3);
    GlueEffect effect = glue(mesh, b[0], b[3]);
    const Vertex gone = std::max(effect.first_ends.from, effect.second_ends.to);
    const Vertex end = std::min(effect.first_ends.to, effect.second_ends.from);
    effect.first_ends.to = end;
    effect.second_ends.from = gone;
    REQUIRE(gone.idx() > end.idx());
    check_refused(mesh, "the edge is no longer as glue() left it", [&] { unglue(mesh, effect); });
  }
}
