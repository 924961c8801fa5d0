// What: the common part of the finders of a tile's triangles, by pivots (pivots/) or by enumeration (enumeration/).
// Law:  a finder replaces `found` by a patch of the complex and the sites that it settles, a function of the tile and
//       alpha alone. A finder returns false if it can decide nothing or would be too slow; `found` is unspecified then.
#pragma once

#include "rbpa/plane/tile/coordinates.h"
#include "rbpa/plane/tile/extract_patch.h"
#include "rbpa/plane/tile/local_front.h"

namespace rbpa {

/// Memory of one thread that is reused from tile to tile; a finder has memory of its own besides.
struct TileWorkspace {
  TileCoordinates coordinates;  ///< coordinates of the tile; a finder replaces everything else
  LocalFront front;             ///< the triangles found
  ExtractionWorkspace extraction;
};

}  // namespace rbpa
