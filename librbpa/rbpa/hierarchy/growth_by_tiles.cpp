#include "rbpa/hierarchy/growth_by_tiles.h"

#include "rbpa/patches/for_each_patch.h"

namespace rbpa {
namespace {

/// What is made of a tile.
struct Share {
  LevelPatch levels;
  meshops::Outline outline;  ///< of `levels.first`, where some triangle waits
  meshops::Placement placement;

  /// Its triangles of the first level.
  const meshops::Patch& patch(const TilePatch& tile) const { return levels.later.empty() ? tile.patch : levels.first; }
  const meshops::Outline& outline_of(const TilePatch& tile) const {
    return levels.later.empty() ? tile.outline : outline;
  }
};

}  // namespace

std::size_t GrowthByTiles::grow(int level, meshops::Front& front) {
  std::size_t sites = 0;
  if (level == 0)
    for (meshops::Site s = 0; s < front.sites(); ++s) sites += !front.is_free(s);
  else
    sites = insert(level, front);
  for (auto h = front.pop(); h.is_valid(); h = front.pop()) front.freeze(h);
  return sites;
}

meshops::AssembledPatches GrowthByTiles::lay(meshops::PatchAssembler assembler) {
  const auto points = sites_.grid().points();
  const Window& window = sites_.window();
  const Radius all = ladder_.radius(ladder_.end());
  assembler.reserve(3 * sites_.size(), 2 * sites_.size());
  const OutlinedPatch rest = for_each_patch<Share>(
      sites_, all, threads_,
      [&](const TilePatch& tile, Share& share) {
        share.levels.part(tile.patch, points, ladder_, window);
        if (!share.levels.later.empty()) meshops::survey(share.levels.first, share.outline);
      },
      [&](const TilePatch& tile, Share& share) {
        assembler.place(share.patch(tile), share.outline_of(tile), share.placement);
        waiting_.add(share.levels.later);
      },
      [&](const TilePatch& tile, Share& share) {
        assembler.fill(share.patch(tile), share.outline_of(tile), share.placement);
      },
      [&] { report_.worked(assembler.faces()); });
  LevelPatch levels;
  levels.part(rest.patch, sites_, ladder_);
  report_.worked(assembler.faces());
  if (levels.later.empty())
    assembler.lay(rest.patch, rest.outline);
  else
    assembler.lay(levels.first);
  waiting_.add(levels.later);
  report_.worked(assembler.faces());
  waiting_.sort(ladder_.end());
  report_.worked(assembler.faces());
  auto assembled = std::move(assembler).join();
  report_.completed(assembled.mesh());
  return assembled;
}

std::size_t GrowthByTiles::insert(int level, meshops::Front& front) {
  seen_.resize(front.sites());
  std::size_t sites = 0;
  for (const auto& corners : waiting_.of_level(level)) {
    report_.seeded(front, front.create(corners[0], corners[1], corners[2]));
    for (const meshops::Site s : corners) {
      std::uint16_t& seen = seen_[s];
      sites += seen != level;
      seen = static_cast<std::uint16_t>(level);
    }
  }
  return sites;
}

}  // namespace rbpa
