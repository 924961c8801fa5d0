// What: maps each site to the vertices of a mesh on it: one for each fan of faces there, or none.
// Law:  for_each(s) visits each vertex that stands on s and has faces, once, and no vertex without faces.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/patch/site.h"

namespace meshops {

/// Map between sites and vertices. Each *first* vertex of a mesh stands on the site of the same number and needs no
/// list; every *further* vertex is listed at its site while it has faces.
class MESHOPS_API SiteVertices {
 public:
  /// Maps vertex i to site i, for i < `sites`: the first vertices. Keeps a reference to the mesh.
  /// Requires: the mesh has these vertices at the first lookup; not checked. Cost: linear in the mesh.
  SiteVertices(Connectivity& mesh, std::size_t sites);
  /// Maps vertex v to site_of[v]; all vertices are further ones. The sites are 0 to the greatest of a live vertex.
  /// Throws: ContractViolation unless `site_of` has a site for each vertex, less than 2³¹ − 1 if the vertex is live.
  SiteVertices(Connectivity& mesh, std::span<const Site> site_of);
  /// Moves the map; `other` has no sites afterwards. A map cannot be copied: a mesh has one.
  SiteVertices(SiteVertices&& other) noexcept
      : mesh_(other.mesh_),
        first_(std::exchange(other.first_, 0)),
        has_dead_(other.has_dead_),
        further_(std::exchange(other.further_, {})),
        listed_at_first_(std::exchange(other.listed_at_first_, {})),
        listed_(std::exchange(other.listed_, {})),
        spare_(std::exchange(other.spare_, {})) {}
  SiteVertices(const SiteVertices&) = delete;

  /// Returns n, where the sites are 0 to n − 1, except the numbers of first vertices that are marked deleted.
  std::size_t sites() const { return first_ + listed_.size(); }
  /// Returns whether `s` is a site.
  bool exists(Site s) const { return is_first(s) ? is_live(mesh_, Vertex(static_cast<int>(s))) : s < sites(); }
  /// Adds a site. Returns: its number, the old value of sites(). Throws ContractViolation beyond 2³¹ − 1 sites.
  Site add_site();
  /// Removes all sites and frees the memory.
  void clear();

  /// Returns the site of a vertex. Throws ContractViolation when the vertex does not exist.
  Site site(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    if (i < first_) return static_cast<Site>(i);
    require(i - first_ < further_.size(), "Front: vertex ", v.idx(), " does not exist");
    return further_[i - first_].site;
  }

  /// Returns whether no fan is on this site; true for the number of a deleted first vertex. Throws ContractViolation
  /// unless s < sites(); so do for_each() and first(), which find no vertex on the number of a deleted one.
  bool is_free(Site s) const {
    if (is_first(s)) return !has_own_fan(s) && first_listed(s) < 0;
    require(s < sites(), "Front: site ", s, " does not exist");
    return first_listed(s) < 0;
  }

  /// Calls visit(Vertex) for each fan on the site, in the order of first() and next().
  template <typename Visit>
  void for_each(Site s, Visit visit) const {
    for (Vertex v = first(s); v.is_valid(); v = next(v)) visit(v);
  }
  /// Returns a vertex with faces on the site, or an invalid handle when the site is free. Throws ContractViolation also
  /// when a listed vertex has lost its faces to a change by other code; so does next().
  Vertex first(Site s) const {
    require(s < sites(), "Front: site ", s, " does not exist");
    return is_first(s) && has_own_fan(s) ? Vertex(static_cast<int>(s)) : listed(first_listed(s));
  }
  /// Returns the vertex with faces after `v` on the same site, or an invalid handle when `v` is the last.
  /// Requires: first() or next() returned `v`. Not checked.
  Vertex next(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    return listed(i < first_ ? first_listed(static_cast<Site>(i)) : further_[i - first_].next);
  }

  /// Returns an isolated vertex for another fan on the site, and lists it there. A vertex that waits at the site keeps
  /// its properties; any other, new or released elsewhere, gets those of first(s), if that is valid.
  /// Requires: the site exists, and no other code has added vertices to the mesh; not checked.
  /// Throws:   ContractViolation if other code marked the returned vertex deleted, or took the faces of first(s).
  Vertex take(Site s);
  /// Releases a vertex that is isolated again. A first vertex waits at its site for the next fan; so does the last
  /// vertex of a site without a first vertex. Others can serve any site, and are marked deleted meanwhile if the mesh
  /// has status. Throws ContractViolation if other code changed the mesh so that the vertex is not listed at its site.
  /// Cost: the number of fans on the site.
  void release(Vertex v);

  // announce(), vertices() and list_announced() are for callers that lay many triangles and list their fans at the end.
  /// Returns the handle of a new further vertex on a site. The caller makes the vertex, before list_announced().
  /// Requires: take() has made no further vertex yet, and is not called before list_announced(). Not checked.
  Vertex announce(Site s) {
    further_.push_back({s, none});
    return vertex(static_cast<int>(further_.size()) - 1);
  }
  /// Returns the number of vertices, including the announced ones.
  std::size_t vertices() const { return first_ + further_.size(); }
  /// Lists every announced vertex at its site. To be called once.
  void list_announced() {
    for (std::size_t i = 0; i < further_.size(); ++i) list(static_cast<int>(i));
  }

 private:
  struct Further {
    Site site;
    int next;  // next vertex of the same site, as an index into further_
  };
  static constexpr int none = -1;
  static constexpr int waiting = -2;  // waiting − i: vertex i of further_ waits for a fan

  bool is_first(Site s) const { return s < first_; }
  /// Returns whether the vertex of a first site has faces. (A deleted vertex may refer to a deleted halfedge.)
  bool has_own_fan(Site s) const {
    const Vertex own(static_cast<int>(s));
    return !mesh_.is_isolated(own) && (!has_dead_ || is_live(mesh_, own));
  }
  Vertex listed(int index) const {
    if (index < 0) return Vertex();
    require(!mesh_.is_isolated(vertex(index)), "Front: the mesh was changed by others: a vertex has lost its faces");
    return vertex(index);
  }
  Vertex vertex(int index) const { return Vertex(static_cast<int>(first_) + index); }
  int index_of(Vertex v) const { return v.idx() - static_cast<int>(first_); }
  int first_listed(Site s) const {
    if (!is_first(s)) return listed_[s - first_];
    return listed_at_first_.empty() ? none : listed_at_first_[s];
  }
  int& link(Site s);
  void list(int index);

  Connectivity& mesh_;
  std::size_t first_;
  bool has_dead_ = false;             // whether some first vertices were deleted when the map was made
  std::vector<Further> further_;      // entry i is for vertex first_ + i
  std::vector<int> listed_at_first_;  // for each first site, the start of its list; empty while all lists are empty
  std::vector<int> listed_;           // start of the list of site first_ + i, or the vertex that waits there
  std::vector<Vertex> spare_;         // isolated vertices of no site
};

}  // namespace meshops
