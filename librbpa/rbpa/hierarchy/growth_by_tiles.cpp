#include "rbpa/hierarchy/growth_by_tiles.h"

#include "rbpa/remainder/remainder.h"
#include "rbpa/tile/for_each_tile.h"

namespace rbpa {
namespace {

/// What is made of a tile.
struct Share {
  LevelPatch levels;
  meshops::Outline outline;  ///< of `levels.first`, where some triangle waits
  meshops::Placement placement;

  /// Its triangles of the first level.
  const meshops::Patch& patch(const TileTriangles& tile) const {
    return levels.later.empty() ? tile.patch : levels.first;
  }
  const meshops::Outline& outline_of(const TileTriangles& tile) const {
    return levels.later.empty() ? tile.outline : outline;
  }
};

}  // namespace

std::size_t GrowthByTiles::grow(int level, meshops::Front& front) {
  std::size_t sites = 0;
  if (level == 0) {
    lay(front);
    for (meshops::Site s = 0; s < static_cast<meshops::Site>(front.sites()); ++s) sites += !front.is_free(s);
  } else {
    sites = insert(level, front);
  }
  for (auto h = front.pop(); h.is_valid(); h = front.pop()) front.freeze(h);
  return sites;
}

void GrowthByTiles::lay(meshops::Front& front) {
  const auto points = grid_.points();
  const Radius all = ladder_.radius(ladder_.end());
  Remainder remainder(points, all);
  front.reserve(3 * points.size(), 2 * points.size());
  for_each_tile<Share>(
      grid_, all, threads_,
      [&](const TileTriangles& tile, Share& share) {
        share.levels.part(tile.patch, points, ladder_);
        if (!share.levels.later.empty()) meshops::survey(share.levels.first, share.outline);
      },
      [&](const TileTriangles& tile, Share& share) {
        front.place(share.patch(tile), share.outline_of(tile), share.placement);
        waiting_.add(share.levels.later);
        remainder.add(tile);
        report_.worked(front);
      },
      [&](const TileTriangles& tile, Share& share) {
        front.fill(share.patch(tile), share.outline_of(tile), share.placement);
      });
  meshops::Patch missing;
  meshops::Outline outline;
  remainder.complete(missing, outline, threads_, [&] { report_.worked(front); });
  LevelPatch levels;
  levels.part(missing, points, ladder_);
  report_.worked(front);
  if (levels.later.empty())
    front.lay(missing, outline);
  else
    front.lay(levels.first);
  report_.worked(front);
  front.join();
  report_.completed(front);
  waiting_.add(levels.later);
  report_.worked(front);
  waiting_.sort(ladder_.end());
  report_.worked(front);
}

std::size_t GrowthByTiles::insert(int level, meshops::Front& front) {
  seen_.resize(front.sites());
  std::size_t sites = 0;
  for (const auto& corners : waiting_.of_level(level)) {
    report_.seeded(front, front.create(corners[0], corners[1], corners[2]));
    for (const meshops::Site s : corners) {
      std::uint16_t& seen = seen_[static_cast<std::size_t>(s)];
      sites += seen != level;
      seen = static_cast<std::uint16_t>(level);
    }
  }
  return sites;
}

}  // namespace rbpa
