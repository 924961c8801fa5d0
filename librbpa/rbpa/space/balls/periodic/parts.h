// What: splits the tetrahedra of a cell that repeats into parts connected through triangles, and finds the directions
//       in which each part percolates.
// Cost: linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/space/balls/periodic/torus_rank.h"

namespace rbpa::space {

/// An image of tetrahedron t, moved by numbers of edges of the cell.
struct TetrahedronImage {
  std::uint32_t t = 0xffffffff;
  Boxes moved = {0, 0, 0};
};

class Parts {
 public:
  /// Finds the parts of the tetrahedra 0 … count − 1. beyond(t, k) returns the image across from corner k of t;
  /// is_open(t, k) returns whether t is connected with it; is_outside(t) whether the part of t counts for
  /// directions_outside().
  template <typename Beyond, typename IsOpen, typename IsOutside>
  Parts(std::size_t count, const Beyond& beyond, const IsOpen& is_open, const IsOutside& is_outside) {
    std::vector<Boxes> place(count);
    std::vector<bool> is_placed(count, false);
    order_.reserve(count);
    for (std::uint32_t first = 0; first < count; ++first) {
      if (is_placed[first]) continue;
      is_placed[first] = true;
      order_.push_back(first);
      Rank& directions = directions_.emplace_back();
      for (std::size_t at = begin_.back(); at < order_.size(); ++at) {
        const std::uint32_t t = order_[at];
        for (std::size_t k = 0; k < 4; ++k) {
          if (!is_open(t, k)) continue;
          const TetrahedronImage other = beyond(t, k);
          const Boxes there = plus(place[t], other.moved);
          Boxes& known = place[other.t];
          if (!is_placed[other.t]) {
            is_placed[other.t] = true;
            known = there;
            order_.push_back(other.t);
            continue;
          }
          const Boxes around = minus(there, known);
          directions.add(around);
          if (is_outside(t)) directions_outside_.add(around);
        }
      }
      begin_.push_back(order_.size());
    }
  }

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> tetrahedra(std::size_t part) const {
    return std::span(order_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }
  /// Returns the directions in which a part percolates: those in which the part is connected with an image of itself.
  const Rank& directions(std::size_t part) const { return directions_[part]; }
  /// Returns the directions in which the parts outside percolate, all together.
  const Rank& directions_outside() const { return directions_outside_; }

 private:
  std::vector<std::size_t> begin_ = {0};
  std::vector<std::uint32_t> order_;
  std::vector<Rank> directions_;
  Rank directions_outside_;
};

}  // namespace rbpa::space
