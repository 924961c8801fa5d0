// What: all tiles, in several threads, joined in one order.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "rbpa/base/parallel/in_order.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/tile/cut.h"

namespace rbpa {

inline constexpr std::uint32_t points_per_tile = 2048;  ///< measured: fewer have more seams, more leave the cache

/// The tiles of the sites in the window: calls work(const Tile&, Workspace&) for each in any thread; join(Workspace&) in the
/// same order on every run and one at a time; then, in any thread, finish(Workspace&). A workspace is one tile's at a
/// time, and is used again for others. Throws what one of them throws.
template <typename Workspace, typename Work, typename Join, typename Finish>
void for_each_tile(const Sites& sites, Threads& threads, Work work, Join join, Finish finish) {
  struct Item {
    std::optional<Cutter> cutter;
    Tile tile;
    Workspace workspace;
  };
  const std::vector<Block> all = blocks(sites.grid(), points_per_tile);
  in_order<Item>(
      threads, all.size(),
      [&](std::size_t i, Item& item) {
        if (!item.cutter) item.cutter.emplace(sites.grid(), sites.hidden());
        item.cutter->cut(all[i], item.tile);
        work(std::as_const(item.tile), item.workspace);
      },
      [&](std::size_t, Item& item) { join(item.workspace); }, [&](std::size_t, Item& item) { finish(item.workspace); });
}

}  // namespace rbpa
