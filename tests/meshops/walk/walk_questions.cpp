// The functions that only read, with valid and invalid arguments.
#include "meshops/core/reach.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/handle/unglue.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/report.h"
#include "meshops/topology/tracker.h"
#include "walk/walk.h"

namespace meshops::test {
namespace {

template <typename Graph>
void turn_around(const Graph& graph, typename Graph::vertex_descriptor v) {
  for (auto [edge, end] = out_edges(v, graph); edge != end; ++edge) target(*edge, graph);
  for (auto [other, end] = adjacent_vertices(v, graph); other != end; ++other) degree(*other, graph);
}

/// Calls ask(); a contract violation is a valid answer.
template <typename Ask>
void allow_refusal(Ask ask) {
  try {
    ask();
  } catch (const ContractViolation&) {
  }
}

}  // namespace

void Walk::ask() {
  judge_.begin("a question");
  const Halfedge a = arguments_.halfedge(), b = arguments_.boundary(), c = arguments_.boundary_near(b);
  const Vertex v = arguments_.vertex();
  const Face f = arguments_.face(), g = arguments_.face();
  allow_refusal([&] { on_same_curve(mesh_, b, choices_.one_in(4) ? a : c); });
  allow_refusal([&] { in_same_component(mesh_, f, g, arguments_.edge()); });
  allow_refusal([&] { BoundaryCurve(mesh_, b).contains(c); });
  allow_refusal([&] { boundary_curve_at(mesh_, v); });
  allow_refusal([&] { turn_around(PrimalGraph(mesh_), v); });
  allow_refusal([&] { turn_around(DualGraph(mesh_), f); });
  allow_refusal([&] { turn_around(BoundaryGraph(mesh_), v); });
  allow_refusal([&] { source(a, DualGraph(mesh_)); });
  allow_refusal([&] {
    const GlueCase what = glue_case(mesh_, b, c);
    if (glue_blocker(mesh_, b, c)) judge_.fail("glue_case returned a case for halfedges that cannot be glued");
    Model glued = judge_.before();
    by_definition::glue(glued, b.idx(), c.idx());
    if (on_ == On::manifolds && !(glued.counts() == judge_.before().counts() + delta_of(what)))
      judge_.fail("glue_case is wrong");
  });
  allow_refusal([&] {
    unglue_case(mesh_, a);
    if (unglue_blocker(mesh_, a)) judge_.fail("unglue_case returned a case for a halfedge that cannot be unglued");
  });
  TopologyTracker tracker(mesh_);
  allow_refusal([&] { tracker.in_same_component(v, arguments_.vertex()); });
  allow_refusal([&] { tracker.note(recall(glued_).effect); });
  allow_refusal([&] { tracker.note_undone(recall(welded_).effect); });
  allow_refusal([&] { tracker.note(CreateTriangleEffect{f, a, b}); });

  const Delta counts = judge_.before().counts();
  const TopologyReport r = report(mesh_);
  const auto is = [](std::size_t number, int expected) { return number == static_cast<std::size_t>(expected); };
  if (!is(r.vertices, counts.vertices) || !is(r.edges, counts.edges) || !is(r.faces, counts.faces) ||
      !is(r.boundary_curves, counts.curves) || !is(r.solid_components + r.isolated, counts.components) ||
      r.genus != counts.genus)
    judge_.fail("report() is wrong");
  const TopologyCounts quick = count_topology(mesh_);
  if (on_ == On::manifolds && (!is(quick.boundary_curves, counts.curves) || !is(quick.components, counts.components)))
    judge_.fail("count_topology() is wrong");
  if (choices_.one_in(4)) homology(mesh_);
  if (snapshot(mesh_) != judge_.records()) judge_.fail("changed the mesh");
}

}  // namespace meshops::test
