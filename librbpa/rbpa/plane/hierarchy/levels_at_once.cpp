#include "rbpa/plane/hierarchy/levels_at_once.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "rbpa/plane/hierarchy/site_levels.h"
#include "rbpa/plane/patches/for_each_patch.h"

namespace rbpa {
namespace {

constexpr std::size_t items_at_a_time = 1u << 16;

/// A record of the levels of triangles that are laid.
struct Notes {
  /// Adds the levels of a patch whose first face is `face`. Called by several threads, whose patches can share sites.
  void add(const meshops::Patch& patch, std::size_t face) const {
    for (const auto& corners : patch.triangles) {
      const int of_triangle = levels.of(corners);
      level[face++] = static_cast<std::uint16_t>(of_triangle);
      if (of_triangle != 0) continue;
      for (const meshops::Site s : corners) std::atomic_ref(seen[s]).store(0, std::memory_order_relaxed);
    }
  }

  const SiteLevels& levels;
  std::uint16_t* level;  ///< for each face
  std::uint16_t* seen;   ///< for each site, 0 if it has a triangle of the first level
};

/// A sink that puts patches into a mesh, and notes their levels.
struct NotingSink {
  struct Share {
    meshops::Placement placement;
    std::size_t first_face;
  };
  static constexpr bool needs_outline = true;

  void prepare(const TilePatch&, Share&) const {}
  void place(const TilePatch& tile, Share& share) {
    share.first_face = assembler.faces();
    assembler.place(tile.patch, tile.outline, share.placement);
  }
  void fill(const TilePatch& tile, Share& share) {
    assembler.fill(tile.patch, tile.outline, share.placement);
    notes.add(tile.patch, share.first_face);
  }
  void worked() { monitor.worked(assembler.faces()); }

