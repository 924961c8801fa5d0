// What: finds all triangles of the solid alpha complex, and puts them into a list.
#pragma once

#include <cstddef>

#include "rbpa/base/progress.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/patches/for_each_patch.h"

namespace rbpa {

/// A sink of patches that fills a list. `List` is TriangleList or has the same interface.
template <typename List>
struct ListSink {
  using Share = typename List::Place;
  static constexpr bool needs_outline = false;

  void prepare(const TilePatch& tile, Share& share) { list.prepare(tile.patch, share); }
  void place(const TilePatch& tile, Share& share) { list.place(tile.patch, share); }
  void fill(const TilePatch& tile, Share& share) { list.fill(tile.patch, share); }
  void worked() { stop_if_cancelled(progress, {list.size(), points}); }

  List& list;
  std::size_t points;
  const OnProgress& progress;
};

/// Puts all triangles of the solid alpha complex into `list`. Calls `progress`, if any, after each patch.
/// Requires: sites that are not all on one line.
/// Throws:   Cancelled.
template <typename List>
void find_triangles(const Sites& sites, const Radius& alpha, const OnProgress& progress, Threads& threads, List& list) {
  ListSink<List> sink{list, sites.size(), progress};
  for_each_patch(sites, alpha, threads, sink);
}

}  // namespace rbpa
