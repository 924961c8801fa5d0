// What:   the front: boundary curves that are still to be advanced, on a mesh whose vertices stand on sites.
// Law:    the mesh is sound at every step; every boundary halfedge is active or frozen; between any two sites there is
//         at most one edge as long as the policy proposes triangles of a complex.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/front/outline.h"
#include "meshops/front/patch.h"
#include "meshops/front/placement.h"
#include "meshops/front/seams.h"
#include "meshops/handle/insert_triangle.h"

namespace meshops {

/// What goes on from one level to the next.
struct LevelTransfer {
  std::vector<Site> carried;    ///< sites that are free or on the boundary, in ascending order
  std::size_t left_behind = 0;  ///< sites that have turned inner since the transfer before
  std::size_t reactivated = 0;  ///< frozen halfedges that are active again
};

class MESHOPS_API Front {
 public:
  /// Begins with an empty mesh: adds `sites` isolated vertices, vertex i on site i.
  /// Elements of the mesh are made `supply` at a time, which is faster than singly; until finish() the mesh then has up
  /// to that many edges and faces at its end that are not in use. With 1 it never has any.
  /// Requires: the mesh has no vertices. Throws ContractViolation.
  explicit Front(Connectivity& mesh, std::size_t sites, std::size_t supply = 1);

  const Connectivity& mesh() const { return mesh_; }
  /// The number of edges and faces in use.
  std::size_t edges() const { return edges_; }
  std::size_t faces() const { return faces_; }
  /// Sites are 0 to sites() − 1.
  std::size_t sites() const { return first_sites_ + added_.size(); }

  /// One more site: for methods that place points while they run.
  /// Returns: its number, which is what sites() was.
  Site add_site();

  Site site(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    return i < first_sites_ ? v.idx() : extra_[i - first_sites_].site;
  }
  Site from_site(Halfedge h) const { return site(mesh_.from_vertex_handle(h)); }
  Site to_site(Halfedge h) const { return site(mesh_.to_vertex_handle(h)); }

  /// No triangle has a corner on this site.
  bool is_free(Site s) const { return is_first(s) ? mesh_.is_isolated(Vertex(s)) : added_[index_of_added(s)] < 0; }
  /// A fan on this site is on the boundary.
  bool is_on_boundary(Site s) const {
    bool found = false;
    for_each_fan(s, [&](Vertex v) { found = found || mesh_.is_boundary(v); });
    return found;
  }

  /// Calls visit(Vertex) for each fan on the site: none when it is free.
  template <typename Visit>
  void for_each_fan(Site s, Visit visit) const {
    if (is_free(s)) return;
    if (is_first(s)) {
      visit(Vertex(s));
      if (extra_.empty()) return;
    }
    for (int i = chain(s); i >= 0; i = extra_[static_cast<std::size_t>(i)].next)
      visit(Vertex(static_cast<int>(first_sites_) + i));
  }

  /// The boundary halfedge that comes from a site into `to`, or leaves `from` for a site; an invalid handle when there
  /// is none. Both find the same halfedge. Cost: the number of fans at `to`, at `from`.
  Halfedge boundary_into(Site from, Site to) const {
    Halfedge found;
    for_each_fan(to, [&](Vertex v) {
      const Halfedge out = mesh_.halfedge_handle(v);
      if (!mesh_.is_boundary(out)) return;
      if (const Halfedge in = mesh_.prev_halfedge_handle(out); from_site(in) == from) found = in;
    });
    return found;
  }
  Halfedge boundary_out_of(Site from, Site to) const {
    Halfedge found;
    for_each_fan(from, [&](Vertex v) {
      const Halfedge out = mesh_.halfedge_handle(v);
      if (mesh_.is_boundary(out) && to_site(out) == to) found = out;
    });
    return found;
  }

  /// Adds a triangle that touches the mesh at most in vertices and along boundary edges between the same sites, to
  /// which it is glued. Its new boundary halfedges become active.
  /// Requires: three distinct sites.
  InsertedTriangle create(Site a, Site b, Site c);

