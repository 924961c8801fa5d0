// What:   the front: boundary curves that are still to be advanced, on a mesh whose vertices stand on sites.
// Law:    whatever calls are made, the mesh is an oriented manifold at every step, and every boundary halfedge is active,
//         frozen, or held by the caller that popped it. Between two sites there is at most one edge, unless the caller decides
//         which sides are glued; then no triangle comes twice. What would break this is refused, with the mesh
//         untouched.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/front/fit.h"
#include "meshops/front/fitting.h"
#include "meshops/front/guard.h"
#include "meshops/front/levels.h"
#include "meshops/front/refusal.h"
#include "meshops/front/waiting_edges.h"
#include "meshops/handle/insert_triangle.h"
#include "meshops/patch/assembled.h"
#include "meshops/patch/site_vertices.h"

namespace meshops {

namespace detail {
class EngineSide;
}  // namespace detail

/// A triangle that is no longer there.
struct DetachedTriangle {
  std::array<Site, 3> corners;
  /// Side i ran from corner i to corner i + 1: a boundary halfedge now, or invalid where nothing lay beyond.
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};
};

/// There is one front on a mesh, which is not copied. While it is in use nobody else adds elements to the mesh or takes some
/// out (garbage_collection(), add_face()); after finish() nobody asks it for more than mesh(), edges(), faces(), sites(),
/// frozen() and level(). Both are checked by every other member. Throws ContractViolation, which names the cause.
class MESHOPS_API Front {
 public:
  /// Begins with an empty mesh: adds `sites` isolated vertices, vertex i on site i.
  /// Elements of the mesh are made `supply` at a time, which is faster than singly; until finish() the mesh then has up
  /// to that many edges and faces at its end that are not in use. With 1 it never has any.
  /// Requires: the mesh has no vertices. Throws ContractViolation.
  Front(Connectivity& mesh, std::size_t sites, std::size_t supply = 1);

  /// Begins with an existing mesh: its boundary curves become the front, active, in the order of their handles.
  /// Vertex v stands on site v, or on site_of_vertex[v] (of a complex with pinches). Its elements keep their handles and
  /// properties; vertices on one site that become one are marked deleted but for one.
  /// Requires: the mesh is sound and has status of every kind; no edge joins two vertices on one site, and no two edges
  ///           join the same sites. All but the last is checked. Throws ContractViolation.
  /// Cost:     linear.
  explicit Front(Connectivity& mesh, std::span<const Site> site_of_vertex = {});

  /// Continues an assembled mesh: sides beyond which a patch may have had more are active, the others frozen.
  explicit Front(AssembledPatches&& assembled, std::size_t supply = 1);

  Front(const Front&) = delete;
  Front& operator=(const Front&) = delete;

  const Connectivity& mesh() const { return mesh_; }
  /// The number of edges and faces of the mesh.
  std::size_t edges() const { return edges_ - dead_edges_; }
  std::size_t faces() const { return faces_ - dead_faces_; }
  /// Sites are 0 to sites() − 1.
  std::size_t sites() const { return vertices_.sites(); }

  /// One more site: for methods that place points while they run. Returns: its number, which is what sites() was.
  Site add_site() {
    guard_.require_changeable();
    return vertices_.add_site();
  }

  /// Throws ContractViolation when there is no such vertex, halfedge or site; likewise below.
  Site site(Vertex v) const {
    guard_.require_intact();
    return vertices_.site(v);
  }
  Site from_site(Halfedge h) const { return by_sites().start(checked(h)); }
  Site to_site(Halfedge h) const { return by_sites().end(checked(h)); }

  /// No triangle has a corner on this site.
  bool is_free(Site s) const {
    guard_.require_intact();
    return vertices_.is_free(s);
  }
  /// A fan on this site is on the boundary.
  bool is_on_boundary(Site s) const {
    bool found = false;
    for_each_fan(s, [&](Vertex v) { found = found || mesh_.is_boundary(v); });
    return found;
  }
  /// Calls visit(Vertex) for each fan on the site: none when it is free. It must not change the mesh.
  template <typename Visit>
  void for_each_fan(Site s, Visit visit) const {
    guard_.require_intact();
    vertices_.for_each(s, [&](Vertex v) {
      visit(v);
      guard_.require_intact();
    });
  }

