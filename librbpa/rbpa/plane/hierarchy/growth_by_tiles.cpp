#include "rbpa/plane/hierarchy/growth_by_tiles.h"

#include <array>

#include "rbpa/plane/patches/for_each_patch.h"

namespace rbpa {
namespace {

/// A sink that puts the triangles of the first level into a mesh, and keeps the triangles of later levels.
struct LevelSink {
  struct Share {
    LevelPatch levels;
    meshops::Outline outline;  ///< outline of `levels.first`, if some triangle waits
    meshops::Placement placement;

    /// Returns the triangles of the first level.
    const meshops::Patch& patch(const TilePatch& tile) const {
      return levels.later.empty() ? tile.patch : levels.first;
    }
    const meshops::Outline& outline_of(const TilePatch& tile) const {
      return levels.later.empty() ? tile.outline : outline;
    }
  };
  static constexpr bool needs_outline = true;

  void prepare(const TilePatch& tile, Share& share) const {
    share.levels.split(tile.patch, levels);
    if (!share.levels.later.empty()) meshops::survey(share.levels.first, share.outline);
  }
  void place(const TilePatch& tile, Share& share) {
    assembler.place(share.patch(tile), share.outline_of(tile), share.placement);
    waiting.add(share.levels.later);
  }
  void fill(const TilePatch& tile, Share& share) {
    assembler.fill(share.patch(tile), share.outline_of(tile), share.placement);
  }
  void worked() { monitor.worked(assembler.faces()); }

  const SiteLevels& levels;
  meshops::PatchAssembler& assembler;
  WaitingTriangles& waiting;
  Monitor& monitor;
};

/// Returns the result of fit(). Does not search for edges with two triangles on one side, as a complex has none.
meshops::Fit fit_of_complex(const meshops::Front& front, const std::array<meshops::Site, 3>& corners) {
  meshops::Fit fit(corners);
  for (std::size_t i = 0; i < 3; ++i)
    if (const meshops::Site from = corners[i], to = corners[(i + 1) % 3]; !front.is_free(from) && !front.is_free(to))
      fit.sides.side[i] = front.boundary_between(from, to);
  return fit;
}

}  // namespace

std::size_t GrowthByTiles::grow(int level, meshops::Front& front) {
  const std::size_t sites = level == 0 ? look_at(front) : insert(level, front);
  for (auto h = front.pop(); h.is_valid(); h = front.pop()) front.freeze(h);
  return sites;
}

/// Returns the number of sites with a triangle in a mesh of the first level, and adds the number of isolated and
/// boundary sites to open_sites_.
std::size_t GrowthByTiles::look_at(const meshops::Front& front) {
  std::size_t sites = 0;
  for (meshops::Site s = 0; s < front.sites(); ++s) {
    const bool is_free = front.is_free(s);
    sites += !is_free;
    open_sites_ += is_free || front.is_on_boundary(s);
  }
  return sites;
}

meshops::AssembledPatches GrowthByTiles::lay(meshops::PatchAssembler assembler) {
  const SiteLevels site_levels(sites_, ladder_);
  const Radius all = ladder_.radius(ladder_.end());
  assembler.reserve(3 * sites_.size(), 2 * sites_.size());
  LevelSink sink{site_levels, assembler, waiting_, monitor_};
  for_each_patch(sites_, all, threads_, sink);
  waiting_.sort(ladder_.end());
  monitor_.worked(assembler.faces());
  auto assembled = std::move(assembler).join();
  monitor_.completed(assembled.mesh());
  return assembled;
}

std::size_t GrowthByTiles::insert(int level, meshops::Front& front) {
  seen_.resize(front.sites());
  std::size_t sites = 0;
  for (const auto& corners : waiting_.of_level(level)) {
    const meshops::InsertedTriangle inserted = front.insert(fit_of_complex(front, corners));
    monitor_.seeded(front, inserted);
    for (const meshops::Halfedge side : inserted.side) {
      const meshops::Vertex v = front.mesh().to_vertex_handle(side);
      // In the plane, a fan that closes around a site is the only fan at the site.
      open_sites_ -= !front.mesh().is_boundary(v);
      std::uint16_t& seen = seen_[front.site(v)];
      sites += seen != level;
      seen = static_cast<std::uint16_t>(level);
    }
  }
  return sites;
}

}  // namespace rbpa
