// What: tetrahedra that fill a box that repeats, as pieces connected through triangles, each laid out in space.
// Cost: linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/periodic_solid.h"
#include "rbpa/space/full/faces_within.h"
#include "rbpa/space/periodic/rank.h"

namespace rbpa::space {

class Parts {
 public:
  /// Pieces of those inside and of those outside; where `walls` is given, its triangles part the latter. Requires: a
  /// tetrahedron across from each corner.
  Parts(const PeriodicSolid& solid, const std::vector<bool>& is_inside, const FacesWithin* walls);

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> tetrahedra(std::size_t part) const {
    return std::span(order_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }
  /// The directions in which the part reaches images of itself.
  const Rank& directions(std::size_t part) const { return directions_[part]; }
  /// The same, of all parts outside together.
  const Rank& directions_outside() const { return directions_outside_; }

 private:
  std::vector<std::size_t> begin_ = {0};
  std::vector<std::uint32_t> order_;
  std::vector<Rank> directions_;
  Rank directions_outside_;
};

/// How many boxes to go from where tetrahedron t is to where its neighbor across from corner k meets it.
Boxes step_across(const PeriodicSolid& solid, std::uint32_t t, std::size_t k);

}  // namespace rbpa::space
