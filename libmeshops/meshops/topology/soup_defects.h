// What: lists every defect that keeps a soup of faces from being an oriented 2-manifold with boundary.
// Law:  build_mesh() accepts a soup whose only defects are pinches; repair() returns a soup without defects.
// Cost: near-linear in the number of corners, faces and points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Kind of a defect.
enum class SoupDefectKind {
  corner_out_of_range,       ///< a corner of a face is not a point of the soup
  degenerate_face,           ///< a face has fewer than three corners, or a point twice
  duplicate_face,            ///< a face has the cycle of corners of an earlier face, in either direction
  non_manifold_edge,         ///< more than two faces meet at an edge
  inconsistent_orientation,  ///< two faces run along their common edge in the same direction
  not_orientable,            ///< no choice of directions makes faces connected through edges of two faces agree
  pinch                      ///< several fans of faces meet in a point
};

/// Defect of a soup. Faces with a defect of the first three kinds are ignored in the search for other kinds.
struct SoupDefect {
  SoupDefectKind kind;
  /// The corners of a face, the ends of an edge in ascending order, or the point of a pinch. For a piece that is not
  /// orientable: the ends of the first edge at which faces disagree although they agree at all edges before it.
  std::vector<std::uint32_t> points;
  /// By kind, ascending: the face; for a duplicate, the first face with these corners and then the duplicate; all faces
  /// at the edge; the first face of a piece that is not orientable; the first face of each fan of a pinch.
  std::vector<std::size_t> faces;
  friend bool operator==(const SoupDefect&, const SoupDefect&) = default;
};

/// Returns the name of a kind in words, for example "non-manifold edge".
MESHOPS_API std::string_view name(SoupDefectKind kind);

/// Returns a text for people, for example "non-manifold edge: points 3 4, faces 0 7 9".
MESHOPS_API std::string describe(const SoupDefect& defect);

/// Returns every defect, in the order of the kinds. Within a kind, defects are in the order of their faces (for a
/// duplicate, of the later face), edges or points; non-orientable pieces are in the order of their first faces.
/// Throws: ContractViolation as require_parted() does, or for 2³⁰ or more corners, points or faces; Cancelled.
MESHOPS_API std::vector<SoupDefect> find_defects(const PolygonSoup& soup, const GoOn& go_on = {});

}  // namespace meshops
