// What: finds the faces of a soup to reverse so that each piece of its surfaces is oriented.
// Law:  after the reversal, the two faces at an edge of an orientable piece run along the edge in opposite directions;
//       the number of reversed faces is the least possible.
// Cost: near-linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Piece of surface: faces that are connected through edges of exactly two faces, as in ComponentReport.
struct SurfacePiece {
  std::size_t first_face = 0;  ///< the least face
  std::size_t faces = 0;       ///< the number of faces
  bool closed = true;          ///< whether every edge of the piece has two faces
  bool orientable = true;      ///< whether reversals can make all faces of the piece agree
};

/// Pieces of a soup, and the faces to reverse.
struct Orientation {
  static constexpr std::uint32_t none = ~0U;  ///< stands for no piece

  std::vector<SurfacePiece> pieces;  ///< in the order of their first faces
  /// For each face, the index of its piece; `none` for a face that is degenerate, duplicate or out of range.
  std::vector<std::uint32_t> piece;
  /// For each face, whether to reverse it. No face of a non-orientable piece is reversed. If two sets of faces of equal
  /// size could be reversed, the set without the first face of the piece is.
  std::vector<bool> reversed;
};

/// Finds the pieces of a soup, and the faces to reverse.
/// Throws: ContractViolation as require_parted() does, or for 2³⁰ or more corners, points or faces; Cancelled.
MESHOPS_API Orientation orient(const PolygonSoup& soup, const GoOn& go_on = {});

/// Reverses the faces f for which reversed[f] is true. The first corner of each face stays the first.
/// Requires: `reversed` has a value for each face. Throws ContractViolation otherwise, and as require_parted() does;
///           the soup is then unchanged.
MESHOPS_API void reverse_faces(PolygonSoup& soup, const std::vector<bool>& reversed);

}  // namespace meshops
