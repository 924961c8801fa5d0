// What: the result of a tile: a patch of the solid alpha complex, and the sites that it settles.
// Law:  a triangle comes from the tile that owns its lexicographically least corner, and from no other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshops/patch/outline.h"
#include "meshops/patch/patch.h"

namespace rbpa {

/// The result of a tile. The star of a site is the set of triangles of the complex around the site. A tile has seen the
/// star when the tile owns the site and found all these triangles; the star is settled when the tile's patch has them
/// all.
struct TilePatch {
  bool with_outline = true;  ///< whether to compute the outline
  meshops::Patch patch;      ///< on the sites
  meshops::Outline outline;
  std::vector<std::uint32_t> settled;  ///< sites whose stars are settled

  // Data that settle more stars when all tiles are done (remainder/remainder.h).
  struct SharedStar {
    std::uint32_t site, elsewhere;
  };
  std::vector<SharedStar> shared;              ///< other stars seen, and how many of their triangles other tiles own
  std::vector<std::uint32_t> ghost_corners;    ///< corners of the patch that are ghosts, once for each triangle
  std::vector<std::uint32_t> loose_triangles;  ///< triangles of the patch none of whose corners is settled
  /// Pairs of a site whose star is seen and a Delaunay neighbor whose star is not settled. If the triangles were found
  /// by enumeration, also pairs with other sites at most about 2 alpha away.
  using Neighbors = std::array<std::uint32_t, 2>;
  std::vector<Neighbors> unsettled_neighbors;

  void clear() {
    patch.clear();
    outline.clear();
    settled.clear();
    shared.clear();
    ghost_corners.clear();
    loose_triangles.clear();
    unsettled_neighbors.clear();
  }
};

}  // namespace rbpa
