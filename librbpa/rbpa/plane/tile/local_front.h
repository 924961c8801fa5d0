// What: triangles of a tile and the front around them, in 16 bits a number.
// Law:  a side of a triangle is glued as soon as the triangle across the side exists.
// Why:  an advancing front on a tile needs neither vertices nor curves: fans on one point are separated when the
//       triangles are added to the mesh. The front stays in the fastest cache, and no branch is unpredictable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rbpa {

class LocalFront {
 public:
  using Index = std::uint16_t;
  static constexpr Index none = 0;            ///< no side: sides of triangles are numbered from 4 on
  static constexpr Index nothing = 1;         ///< no side, and none will be added
  static constexpr std::size_t padding = 16;  ///< triangles that can be read after the last

  /// Removes all triangles, and makes room for `points` points and 2 · points + 1 triangles; to add more is undefined,
  /// and not checked. Requires: points ≤ Tile::max_points.
  void begin(std::size_t points) {
    head_.assign(points, none);
    touched_.assign(points, 0);
    if (const std::size_t sides = 4 * (2 * points + 2 + padding); corner_.size() < sides)
      for (auto* of_side : {&corner_, &across_, &link_}) of_side->resize(sides);
    corner_[none] = no_point;
    link_[none] = none;
    triangles_ = 1;
  }

  /// Returns one more than the number of triangles: triangles are numbered from 1 on.
  std::size_t triangles() const { return triangles_; }
  /// Returns the ends of a side. Side 4 t + i of triangle t runs from its corner i to the next.
  Index from(std::size_t side) const { return corner_[side]; }
  Index to(std::size_t side) const { return corner_[side + 1]; }
  /// Returns from() of all sides.
  const Index* corners() const { return corner_.data(); }
  /// Returns the side across; `none` if `side` is on the front, `nothing` if seal() took `side` from the front.
  Index across(std::size_t side) const { return across_[side]; }

  /// Returns whether a triangle has a corner on the point, or the point was sealed.
  bool is_touched(std::size_t point) const { return touched_[point] != 0; }
  /// Returns whether a side on the front ends at the point.
  bool is_on_front(std::size_t point) const { return head_[point] != none; }

  /// Adds triangle (a, b, c), and glues its sides where they meet the front. Calls added(side, is on the front) for
  /// each side. Requires: a, b, c are counter-clockwise; no triangle has the side a→b, b→c or c→a yet; not sealed.
  template <typename Added>
  void create(Index a, Index b, Index c, Added added) {
    const Index s = next_triangle(a, b, c);
    glue_or_add(s, a, b, added);
    glue_or_add(static_cast<Index>(s + 1), b, c, added);
    glue_or_add(static_cast<Index>(s + 2), c, a, added);
    touched_[a] = touched_[b] = touched_[c] = 1;
  }

  /// Adds triangle (a, b, c) across `side`, which is on the front and runs from b to a. Calls added() for the sides b→c
  /// and c→a. Requires: what create() requires.
  template <typename Added>
  void attach(Index side, Index a, Index b, Index c, Added added) {
    const Index s = next_triangle(a, b, c);
    glue(s, side);
    take_from_front(a, side);
    glue_or_add(static_cast<Index>(s + 1), b, c, added);
    glue_or_add(static_cast<Index>(s + 2), c, a, added);
    touched_[c] = 1;
  }

  /// Seals the marked points, at which there is no further triangle: marked points become touched, and all sides at
  /// them leave the front. Afterwards is_touched() and is_on_front() are meaningless for other points, and begin() is
  /// the only change allowed.
  /// Requires: `marked` has 0 or 1 for each point.
  void seal(const std::vector<std::uint8_t>& marked) {
    for (std::size_t v = 0; v < head_.size(); ++v) {
      head_[v] = marked[v] ? none : head_[v];
      touched_[v] |= marked[v];
    }
    for (std::size_t t = 1; t < triangles_; ++t)
      for (std::size_t s = 4 * t; s < 4 * t + 3; ++s) {
        const int is_free = across_[s] == none;
        across_[s] = static_cast<Index>(across_[s] | (is_free & (marked[from(s)] | marked[to(s)])) * nothing);
      }
  }

 private:
  static constexpr Index no_point = 0xffff;

  Index next_triangle(Index a, Index b, Index c) {
    const auto s = static_cast<Index>(4 * triangles_++);
    corner_[s] = a;
    corner_[s + 1u] = b;
    corner_[s + 2u] = c;
    corner_[s + 3u] = a;
    return s;
  }
  void glue(Index s, Index other) {
    across_[s] = other;
    across_[other] = s;
  }
  /// Glues side s, which runs between two points, to the opposite side on the front, or adds s to the front if there is
  /// no such side. A branch would be mispredicted often: both results are computed instead, and one has no effect.
  template <typename Added>
  void glue_or_add(Index s, Index from, Index to, Added added) {
    // The side across runs from `to` to `from`: it is listed at the point where it ends.
    Index* at = &head_[from];
    while (link_[*at] != none && corner_[*at] != to) at = &link_[*at];
    const Index f = *at;
    const bool found = corner_[f] == to;
    const auto all = static_cast<Index>(-static_cast<int>(found));  // bits, or none of them: no branch is needed
    const Index head = head_[to];
    across_[s] = f & all;
    across_[f & all] = s;
    *at = either(link_[f], f, all);
    link_[s] = head;
    head_[to] = either(head, s, all);
    added(s, !found);
  }
  static Index either(Index a, Index b, Index bits_of_a) { return static_cast<Index>(b ^ ((a ^ b) & bits_of_a)); }
  void take_from_front(Index point, Index side) {
    Index* at = &head_[point];
    while (*at != side) at = &link_[*at];
    *at = link_[side];
  }

  std::vector<Index> head_;             // for each point, the first side on the front that ends there
  std::vector<Index> link_;             // for each side on the front, the next side that ends at the same point
  std::vector<Index> corner_, across_;  // a triangle's first corner is repeated after its last
  // 16 bits wide: the compiler assumes that a write of bytes may change the other arrays, and would read these again
  std::vector<Index> touched_;
  std::size_t triangles_ = 1;
};

}  // namespace rbpa
