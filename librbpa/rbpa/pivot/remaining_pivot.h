// What: the pivot where most triangles are there already: only points with a triangle still to come are candidates.
// Law:  the apex that Pivot without a radius finds, where that is one of the points that remain: leaving out others
//       leaves the winner in.
// Why:  beside a crowd, a search among all points goes through the crowd, of which but the rim matters. This is what
//       makes levels cheap: the paper leaves the interior behind, for the search as well.
// Cost: a grid of the points that remain; pivots as fast as on uniform points again.
// Source: Restricted BPA, section 6.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/pivot/pivot.h"

namespace rbpa {

template <typename Real>
class RemainingPivot {
 public:
  using Site = std::uint32_t;

  /// Keeps a reference. `done` tells of each site whether it can be left out; empty, none can.
  /// `grid_unit` as for Candidates. Requires: the points are not on a line, and the corners of their hull are not done.
  RemainingPivot(const PointGrid<Real>& grid, const std::vector<bool>& done, Real grid_unit)
      : points_(remaining(grid, done)), grid_(points_), pivot_(points_.empty() ? grid : grid_, Radius(), grid_unit) {
    if (points_.empty()) return;
    number_.assign(grid.points().size(), none);
    site_.resize(grid_.points().size());
    std::vector<Site> of_point;
    for (Site s = 0; s < done.size(); ++s)
      if (!done[s]) of_point.push_back(s);
    for (Site i = 0; i < site_.size(); ++i) {
      site_[i] = of_point[grid_.input_index()[i]];
      number_[site_[i]] = i;
    }
    points_ = {};
  }
  RemainingPivot(const RemainingPivot&) = delete;
  RemainingPivot& operator=(const RemainingPivot&) = delete;

  /// The apex left of the Delaunay edge a→b; nothing on the hull. Requires: neither the ends nor the apex are done.
  std::optional<Site> operator()(Site a, Site b, std::initializer_list<Site> hints = {}) const {
    if (number_.empty()) return pivot_(a, b, hints);
    Site known[2] = {number_[a], number_[b]};  // of no use as hints, and no harm
    std::size_t i = 0;
    for (const Site h : hints)
      if (i < 2 && number_[h] != none) known[i++] = number_[h];
    const auto apex = pivot_(number_[a], number_[b], {known[0], known[1]});
    return apex ? std::optional(site_[*apex]) : std::nullopt;
  }

 private:
  static constexpr Site none = std::numeric_limits<Site>::max();

  static std::vector<Point> remaining(const PointGrid<Real>& grid, const std::vector<bool>& done) {
    std::vector<Point> points;
    for (std::size_t s = 0; s < done.size(); ++s)
      if (!done[s]) points.push_back(grid.points()[s]);
    return points;
  }

  std::vector<Point> points_;  // those that remain; empty when all do, and after construction
  PointGrid<Real> grid_;
  Pivot<Real> pivot_;
  std::vector<Site> number_;  // of each site, in grid_
  std::vector<Site> site_;    // of each point of grid_
};

}  // namespace rbpa
