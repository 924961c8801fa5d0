// What: makes an oriented manifold of any soup, and reports every change.
// Law:  find_defects(repair(s).soup) is empty; a soup without defects is returned unchanged; repair() adds no faces.
// Cost: near-linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Kind of a change that repair() makes.
enum class RepairKind {
  corner_dropped,  ///< a corner of a face was removed, because it equaled the next corner
  face_dropped,    ///< a face was removed, because it was degenerate, duplicate, or out of range in a corner
  face_reversed,   ///< a face was reversed
  edge_cut,        ///< some faces at an edge are no longer joined there
  point_split      ///< a point became several points, one for each fan of faces
};

/// Step of a repair. All its numbers refer to the given soup.
struct RepairStep {
  RepairKind kind;
  /// The corner that was dropped; the old corners of a face that was dropped or reversed; the ends of an edge, in
  /// ascending order; or the point that was split.
  std::vector<std::uint32_t> points;
  std::vector<std::size_t> faces;  ///< the face, or the faces at the edge; empty for a point that was split
  friend bool operator==(const RepairStep&, const RepairStep&) = default;
};

/// Result of repair().
struct Repair {
  PolygonSoup soup;                      ///< points of the given soup keep their numbers; new points follow
  std::vector<std::uint32_t> stands_on;  ///< for each point of `soup`, the given point at the same position
  std::vector<std::size_t> face_was;     ///< for each face of `soup`, its number in the given soup
  std::vector<RepairStep> steps;         ///< in the order of the kinds; within a kind, of faces, edges or points
};

/// Returns the name of a kind in words, for example "face dropped".
MESHOPS_API std::string_view name(RepairKind kind);

/// Returns a text for people, for example "face dropped: points 3 3 4, face 7".
MESHOPS_API std::string describe(const RepairStep& step);

/// Repairs a soup. First, corners that equal the next corner of their face are dropped, then faces that are degenerate,
/// duplicate or out of range. Walls are kept: pairs of faces with the same corners in opposite directions, at each edge
/// of which two sides run in each direction, as between two closed solids. The faces of a pair get points of their own,
/// and each face stays joined to the surface on its side. If this would reverse a face of a wall or leave a defect, no
/// wall is kept: the later face of every pair is dropped. Faces connected through edges of two faces are two sets of
/// opposite directions; the smaller set is reversed, or, in a tie, the set without the first face. An edge is cut if
/// more than two faces meet there, or two that do not agree on a direction. Two faces at a cut edge stay joined only if
/// other edges connect them around both ends of the edge. A point with several fans is split.
/// Throws: ContractViolation as require_parted() does, or for 2³⁰ or more corners, points or faces; Cancelled.
MESHOPS_API Repair repair(const PolygonSoup& soup, const GoOn& go_on = {});

}  // namespace meshops
