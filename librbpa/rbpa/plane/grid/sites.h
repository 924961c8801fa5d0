// What: the distinct points of the input, numbered: sites. Sites in the window of doubles come first, in the order of a
//       grid's cells and scaled to fit; then sites beyond the window.
// Law:  at(s) is the input point input_index()[s], of equal points the one with the lowest index.
// Cost: that of PointGrid; and a sort of the points beyond the window.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/grid/hidden_points.h"
#include "rbpa/plane/grid/point_grid.h"
#include "rbpa/plane/predicate/window.h"

namespace rbpa {

class Sites {
 public:
  /// Sorts the points into sites. Calls `checkpoint`, if any, repeatedly; `checkpoint` may throw.
  Sites(std::span<const Point> input, Threads& threads, const Checkpoint& checkpoint = {});

  std::size_t size() const { return grid_.points().size() + beyond_.size(); }
  /// Returns the points in the window, multiplied by 2^window().exponent.
  const PointGrid& grid() const { return grid_; }
  const Window& window() const { return window_; }
  /// Returns the points beyond the window, unscaled; the first of them is the site after the grid's sites.
  std::span<const Point> beyond() const { return beyond_; }
  /// Returns the points beyond the window in the window's scale, with coordinates limited to ±2^200.
  const HiddenPoints& hidden() const { return hidden_; }

  /// Returns the point of site `s` in the user's coordinates.
  Point at(std::size_t s) const {
    if (s >= grid_.points().size()) return beyond_[s - grid_.points().size()];
    const Point& p = grid_.points()[s];
    return {p.x * unscale_, p.y * unscale_};
  }
  /// Returns all points in the user's coordinates.
  std::vector<Point> points() const;
  std::span<const std::uint32_t> input_index() const { return beyond_.empty() ? grid_.input_index() : index_; }
  std::vector<Duplicate> duplicates() const;
  /// Returns an upper bound of the distance of any two points.
  long double diameter_bound() const;
  /// Returns the radius alpha, or the infinite one if alpha is certainly above every circumradius.
  Radius reachable(double alpha) const {
    const Radius radius = Radius::of(alpha);
    return beyond_.empty() && window_.scaled(radius).is_infinite() ? Radius() : radius;
  }

 private:
  void find_beyond(std::span<const Point> input);

  Window window_;
  double unscale_;
  PointGrid grid_;
  std::vector<Point> beyond_;
  std::vector<Duplicate> repeated_beyond_;
  std::vector<std::uint32_t> index_;  // the input index of each site; empty if no site is beyond the window
  HiddenPoints hidden_;
};

}  // namespace rbpa
