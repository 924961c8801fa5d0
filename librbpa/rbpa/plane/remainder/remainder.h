// What:   finds the triangles that the patches of all tiles lack, in one triangulation of the unsettled sites and their
//         neighbors.
// Law:    the triangles of the tiles and those of complete() are the solid alpha complex, each once.
// How:    a star is settled when every triangle of the complex around its site is in some patch. A missing triangle has
//         no settled corner, and is in the Delaunay triangulation of unsettled sites and their neighbors.
// Cost:   linear in the lists of the patches; O(r log r) for the r sites of not_done(): at worst all sites.
// Source: docs/explanation/plane.md, sections 12 to 14.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/tile_patch.h"

namespace rbpa {

class Remainder {
 public:
  /// Begins without a tile. Keeps a reference to the sites. Alpha is in the scale of the input.
  Remainder(const Sites& sites, const Radius& alpha) : sites_(sites), alpha_(alpha), missing_(sites.size(), unseen) {}

  /// Adds the patch of a tile; tiles may come in any order.
  void add(const TilePatch& tile);

  /// Returns whether every triangle of the complex at the site is in a patch; called after all tiles.
  bool is_settled(std::uint32_t site) const { return missing_[site] == 0; }

  /// Returns the sites that are not settled or may have an unsettled neighbor, ascending; called after all tiles.
  std::vector<std::uint32_t> not_done() const;

  /// Replaces rest.patch by the triangles of the complex that are in no patch of a tile, on the sites, and
  /// rest.outline, if rest.with_outline, by their outline; empties the other lists of `rest`. Called after all tiles.
  /// Calls working() repeatedly, in any thread and one call at a time; working() may throw to end the run.
  void complete(Threads& threads, const Checkpoint& working, TilePatch& rest) const;

 private:
  using Corners = std::array<meshops::Site, 3>;
  static constexpr int unseen = 1 << 30;

  std::vector<Corners> found_without_settled() const;

  const Sites& sites_;
  Radius alpha_;
  // for each site, the number of missing triangles; `unseen` more while no tile has seen the whole star
  meshops::FreshVector<int> missing_;
  meshops::FreshVector<TilePatch::Neighbors> unsettled_neighbors_;  // pairs of a site whose star is seen and a neighbor
  meshops::FreshVector<Corners> loose_triangles_;  // triangles of patches that may have no settled corner
};

}  // namespace rbpa
