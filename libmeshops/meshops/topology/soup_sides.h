// What: the sides of the faces of a soup, brought together by edge; and the fans that they make of the corners.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/topology/disjoint_sets.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops::detail {

enum class FaceFault : std::uint8_t { none, out_of_range, degenerate, duplicate };

struct FaceFaults {
  std::vector<FaceFault> of;         ///< each face; the first that holds
  std::vector<std::size_t> repeats;  ///< of each face: the earlier face that a duplicate repeats
};

/// Throws ContractViolation when the soup is too large for handles: 2³⁰ corners, points or faces.
FaceFaults find_face_faults(const PolygonSoup& soup);

/// Every corner is a point, every face has three corners or more, and none twice: all that is left to find is
/// duplicates. Throws as above.
bool has_sound_faces(const PolygonSoup& soup);

/// A side runs from the corner at index `corner` of the soup to the next one of its face.
struct SoupSide {
  std::uint32_t low, high;  ///< the points at its ends, in ascending order
  std::uint32_t corner;
  std::uint32_t face;
  bool ascending;  ///< it runs from low to high
};

/// Faces that fit together at an edge: one, or two that run along it in opposite directions.
inline bool fits(std::span<const SoupSide> edge) {
  return edge.size() == 1 || (edge.size() == 2 && edge[0].ascending != edge[1].ascending);
}

/// The sides of the faces that are given, sorted by edge and then by face.
class SoupSides {
 public:
  SoupSides(const PolygonSoup& soup, const FaceFaults& faults);
  /// Of all faces.
  /// Requires: has_sound_faces(soup).
  explicit SoupSides(const PolygonSoup& soup);

  std::size_t edges() const { return begin_.size() - 1; }
  std::span<const SoupSide> edge(std::size_t e) const {
    return std::span(sides_).subspan(begin_[e], begin_[e + 1] - begin_[e]);
  }
  /// The corner of a side at its lower or higher end.
  std::uint32_t corner_at_low(const SoupSide& s) const { return s.ascending ? s.corner : next_corner(s); }
  std::uint32_t corner_at_high(const SoupSide& s) const { return s.ascending ? next_corner(s) : s.corner; }

 private:
  template <typename IsGiven>
  void bring_together(IsGiven is_given);
  std::uint32_t next_corner(const SoupSide& s) const;

  const PolygonSoup& soup_;
  std::vector<SoupSide> sides_;
  std::vector<std::size_t> begin_;
};

/// No edge has more than two sides, and two run in opposite directions and belong to faces with different corners.
/// Requires: the sides of all faces of the soup.
bool is_manifold(const PolygonSoup& soup, const SoupSides& sides);

/// How corners hang together to fans around points. The sides at an edge join corners when `joins(sides)`.
template <typename Joins>
DisjointSets fans_of(const PolygonSoup& soup, const SoupSides& sides, Joins joins) {
  DisjointSets fans(soup.corners.size());
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    if (!joins(edge)) continue;
    for (const SoupSide& side : edge.subspan(1)) {
      fans.unite(sides.corner_at_low(edge[0]), sides.corner_at_low(side));
      fans.unite(sides.corner_at_high(edge[0]), sides.corner_at_high(side));
    }
  }
  return fans;
}

/// How faces hang together through edges of exactly two faces; faces of odd parity must be reversed for all to agree.
/// Calls disagree(sides) where no reversing helps.
template <typename Disagree>
DisjointSets pieces_of(const PolygonSoup& soup, const SoupSides& sides, Disagree disagree) {
  DisjointSets pieces(soup.faces());
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    if (edge.size() == 2 && !pieces.unite(edge[0].face, edge[1].face, edge[0].ascending == edge[1].ascending))
      disagree(edge);
  }
  return pieces;
}

}  // namespace meshops::detail
