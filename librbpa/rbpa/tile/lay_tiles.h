// What:   the local part of a run: all that can be told tile by tile, laid beside each other.
// Law:    what is laid is part of the solid alpha complex; nothing is missing at sites that are known.
// Source: docs/tiles.md.
#pragma once

#include "meshops/patch/assembler.h"
#include "rbpa/predicate/radius.h"
#include "rbpa/search/sites.h"
#include "rbpa/tile/for_each_tile.h"

namespace rbpa {

/// Lays every tile, calling laid(const TileTriangles&) after each, one at a time and in any thread; it may throw to end the
/// run. PatchAssembler::join() is left to the caller, who may have more to lay.
template <typename Laid>
void lay_tiles(const Sites& sites, const Radius& radius, meshops::PatchAssembler& assembler, Threads& threads,
               Laid laid) {
  assembler.reserve(3 * sites.size(), 2 * sites.size());
  for_each_tile<meshops::Placement>(
      sites, radius, threads, [](const TileTriangles&, meshops::Placement&) {},
      [&](const TileTriangles& tile, meshops::Placement& placement) {
        assembler.place(tile.patch, tile.outline, placement);
        laid(tile);
      },
      [&](const TileTriangles& tile, meshops::Placement& placement) {
        assembler.fill(tile.patch, tile.outline, placement);
      });
}

}  // namespace rbpa
