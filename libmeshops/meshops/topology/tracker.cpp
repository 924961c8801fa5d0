#include "meshops/topology/tracker.h"

#include <optional>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/reach.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

void add(std::size_t& count, int change) {
  count = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(count) + change);
}

}  // namespace

TopologyTracker::TopologyTracker(Connectivity& mesh)
    : mesh_(mesh), counts_(count_topology(mesh)), nodes_(mesh.n_vertices()) {
  for (std::uint32_t v = 0; v < mesh.n_vertices(); ++v) node_of_.push_back(v);
  for_each_edge(mesh, [&](Edge e) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    nodes_.unite(node(mesh.from_vertex_handle(h)), node(mesh.to_vertex_handle(h)));
  });
}

bool TopologyTracker::in_same_component(Vertex a, Vertex b) {
  for (const Vertex v : {a, b})
    require(is_live(mesh_, v), "TopologyTracker: vertex ", v.idx(), " does not exist or is deleted");
  return nodes_.find(node(a)) == nodes_.find(node(b));
}

GlueEffect TopologyTracker::glue(Halfedge first, Halfedge second) {
  // meshops::glue() refuses the calls that must be refused, and says why.
  if (!has_status(mesh_) || detail::glue_links_blocker(mesh_, first, second))
    return meshops::glue(mesh_, first, second);
  const GlueEffect effect = detail::glue_links(mesh_, first, second, case_of(first, second));
  note(effect);
  return effect;
}

/// Returns the case of a glue. No search through faces is needed, because components are tracked: two edges on
/// different curves of one component make a handle.
GlueCase TopologyTracker::case_of(Halfedge first, Halfedge second) {
  if (!in_same_component(mesh_.from_vertex_handle(first), mesh_.from_vertex_handle(second))) return GlueCase::join;
  const bool adjacent = mesh_.next_halfedge_handle(first) == second || mesh_.next_halfedge_handle(second) == first;
  return adjacent || on_same_curve(mesh_, first, second) ? detail::case_of_glue(mesh_, first, second)
                                                         : GlueCase::handle;
}

void TopologyTracker::note(const CreateTriangleEffect& effect) {
  require(is_live(mesh_, effect.inner), "TopologyTracker: halfedge ", effect.inner.idx(),
          " does not exist or is deleted");
  change(effect.delta());
  const std::uint32_t fresh = new_node();
  Halfedge h = effect.inner;
  do {
    put(mesh_.from_vertex_handle(h), fresh);
    h = mesh_.next_halfedge_handle(h);
  } while (h != effect.inner);
}

void TopologyTracker::note_destroyed() { change(delta_of_destroy()); }

void TopologyTracker::note(const GlueEffect& effect) {
  const std::uint32_t a = node(effect.first_ends.from), b = node(effect.second_ends.from);
  change(effect.delta());
  nodes_.unite(a, b);
}

void TopologyTracker::note(const UnglueEffect& effect) {
  for (const Halfedge h : {effect.first, effect.second})
    require(is_live(mesh_, h) && mesh_.is_boundary(h), "TopologyTracker: halfedge ", h.idx(),
            " is not a boundary halfedge");
  // At least one end of the two halfedges is an old vertex.
  const Vertex ends[] = {mesh_.from_vertex_handle(effect.first), mesh_.to_vertex_handle(effect.first),
                         mesh_.from_vertex_handle(effect.second), mesh_.to_vertex_handle(effect.second)};
  Vertex known;
  for (const Vertex v : ends)
    if (v != effect.new_start && v != effect.new_end) known = v;
  const std::uint32_t old = node(known);
  std::optional<std::vector<Face>> parted;
  if (effect.what == GlueCase::join) {
    const auto face_at = [&](Halfedge h) { return mesh_.face_handle(mesh_.opposite_halfedge_handle(h)); };
    parted = smaller_part(mesh_, face_at(effect.first), face_at(effect.second));
    require(parted.has_value(),
            "TopologyTracker: unglue() split no component, contrary to its effect (pass the effect unchanged)");
  }
  for (const Vertex v : {effect.new_start, effect.new_end})
    require(!v.is_valid() || is_live(mesh_, v), "TopologyTracker: vertex ", v.idx(), " does not exist or is deleted");

  change(effect.delta());
  for (const Vertex v : {effect.new_start, effect.new_end})
    if (v.is_valid()) put(v, old);
  if (!parted) return;
  const std::uint32_t fresh = new_node();
  for (const Face f : *parted) {
    const Halfedge first = mesh_.halfedge_handle(f);
    Halfedge h = first;
    do {
      put(mesh_.from_vertex_handle(h), fresh);
      h = mesh_.next_halfedge_handle(h);
    } while (h != first);
  }
}