  /// create() for who knows where the triangle goes. Its new boundary halfedges are neither active nor frozen: those to
  /// which nothing is glued before the next pop() must be made one of them.
  /// Requires: the given sides are boundary halfedges, and all that there are between these sites. `sides.corner` is not
  ///           looked at.
  InsertedTriangle insert(TriangleSides sides, Site a, Site b, Site c);

  /// Where create() and attach() would put a triangle: which of its sides are boundary halfedges already.
  TriangleSides sides_of(Site a, Site b, Site c) const;
  TriangleSides sides_of(Halfedge h, Site apex) const;

  /// Attaches a triangle to an active halfedge a→b, with its apex on a site, and glues its other sides to the boundary
  /// halfedges b→apex and apex→a where they exist, on whatever curve. New boundary halfedges become active.
  /// Requires: `h` is a boundary halfedge; the apex is neither of its ends.
  InsertedTriangle attach(Halfedge h, Site apex);

  /// Lays many triangles at once, whose edges among each other are known: gluing in bulk. Patches are laid beside each
  /// other, in any order; an open side is glued to the side of another patch on the same sites. join() must
  /// follow before anything else is done.
  /// Requires: no triangle but those of patches, none joined yet, and no added site. The triangles of all patches are
  ///           those of a complex; a site around which they close has no other fan, as it is in the plane.
  /// Cost:     linear in the patch.
  void lay(const Patch& patch);
  /// The same where the outline is known.
  void lay(const Patch& patch, const Outline& outline);

  /// lay() in three steps, so that threads can share the work: survey(), where the outline is not known; place(), one
  /// patch after another, in the order that is to give elements their numbers; and fill(), which may run beside other
  /// fills, surveys and place(), provided that reserve() made room for all patches.
  /// Requires: what lay() does, and the outline of the patch; to fill, that it was placed, with the same arguments.
  /// Cost:     place() is linear in the sides at the rim of the patch and its holes, fill() in the patch.
  void reserve(std::size_t edges, std::size_t faces);
  void place(const Patch& patch, const Outline& outline, Placement& placement);
  void fill(const Patch& patch, const Outline& outline, Placement& placement);

  /// Ends the laying of patches: every fan gets a vertex of its own, and sides to which nothing was glued become
  /// boundary halfedges, active those that were open and frozen the others. The mesh is sound again.
  /// Cost:     linear in the open sides of all patches, the fans at them, and all other fans but one at each site.
  void join();

  /// The next active halfedge, which is then no longer active until it is frozen or attached to; none when the front
  /// has run dry.
  Halfedge pop() {
    while (head_ < active_.size()) {
      const Halfedge h = active_[head_++];
      if (mesh_.is_boundary(h)) return h;
    }
    active_.clear();
    head_ = 0;
    return Halfedge();
  }

  /// Makes a boundary halfedge active that is neither active nor frozen.
  void activate(Halfedge h);

  /// Sets a halfedge aside: nothing can be attached to it at this level.
  void freeze(Halfedge h) { frozen_.push_back(h); }
  /// What was set aside at this level, in that order; some of it may have been attached to since and be inner now.
  const std::vector<Halfedge>& frozen() const { return frozen_; }

  /// The boundary curves, each from its least halfedge. Cost: linear in the edges in use.
  std::vector<BoundaryCurve> curves() const;
  /// The boundary curves through a site, one for each fan on it that is on the boundary, each from where it leaves the
  /// site. A curve that passes the site several times comes as often. Cost: the number of fans.
  std::vector<BoundaryCurve> curves_at(Site s) const;

  /// Goes on to the next level: frozen halfedges that are still on the boundary become active again. The mesh and its
  /// curves stay as they are, and nothing of what was left behind before is read.
  /// Cost:   linear in the sites that the transfer before carried (all, the first time), and m log m in the m frozen
  ///         halfedges.
  /// Source: Restricted BPA, section 6; it is an operation on the mesh alone.
  LevelTransfer next_level();

