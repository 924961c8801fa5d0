// Gives handles that name nothing, and effects that no operator returned, to every function with such arguments: each
// throws a contract violation that names the function, and changes no bit of the mesh.
#include "meshops/core/contract.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "meshops/core/reach.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/front/front.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/extract_triangle.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/history/history.h"
#include "meshops/patch/assembler.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/diagonal.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/triangulate_face.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/cut_open.h"
#include "meshops/topology/examine.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/keep_faces.h"
#include "meshops/topology/loop_kinds.h"
#include "meshops/topology/merge_points.h"
#include "meshops/topology/orient.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/shortest_loops.h"
#include "meshops/topology/tracker.h"
#include "support/corpus.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

template <typename Handle>
using Calls = std::vector<std::pair<const char*, std::function<void(TestMesh&, Handle)>>>;

/// Annulus in which an element of each kind is marked deleted.
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

WeldEffect weld_of(Vertex survivor, Halfedge halfedge) {
  WeldEffect effect;
  effect.survivor = survivor;
  effect.left = effect.halfedge = halfedge;
  return effect;
}

std::vector<LoopKind> kinds_of(const TestMesh& mesh, const Loop& loop) {
  const std::vector<std::array<double, 3>> places(mesh.n_vertices());
  return loop_kinds(mesh, places, std::vector<Loop>{loop});
}

}  // namespace

