// What:   the front: boundary curves that are still to be advanced, on a mesh whose vertices stand on sites.
// Law:    whatever calls are made, the mesh is an oriented manifold after each, and every boundary halfedge is active,
//         frozen, or held by the caller that popped it. At most one edge joins two sites, unless the caller decides
//         which sides are glued; then no triangle exists twice. A call that would break the law is refused, and the
//         mesh stays as it is.
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

/// Triangle that was detached: its corners, and the halfedges of its former sides.
struct DetachedTriangle {
  std::array<Site, 3> corners;  ///< counter-clockwise
  /// Side i ran from corner i to corner i + 1, modulo 3. It is a boundary halfedge now, or invalid if no face was
  /// beyond.
  std::array<Halfedge, 3> side = {Halfedge(), Halfedge(), Halfedge()};
};

/// Front on a mesh.
///
/// A *site* is the number of a point. A *fan* is a sequence of faces around a site, each adjacent to the next; each fan
/// has its own vertex, which stands on the site. A *deferred* halfedge is active, but has its turn only if no other
/// halfedge is active. A *frozen* halfedge waits for the next *level*, which next_level() begins.
///
/// A mesh has at most one front. While the front is in use, no other code may add elements to the mesh or remove
/// elements, as add_face() and garbage_collection() do. Every member throws ContractViolation if the numbers of
/// elements of the mesh are not those that the front left, or after finish(); the message names the cause. Only mesh(),
/// edges(), faces(), sites(), frozen() and level() may be called in these cases.
class MESHOPS_API Front {
 public:
  /// Begins with an empty mesh: adds `sites` isolated vertices, vertex i on site i. The front adds `supply` edges or
  /// faces to the mesh at a time, which is faster than one by one; until finish(), up to `supply` unused edges and as
  /// many unused faces may be at the end of the mesh. With `supply` = 1 there are never any.
  /// Requires: the mesh has no vertices; supply > 0. Throws ContractViolation otherwise.
  Front(Connectivity& mesh, std::size_t sites, std::size_t supply = 1);

  /// Begins with an existing mesh: its boundary halfedges become the front, all active, in ascending order. Vertex v
  /// stands on site v, or on site_of_vertex[v] (for a complex with pinches). The elements keep their handles and
  /// properties. If several vertices on one site become one, all but one are marked deleted.
  /// Requires: the mesh is sound and has status of every kind; `site_of_vertex` is empty, or has a site for each
  ///           vertex, below 2³¹ − 1 for live ones; no edge joins two vertices on one site; no two edges join the same
  ///           sites. All but the last is checked. Throws ContractViolation.
  /// Cost:     linear in the mesh and the greatest site.
  explicit Front(Connectivity& mesh, std::span<const Site> site_of_vertex = {});

  /// Continues an assembled mesh: open sides to which no patch was glued are active, and sides marked Patch::nothing
  /// are frozen. `supply` has the meaning that it has for an empty mesh. Leaves `assembled` empty.
  /// Requires: `assembled` is not empty, and its mesh is unchanged; supply > 0. Throws ContractViolation.
  explicit Front(AssembledPatches&& assembled, std::size_t supply = 1);

  Front(const Front&) = delete;
  Front& operator=(const Front&) = delete;

  const Connectivity& mesh() const { return mesh_; }
  /// edges() and faces() return the numbers of live edges and faces, without unused ones.
  std::size_t edges() const { return edges_ - dead_edges_; }
  std::size_t faces() const { return faces_ - dead_faces_; }
  /// Returns n such that the sites are 0 to n − 1; in a front without `site_of_vertex`, except the numbers of vertices
  /// that were deleted before the front began. Returns 0 after finish().
  std::size_t sites() const { return vertices_.sites(); }

  /// Adds a site, for methods that place points while they run. Returns: its number, the old value of sites().
  /// Throws: ContractViolation also if there are 2³¹ − 1 sites already.
  Site add_site() {
    guard_.require_changeable();
    return vertices_.add_site();
  }