  /// Frees memory that is of no more use and makes the mesh whole: removes vertices without triangles and renumbers
  /// the others, keeping their order.
  /// Returns: the site of each vertex that is left.
  /// Invalidates: vertex handles and this front, on which only mesh() may be called afterwards.
  std::vector<Site> finish();

 private:
  struct Extra {
    Site site;
    int next;  // the next extra vertex on the site, or -1
  };

  /// Elements for insert_triangle().
  struct Supply {
    Front& front;
    Halfedge edge(Vertex from, Vertex to) {
      if (front.edges_ == front.mesh_.n_edges()) front.supply(front.supply_, 0);
      const Halfedge h(static_cast<int>(2 * front.edges_++));
      front.mesh_.set_vertex_handle(h, to);
      front.mesh_.set_vertex_handle(front.mesh_.opposite_halfedge_handle(h), from);
      return h;
    }
    Face face() {
      if (front.faces_ == front.mesh_.n_faces()) front.supply(0, front.supply_);
      return Face(static_cast<int>(front.faces_++));
    }
  };
  void supply(std::size_t edges, std::size_t faces);

  /// A side of a patch at whose other side nothing lies yet.
  struct Rim {
    Halfedge boundary;
    Site to;  // where it ends
  };
  /// Of sides of patches beyond which there is nothing.
  struct Holes {
    std::vector<std::array<int, 2>> edges;  // the first, and one behind the last
    std::vector<bool> has_vertex;           // of each site: a fan between holes has it for its vertex
    std::vector<Halfedge> into;             // of each extra vertex, a boundary halfedge that ends there
    std::vector<Halfedge> loose;            // boundary halfedges that end where another patch has a say in what follows
  };
  void place_holes(const Patch& patch, const Outline& outline, Placement& placement);
  void fill_holes(const Patch& patch, const Outline& outline, Placement& placement);
  Halfedge next_on_boundary(Halfedge boundary) const;
  void close_fan(Halfedge boundary);
  Vertex extra_vertex(Site s, Halfedge into);

  bool is_first(Site s) const { return static_cast<std::size_t>(s) < first_sites_; }
  std::size_t index_of_added(Site s) const { return static_cast<std::size_t>(s) - first_sites_; }
  /// The first extra vertex on a site, as an index into extra_; −1 when there is none.
  int chain(Site s) const {
    if (!is_first(s)) return added_[index_of_added(s)];
    return first_extra_.empty() ? -1 : first_extra_[static_cast<std::size_t>(s)];
  }
  int& first_on(Site s) { return is_first(s) ? first_extra_[static_cast<std::size_t>(s)] : added_[index_of_added(s)]; }
  void chain(Site s, int index);
  Vertex vertex_for_fan(Site s);
  void release(Vertex v);
  void renumber(std::size_t first, const std::vector<int>& number);
  InsertedTriangle insert_and_activate(const TriangleSides& sides, Site a, Site b, Site c);

  Connectivity& mesh_;
  std::size_t first_sites_;  // those the front began with: each has the vertex of its number
  std::size_t supply_;
  std::size_t edges_ = 0;
  std::size_t faces_ = 0;
  std::vector<Extra> extra_;      // of vertex first_sites_ + i: a further fan, or one on an added site
  std::vector<int> first_extra_;  // of each first site, an index into extra_, or −1; empty while there is no pinch
  std::vector<int> added_;        // of added site i: its first fan as an index into extra_, or −1
  std::vector<Vertex> unused_;    // extra vertices merged away, to be used again
  std::vector<Halfedge> active_;  // a queue from head_ on; halfedges that turned inner are passed over
  std::size_t head_ = 0;
  std::vector<Halfedge> frozen_;
  Seams<Rim> rims_;  // each at the site that its boundary halfedge leaves
  Holes holes_;
  Outline outline_;  // of the patch being laid
  Placement placement_;
  std::vector<Site> carried_;       // by the last transfer
  std::size_t carried_before_ = 0;  // the number of sites then; later ones have been added since
};

}  // namespace meshops