  meshops::PatchAssembler& assembler;
  Monitor& monitor;
  const Notes& notes;
};

}  // namespace

meshops::AssembledPatches LevelsAtOnce::lay(Assembly& assembly) {
  auto assembled = lay(assembly.assembler());
  std::vector<std::uint32_t> later;
  const auto number = new_numbers(assembled.faces(), later);
  count_later(assembled, later);
  if (!later.empty()) renumber(number, assembly.mesh());
  count_closed(assembled);
  return assembled;
}

meshops::AssembledPatches LevelsAtOnce::lay(meshops::PatchAssembler assembler) {
  const SiteLevels levels(sites_, ladder_);
  level_.resize(2 * sites_.size());
  seen_.assign(sites_.size(), none);
  const Notes notes{levels, level_.data(), seen_.data()};
  assembler.reserve(3 * sites_.size(), 2 * sites_.size());
  NotingSink sink{assembler, monitor_, notes};
  for_each_patch(sites_, ladder_.radius(ladder_.end()), threads_, sink);
  auto assembled = std::move(assembler).join();
  monitor_.completed(assembled.mesh());
  return assembled;
}

meshops::FreshVector<std::uint32_t> LevelsAtOnce::new_numbers(std::size_t faces, std::vector<std::uint32_t>& later) {
  growth_.assign(static_cast<std::size_t>(ladder_.end()) + 1, {});
  for (std::size_t f = 0; f < faces; ++f) ++growth_[level_[f]].triangles;
  std::vector<std::uint32_t> next;  // for each level, the number of its next face
  std::size_t before = 0;
  for (const Growth& growth : growth_) {
    next.push_back(static_cast<std::uint32_t>(before));
    before += growth.triangles;
  }
  const std::size_t first = growth_.front().triangles;
  later.resize(faces - first);
  meshops::FreshVector<std::uint32_t> number(later.empty() ? 0 : faces);
  for (std::size_t f = 0; f < number.size(); ++f) {
    number[f] = next[level_[f]]++;
    if (level_[f] != 0) later[number[f] - first] = static_cast<std::uint32_t>(f);
  }
  return number;
}

/// Counts the sites and edges that each level adds. `later` are the faces of all levels but the first; an edge belongs
/// to the lower level of its faces.
void LevelsAtOnce::count_later(const meshops::AssembledPatches& assembled, std::span<const std::uint32_t> later) {
  const meshops::Connectivity& mesh = assembled.mesh();
  Growth& first = growth_.front();
  first.sites = static_cast<std::size_t>(std::count(seen_.begin(), seen_.end(), 0));
  first.edges = mesh.n_edges();
  for (const std::uint32_t f : later) {
    const std::uint16_t level = level_[f];
    Growth& growth = growth_[level];
    for (const auto h : mesh.fh_ccw_range(meshops::Face(static_cast<int>(f)))) {
      const meshops::Halfedge opposite = mesh.opposite_halfedge_handle(h);
      const meshops::Face beyond = mesh.face_handle(opposite);
      const std::uint16_t level_beyond = beyond.is_valid() ? level_[static_cast<std::size_t>(beyond.idx())] : none;
      if (level < level_beyond || (level == level_beyond && h.idx() < opposite.idx())) {
        ++growth.edges;
        --first.edges;
      }
      std::uint16_t& seen = seen_[assembled.site(mesh.to_vertex_handle(h))];
      growth.sites += seen != level;
      seen = level;
    }
  }
}

void LevelsAtOnce::renumber(std::span<const std::uint32_t> number, Mesh& mesh) {
  meshops::FreshVector<meshops::Halfedge> halfedge(number.size());  // for each face, by its new number, a halfedge
  for_each_part(threads_, number.size(), items_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      halfedge[number[f]] = mesh.halfedge_handle(meshops::Face(static_cast<int>(f)));
  });
  for_each_part(threads_, number.size(), items_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) mesh.set_halfedge_handle(meshops::Face(static_cast<int>(f)), halfedge[f]);
  });
  for_each_part(threads_, mesh.n_halfedges(), items_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const meshops::Halfedge h(static_cast<int>(i));
      if (const meshops::Face f = mesh.face_handle(h); f.is_valid())
        mesh.set_face_handle(h, meshops::Face(static_cast<int>(number[static_cast<std::size_t>(f.idx())])));
    }
  });
}

/// Counts the sites that close on each level. A site closes on the last level of its triangles, unless it is on the
/// boundary of the whole mesh. In the plane, a fan that closes around a site is the only fan at the site.
void LevelsAtOnce::count_closed(const meshops::AssembledPatches& assembled) {
  const meshops::Connectivity& mesh = assembled.mesh();
  for_each_part(threads_, mesh.n_halfedges(), items_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const meshops::Halfedge h(static_cast<int>(i));
      if (!mesh.is_boundary(h)) continue;
      std::uint16_t& seen = seen_[assembled.site(mesh.to_vertex_handle(h))];
      std::atomic_ref(seen).store(none, std::memory_order_relaxed);
    }
  });
  for (const std::uint16_t last : seen_)
    if (last != none) ++growth_[last].closed;
}

std::vector<Level> LevelsAtOnce::levels(double alpha) const {
  std::vector<Level> levels;
  std::size_t open = sites_.size(), edges = 0, triangles = 0;
  for (int number = 0; number <= ladder_.end(); ++number) {
    const bool is_last = ladder_.is_last(number);
    const Growth& growth = growth_[static_cast<std::size_t>(number)];
    if (growth.triangles == 0 && number != 0 && !is_last) continue;
    levels.push_back({.alpha = is_last ? alpha : ladder_.radius(number).value(),
                      .number = number,
                      .transferred = open,
                      .taking_part = growth.sites,
                      .advancing = 2 * edges - 3 * triangles,
                      .triangles = triangles + growth.triangles});
    open -= growth.closed;
    edges += growth.edges;
    triangles += growth.triangles;
  }
  return levels;
}

}  // namespace rbpa