  /// The halfedge from a site to another, on the boundary or not; an invalid handle when no edge joins them.
  /// Cost: the lesser of the numbers of edges at both sites.
  Halfedge edge_between(Site from, Site to) const { return by_sites().edge_between(from, to); }
  /// All of them, in any order: there are several only where the caller decides what is glued.
  /// Cost: that of edge_between() where no edge joins them.
  std::vector<Halfedge> edges_between(Site from, Site to) const { return by_sites().edges_between(from, to); }
  /// The boundary halfedge from a site to another; an invalid handle when there is none.
  /// Cost: the lesser of the numbers of fans at both sites.
  Halfedge boundary_between(Site from, Site to) const { return by_sites().boundary_between(from, to); }
  /// The triangle with these corners in this order, whichever is first; an invalid handle when there is none.
  /// Cost: the number of edges at the first.
  Face triangle_on(Site a, Site b, Site c) const { return by_sites().triangle_on(a, b, c); }

  /// The number of transfers to a next level so far.
  std::size_t level() const { return levels_.count(); }
  /// What level() was when a face was inserted; 0 for those that the front began with. Also after finish().
  /// Cost: the logarithm of the number of levels. Throws ContractViolation when there is no such face; detached ones count.
  std::size_t level(Face f) const;

  /// Why create() and attach() would refuse; nothing when they would not. A triangle has three distinct sites, which
  /// exist or are the next new ones; on none of them do all faces close; and no face lies on its side of its edges yet.
  std::optional<Refusal> create_blocker(Site a, Site b, Site c) const { return fit(a, b, c).refusal; }
  std::optional<Refusal> attach_blocker(Halfedge h, Site apex) const { return fit(h, apex).refusal; }

  /// Adds a triangle, counter-clockwise, and glues it to the boundary halfedges between its sites. Its new boundary
  /// halfedges become active. A corner without a face beside it there is a fan, and a vertex, of its own.
  /// The numbers that follow the last site stand for new ones, which are added then.
  /// Requires: create_blocker() is empty. Throws ContractViolation, mesh untouched.
  /// Cost:     as edge_between() for each of the three, plus the degree of vertices that become one.
  InsertedTriangle create(Site a, Site b, Site c) { return insert_checked(fit(a, b, c), "create"); }

  /// Attaches a triangle to a boundary halfedge a→b, with its apex on a site, on the left: create(a, b, apex) for a caller
  /// that has the halfedge.
  /// Requires: attach_blocker() is empty. Throws ContractViolation, mesh untouched.
  InsertedTriangle attach(Halfedge h, Site apex) { return insert_checked(fit(h, apex), "attach"); }

  /// The same in two steps, so that the triangle is checked once.
  Fit fit(Site a, Site b, Site c) const;
  Fit fit(Halfedge h, Site apex) const;
  /// The same for a caller that decides which sides are glued, where sites do not decide it: surfaces in space touch along
  /// edges, and have slits. Of the boundary halfedges between the sites of a side, the first is glued for which
  /// glues(halfedge, apex) is true, the apex being the third corner; without any it is a new edge. It must not change the
  /// front. The only requirements on the triangle itself are that it does not exist yet, and that its corners are distinct,
  /// and exist or are the next new ones.
  /// Cost: the numbers of fans at the corners, and of the edges at one.
  template <typename Glues>
  Fit fit(Site a, Site b, Site c, Glues glues) const {
    return find_glued(at(a, b, c), glues);
  }
  template <typename Glues>
  Fit fit(Halfedge h, Site apex, Glues glues) const {
    return find_glued(at(h, apex), glues);
  }
  /// Requires: `fit` has no refusal; nothing was attached or detached since this front made it; its corners are distinct, and
  ///           exist or are the next new ones; its sides are boundary halfedges between them. Throws ContractViolation, mesh
  ///           untouched.
  InsertedTriangle insert(const Fit& fit);

  /// Why detach() would refuse: there is no such face, it is no triangle, none of its sides is on the boundary, or the
  /// mesh has no status.
  std::optional<Refusal> detach_blocker(Face f) const;
  /// Detaches a triangle at the front, which is marked deleted as are the edges that no other has; sides that it was
  /// glued by become boundary halfedges, and active. The inverse of attach() and create(), up to handles.
  /// Requires: detach_blocker() is empty; the mesh has status of every kind. Throws ContractViolation, mesh untouched.
  /// Cost:     constant, plus the degree of a corner at which a fan falls in two.
  DetachedTriangle detach(Face f);

