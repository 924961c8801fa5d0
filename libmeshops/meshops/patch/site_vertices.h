// What: maps each site to the vertices of a mesh that stand on the site: one for each fan of faces on it, or none.
// Law:  for_each(s) visits each vertex that stands on s and has faces once, and no vertex without faces.
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
/// list. Every other vertex is a *further* vertex, and is listed at its site while it has faces.
class MESHOPS_API SiteVertices {
 public:
  /// Maps vertex i to site i, for i < `sites`; these are the first vertices. Keeps a reference to the mesh.
  /// Requires: the mesh has these vertices when a vertex is first looked up; not checked. Cost: linear in the mesh.
  SiteVertices(Connectivity& mesh, std::size_t sites);
  /// Maps vertex v to site_of[v]; all vertices are further vertices. The sites are 0 to the greatest of a live vertex.
  /// Throws: ContractViolation unless `site_of` has a site for each vertex, below 2³¹ − 1 if the vertex is live.
  SiteVertices(Connectivity& mesh, std::span<const Site> site_of);
  /// Moves the map; afterwards, `other` has no sites. A map cannot be copied, because a mesh has only one.
  SiteVertices(SiteVertices&& other) noexcept
      : mesh_(other.mesh_),
        first_(std::exchange(other.first_, 0)),
        has_dead_(other.has_dead_),
        further_(std::exchange(other.further_, {})),
        listed_at_first_(std::exchange(other.listed_at_first_, {})),
        listed_(std::exchange(other.listed_, {})),
        spare_(std::exchange(other.spare_, {})) {}
  SiteVertices(const SiteVertices&) = delete;

  /// Returns n such that the sites are 0 to n − 1, except the numbers of first vertices that are marked deleted.
  std::size_t sites() const { return first_ + listed_.size(); }
  /// Returns whether `s` is a site.
  bool exists(Site s) const { return is_first(s) ? is_live(mesh_, Vertex(static_cast<int>(s))) : s < sites(); }
  /// Adds a site. Returns: its number, the old value of sites(). Throws ContractViolation if there are 2³¹ − 1 sites.
  Site add_site();
  /// Removes all sites and frees the memory.
  void clear();

  /// Returns the site of a vertex. Throws ContractViolation if the vertex does not exist.
  Site site(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    if (i < first_) return static_cast<Site>(i);
    require(i - first_ < further_.size(), "Front: vertex ", v.idx(), " does not exist");
    return further_[i - first_].site;
  }

  /// Returns whether no fan is on this site; true for the number of a deleted first vertex, on which for_each() and
  /// first() find no vertex. All three throw ContractViolation unless s < sites().
  bool is_free(Site s) const {
    if (is_first(s)) return !has_own_fan(s) && first_listed(s) < 0;
    require(s < sites(), "Front: site ", s, " does not exist");
    return first_listed(s) < 0;
  }

  /// Calls visit(Vertex) for the vertex of each fan on the site, in the order of first() and next().
  template <typename Visit>
  void for_each(Site s, Visit visit) const {
    for (Vertex v = first(s); v.is_valid(); v = next(v)) visit(v);
  }
  /// Returns a vertex with faces on the site, or an invalid handle if the site is free. first() and next() also throw
  /// ContractViolation if other code has changed the mesh so that a listed vertex has lost its faces.
  Vertex first(Site s) const {
    require(s < sites(), "Front: site ", s, " does not exist");
    return is_first(s) && has_own_fan(s) ? Vertex(static_cast<int>(s)) : listed(first_listed(s));
  }
  /// Returns the next vertex with faces after `v` on the same site, or an invalid handle if `v` is the last.
  /// Requires: first() or next() returned `v`. Not checked.
  Vertex next(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    return listed(i < first_ ? first_listed(static_cast<Site>(i)) : further_[i - first_].next);
  }

  /// Returns an isolated vertex for another fan on the site, and lists the vertex at the site. A vertex that waits at
  /// the site keeps its properties; any other vertex, new or reused, gets the properties of first(s), if that is valid.
  /// Requires: the site exists, and no other code has added vertices to the mesh; not checked.
  /// Throws:   ContractViolation if other code marked the returned vertex deleted, or took the faces of first(s).
  Vertex take(Site s);
  /// Releases a vertex that has become isolated. A first vertex, or the last further vertex of a site without a first
  /// vertex, waits at its site for the next fan. Another vertex can serve any site, and is marked deleted meanwhile if
  /// the mesh has vertex status. Throws ContractViolation if other code changed the mesh so that the vertex is not
  /// listed at its site.
  /// Cost: the number of fans on the site.
  void release(Vertex v);

  // announce(), vertices() and list_announced() are for callers that lay many triangles and list their fans at the end.
  /// Returns the handle of a new further vertex on a site. The caller makes the vertex, before list_announced().
  /// Requires: take() has not yet made a further vertex, and is not called before list_announced(). Not checked.
  Vertex announce(Site s) {
    further_.push_back({s, none});
    return vertex(static_cast<int>(further_.size()) - 1);
  }
  /// Returns the number of vertices, including announced vertices.
  std::size_t vertices() const { return first_ + further_.size(); }
  /// Lists every announced vertex at its site. Must be called only once.
  void list_announced() {
    for (std::size_t i = 0; i < further_.size(); ++i) list(static_cast<int>(i));
  }

 private:
  struct Further {
    Site site;
    int next;  // next vertex listed at the same site, as an index into further_
  };
  static constexpr int none = -1;
  static constexpr int waiting = -2;  // an entry waiting − i says that vertex i of further_ waits for a fan

  bool is_first(Site s) const { return s < first_; }
  /// Returns whether the first vertex on the site has faces. (A deleted vertex may refer to a deleted halfedge.)
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
  bool has_dead_ = false;             // whether some first vertices were marked deleted when the map was made
  std::vector<Further> further_;      // entry i belongs to vertex first_ + i
  std::vector<int> listed_at_first_;  // for each first site, the start of its list; empty until a first site has a list
  std::vector<int> listed_;           // for site first_ + i, the start of its list, or the vertex that waits there
  std::vector<Vertex> spare_;         // isolated vertices that stand on no site
};

}  // namespace meshops
