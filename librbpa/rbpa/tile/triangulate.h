// What:   the Delaunay triangles of a tile by ball pivoting, as far as its points tell them; where alpha is small, by
//         enumeration (tile/enumerate.h).
// Law:    every triangle returned is one of the solid alpha complex of all points, and none is left out whose circle
//         lies where all points are known and to which a front of such triangles leads.
// Cost:   about two pivots a point, each a few vector instructions in single precision; exact arithmetic where these
//         leave two points in the contest. See docs/tiles.md.
// Source: Restricted BPA, sections 3.1 and 3.2.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshops/front/outline.h"
#include "meshops/front/patch.h"
#include "rbpa/predicate/radius.h"
#include "rbpa/tile/coordinates.h"
#include "rbpa/tile/local_front.h"
#include "rbpa/tile/tile.h"
#include "rbpa/tile/within_alpha.h"

namespace rbpa {

struct TileTriangles {
  meshops::Patch patch;  ///< on the sites; the triangles whose least corner the tile owns
  meshops::Outline outline;
  std::vector<std::uint32_t>
      known;  ///< sites the tile owns at which no triangle of the complex is but those of the patch

  // What makes more of this when all tiles have told (remainder/remainder.h). A star is seen when the
  // tile owns its site, and it is closed or was enumerated.
  struct SharedStar {
    std::uint32_t site, foreign;
  };
  std::vector<SharedStar> shared;     ///< other stars seen, and how many triangles of the complex other tiles own there
  std::vector<std::uint32_t> given;   ///< corners of the patch that other tiles own, once for each triangle
  std::vector<std::uint32_t> unsure;  ///< triangles of the patch none of whose corners is known
  std::vector<std::array<std::uint32_t, 2>>
      beside;  ///< sites whose stars are seen, each with a Delaunay neighbour that is not known; or, of a tile that was
               ///< enumerated, with any that is not known and nearer than 2 alpha

  void clear() {
    patch.clear();
    outline.clear();
    known.clear();
    shared.clear();
    given.clear();
    unsure.clear();
    beside.clear();
  }
};

/// What one thread works with, from tile to tile.
struct TileWorkspace {
  TileCoordinates coordinates;
  LocalFront front;
  std::vector<std::uint16_t> queue, wave;
  std::vector<float> radius;
  // For enumerate(): of each point, its number and whether the tile owns it; what else to put into `beside`.
  std::vector<std::int32_t> labels;
  std::vector<std::uint64_t> own_bits;
  std::vector<std::array<std::uint32_t, 2>> near_rim;
  // For hand_over(). Numbers of triangles:
  std::vector<std::uint16_t> told, others, marginal;
  // Of each triangle: it has an owner here. Of each side: what others are told of it. Of each point: triangles whose
  // owners may not have found them, the side that leaves it in an outline, and one of those at the rim that end there.
  std::vector<std::uint16_t> owned, number, foreign;
  std::vector<int> last, ending;
  std::vector<Within> within;  // of each triangle, alpha
  std::vector<std::uint8_t> star;
  // Lists of the result, before their length is known.
  std::vector<TileTriangles::SharedStar> shared;
  std::vector<std::array<std::uint32_t, 2>> beside;
  std::vector<std::uint32_t> given;
  std::vector<int> outer;
};

/// Replaces `result`.
void triangulate(const Tile& tile, const Radius& radius, TileWorkspace& workspace, TileTriangles& result);

}  // namespace rbpa
