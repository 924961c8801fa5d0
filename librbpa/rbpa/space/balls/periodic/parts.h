// What: splits the tetrahedra that fill a periodic box into parts connected through triangles, and finds the directions
//       in which each part percolates.
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
  /// Finds the parts of the tetrahedra t with is_inside[t], and the parts of the other tetrahedra. If `walls` is given,
  /// its triangles separate parts of the other tetrahedra. Requires: every tetrahedron has four neighbors.
  Parts(const PeriodicSolid& solid, const std::vector<bool>& is_inside, const FacesWithin* walls);

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> tetrahedra(std::size_t part) const {
    return std::span(order_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }
  /// Returns the directions in which a part percolates: those in which the part is connected with an image of itself.
  const Rank& directions(std::size_t part) const { return directions_[part]; }
  /// Returns the directions in which the parts of the tetrahedra t without is_inside[t] percolate, all together.
  const Rank& directions_outside() const { return directions_outside_; }

 private:
  std::vector<std::size_t> begin_ = {0};
  std::vector<std::uint32_t> order_;
  std::vector<Rank> directions_;
  Rank directions_outside_;
};

/// Returns by how many boxes the neighbor across from corner k of tetrahedron t must be moved to share the face with t.
Boxes step_across(const PeriodicSolid& solid, std::uint32_t t, std::size_t k);

}  // namespace rbpa::space
