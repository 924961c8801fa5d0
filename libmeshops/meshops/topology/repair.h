// What: makes an oriented manifold of any soup, and reports what was changed.
// Law:  find_defects(repair(s).soup) is empty; a soup without defects comes back as it was; nothing is added to the
//       surface.
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

enum class RepairKind {
  corner_dropped,  ///< a face named one point twice in a row, and names it once now
  face_dropped,    ///< a degenerate or duplicate face, or one with a corner out of range, is gone
  face_reversed,   ///< a face runs the other way now
  edge_cut,        ///< the faces at an edge are not all joined there any more
  point_split      ///< a point has become several, one for each fan of faces
};

/// All numbers are those of the soup that was given.
struct RepairStep {
  RepairKind kind;
  std::vector<std::uint32_t> points;  ///< the corner; the corners of the face; the ends of the edge; the point
  std::vector<std::size_t> faces;     ///< the face, or the faces at the edge
  friend bool operator==(const RepairStep&, const RepairStep&) = default;
};

struct Repair {
  PolygonSoup soup;                      ///< points of the given soup keep their numbers; new ones follow
  std::vector<std::uint32_t> stands_on;  ///< of each point: which of the given points has its place
  std::vector<std::size_t> face_was;     ///< of each face: its number in the given soup
  std::vector<RepairStep> steps;         ///< in the order of the kinds
};

MESHOPS_API std::string_view name(RepairKind kind);

/// For people: "face dropped: points 3 3 4, face 7".
MESHOPS_API std::string describe(const RepairStep& step);

/// Faces that are degenerate, repeated or out of range are dropped. Of the faces that are connected through edges of two
/// faces as few as possible are reversed, the first one not when it is even. An edge is cut where more than two faces meet,
/// or two that cannot agree on a direction; of these faces only two stay joined that are connected around both ends some
/// other way.
/// Throws: ContractViolation as require_parted(), and when there are 2³⁰ corners, points or faces, or more; Cancelled.
MESHOPS_API Repair repair(const PolygonSoup& soup, const GoOn& go_on = {});

}  // namespace meshops