  /// The next active halfedge, first in first out, deferred ones last, which is then no longer active until it is made so,
  /// frozen or attached to; an invalid handle when the front has run dry.
  Halfedge pop() {
    guard_.require_changeable();
    Halfedge h = waiting_.next();
    if (!h.is_valid()) h = waiting_.next_deferred();
    if (h.is_valid()) waiting_.release(h);
    return h;
  }
  /// A boundary halfedge of the mesh: false of any other handle.
  bool is_boundary(Halfedge h) const;
  /// It waits for its turn, or is deferred.
  bool is_active(Halfedge h) const {
    guard_.require_intact();
    return waiting_.is_active(h);
  }
  bool is_frozen(Halfedge h) const {
    guard_.require_intact();
    return waiting_.is_frozen(h);
  }

  /// Queues a boundary halfedge: one that was popped, or one that is frozen or deferred, which wakes. Nothing when it is
  /// queued.
  /// Requires: a boundary halfedge of the mesh. Throws ContractViolation.
  void activate(Halfedge h);
  /// Sets a boundary halfedge aside: nothing can be attached to it at this level. Nothing when it is frozen.
  /// Requires: a boundary halfedge of the mesh. Throws ContractViolation.
  void freeze(Halfedge h);
  /// What was set aside at this level, in that order; some of it may have been attached to or woken since.
  const std::vector<Halfedge>& frozen() const { return waiting_.frozen(); }

  /// The boundary curves, each from its least halfedge. Cost: linear in the edges.
  std::vector<BoundaryCurve> curves() const;
  /// The boundary curves through a site, one for each fan on it that is on the boundary, each from where it leaves the
  /// site. A curve that passes the site several times comes as often. Cost: the number of fans.
  std::vector<BoundaryCurve> curves_at(Site s) const;

  /// Goes on to the next level: frozen halfedges become active again. The mesh and its curves stay as they are, and
  /// nothing of what was left behind before is read.
  /// Cost:   linear in the sites that the transfer before carried (all, the first time), and m log m in the m frozen
  ///         halfedges.
  /// Source: Restricted BPA, section 6; it is an operation on the mesh alone.
  LevelTransfer next_level();

  /// Frees memory that is no longer used and completes the mesh. A front that began with an empty mesh removes the
  /// vertices without triangles and renumbers the others, keeping their order; one that began with a mesh of the user's
  /// leaves every handle as it is. What was detached stays marked deleted.
  /// Returns:     the site of each vertex of the mesh.
  /// Invalidates: vertex handles, of an empty mesh; and this front, which has no sites any more.
  std::vector<Site> finish();

 private:
  /// Elements for insert_triangle(), which are there already.
  struct Supply {
    Front& front;
    Halfedge edge(Vertex from, Vertex to);
    Face face() { return Face(static_cast<int>(front.faces_++)); }
  };
  void supply(std::size_t edges, std::size_t faces);

  /// The number of triangles attached and detached so far, and of those it began with.
  std::size_t revision() const { return faces_ + dead_faces_; }

  /// What sites decide on the mesh as it is.
  detail::Fitting by_sites() const {
    guard_.require_intact();
    return {mesh_, vertices_};
  }
  Halfedge checked(Halfedge h) const {
    guard_.require_intact();
    require(h.idx() >= 0 && static_cast<std::size_t>(h.idx()) < 2 * edges_, "Front: no such halfedge");
    return h;
  }
  friend class detail::EngineSide;
  /// With the requirements on every triangle checked; its sides are still to be found.
  Fit at(Site a, Site b, Site c) const;
  Fit at(Halfedge h, Site apex) const;
  template <typename Glues>
  Fit find_glued(Fit fit, Glues glues) const;
  void check(const Fit& fit) const;
  InsertedTriangle put(const Fit& fit);
  void requeue(Halfedge in_hand, std::span<const Halfedge> next);
  InsertedTriangle insert_checked(const Fit& fit, const char* operation);

  Connectivity& mesh_;
  detail::Guard guard_;
  SiteVertices vertices_;
  std::size_t supply_;
  bool keeps_handles_ = false;  // it began with a mesh of the user's
  std::size_t edges_ = 0;       // in use, dead ones included; there may be more in supply
  std::size_t faces_ = 0;
  std::size_t dead_edges_ = 0;
  std::size_t dead_faces_ = 0;
  detail::WaitingEdges waiting_;
  detail::Levels levels_;
};

template <typename Glues>
Fit Front::find_glued(Fit fit, Glues glues) const {
  if (fit.refusal) return fit;
  // Many threads may call glues(), on a front that they only read.
  by_sites().find_sides(fit, [&](Halfedge h, Site apex) {
    const bool yes = glues(h, apex);
    guard_.require_intact();
    require(revision() == fit.revision_, "fit: glues() changed the front while it was asked");
    return yes;
  });
  return fit;
}

}  // namespace meshops
