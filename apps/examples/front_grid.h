// What: a grid over the sides of a front in the plane, which tests whether a new side crosses the front; for copying.
// Law:  the result equals that of a test of every side of the front (example grid_front). It is exact for integer
//       coordinates: cell numbers never decrease with coordinates, so sides that cross have a cell in common, and no
//       product overflows. For doubles, call your own exact predicates in turn().
// Cost: for a side that is no longer than a few times the mean distance of points, the number of sides nearby; for a
//       longer side, the number of cells in its bounding box.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/front/front.h"
#include "meshops/front/visitor.h"

struct Place {
  std::int64_t x, y;  ///< from −2³⁰ to 2³⁰
};

/// A visitor that updates the grid when the front changes: pass this visitor to meshops::advance(). Sites are indices
/// of places. A policy that adds a place must append it to the vector, inside the bounding box of the first places,
/// before the front inserts its triangle.
class FrontGrid : public meshops::FrontVisitor {
 public:
  explicit FrontGrid(const std::vector<Place>& places) : places_(places) {
    const auto [left, right] = std::ranges::minmax(places, {}, &Place::x);
    const auto [low, high] = std::ranges::minmax(places, {}, &Place::y);
    columns_ = rows_ = 1 + static_cast<std::int64_t>(std::sqrt(double(places.size())));
    corner_ = {left.x, low.y};
    width_ = 1 + (right.x - left.x) / columns_, height_ = 1 + (high.y - low.y) / rows_;
    cells_.resize(static_cast<std::size_t>(columns_ * rows_));
  }

  /// Returns whether the segment between a and b crosses a side of the front at an inner point of both. A contact at an
  /// end does not count.
  bool crosses(const meshops::Front& front, meshops::Site a, meshops::Site b) {
    return any_cell(a, b, [&](std::vector<Side>& cell) {
      // Remove sides that are no longer at the front.
      std::erase_if(cell, [&](const Side& s) { return !front.boundary_between(s.from, s.to).is_valid(); });
      return std::ranges::any_of(cell, [&](const Side& s) { return cross(a, b, s.from, s.to); });
    });
  }

  void seeded(const meshops::Front& front, const meshops::InsertedTriangle& t) { add(front, t.side); }
  void attached(const meshops::Front& front, meshops::Halfedge, const meshops::InsertedTriangle& t) {
    add(front, t.side);
  }
  void detached(const meshops::Front& front, const meshops::DetachedTriangle& t) {
    for (const meshops::Halfedge side : t.side)
      if (side.is_valid()) add(front, side);
  }

  /// Returns 1 if a, b, c turn left, −1 if they turn right, 0 if they are on a line.
  int turn(meshops::Site a, meshops::Site b, meshops::Site c) const {
    const Place &p = places_[a], &q = places_[b], &r = places_[c];
    const std::int64_t area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return (area > 0) - (area < 0);
  }

  bool cross(meshops::Site a, meshops::Site b, meshops::Site c, meshops::Site d) const {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }

 private:
  struct Side {
    meshops::Site from, to;
    friend bool operator==(const Side&, const Side&) = default;
  };

  /// Adds the sides of a new triangle that are at the front.
  void add(const meshops::Front& front, const std::array<meshops::Halfedge, 3>& sides) {
    for (const meshops::Halfedge side : sides) {
      const meshops::Halfedge beyond = front.mesh().opposite_halfedge_handle(side);
      if (front.mesh().is_boundary(beyond)) add(front, beyond);
    }
  }
  void add(const meshops::Front& front, meshops::Halfedge h) {
    const Side side{front.from_site(h), front.to_site(h)};
    any_cell(side.from, side.to, [&](std::vector<Side>& cell) {
      if (std::ranges::find(cell, side) == cell.end()) cell.push_back(side);
      return false;
    });
  }

  static std::int64_t step(std::int64_t from, std::int64_t size, std::int64_t at, std::int64_t steps) {
    return std::clamp<std::int64_t>((at - from) / size, 0, steps - 1);
  }
  /// Calls visit(cell) for the cells of the bounding box of the places of a and b, until a call returns true. Returns
  /// whether a call returned true.
  template <typename Visit>
  bool any_cell(meshops::Site a, meshops::Site b, Visit visit) {
    const Place &p = places_[a], &q = places_[b];
    const std::int64_t first = step(corner_.x, width_, std::min(p.x, q.x), columns_);
    const std::int64_t last = step(corner_.x, width_, std::max(p.x, q.x), columns_);
    const std::int64_t top = step(corner_.y, height_, std::max(p.y, q.y), rows_);
    for (std::int64_t row = step(corner_.y, height_, std::min(p.y, q.y), rows_); row <= top; ++row)
      for (std::int64_t column = first; column <= last; ++column)
        if (visit(cells_[static_cast<std::size_t>(row * columns_ + column)])) return true;
    return false;
  }

  const std::vector<Place>& places_;
  Place corner_;
  std::int64_t width_, height_, columns_, rows_;
  std::vector<std::vector<Side>> cells_;
};
