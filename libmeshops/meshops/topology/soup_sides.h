// What: the sides of the faces of a soup, grouped by edge, and the fans that corners form through these sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/core/fresh_vector.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops::detail {

/// Fault of a face; SoupDefectKind (soup_defects.h) explains the kinds. A duplicate may run in either direction.
enum class FaceFault : std::uint8_t { none, out_of_range, degenerate, duplicate };

struct FaceFaults {
  std::vector<FaceFault> of;         ///< for each face, its first fault in the order of FaceFault
  std::vector<std::size_t> repeats;  ///< by face: for a duplicate, the first face with its cycle; or empty
  /// By face: for a face of a wall, the face on its other side, otherwise `none`; empty if there is no wall.
  std::vector<std::uint32_t> twin = {};
  static constexpr std::uint32_t none = 0xffffffff;
};

/// Finds the faults of all faces. Throws: ContractViolation as require_parted() does, or for 2³⁰ or more corners,
/// points or faces, which are too many for handles; Cancelled.
FaceFaults find_face_faults(const PolygonSoup& soup, const GoOn& go_on);

/// Finds walls, and removes the faults of their faces. A wall is made of pairs of faces with the same corners in
/// opposite directions. At each of its edges four sides meet, two in each direction, so that the wall separates two
/// surfaces.
/// Requires: `faults` is find_face_faults(soup); not checked. Throws Cancelled.
void keep_walls(const PolygonSoup& soup, FaceFaults& faults, const GoOn& go_on);

/// Returns whether every corner is a point, and every face has three or more corners, all distinct. The only fault that
/// a face can still have is that it is a duplicate. Throws what find_face_faults() throws.
bool has_sound_faces(const PolygonSoup& soup, const GoOn& go_on);

/// Side of a face, from the corner at index `corner` of the soup to the corner at index `next`.
class SoupSide {
 public:
  SoupSide() = default;
  SoupSide(std::uint32_t low_point, std::uint32_t high_point, std::uint32_t first_corner, std::uint32_t next_corner,
           std::uint32_t of_face, bool is_ascending)
      : low(low_point),
        high(high_point),
        corner(first_corner),
        next(next_corner),
        face_(2 * of_face + (is_ascending ? 1U : 0U)) {}

  std::uint32_t low, high;  ///< the points at the ends of the side, in ascending order
  std::uint32_t corner, next;

  std::uint32_t face() const { return face_ >> 1U; }
  bool ascending() const { return (face_ & 1U) != 0; }  ///< whether the side runs from `low` to `high`
  std::uint32_t corner_at_low() const { return ascending() ? corner : next; }
  std::uint32_t corner_at_high() const { return ascending() ? next : corner; }

 private:
  std::uint32_t face_;  // twice the face, plus 1 if the side is ascending, to save memory
};

/// Returns whether the faces at an edge fit together: one face, or two faces that run along it in opposite directions.
inline bool fits(std::span<const SoupSide> edge) {
  return edge.size() == 1 || (edge.size() == 2 && edge[0].ascending() != edge[1].ascending());
}

/// Returns the two pairs of sides that belong to the same surface at an edge: of the four sides, those of a face of a
/// wall and of a face that runs along the edge in the other direction and is not its twin. Returns nothing if there is
/// no such face, or not two sides run in each direction.
std::optional<std::array<std::array<SoupSide, 2>, 2>> sides_of_wall(std::span<const SoupSide> edge,
                                                                    const std::vector<std::uint32_t>& twin);

/// Sides of faces, sorted by edge and then by face.
class SoupSides {
 public:
  /// Collects the sides of the faces without a fault. Throws Cancelled.
  /// Requires: `faults` is find_face_faults(soup); not checked.
  SoupSides(const PolygonSoup& soup, const FaceFaults& faults, const GoOn& go_on);
  /// Collects the sides of all faces. Throws Cancelled.
  /// Requires: has_sound_faces(soup); not checked.
  SoupSides(const PolygonSoup& soup, const GoOn& go_on);

  std::size_t edges() const { return begin_.size() - 1; }
  std::span<const SoupSide> edge(std::size_t e) const {
    return std::span(sides_).subspan(begin_[e], begin_[e + 1] - begin_[e]);
  }

 private:
  template <typename IsGiven>
  void bring_together(const PolygonSoup& soup, IsGiven is_given, const GoOn& go_on);

  FreshVector<SoupSide> sides_;
  FreshVector<std::uint32_t> begin_;
};

/// Returns whether every edge has one side, or two sides that run in opposite directions and belong to faces that are
/// not duplicates. Several fans may stand on a point.
/// Requires: `sides` has the sides of all faces of `soup`; not checked. Throws Cancelled.
bool is_manifold(const PolygonSoup& soup, const SoupSides& sides, const GoOn& go_on);

/// Returns the fans that corners form around points, as sets of indices of corners. All sides at an edge join their
/// corners if joins(sides) returns true. Throws Cancelled.
template <typename Joins>
DisjointSets fans_of(const PolygonSoup& soup, const SoupSides& sides, Joins joins, const GoOn& go_on) {
  DisjointSets fans(soup.corners.size());
  Steps step(go_on);
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    step();
    if (!joins(edge)) continue;
    for (const SoupSide& side : edge.subspan(1)) {
      step();
      fans.unite(edge[0].corner_at_low(), side.corner_at_low());
      fans.unite(edge[0].corner_at_high(), side.corner_at_high());
    }
  }
  return fans;
}

/// Returns the sets of faces that are connected through edges of exactly two faces. If the faces of odd parity are
/// reversed, all faces agree, except at edges for which disagree(sides) is called. Throws Cancelled.
template <typename Disagree>
DisjointSets pieces_of(const PolygonSoup& soup, const SoupSides& sides, Disagree disagree, const GoOn& go_on) {
  DisjointSets pieces(soup.faces());
  Steps step(go_on);
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    step();
    if (edge.size() == 2 && !pieces.unite(edge[0].face(), edge[1].face(), edge[0].ascending() == edge[1].ascending()))
      disagree(edge);
  }
  return pieces;
}

}  // namespace meshops::detail
