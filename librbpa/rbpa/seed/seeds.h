// What:   ideal seeds: triangles from which the front has not come by itself.
// Law:    when next() returns nothing, no triangle of the solid alpha complex is missing from the mesh, provided the
//         front ran dry between calls. Once a site has been passed, every triangle of the complex at it is in the mesh.
// Cost:   a look at each site; a search or two at each that is isolated or on the boundary.
// Source: Restricted BPA, section 4 and Theorem 1; docs/seeding.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/pivot/pivot.h"
#include "rbpa/seed/nearest.h"
#include "rbpa/seed/roll.h"

namespace rbpa {

template <typename Real>
class Seeds {
 public:
  using Site = meshops::Site;

  /// Keeps references. `known`, where it is not empty, tells of each site whether all its triangles were found already.
  Seeds(const PointGrid<Real>& grid, const Radius& radius, const Pivot<Real>& pivot, std::vector<bool> known = {})
      : grid_(grid), radius_(radius), pivot_(pivot), known_(std::move(known)) {}

  /// A triangle of the complex that is not in the mesh, counter-clockwise. Calls searched() after each search.
  template <typename Searched>
  std::optional<std::array<meshops::Site, 3>> next(const meshops::Front& front, Searched searched) {
    for (;;) {
      while (!pending_.empty()) {
        const auto seed = pending_.back();
        pending_.pop_back();
        // Another seed's front may have come here since.
        if (!front.boundary_into(seed[1], seed[0]).is_valid()) return seed;
      }
      // Without a radius the complex is connected through edges: one seed, or none, is all there is.
      if (radius_.is_infinite() && front.faces() > 0) return std::nullopt;
      while (site_ < known_.size() && known_[site_]) ++site_;
      if (site_ == front.sites()) return std::nullopt;
      const auto s = static_cast<Site>(site_);
      if (front.is_free(s)) {
        // A site that gets its first triangle is looked at again, then as a boundary site.
        if (!look_around_isolated(s)) ++site_;
        searched();
      } else {
        ++site_;
        if (!radius_.is_infinite() && look_around_boundary(front, s)) searched();
      }
      if (radius_.is_infinite()) site_ = front.sites();
    }
  }

 private:
  /// The nearest point is a Delaunay neighbour: there is a triangle at one side of the edge, or the ball rolls on.
  /// Returns whether a triangle was found.
  bool look_around_isolated(Site v) {
    const auto u = nearest(grid_, radius_, v);
    if (!u) return false;
    if (add_beyond(v, *u) || add_beyond(*u, v)) return true;
    if (!radius_.is_infinite()) roll(v, *u, *u);
    return !pending_.empty();
  }

  /// Each fan at a boundary point ends with a frozen edge, from which the ball rolls to the next fan.
  /// Returns whether there is a fan with boundary, and so something was searched.
  bool look_around_boundary(const meshops::Front& front, Site v) {
    ends_.clear();
    front.for_each_fan(v, [&](meshops::Vertex fan) {
      const auto out = front.mesh().halfedge_handle(fan);
      if (!front.mesh().is_boundary(out)) return;
      ends_.push_back({front.from_site(front.mesh().prev_halfedge_handle(out)), front.to_site(out)});
    });
    for (const Fan& fan : ends_) {
      const Roll<Real> order(grid_, radius_.value(), v, fan.last, fan.last);
      Site until = fan.first;
      for (const Fan& other : ends_)
        if (order.met_before(other.first, until)) until = other.first;
      roll(v, fan.last, until);
    }
    return !ends_.empty();
  }

  void roll(Site v, Site from, Site until) {
    for (const Site q : Roll<Real>(grid_, radius_.value(), v, from, until).contacts()) add_beyond(v, q);
  }

  /// Adds the triangle left of v→q, if there is one.
  bool add_beyond(Site v, Site q) {
    const auto apex = pivot_(v, q);
    if (apex) pending_.push_back({v, q, *apex});
    return apex.has_value();
  }

  /// The other ends of the two boundary edges of a fan, the fan lying counter-clockwise from the first to the last.
  struct Fan {
    Site first, last;
  };

  const PointGrid<Real>& grid_;
  const Radius& radius_;
  const Pivot<Real>& pivot_;
  std::vector<bool> known_;
  std::size_t site_ = 0;
  std::vector<std::array<meshops::Site, 3>> pending_;
  std::vector<Fan> ends_;
};

}  // namespace rbpa
