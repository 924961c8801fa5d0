// What: holds the triangles that are not of the first level, sorted by level.
// Cost: linear in the triangles, and in the levels.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/hierarchy/level_patch.h"

namespace rbpa {

class WaitingTriangles {
 public:
  using Corners = std::array<meshops::Site, 3>;

  void add(const std::vector<WaitingTriangle>& triangles) {
    added_.insert(added_.end(), triangles.begin(), triangles.end());
  }

  /// Sorts the triangles by level; triangles of one level stay in the order in which they were added. Requires: all
  /// triangles were added, with levels from 0 to `last`; called once.
  void sort(int last) {
    start_.assign(static_cast<std::size_t>(last) + 2, 0);
    for (const WaitingTriangle& t : added_) ++start_[static_cast<std::size_t>(t.level) + 1];
    for (std::size_t level = 1; level < start_.size(); ++level) start_[level] += start_[level - 1];
    std::vector<std::size_t> next(start_);
    corners_.resize(added_.size());
    for (const WaitingTriangle& t : added_) corners_[next[static_cast<std::size_t>(t.level)]++] = t.corners;
    added_ = std::vector<WaitingTriangle>();  // = {} would keep the memory
  }

  /// Returns the triangles of a level. Requires: sort(last) was called; 0 ≤ level ≤ last.
  std::span<const Corners> of_level(int level) const {
    const auto at = static_cast<std::size_t>(level);
    return std::span(corners_).subspan(start_[at], start_[at + 1] - start_[at]);
  }

  /// Returns the first level after `level` that has a triangle, or Ladder::never. Requires: as of_level().
  int after(int level) const {
    const std::size_t before = start_[static_cast<std::size_t>(level) + 1];
    if (before == corners_.size()) return Ladder::never;
    const auto next = std::upper_bound(start_.begin(), start_.end(), before);
    return static_cast<int>(next - start_.begin()) - 1;
  }

 private:
  std::vector<WaitingTriangle> added_;
  std::vector<Corners> corners_;
  std::vector<std::size_t> start_;  // for each level, its first entry of corners_; then the end
};

}  // namespace rbpa