  /// Returns the site of a vertex, or of the start or the end of a halfedge. Throws ContractViolation if the handle is
  /// out of range.
  Site site(Vertex v) const {
    guard_.require_intact();
    return vertices_.site(v);
  }
  Site from_site(Halfedge h) const { return by_sites().start(checked(h)); }
  Site to_site(Halfedge h) const { return by_sites().end(checked(h)); }

  /// Returns whether no triangle has a corner on this site. Throws ContractViolation unless the site is below sites();
  /// so do the members up to boundary_between(). The number of a deleted vertex counts as a free site.
  bool is_free(Site s) const {
    guard_.require_intact();
    return vertices_.is_free(s);
  }
  /// Returns whether a fan on this site is on the boundary; false if the site is free.
  bool is_on_boundary(Site s) const {
    bool found = false;
    for_each_fan(s, [&](Vertex v) { found = found || mesh_.is_boundary(v); });
    return found;
  }
  /// Calls visit(Vertex) for the vertex of each fan on the site. visit() must not change the mesh.
  template <typename Visit>
  void for_each_fan(Site s, Visit visit) const {
    guard_.require_intact();
    vertices_.for_each(s, [&](Vertex v) {
      visit(v);
      guard_.require_intact();
    });
  }

  /// Returns the halfedge from site `from` to site `to`, on the boundary or not; an invalid handle if there is none.
  /// Cost: the lesser of the numbers of edges at the two sites.
  Halfedge edge_between(Site from, Site to) const { return by_sites().edge_between(from, to); }
  /// Returns all halfedges from site `from` to site `to`, in any order. There can be several only if the caller decides
  /// which sides are glued. Cost: that of edge_between().
  std::vector<Halfedge> edges_between(Site from, Site to) const { return by_sites().edges_between(from, to); }
  /// Returns a boundary halfedge from site `from` to site `to`; an invalid handle if there is none.
  /// Cost: the lesser of the numbers of fans on the two sites.
  Halfedge boundary_between(Site from, Site to) const { return by_sites().boundary_between(from, to); }
  /// Returns the triangle with these corners in this cyclic order; an invalid handle if there is none.
  /// Throws: ContractViolation if site `a` does not exist. Cost: the number of edges at `a`.
  Face triangle_on(Site a, Site b, Site c) const { return by_sites().triangle_on(a, b, c); }

  /// Returns the number of transfers to a next level.
  std::size_t level() const { return levels_.count(); }
  /// Returns the value of level() when the face was inserted; 0 for faces with which the front began. May be called
  /// after finish() and for detached faces. Throws ContractViolation if the face does not exist.
  /// Cost: the logarithm of the number of levels.
  std::size_t level(Face f) const;

  /// Returns why create() or attach() would refuse, or nothing if it would not. The three corners of a triangle must be
  /// distinct sites. Each must exist or be one of the next new sites, and must be free or have a fan on the boundary.
  /// Where an edge joins two corners already, no face may lie on the side of the triangle. attach() also needs a
  /// boundary halfedge, which may be frozen.
  std::optional<Refusal> create_blocker(Site a, Site b, Site c) const { return fit(a, b, c).refusal; }
  std::optional<Refusal> attach_blocker(Halfedge h, Site apex) const { return fit(h, apex).refusal; }

  /// Adds a triangle, counter-clockwise, and glues it to the boundary halfedges between its sites. Its new boundary
  /// halfedges become active. At a corner where nothing is glued, the triangle begins a fan with its own vertex. The
  /// numbers that follow the last site stand for new sites, which the call adds.
  /// Requires: create_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
  /// Cost:     the cost of edge_between() for each side, plus the degrees of vertices that become one.
  InsertedTriangle create(Site a, Site b, Site c) { return insert_checked(fit(a, b, c), "create"); }

