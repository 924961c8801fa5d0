// What: processes all tiles in several threads, and joins their results in a fixed order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "rbpa/base/parallel/in_order.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/tile/cut.h"

namespace rbpa {

/// Target number of points of a tile. Measured: smaller tiles have more seams, larger ones leave the cache.
inline constexpr std::uint32_t points_per_tile = 2048;

/// Calls three functions for each tile of the sites in the window: work(const Tile&, Workspace&) in any thread; then
/// join(number, Workspace&), one call at a time, in ascending order of the tiles' numbers, which do not depend on the
/// run; then finish(Workspace&) in any thread. A workspace belongs to one tile at a time, and is used again. Any thread
/// calls is_wanted(number); if the result is false, the tile is empty. Rethrows an exception of any call.
template <typename Workspace, typename IsWanted, typename Work, typename Join, typename Finish>
void for_each_tile(const Sites& sites, Threads& threads, IsWanted is_wanted, Work work, Join join, Finish finish) {
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
        if (is_wanted(i))
          item.cutter->cut(all[i], item.tile);
        else
          item.tile.clear();
        work(std::as_const(item.tile), item.workspace);
      },
      [&](std::size_t i, Item& item) { join(i, item.workspace); },
      [&](std::size_t, Item& item) { finish(item.workspace); });
}

}  // namespace rbpa
