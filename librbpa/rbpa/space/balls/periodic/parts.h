// What: pieces of tetrahedra connected through triangles that fill a periodic box, each piece laid out in space.
// Cost: linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/periodic/torus_rank.h"
#include "rbpa/space/solid/periodic_solid.h"

namespace rbpa::space {

class Parts {
 public:
  /// Finds the pieces of the tetrahedra inside and of those outside. If `walls` is given, its triangles separate the
  /// pieces outside. Requires: a tetrahedron across from each corner.
  Parts(const PeriodicSolid& solid, const std::vector<bool>& is_inside, const FacesWithin* walls);

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> tetrahedra(std::size_t part) const {
    return std::span(order_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }
  /// Returns the directions in which a part percolates: reaches images of itself.
  const Rank& directions(std::size_t part) const { return directions_[part]; }
  /// Returns the directions in which all parts outside together percolate.
  const Rank& directions_outside() const { return directions_outside_; }

 private:
  std::vector<std::size_t> begin_ = {0};
  std::vector<std::uint32_t> order_;
  std::vector<Rank> directions_;
  Rank directions_outside_;
};

/// Returns the offset, in boxes, from tetrahedron t to the image that its neighbor across from corner k meets.
Boxes step_across(const PeriodicSolid& solid, std::uint32_t t, std::size_t k);

}  // namespace rbpa::space