  /// Attaches a triangle to the boundary halfedge `h`, on the left of `h`, with its third corner on the site `apex`, as
  /// create() does with the two sites of `h` and `apex`. Side 0 of the triangle is `h`.
  /// Requires: attach_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
  InsertedTriangle attach(Halfedge h, Site apex) { return insert_checked(fit(h, apex), "attach"); }

  /// Returns the place of a triangle, or the reason why the triangle is refused. insert() then adds the triangle. fit()
  /// and insert() together do what create() or attach() does; a blocker and create() would check the triangle twice.
  Fit fit(Site a, Site b, Site c) const;
  Fit fit(Halfedge h, Site apex) const;
  /// Returns the place of a triangle for a caller that decides which sides are glued. Sites alone do not decide this if
  /// surfaces in space touch along edges or have slits. If `h` is given, side 0 is glued to `h`. Another side is glued
  /// to the first boundary halfedge between its sites for which glues(halfedge, apex) returns true, where `apex` is the
  /// third corner. Without a boundary halfedge of this kind, the side is a new edge. glues() must not change the front
  /// (ContractViolation). The triangle is refused only if it exists already, if two corners are equal, if a corner
  /// neither exists nor is one of the next new sites, or if `h` is not a boundary halfedge.
  /// Cost: the numbers of fans at the corners, and the number of edges at one corner.
  template <typename Glues>
  Fit fit(Site a, Site b, Site c, Glues glues) const {
    return find_glued(at(a, b, c), glues);
  }
  template <typename Glues>
  Fit fit(Halfedge h, Site apex, Glues glues) const {
    return find_glued(at(h, apex), glues);
  }
  /// Inserts the triangle of a fit, as create() does.
  /// Requires: `fit` has no refusal. A caller constructed `fit`, or this front made it and has inserted or detached
  ///           nothing since. The corners are distinct, and exist or are the next new sites. The sides are boundary
  ///           halfedges between the corners. Throws ContractViolation; the mesh is then unchanged.
  InsertedTriangle insert(const Fit& fit);

  /// Returns why detach() would refuse, or nothing if it would not. The reasons: the face does not exist or is deleted,
  /// it is not a triangle, none of its sides is on the boundary, or the mesh lacks status of some kind.
  std::optional<Refusal> detach_blocker(Face f) const;
  /// Detaches a triangle with a side on the boundary. The triangle and its edges without another face are marked
  /// deleted; its other sides become active boundary halfedges. The inverse of attach() and create(), up to handles.
  /// Requires: detach_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
  /// Cost:     the number of fans at the corners, plus the degree of each corner at which a fan becomes two.
  DetachedTriangle detach(Face f);

  /// Removes and returns the next active halfedge: first in, first out, and deferred halfedges last; an invalid handle
  /// if none is active. The halfedge is then neither active nor frozen, until activate() or freeze() is called for it.
  Halfedge pop() {
    guard_.require_changeable();
    Halfedge h = waiting_.next();
    if (!h.is_valid()) h = waiting_.next_deferred();
    if (h.is_valid()) waiting_.release(h);
    return h;
  }
  /// Returns whether `h` is a boundary halfedge of the mesh; false for any other handle.
  bool is_boundary(Halfedge h) const;
  /// Returns whether `h` is active, that is, queued or deferred.
  bool is_active(Halfedge h) const {
    guard_.require_intact();
    return waiting_.is_active(h);
  }
  /// Returns whether `h` is frozen, that is, waits for the next level.
  bool is_frozen(Halfedge h) const {
    guard_.require_intact();
    return waiting_.is_frozen(h);
  }