void TopologyTracker::note(const CloseCurveEffect& effect) {
  require(is_live(mesh_, effect.face), "TopologyTracker: face ", effect.face.idx(), " does not exist or is deleted");
  change(effect.delta());
}

void TopologyTracker::note(const OpenCurveEffect& effect) {
  require(is_live(mesh_, effect.curve) && mesh_.is_boundary(effect.curve), "TopologyTracker: halfedge ",
          effect.curve.idx(), " is not a boundary halfedge");
  change(effect.delta());
}

ZipCurvesEffect TopologyTracker::zip_curves(Halfedge first, Halfedge second) {
  const bool live = is_live(mesh_, first) && is_live(mesh_, second);
  const std::uint32_t a = live ? node(mesh_.from_vertex_handle(first)) : 0;
  const std::uint32_t b = live ? node(mesh_.from_vertex_handle(second)) : 0;
  const ZipCurvesEffect effect = meshops::zip_curves(mesh_, first, second);
  change(effect.delta());
  nodes_.unite(a, b);
  return effect;
}

void TopologyTracker::note(const SplitEffect& effect) {
  require(is_live(mesh_, effect.halfedge) && is_live(mesh_, effect.added.vertex),
          "TopologyTracker: the halfedge or the new vertex of the split does not exist or is deleted");
  const std::uint32_t old = node(mesh_.to_vertex_handle(effect.halfedge));
  change(effect.delta());
  put(effect.added.vertex, old);
}

void TopologyTracker::note(const WeldEffect& effect) {
  require(is_live(mesh_, effect.survivor) && effect.removed.vertex.is_valid() && !is_live(mesh_, effect.removed.vertex),
          "TopologyTracker: the surviving vertex of the weld does not exist, or the removed vertex is not deleted");
  change(effect.delta());
}

void TopologyTracker::note_undone(const WeldEffect& effect) {
  require(is_live(mesh_, effect.removed.vertex),
          "TopologyTracker: the removed vertex is not restored (call note_undone() after undo())");
  const std::uint32_t old = node(effect.survivor);
  change(-effect.delta());
  put(effect.removed.vertex, old);
}

void TopologyTracker::change(const Delta& delta) {
  add(counts_.vertices, delta.vertices);
  add(counts_.edges, delta.edges);
  add(counts_.faces, delta.faces);
  add(counts_.boundary_curves, delta.curves);
  add(counts_.components, delta.components);
}

void TopologyTracker::put(Vertex v, std::uint32_t node) {
  const auto index = static_cast<std::size_t>(v.idx());
  if (index >= node_of_.size()) node_of_.resize(index + 1, node);
  node_of_[index] = node;
}

std::uint32_t TopologyTracker::node(Vertex v) const {
  require(v.is_valid() && static_cast<std::size_t>(v.idx()) < node_of_.size(), "TopologyTracker: vertex ", v.idx(),
          " is invalid or unknown (call note() after each operator)");
  return node_of_[static_cast<std::size_t>(v.idx())];
}

std::uint32_t TopologyTracker::new_node() {
  if (nodes_.size() > 2 * node_of_.size() + 1024) forget_old_nodes();
  return nodes_.add();
}

/// Renumbers the nodes, with one node for each set in use, so that their number does not grow through a long run.
void TopologyTracker::forget_old_nodes() {
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> renumbered(nodes_.size(), none);
  DisjointSets fresh;
  for (std::uint32_t& node : node_of_) {
    std::uint32_t& number = renumbered[nodes_.find(node)];
    if (number == none) number = fresh.add();
    node = number;
  }
  nodes_ = std::move(fresh);
}

}  // namespace meshops
