// What: the solid alpha complex, patch by patch: those of tiles, then one of what tiles leave over.
// Law:  each triangle is in one patch; the patches and their order are a function of the sites and alpha.
// How:  1. Tiles are cut out of the sites in the window of doubles (tile/cut.h).
//       2. A finder makes a patch of each, and says which stars are settled (patches/find_patch.h).
//       3. Patches are handed to the caller, one at a time where they have to do with each other.
//       4. Sites whose stars are not settled, and those beyond the window, make the last patch (remainder/remainder.h).
// Cost: linear where density is even; at worst O(n log n).
#pragma once

#include <utility>

#include "meshops/patch/patch.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/remainder/remainder.h"
#include "rbpa/plane/tile/for_each_tile.h"

namespace rbpa {

/// Calls for the patch of each tile, a TilePatch: prepare(patch, share) in any thread; place(patch, share) in order and one
/// at a time; fill(patch, share) in any thread. A Share is one tile's at a time, and is used again for others.
/// Calls working() now and then, in any thread and one at a time; any of these may throw to end it.
/// Returns: what tiles leave over, to be put beside the others.
template <typename Share, typename Prepare, typename Place, typename Fill, typename Working>
meshops::Patch for_each_patch(const Sites& sites, const Radius& alpha, Threads& threads, Prepare prepare, Place place,
                              Fill fill, Working working, bool with_outline = true) {
  struct Workspace {
    FinderWorkspace finder;
    TilePatch found;
    Share share;
  };
  const Radius scaled = sites.window().scaled(alpha);
  Remainder remainder(sites, alpha);
  for_each_tile<Workspace>(
      sites, threads,
      [&](const Tile& tile, Workspace& w) {
        w.found.with_outline = with_outline;
        find_patch(tile, scaled, w.finder, w.found);
        prepare(std::as_const(w.found), w.share);
      },
      [&](Workspace& w) {
        place(std::as_const(w.found), w.share);
        remainder.add(w.found);
        working();
      },
      [&](Workspace& w) { fill(std::as_const(w.found), w.share); });
  return remainder.complete(threads, working);
}

}  // namespace rbpa
