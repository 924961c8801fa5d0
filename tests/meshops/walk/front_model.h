// What: a model of a front by its definition alone: oriented faces on sites. Slow, and hard to get wrong.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "meshops/front/front.h"

namespace meshops::test {

/// Directed side from a site to another.
using Arrow = std::pair<Site, Site>;
/// A cycle of sites, counter-clockwise, the least first.
using SiteCycle = std::vector<Site>;

SiteCycle canonical(SiteCycle cycle);

class FrontModel {
 public:
  enum class State { active, frozen, popped };

  explicit FrontModel(std::size_t sites);
  /// Begins with faces, whose boundary is all active. Some sites may not exist.
  FrontModel(std::size_t sites, const std::set<SiteCycle>& faces, const std::set<Site>& missing);

  std::size_t sites() const { return sites_; }
  bool exists(Site s) const { return s < sites_ && !missing_.contains(s); }
  const std::set<SiteCycle>& faces() const { return faces_; }
  /// Returns the state of each arrow along the boundary, with the mesh on its right.
  const std::map<Arrow, State>& boundary() const { return boundary_; }

  /// Returns whether a face lies on the left of the arrow.
  bool has_side(const Arrow& arrow) const { return sides_.contains(arrow); }
  /// Returns the faces at a site, in sets that are connected around it.
  std::set<std::set<SiteCycle>> fans(Site s) const;
  bool is_free(Site s) const;
  /// Returns whether the site has faces, and they close around it in every fan.
  bool is_closed(Site s) const;

  /// Returns every reason against a triangle; the next new sites may be named.
  std::set<RefusalKind> against(const std::array<Site, 3>& corners) const;
  void add(const std::array<Site, 3>& corners);
  void add_site() { ++sites_; }

  /// Returns every reason against detaching a face.
  std::set<RefusalKind> against_removing(const SiteCycle& face) const;
  void remove(const SiteCycle& face);

  void set(const Arrow& arrow, State state) { boundary_.at(arrow) = state; }
  /// Returns the sites that the next transfer carries.
  std::vector<Site> carried() const;
  void next_level();
  std::size_t level() const { return level_; }
  /// Returns the number of transfers before a face of the model was inserted.
  std::size_t level(const SiteCycle& face) const {
    const auto added = level_of_.find(face);
    return added == level_of_.end() ? 0 : added->second;
  }

 private:
  struct Star {
    std::map<Site, std::pair<Site, const SiteCycle*>>
        after;             // around the site, from neighbor to neighbor across a face
    std::set<Site> first;  // neighbors without a face before them
  };
  Star star(Site s) const;

  std::size_t sites_;
  std::set<Site> missing_;
  std::set<SiteCycle> faces_;
  std::set<Arrow> sides_;
  std::map<Arrow, State> boundary_;
  std::size_t level_ = 0;
  std::map<SiteCycle, std::size_t> level_of_;  // without the faces at the beginning
};

}  // namespace meshops::test
