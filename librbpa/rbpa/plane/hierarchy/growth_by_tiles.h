// What:   builds the complex level by level, with a whole mesh after each level; LevelsAtOnce builds only the last
//         mesh.
// Law:    grow() turns the complex of the previous level's radius into the complex of the given level's radius, with
//         every boundary halfedge frozen.
// How:    adds the triangles of the first level together, from tiles and remainder as rbpa() does; the triangles of
//         later levels wait, and each is inserted on its level.
// Cost:   that of rbpa(), and one insertion for each triangle of a later level.
// Source: docs/explanation/plane.md, sections 16 and 17.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/hierarchy/level_patch.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/mesh/monitor.h"

namespace rbpa {

/// The triangles that are not of the first level, sorted by level. Cost: linear in the triangles, and in the levels.
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

class GrowthByTiles {
 public:
  /// Keeps references to all arguments.
  GrowthByTiles(const Sites& sites, const Ladder& ladder, Threads& threads, Monitor& monitor)
      : sites_(sites), ladder_(ladder), threads_(threads), monitor_(monitor) {}

  /// Returns the front of level 0, with its triangles.
  meshops::Front begin(Assembly& assembly) { return assembly.front(lay(assembly.assembler())); }

  /// Adds the triangles of a level to the mesh (those of level 0 are there already), and freezes all boundary
  /// halfedges.
  /// Requires: ascending levels from 0; a level without triangles may be left out.
  /// Returns:  the number of sites that are corners of triangles of this level.
  std::size_t grow(int level, meshops::Front& front);

  /// Returns the number of sites that were isolated or on the boundary after the last grow().
  std::size_t open_sites() const { return open_sites_; }

  /// Returns the first level after `level` that has triangles to add; Ladder::never when no level follows.
  int next(int level) const { return waiting_.after(level); }

 private:
  meshops::AssembledPatches lay(meshops::PatchAssembler assembler);
  std::size_t look_at(const meshops::Front& front);
  std::size_t insert(int level, meshops::Front& front);

  const Sites& sites_;
  const Ladder& ladder_;
  Threads& threads_;
  Monitor& monitor_;
  WaitingTriangles waiting_;
  std::size_t open_sites_ = 0;
  std::vector<std::uint16_t> seen_;  // for each site, the last grown level above 0 with a triangle there, or 0
};

}  // namespace rbpa
