// What: which vertices of a mesh stand on which site: none, or one for each fan of faces there.
// Law:  a vertex with faces is listed at its site, and at no other; one without is of no fan.
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

/// The first vertices of a mesh can have a site each, of their own number: they need no list. Of the others each is
/// listed at its site.
class MESHOPS_API SiteVertices {
 public:
  /// Vertex i stands on site i. Keeps a reference to the mesh, which has these vertices.
  SiteVertices(Connectivity& mesh, std::size_t sites);
  /// Vertex v stands on site_of[v].
  SiteVertices(Connectivity& mesh, std::span<const Site> site_of);
  /// There is one list of the vertices of a mesh: it can be moved, and then has no sites any more, but not be copied.
  SiteVertices(SiteVertices&& other) noexcept
      : mesh_(other.mesh_),
        first_(std::exchange(other.first_, 0)),
        has_dead_(other.has_dead_),
        further_(std::exchange(other.further_, {})),
        listed_at_first_(std::exchange(other.listed_at_first_, {})),
        listed_(std::exchange(other.listed_, {})),
        spare_(std::exchange(other.spare_, {})) {}
  SiteVertices(const SiteVertices&) = delete;

  /// Sites are 0 to sites() − 1, without those whose vertex was marked deleted before it could have a fan.
  std::size_t sites() const { return first_ + listed_.size(); }
  bool exists(Site s) const { return is_first(s) ? is_live(mesh_, Vertex(static_cast<int>(s))) : s < sites(); }
  /// Returns: the number of a new site, which is what sites() was.
  Site add_site();
  /// There are no sites any more.
  void clear();

  /// Throws ContractViolation when there is no such vertex.
  Site site(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    if (i < first_) return static_cast<Site>(i);
    require(i - first_ < further_.size(), "Front: no such vertex");
    return further_[i - first_].site;
  }

  /// No fan is on this site. Throws ContractViolation when there is none.
  bool is_free(Site s) const {
    if (is_first(s)) return !has_own_fan(s) && first_listed(s) < 0;
    require(s < sites(), "Front: no such site");
    return first_listed(s) < 0;
  }

  /// Calls visit(Vertex) for each fan on the site. Throws ContractViolation when there is no such site.
  template <typename Visit>
  void for_each(Site s, Visit visit) const {
    for (Vertex v = first(s); v.is_valid(); v = next(v)) visit(v);
  }
  /// The same one by one; an invalid handle behind the last. Throws ContractViolation also where others took the faces of
  /// a vertex that is listed.
  Vertex first(Site s) const {
    require(s < sites(), "Front: no such site");
    return is_first(s) && has_own_fan(s) ? Vertex(static_cast<int>(s)) : listed(first_listed(s));
  }
  Vertex next(Vertex v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    return listed(i < first_ ? first_listed(static_cast<Site>(i)) : further_[i - first_].next);
  }

  /// An isolated vertex for another fan on the site, which lists it. It has the properties of the first vertex there,
  /// if that has faces. Throws ContractViolation where others marked it deleted.
  Vertex take(Site s);
  /// Releases a vertex that is isolated again. The last on its site waits for the next triangle there; others serve
  /// any site, and are marked deleted meanwhile where the mesh can.
  void release(Vertex v);

  // For callers that lay many triangles at once, and list their fans at the end.
  /// A further vertex on a site: its handle, for a vertex and a listing that come with list_announced().
  /// Requires: no further vertex was used.
  Vertex announce(Site s) {
    further_.push_back({s, none});
    return vertex(static_cast<int>(further_.size()) - 1);
  }
  /// The number of vertices, with those announced.
  std::size_t vertices() const { return first_ + further_.size(); }
  void list_announced() {
    for (std::size_t i = 0; i < further_.size(); ++i) list(static_cast<int>(i));
  }

 private:
  struct Further {
    Site site;
    int next;  // of the same site, as an index into further_
  };
  static constexpr int none = -1;
  static constexpr int waiting = -2;  // waiting − i: vertex i of further_ waits for a fan

  bool is_first(Site s) const { return s < first_; }
  /// Returns whether the vertex of a first site has faces. One that is deleted may name a halfedge that is, too.
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
  bool has_dead_ = false;             // some first vertices were deleted when the list was made
  std::vector<Further> further_;      // of vertex first_ + i
  std::vector<int> listed_at_first_;  // of each first site, where its list begins; empty while all are empty
  std::vector<int> listed_;           // the same of site first_ + i; or what waits there
  std::vector<Vertex> spare_;         // isolated, and of no site
};

}  // namespace meshops