  /// Queues a boundary halfedge that was popped, frozen or deferred. Does nothing if the halfedge is queued already.
  /// Requires: `h` is a boundary halfedge of the mesh. Throws ContractViolation otherwise.
  void activate(Halfedge h);
  /// Freezes a boundary halfedge, which then has no turn at this level, but can be glued. Does nothing if it is frozen.
  /// Requires: `h` is a boundary halfedge of the mesh. Throws ContractViolation otherwise.
  void freeze(Halfedge h);
  /// Returns the halfedges that were frozen at this level, in the order in which they were frozen; empty after
  /// finish(). Some may have been activated or glued later; a halfedge that was frozen again is listed again.
  const std::vector<Halfedge>& frozen() const { return waiting_.frozen(); }

  /// Returns the boundary curves, each from its least halfedge on, in ascending order. Cost: linear in the edges.
  std::vector<BoundaryCurve> curves() const;
  /// Returns the boundary curves through a site, one for each boundary fan on the site, each beginning where it leaves
  /// the site. A curve through several of the fans is listed as often. Throws ContractViolation unless s < sites().
  /// Cost: the number of fans on the site.
  std::vector<BoundaryCurve> curves_at(Site s) const;

  /// Moves to the next level: frozen halfedges become active again, in the order in which they were frozen. The mesh
  /// and its curves do not change. Inner sites that earlier transfers left behind are not read.
  /// Requires: every halfedge that was popped has been activated, frozen or glued since.
  /// Throws:   ContractViolation otherwise; the front is then unchanged.
  /// Cost:     linear in the sites that the previous transfer carried (the first time, all sites) or that were added
  ///           since, n log n for n such sites if detach() reopened a site; also m log m for m waiting halfedges.
  /// Source:   Restricted BPA, section 6; next_level() is an operation on the mesh alone.
  LevelTransfer next_level();

  /// Completes the mesh and frees the memory of the front. If the front began with an empty or an assembled mesh,
  /// finish() removes the vertices without triangles and renumbers the others, which keep their order and properties.
  /// If the front began with an existing mesh, every handle stays. Detached faces and edges stay marked deleted.
  /// Returns:     the site of each vertex of the mesh.
  /// Invalidates: this front, which then has no sites; vertex handles, unless the front began with an existing mesh.
  std::vector<Site> finish();

 private:
  /// Source of edges and faces for insert_triangle() that are in the mesh already.
  struct Supply {
    Front& front;
    Halfedge edge(Vertex from, Vertex to);
    Face face() { return Face(static_cast<int>(front.faces_++)); }
  };
  void supply(std::size_t edges, std::size_t faces);

  /// Returns a number that grows with every triangle that is inserted or detached.
  std::size_t revision() const { return faces_ + dead_faces_; }

  /// Returns the lookups by sites. Throws ContractViolation if the front is finished or other code changed the mesh.
  detail::Fitting by_sites() const {
    guard_.require_intact();
    return {mesh_, vertices_};
  }
  Halfedge checked(Halfedge h) const {
    guard_.require_intact();
    require(h.idx() >= 0 && static_cast<std::size_t>(h.idx()) < 2 * edges_, "Front: halfedge ", h.idx(),
            " does not exist");
    return h;
  }
  friend class detail::EngineSide;
  /// Returns a fit whose corners are checked, but whose sides are not yet found.
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
  bool keeps_handles_ = false;  // whether the front began with an existing mesh
  std::size_t edges_ = 0;       // edges in use, including deleted edges; the mesh may have unused ones after them
  std::size_t faces_ = 0;
  std::size_t dead_edges_ = 0;
  std::size_t dead_faces_ = 0;
  std::size_t more_sides_ = 0;  // the number of sides of all faces, minus three for each face
  detail::WaitingEdges waiting_;
  detail::Levels levels_;
};

template <typename Glues>
Fit Front::find_glued(Fit fit, Glues glues) const {
  if (fit.refusal) return fit;
  // Several threads may run this function at the same time, if all only read the front.
  by_sites().find_sides(fit, [&](Halfedge h, Site apex) {
    const bool yes = glues(h, apex);
    guard_.require_intact();
    require(revision() == fit.revision_, "fit: glues() changed the front during the call");
    return yes;
  });
  return fit;
}

}  // namespace meshops
