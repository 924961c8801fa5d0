// What:   the triangles that the patches of all tiles lack: found in one triangulation, of the sites that are not settled
//         and their neighbors.
// Law:    the triangles of the tiles and those of complete() are the solid alpha complex, each once.
// How:    a star is settled when every triangle of the complex around its site is in some patch. What is missing has no
//         settled corner, and is in the Delaunay triangulation of those sites and their neighbors.
// Cost:   linear in the lists of the patches; O(r log r) for the r sites that are not done: at worst all.
// Source: docs/remainder.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/tile_patch.h"

namespace rbpa {

class Remainder {
 public:
  /// No tile is added yet. Keeps a reference. Alpha is that of the points as they were given.
  Remainder(const Sites& sites, const Radius& alpha) : sites_(sites), alpha_(alpha), missing_(sites.size(), unseen) {}

  /// Tiles come in any order.
  void add(const TilePatch& tile);

  /// After all tiles: every triangle of the complex at the site is in a patch.
  bool is_settled(std::uint32_t site) const { return missing_[site] == 0; }

  /// After all tiles: the sites that are not settled or have a neighbor that may not be, ascending.
  std::vector<std::uint32_t> not_done() const;

  /// After all tiles: the triangles of the complex that are in no patch, on the sites, and their outline if wanted; nothing
  /// else of `rest` has a meaning. Calls working() now and then, in any thread and one at a time; it may throw to end it.
  void complete(Threads& threads, const std::function<void()>& working, TilePatch& rest) const;

 private:
  using Corners = std::array<meshops::Site, 3>;
  static constexpr int unseen = 1 << 30;

  std::vector<Corners> found_without_settled() const;

  const Sites& sites_;
  Radius alpha_;
  std::vector<int> missing_;  // of each site, how many triangles; `unseen` more while no tile has seen the whole star
  std::vector<TilePatch::Neighbors> unsettled_neighbors_;  // sites whose stars are seen, with a neighbor each
  std::vector<Corners> loose_triangles_;                   // of patches, those that may have no settled corner
};

}  // namespace rbpa