TEST_SUITE("contracts") {
  TEST_CASE_FIXTURE(Annulus, "no function follows a halfedge that does not exist") {
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
                     {"TopologyTracker:",
                      [](TestMesh& m, Halfedge h) {
                        TopologyTracker(m).note(CreateTriangleEffect{Face(), h, h});
                      }},
                     {"insert_diagonal:", [&](TestMesh& m, Halfedge h) { insert_diagonal(m, h, good); }},
                     {"insert_diagonal:", [&](TestMesh& m, Halfedge h) { insert_diagonal(m, good, h); }},
                     {"remove_diagonal:", [](TestMesh& m, Halfedge h) { remove_diagonal(m, h); }},
                     {"split_edge:", [](TestMesh& m, Halfedge h) { split_edge(m, h, CarryOver()); }},
                     {"split_vertex:", [](TestMesh& m, Halfedge h) { split_vertex(m, h, h, CarryOver()); }},
                     {"unglue:", [](TestMesh& m, Halfedge h) { unglue(m, made_up(GlueCase::zip, h, h)); }},
                     {"undo:", [](TestMesh& m, Halfedge h) { undo(m, weld_of(Vertex(0), h)); }},
                     {"glue:",
                      [](TestMesh& m, Halfedge h) {
                        glue_back(m, std::vector{UnglueEffect{GlueCase::zip, h, h, Vertex(), Vertex()}});
                      }},
                     {"loop_kinds:", [](TestMesh& m, Halfedge h) { kinds_of(m, {h}); }},
                     {"loop_kinds:",
                      [&](TestMesh& m, Halfedge h) {
                        kinds_of(m, {good, h});
                      }},
                     {"TopologyTracker:", [](TestMesh& m, Halfedge h) { TopologyTracker(m).note(OpenCurveEffect{h}); }},
                     {"TopologyTracker:",
                      [](TestMesh& m, Halfedge h) {
                        TopologyTracker(m).note(SplitEffect{{}, h});
                      }},
                     {"glue:", [&](TestMesh& m, Halfedge h) { History(m).glue(h, good); }},
                     {"unglue:", [](TestMesh& m, Halfedge h) { History(m).unglue(h); }},
                     {"close_curve:", [](TestMesh& m, Halfedge h) { History(m).close_curve(h); }},
                     {"collapse:", [](TestMesh& m, Halfedge h) { History(m).collapse(h); }},
                     {"weld_edge:", [](TestMesh& m, Halfedge h) { History(m).weld_edge(h); }},
                     {"insert_diagonal:", [&](TestMesh& m, Halfedge h) { History(m).insert_diagonal(good, h); }},
                     {"remove_diagonal:", [](TestMesh& m, Halfedge h) { History(m).remove_diagonal(h); }},
                     {"split_edge:", [](TestMesh& m, Halfedge h) { History(m).split_edge(h); }},
                     {"split_edge:", [](TestMesh& m, Halfedge h) { History(m).split_edge(m, h); }},
                     {"split_vertex:", [](TestMesh& m, Halfedge h) { History(m).split_vertex(h, h); }},
                     {"split_vertex:", [](TestMesh& m, Halfedge h) { History(m).split_vertex(m, h, h); }},
                     {"freeze:", [](TestMesh& m, Halfedge h) { Front(m).freeze(h); }},
                     {"activate:", [](TestMesh& m, Halfedge h) { Front(m).activate(h); }},
                     {"attach:", [](TestMesh& m, Halfedge h) { Front(m).attach(h, 0); }},
                     {"glue:", [&](TestMesh& m, Halfedge h) { TopologyTracker(m).glue(h, good); }},
                     {"zip_curves:", [&](TestMesh& m, Halfedge h) { TopologyTracker(m).zip_curves(good, h); }}});
    // In a view, a deleted edge still has ends.
    const auto out_of_range = std::vector<Halfedge>{Halfedge(), Halfedge(-5), Halfedge(1 << 30)};
    check<Halfedge>(out_of_range, {{"graph view:", [](TestMesh& m, Halfedge h) { source(h, PrimalGraph(m)); }},
                                   {"graph view:", [](TestMesh& m, Halfedge h) { target(h, DualGraph(m)); }},
                                   {"graph view:", [](TestMesh& m, Halfedge h) { target(h, BoundaryGraph(m)); }},
                                   {"length_map:", [](TestMesh& m, Halfedge h) { get(length_map(m), h); }},
                                   {"Front:", [](TestMesh& m, Halfedge h) { Front(m).from_site(h); }},
                                   {"Front:", [](TestMesh& m, Halfedge h) { Front(m).to_site(h); }}});
  }

  TEST_CASE_FIXTURE(Annulus, "no function follows a vertex, an edge or a face that does not exist") {
    check<Vertex>(
        no_vertices(),
        {{"weld_face:", [](TestMesh& m, Vertex v) { weld_face(m, v); }},
         {"remove_vertex:", [](TestMesh& m, Vertex v) { remove_vertex(m, v); }},
         {"boundary_curve_at:", [](TestMesh& m, Vertex v) { boundary_curve_at(m, v); }},
         {"graph view: vertex ", [](TestMesh& m, Vertex v) { out_edges(v, PrimalGraph(m)); }},
         {"graph view: vertex ", [](TestMesh& m, Vertex v) { in_edges(v, directed(PrimalGraph(m))); }},
         {"graph view: vertex ", [](TestMesh& m, Vertex v) { adjacent_vertices(v, BoundaryGraph(m)); }},
         {"TopologyTracker:", [](TestMesh& m, Vertex v) { TopologyTracker(m).in_same_component(Vertex(0), v); }},
         {"TopologyTracker:", [](TestMesh& m, Vertex v) { TopologyTracker(m).note(weld_of(v, Halfedge(0))); }},
         {"weld_face:", [](TestMesh& m, Vertex v) { History(m).weld_face(v); }},
         {"remove_vertex:", [](TestMesh& m, Vertex v) { History(m).remove_vertex(v); }}});
    const auto out_of_range = std::vector<Vertex>{Vertex(), Vertex(-5), Vertex(1 << 30)};
    check<Vertex>(out_of_range, {{"Front:", [](TestMesh& m, Vertex v) { Front(m).site(v); }}});
    const auto no_edges_of_signature = std::vector<Edge>{Edge(), Edge(-5), Edge(1 << 30)};
    check<Edge>(no_edges_of_signature,
                {{"HomologySignature:", [](TestMesh& m, Edge e) { homology_signature(m).of(e); }}});
    check<Edge>(no_edges(), {{"cut_open:", [](TestMesh& m, Edge e) { cut_open(m, std::vector{e}); }},
                             {"cut_open:",
                              [](TestMesh& m, Edge e) {
                                cut_open(m, Homology{{}, {e}});
                              }},
                             {"flip:", [](TestMesh& m, Edge e) { History(m).flip(e); }},
                             {"split_edge:", [](TestMesh& m, Edge e) { split_edge(m, e, CarryOver()); }},
                             {"split_edge:", [](TestMesh& m, Edge e) { split_edge(m, e); }},
                             {"flip:", [](TestMesh& m, Edge e) { flip(m, e); }},
                             {"undo:", [](TestMesh& m, Edge e) {
                                undo(m, FlipEffect{e, {Halfedge(), Halfedge()}});
                              }}});
    check<Face>(no_faces(),
                {{"destroy_triangle:", [](TestMesh& m, Face f) { destroy_triangle(m, f); }},
                 {"remove_triangle:", [](TestMesh& m, Face f) { remove_triangle(m, f); }},
                 {"open_curve:", [](TestMesh& m, Face f) { open_curve(m, f); }},
                 {"split_face:", [](TestMesh& m, Face f) { split_face(m, f); }},
                 {"split_face:", [](TestMesh& m, Face f) { split_face(m, f, CarryOver()); }},
                 {"triangulate_face:", [](TestMesh& m, Face f) { triangulate_face(m, f); }},
                 {"rim_of:", [](TestMesh& m, Face f) { rim_of(m, f); }},
                 {"TopologyTracker:", [](TestMesh& m, Face f) { TopologyTracker(m).note(CloseCurveEffect{f}); }},
                 {"destroy_triangle:", [](TestMesh& m, Face f) { History(m).destroy_triangle(f); }},
                 {"open_curve:", [](TestMesh& m, Face f) { History(m).open_curve(f); }},
                 {"split_face:", [](TestMesh& m, Face f) { History(m).split_face(f); }},
                 {"split_face:", [](TestMesh& m, Face f) { History(m).split_face(m, f); }},
                 {"detach:", [](TestMesh& m, Face f) { Front(m).detach(f); }},
                 {"smaller_part:", [](TestMesh& m, Face f) { smaller_part(m, f, Face(0)); }},
                 {"in_same_component:", [](TestMesh& m, Face f) { in_same_component(m, Face(0), f); }},
                 {"graph view: face ", [](TestMesh& m, Face f) { out_edges(f, DualGraph(m)); }}});
  }

  TEST_CASE_FIXTURE(Annulus, "no function of a front follows a site that does not exist") {
    const auto before = snapshot(mesh);
    const Front front(mesh);
    for (const Site s : {static_cast<Site>(front.sites()), Site{1} << 30, static_cast<Site>(-1)}) {
      CAPTURE(s);
      CHECK_THROWS_AS(front.is_free(s), ContractViolation);
      CHECK_THROWS_AS(front.is_on_boundary(s), ContractViolation);
      CHECK_THROWS_AS(front.for_each_fan(s, [](Vertex) {}), ContractViolation);
      CHECK_THROWS_AS(front.edge_between(s, 0), ContractViolation);
      CHECK_THROWS_AS(front.edge_between(0, s), ContractViolation);
      CHECK_THROWS_AS(front.edges_between(0, s), ContractViolation);
      CHECK_THROWS_AS(front.boundary_between(s, 0), ContractViolation);
      CHECK_THROWS_AS(front.triangle_on(s, 0, 1), ContractViolation);
      CHECK_FALSE(front.triangle_on(0, 1, s).is_valid());
      CHECK_THROWS_AS(front.curves_at(s), ContractViolation);
      if (s > front.sites()) CHECK(front.create_blocker(0, 1, s));
    }
    for (const Face f : {Face(), Face(-5), Face(1 << 30)}) CHECK_THROWS_AS(front.level(f), ContractViolation);
    CHECK_FALSE(front.is_boundary(Halfedge()));
    CHECK_FALSE(front.is_active(Halfedge(1 << 30)));
    CHECK_FALSE(front.is_frozen(Halfedge(-5)));
    CHECK(snapshot(mesh) == before);
  }

  TEST_CASE_FIXTURE(Annulus, "numbers and lists of another length than the mesh's are refused") {
    const auto before = snapshot(mesh);
    const std::vector<double> short_lengths(mesh.n_edges() - 1, 1.0);
    const std::vector<std::uint32_t> short_points(mesh.n_vertices() - 1, 0);
    const std::vector<Site> short_sites(mesh.n_vertices() - 1, 0);
    CHECK_THROWS_AS(homology(mesh, short_lengths), ContractViolation);
    CHECK_THROWS_AS(homology_generators(mesh, short_lengths), ContractViolation);
    CHECK_THROWS_AS(shortest_homology_basis(mesh, short_lengths), ContractViolation);
    CHECK_THROWS_AS(shortest_homology_loops(mesh, short_lengths, 1), ContractViolation);
    std::vector<double> lengths(mesh.n_edges(), 1.0);
    for (const double wrong :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      lengths[static_cast<std::size_t>(mesh.edge_handle(boundary).idx())] = wrong;
      CHECK_THROWS_AS(homology(mesh, lengths), ContractViolation);
      CHECK_THROWS_AS(homology_generators(mesh, lengths), ContractViolation);
      CHECK_THROWS_AS(shortest_homology_basis(mesh, lengths), ContractViolation);
      CHECK_THROWS_AS(shortest_homology_loops(mesh, lengths, 1), ContractViolation);
    }
    CHECK_THROWS_AS(soup_of(mesh, short_points), ContractViolation);
    CHECK_THROWS_AS(report(mesh, short_points), ContractViolation);
    CHECK_THROWS_AS(Front(mesh, short_sites), ContractViolation);
    CHECK_THROWS_AS(Front(mesh, std::size_t{3}), ContractViolation);
    CHECK_THROWS_AS(build_mesh(mesh, PolygonSoup()), ContractViolation);
    CHECK_THROWS_AS(PatchAssembler(mesh, 3), ContractViolation);
    const PolygonSoup soup = soup_of(mesh);
    CHECK_THROWS_AS(keep_faces(soup, std::vector<bool>(soup.faces() - 1)), ContractViolation);
    CHECK_THROWS_AS(merge_points(soup, std::vector<std::uint32_t>(soup.points - 1)), ContractViolation);
    CHECK_THROWS_AS(merge_points(soup, std::vector<std::uint32_t>(soup.points, 1)), ContractViolation);
    PolygonSoup other = soup;
    CHECK_THROWS_AS(reverse_faces(other, std::vector<bool>(soup.faces() - 1)), ContractViolation);
    PolygonSoup unparted = soup;
    unparted.begin.back() += 1;
    CHECK_THROWS_AS(find_defects(unparted), ContractViolation);
    CHECK_THROWS_AS(repair(unparted), ContractViolation);
    CHECK_THROWS_AS(orient(unparted), ContractViolation);
    CHECK_THROWS_AS(report(unparted), ContractViolation);
    CHECK_THROWS_AS(examine(unparted), ContractViolation);
    CHECK_THROWS_AS(keep_faces(unparted, std::vector<bool>(soup.faces())), ContractViolation);
    CHECK_THROWS_AS(merge_points(unparted, std::vector<std::uint32_t>(soup.points)), ContractViolation);
    CHECK(snapshot(mesh) == before);
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
        {"open_curve", message([&] { open_curve(mesh, Face(0)); })},
        {"remove_diagonal", message([&] { remove_diagonal(mesh, b[0]); })}};
    for (const auto& found : all)
      CHECK_MESSAGE(found.second.starts_with(found.first + ": the mesh needs "), found.second);
    // Their blockers return the reason as well.
    const std::pair<std::string, std::optional<Blocker>> blockers[] = {
        {"collapse", collapse_blocker(mesh, b[0])},
        {"weld_edge", weld_edge_blocker(mesh, b[0])},
        {"weld_face", weld_face_blocker(mesh, Vertex(0))},
        {"remove_vertex", remove_vertex_blocker(mesh, Vertex(0))},
        {"glue", glue_blocker(mesh, b[0], b[3])},
        {"zip_curves", zip_curves_blocker(mesh, b[0], b[3])},
        {"destroy_triangle", destroy_triangle_blocker(mesh, Face(0))},
        {"remove_triangle", remove_triangle_blocker(mesh, Face(0))},
        {"open_curve", open_curve_blocker(mesh, Face(0))},
        {"remove_diagonal", remove_diagonal_blocker(mesh, b[0])}};
    for (const auto& [name, blocker] : blockers) {
      const auto& shown_name = name;
      CAPTURE(shown_name);
      const auto found = std::ranges::find(all, name, [](const auto& one) { return one.first; });
      REQUIRE(blocker);
      CHECK(found->second == name + ": " + describe(*blocker));
    }
    OpenMesh::TriMesh_ArrayKernelT<> empty;
    Front front(empty, 3);
    front.create(0, 1, 2);
    REQUIRE(front.detach_blocker(Face(0)));
    CHECK(front.detach_blocker(Face(0))->kind == RefusalKind::no_status);
    CHECK_THROWS_AS(front.detach(Face(0)), ContractViolation);
    CHECK(front.faces() == 1);
  }

  TEST_CASE("a tracker refuses an effect that did not happen, and counts nothing") {
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
    CHECK_THROWS_AS(tracker.note(WeldEffect()), ContractViolation);
    CHECK_THROWS_AS(tracker.note(CloseCurveEffect()), ContractViolation);
    CHECK_THROWS_AS(tracker.note(OpenCurveEffect()), ContractViolation);
    const Vertex unknown = mesh.new_vertex();
    CHECK_THROWS_AS(tracker.in_same_component(unknown, Vertex(0)), ContractViolation);
    CHECK(tracker.counts() == counts);
  }

  TEST_CASE("a made-up effect of glue() is refused if it would revive one vertex twice") {
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
