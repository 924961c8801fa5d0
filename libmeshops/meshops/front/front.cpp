#include "meshops/front/front.h"

#include <algorithm>
#include <utility>

#include "meshops/core/validate.h"
#include "meshops/handle/extract_triangle.h"
#include "meshops/patch/compact.h"

namespace meshops {
namespace {

SiteVertices vertices_on(Connectivity& mesh, std::span<const Site> site_of_vertex) {
  if (site_of_vertex.empty()) return {mesh, mesh.n_vertices()};
  return {mesh, site_of_vertex};
}

}  // namespace

Front::Front(Connectivity& mesh, std::size_t sites, std::size_t supply)
    : mesh_(mesh), guard_(mesh), vertices_(mesh, sites), supply_(supply), waiting_(mesh) {
  require(mesh.n_vertices() == 0, "Front: the mesh has ", static_cast<long long>(mesh.n_vertices()),
          " vertices, expected none");
  require(supply > 0, "Front: supply is 0, expected 1 or more");
  mesh.resize(sites, 0, 0);
  guard_.count_elements();
}

Front::Front(Connectivity& mesh, std::span<const Site> site_of_vertex)
    : mesh_(mesh),
      guard_(mesh),
      vertices_(vertices_on(mesh, site_of_vertex)),
      supply_(1),
      keeps_handles_(true),
      waiting_(mesh) {
  detail::require_status(mesh, "Front");
  if (const auto defects = validate(mesh); !defects.empty())
    throw ContractViolation("Front: the mesh is not sound: " + describe(defects.front()));
  guard_.count_elements();
  edges_ = dead_edges_ = mesh.n_edges();
  faces_ = dead_faces_ = mesh.n_faces();
  for_each_face(mesh, [&](Face) { --dead_faces_; });
  for_each_edge(mesh, [&](Edge e) {
    --dead_edges_;
    const Halfedge h = mesh.halfedge_handle(e, 0);
    require(from_site(h) != to_site(h), "Front: an edge joins two vertices on one site");
  });
  more_sides_ = 2 * edges() - 3 * faces();
  for_each_halfedge(mesh, [&](Halfedge h) {
    if (!mesh.is_boundary(h)) return;
    activate(h);
    --more_sides_;
  });
}

Front::Front(AssembledPatches&& assembled, std::size_t supply)
    : mesh_(assembled.unchanged()),
      guard_(mesh_),
      vertices_(std::move(assembled.vertices_)),
      supply_(supply),
      edges_(mesh_.n_edges()),
      faces_(mesh_.n_faces()),
      waiting_(mesh_) {
  require(supply > 0, "Front: supply is 0, expected 1 or more");
  guard_.count_elements();
  waiting_.queue_all(std::move(assembled.open_));
  for (const auto& [first, end] : assembled.holes_)
    for (int e = first; e < end; ++e) waiting_.freeze(Halfedge(2 * e + 1));
}

void Front::supply(std::size_t edges, std::size_t faces) {
  mesh_.resize(mesh_.n_vertices(), mesh_.n_edges() + edges, mesh_.n_faces() + faces);
}

Halfedge Front::Supply::edge(Vertex from, Vertex to) {
  const Halfedge h(static_cast<int>(2 * front.edges_++));
  front.mesh_.set_vertex_handle(h, to);
  front.mesh_.set_vertex_handle(front.mesh_.opposite_halfedge_handle(h), from);
  return h;
}

bool Front::is_boundary(Halfedge h) const {
  guard_.require_intact();
  return h.idx() >= 0 && static_cast<std::size_t>(h.idx()) < 2 * edges_ && is_live(mesh_, h) && mesh_.is_boundary(h);
}

std::size_t Front::level(Face f) const {
  require(f.idx() >= 0 && static_cast<std::size_t>(f.idx()) < faces_, "level: face ", f.idx(), " does not exist");
  return levels_.level(f);
}

Fit Front::at(Site a, Site b, Site c) const {
  Fit fit({a, b, c}, *this, revision());
  by_sites().check_corners(fit);
  return fit;
}

Fit Front::at(Halfedge h, Site apex) const {
  Fit fit({0, 0, apex}, *this, revision());
  if (!is_boundary(h)) {
    fit.refusal = Refusal{RefusalKind::no_boundary_halfedge, 0, 0, h.idx()};
    return fit;
  }
  const detail::Fitting lookup = by_sites();
  fit.corners = {lookup.start(h), lookup.end(h), apex};
  fit.sides.side[0] = h;
  lookup.check_corners(fit);
  return fit;
}

Fit Front::fit(Site a, Site b, Site c) const {
  Fit fit = at(a, b, c);
  if (!fit.refusal) by_sites().find_sides(fit);
  return fit;
}

Fit Front::fit(Halfedge h, Site apex) const {
  Fit fit = at(h, apex);
  if (!fit.refusal) by_sites().find_other_sides(fit);
  return fit;
}

/// Checks a fit completely, because a caller may have made it, or the front may have changed after fit().
void Front::check(const Fit& fit) const {
  detail::enforce("insert", fit.refusal);
  if (fit.front_ != nullptr) {
    require(fit.front_ == this, "insert: the fit is one of another front");
    require(fit.revision_ == revision(),
            "insert: the fit is stale: a triangle was attached or detached since it was made");
  }
  const detail::Fitting lookup = by_sites();
  Fit corners(fit.corners);
  lookup.check_corners(corners);
  detail::enforce("insert", corners.refusal);
  for (unsigned i = 0; i < 3; ++i) {
    const Halfedge h = fit.sides.side[i];
    if (!h.is_valid()) continue;
    if (!is_boundary(h))
      detail::enforce("insert", std::optional(Refusal{RefusalKind::no_boundary_halfedge, 0, 0, h.idx()}));
    require(lookup.start(h) == fit.corners[i] && lookup.end(h) == fit.corners[(i + 1) % 3],
            "insert: a given side does not run between its corners");
  }
}

InsertedTriangle Front::insert(const Fit& fit) {
  guard_.require_changeable();
  check(fit);
  return put(fit);
}

InsertedTriangle Front::put(const Fit& fit) {
  std::size_t new_edges = 0;
  for (unsigned i = 0; i < 3; ++i) {
    while (fit.corners[i] >= sites()) vertices_.add_site();
    new_edges += !fit.sides.side[i].is_valid();
  }
  if (edges_ + new_edges > mesh_.n_edges()) supply(std::max(new_edges, supply_), 0);
  if (faces_ == mesh_.n_faces()) supply(0, supply_);
  TriangleSides sides = fit.sides;
  for (unsigned i = 0; i < 3; ++i)
    if (!sides.side[i].is_valid() && !sides.side[(i + 2) % 3].is_valid())
      sides.corner[i] = vertices_.take(fit.corners[i]);
  guard_.count_elements();
  const InsertedTriangle result = insert_triangle(mesh_, sides, Supply{*this});
  for (unsigned i = 0; i < static_cast<unsigned>(result.merged); ++i) vertices_.release(result.left_over[i]);
  for (unsigned i = 0; i < 3; ++i)
    if (!sides.side[i].is_valid()) waiting_.queue(mesh_.opposite_halfedge_handle(result.side[i]));
  return result;
}

InsertedTriangle Front::insert_checked(const Fit& fit, const char* operation) {
  guard_.require_changeable();
  detail::enforce(operation, fit.refusal);
  return put(fit);
}

std::optional<Refusal> Front::detach_blocker(Face f) const {
  guard_.require_intact();
  const Refusal refusal{RefusalKind::no_such_face, 0, 0, f.idx()};
  const auto because = [&](RefusalKind kind) { return Refusal{kind, 0, 0, f.idx()}; };
  if (f.idx() < 0 || static_cast<std::size_t>(f.idx()) >= faces_ || !is_live(mesh_, f)) return refusal;
  const Halfedge side = mesh_.halfedge_handle(f);
  const Halfedge next = mesh_.next_halfedge_handle(side), last = mesh_.prev_halfedge_handle(side);
  if (mesh_.next_halfedge_handle(next) != last) return because(RefusalKind::no_triangle);
  for (const Halfedge h : {side, next, last})
    if (mesh_.is_boundary(mesh_.opposite_halfedge_handle(h)))
      return has_status(mesh_) ? std::nullopt : std::optional(because(RefusalKind::no_status));
  return because(RefusalKind::not_at_front);
}

DetachedTriangle Front::detach(Face f) {
  guard_.require_changeable();
  detail::enforce("detach", detach_blocker(f));
  const TriangleRim rim = rim_of(mesh_, f);
  DetachedTriangle detached;
  std::array<Vertex, 3> second;
  for (unsigned i = 0; i < 3; ++i) {
    const Site s = detached.corners[i] = site(rim.corner[i]);
    if (!is_on_boundary(s)) levels_.reopen(s);
    if (rim.is_passage[i]) {
      second[i] = vertices_.take(s);
      guard_.count_elements();
    }
  }
  extract_triangle(mesh_, rim, second);
  ++dead_faces_;
  for (unsigned i = 0; i < 3; ++i) {
    if (mesh_.is_isolated(rim.corner[i])) vertices_.release(rim.corner[i]);
    if (rim.is_glued[i]) {
      detached.side[i] = rim.side[i];
      waiting_.queue(rim.side[i]);
    } else {
      ++dead_edges_;
      waiting_.release(rim.side[i]);
    }
  }
  return detached;
}

void Front::requeue(Halfedge in_hand, std::span<const Halfedge> next) {
  if (!guard_.is_intact()) return;
  std::vector<Halfedge> first;
  if (is_boundary(in_hand) && !waiting_.is_waiting(in_hand)) {
    waiting_.queue(in_hand);
    first.push_back(in_hand);
  }
  first.insert(first.end(), next.begin(), next.end());
  waiting_.requeue(first);
}

void Front::activate(Halfedge h) {
  guard_.require_states_changeable();
  require(is_boundary(h), "activate: halfedge ", h.idx(), " is not a boundary halfedge");
  if (!is_active(h) || waiting_.is_deferred(h)) waiting_.queue(h);
}

void Front::freeze(Halfedge h) {
  guard_.require_states_changeable();
  require(is_boundary(h), "freeze: halfedge ", h.idx(), " is not a boundary halfedge");
  if (!is_frozen(h)) waiting_.freeze(h);
}

std::vector<BoundaryCurve> Front::curves() const {
  guard_.require_intact();
  std::vector<BoundaryCurve> found;
  std::vector<bool> seen(2 * edges_, false);
  for (std::size_t i = 0; i < 2 * edges_; ++i) {
    const Halfedge h(static_cast<int>(i));
    if (seen[i] || !is_boundary(h)) continue;
    found.emplace_back(mesh_, h);
    for (const Halfedge on_curve : found.back()) seen[static_cast<std::size_t>(on_curve.idx())] = true;
  }
  return found;
}

std::vector<BoundaryCurve> Front::curves_at(Site s) const {
  std::vector<BoundaryCurve> found;
  for_each_fan(s, [&](Vertex v) {
    if (const auto curve = boundary_curve_at(mesh_, v)) found.push_back(*curve);
  });
  return found;
}

LevelTransfer Front::next_level() {
  guard_.require_changeable();
  // The boundary halfedges give the sites on the boundary, so that no fan of any other site is read.
  std::vector<Halfedge> waiting;
  waiting_.for_each([&](Halfedge h) { waiting.push_back(h); });
  std::sort(waiting.begin(), waiting.end());
  waiting.erase(std::unique(waiting.begin(), waiting.end()), waiting.end());
  // Every halfedge is a side of a face or on the boundary, so that the counts give the number of popped halfedges.
  const std::size_t popped = 2 * edges() - 3 * faces() - more_sides_ - waiting.size();
  require(popped == 0, "next_level: the number of boundary halfedges that were popped and not queued again is ",
          static_cast<long long>(popped), ", expected 0 (freeze() or activate() them)");
  std::vector<Site> on_boundary;
  for (const Halfedge h : waiting) on_boundary.push_back(from_site(h));
  LevelTransfer transfer = levels_.begin_next(vertices_, std::move(on_boundary), faces_);
  transfer.reactivated = waiting_.wake_all();
  return transfer;
}

std::vector<Site> Front::finish() {
  guard_.require_changeable();
  std::vector<Site> site_of;
  if (keeps_handles_) {
    site_of.resize(mesh_.n_vertices());
    for (std::size_t i = 0; i < site_of.size(); ++i) site_of[i] = site(Vertex(static_cast<int>(i)));
    mesh_.resize(site_of.size(), edges_, faces_);
  } else {
    site_of = detail::compact(mesh_, vertices_, edges_, faces_);
  }
  guard_.finish();
  vertices_.clear();
  waiting_.clear();
  levels_.clear_sites();
  return site_of;
}

}  // namespace meshops
