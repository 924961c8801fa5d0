// What: a front from its definition alone: oriented faces on sites, and nothing else. Slow, and hard to get wrong.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "meshops/front/front.h"

namespace meshops::test {

/// From a site to another.
using Arrow = std::pair<Site, Site>;
/// Sites, counter-clockwise, the least first.
using Cycle = std::vector<Site>;

Cycle canonical(Cycle cycle);

class FrontModel {
 public:
  enum class State { active, frozen, popped };

  explicit FrontModel(std::size_t sites);
  /// Begins with faces, at whose boundary all is active. Some sites may not be there.
  FrontModel(std::size_t sites, const std::set<Cycle>& faces, const std::set<Site>& missing);

  std::size_t sites() const { return sites_; }
  bool exists(Site s) const { return s < sites_ && !missing_.contains(s); }
  const std::set<Cycle>& faces() const { return faces_; }
  /// Of each arrow along the boundary, the mesh on its right.
  const std::map<Arrow, State>& boundary() const { return boundary_; }

  /// A face has this side: it lies on the left of the arrow.
  bool has_side(const Arrow& arrow) const { return sides_.contains(arrow); }
  /// The faces at a site, in sets of those that hang together around it.
  std::set<std::set<Cycle>> fans(Site s) const;
  bool is_free(Site s) const;
  /// It has faces, and they close around it in every fan.
  bool is_closed(Site s) const;

  /// Every reason against a triangle; the next new sites may be named.
  std::set<RefusalKind> against(const std::array<Site, 3>& corners) const;
  void add(const std::array<Site, 3>& corners);
  void add_site() { ++sites_; }

  /// Every reason against detaching a face.
  std::set<RefusalKind> against_removing(const Cycle& face) const;
  void remove(const Cycle& face);

  void set(const Arrow& arrow, State state) { boundary_.at(arrow) = state; }
  /// What the next transfer carries.
  std::vector<Site> carried() const;
  void next_level();
  std::size_t level() const { return level_; }
  /// How many transfers there were before a face of the model came.
  std::size_t level(const Cycle& face) const {
    const auto added = level_of_.find(face);
    return added == level_of_.end() ? 0 : added->second;
  }

 private:
  struct Star {
    std::map<Site, std::pair<Site, const Cycle*>> after;  // around the site, from neighbor to neighbor across a face
    std::set<Site> first;                                 // neighbors before which there is no face
  };
  Star star(Site s) const;

  std::size_t sites_;
  std::set<Site> missing_;
  std::set<Cycle> faces_;
  std::set<Arrow> sides_;
  std::map<Arrow, State> boundary_;
  std::size_t level_ = 0;
  std::map<Cycle, std::size_t> level_of_;  // without those that were there at the beginning
};

}  // namespace meshops::test
