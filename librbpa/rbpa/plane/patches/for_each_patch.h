// What: computes the solid alpha complex patch by patch: a patch of triangles for each tile, then one patch with all
//       triangles that are in no patch of a tile.
// Law:  each triangle is in one patch; the patches and their order are a function of the sites and alpha.
// How:  1. The sites in the window of doubles are cut into tiles (tile/cut.h).
//       2. A finder makes the patch of each tile, and marks the sites whose stars are settled: all triangles of the
//          complex around these sites are in patches (patches/find_patch.h). After tiles that settle few stars, some
//          tiles are skipped (patches/skipped_tiles.h).
//       3. A sink receives the patches and joins them; its step place() is called for one patch at a time, in order.
//       4. The sites whose stars are not settled, and those beyond the window, make the last patch
//          (remainder/remainder.h).
// Cost: linear if the density is even; at worst O(n log n).
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>

#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/patches/skipped_tiles.h"
#include "rbpa/plane/remainder/remainder.h"
#include "rbpa/plane/tile/for_each_tile.h"

namespace rbpa {

/// The receiver of patches. For each patch, these functions are called in this order, with one Share that belongs to
/// the patch until fill() returns and is then used again: prepare(tile, share) in any thread; place(tile, share), one
/// patch after another, in their order; fill(tile, share) in any thread. worked() is called after each place(), one
/// call at a time, and repeatedly in the remainder. Each function may throw, which ends the run.
template <typename Sink>
concept PatchSink = requires(Sink& sink, const TilePatch& tile, typename Sink::Share& share) {
  sink.prepare(tile, share);
  sink.place(tile, share);
  sink.fill(tile, share);
  sink.worked();
  { Sink::needs_outline } -> std::convertible_to<bool>;  // whether patches come with their outlines
};

template <PatchSink Sink>
void for_each_patch(const Sites& sites, const Radius& alpha, Threads& threads, Sink& sink) {
  struct Workspace {
    FinderWorkspace finder;
    std::size_t owned;
    TilePatch found;
    typename Sink::Share share;
  };
  const Radius scaled = sites.window().scaled(alpha);
  Remainder remainder(sites, alpha);
  SkippedTiles skipped;
  for_each_tile<Workspace>(
      sites, threads, [&](std::size_t i) { return !skipped.contains(i); },
      [&](const Tile& tile, Workspace& w) {
        w.found.with_outline = Sink::needs_outline;
        w.owned = static_cast<std::size_t>(std::count(tile.owned.begin(), tile.owned.end(), 1));
        find_patch(tile, scaled, w.finder, w.found);
        sink.prepare(std::as_const(w.found), w.share);
      },
      [&](std::size_t i, Workspace& w) {
        if (!skipped.contains(i)) {
          skipped.joined(i, w.owned, w.found.settled.size());
        } else if (w.owned != 0) {  // found before earlier tiles decided to skip this tile
          w.found.clear();
          sink.prepare(std::as_const(w.found), w.share);
        }
        sink.place(std::as_const(w.found), w.share);
        remainder.add(w.found);
        sink.worked();
      },
      [&](Workspace& w) { sink.fill(std::as_const(w.found), w.share); });
  TilePatch rest;
  rest.with_outline = Sink::needs_outline;
  remainder.complete(
      threads, [&] { sink.worked(); }, rest);
  typename Sink::Share share;
  sink.prepare(std::as_const(rest), share);
  sink.place(std::as_const(rest), share);
  sink.worked();
  sink.fill(std::as_const(rest), share);
}

}  // namespace rbpa
