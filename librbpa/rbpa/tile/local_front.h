// What: triangles of a tile and the front around them, in 16 bits a number.
// Law:  a side of a triangle is glued as soon as the triangle across it is there.
// Why:  an advancing front on a tile needs neither vertices nor curves: fans on one point are told apart when the
//       triangles come to the mesh. It stays in the fastest cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rbpa {

class LocalFront {
 public:
  using Index = std::uint16_t;
  static constexpr Index none = 0xffff;

  /// Begins without a triangle, on at most 10,000 points.
  void begin(std::size_t points) {
    head_.assign(points, none);
    touched_.assign(points, 0);
    if (corner_.size() < 6 * points + 3) {
      corner_.resize(6 * points + 3);
      across_.resize(6 * points + 3);
      link_.resize(6 * points + 3);
    }
    sides_ = 0;
  }

  /// Side 3 t + i of triangle t runs from its corner i to corner i + 1.
  std::size_t sides() const { return sides_; }
  Index from(std::size_t side) const { return corner_[side]; }
  Index to(std::size_t side) const { return corner_[side % 3 == 2 ? side - 2 : side + 1]; }
  /// The side beyond, or none when it is on the front.
  Index across(std::size_t side) const { return across_[side]; }

  /// A triangle has a corner on the point.
  bool is_touched(std::size_t point) const { return touched_[point] != 0; }
  /// A side on the front ends at the point.
  bool is_on_front(std::size_t point) const { return head_[point] != none; }

  /// A triangle beside all others. Calls added(side) for each of its sides that is on the front then.
  template <typename Added>
  void create(Index a, Index b, Index c, Added added) {
    const Index s = next_triangle(a, b, c);
    glue_or_add(s, a, b, added);
    glue_or_add(static_cast<Index>(s + 1), b, c, added);
    glue_or_add(static_cast<Index>(s + 2), c, a, added);
    touched_[a] = touched_[b] = touched_[c] = 1;
  }

  /// A triangle across a side on the front, which runs from b to a.
  template <typename Added>
  void attach(Index side, Index a, Index b, Index c, Added added) {
    const Index s = next_triangle(a, b, c);
    glue(s, side);
    take_from_front(a, side);
    glue_or_add(static_cast<Index>(s + 1), b, c, added);
    glue_or_add(static_cast<Index>(s + 2), c, a, added);
    touched_[c] = 1;
  }

 private:
  Index next_triangle(Index a, Index b, Index c) {
    const auto s = static_cast<Index>(sides_);
    sides_ += 3;
    corner_[s] = a;
    corner_[s + 1u] = b;
    corner_[s + 2u] = c;
    return s;
  }
  void glue(Index s, Index other) {
    across_[s] = other;
    across_[other] = s;
  }
  template <typename Added>
  void glue_or_add(Index s, Index from, Index to, Added added) {
    // Across lies a side that runs from `to` to `from`: it is listed where it ends.
    for (Index f = head_[from]; f != none; f = link_[f]) {
      if (corner_[f] != to) continue;
      glue(s, f);
      take_from_front(from, f);
      return;
    }
    across_[s] = none;
    link_[s] = head_[to];
    head_[to] = s;
    added(s);
  }
  void take_from_front(Index point, Index side) {
    Index* at = &head_[point];
    while (*at != side) at = &link_[*at];
    *at = link_[side];
  }

  std::vector<Index> head_;  // of each point, the first side on the front that ends there
  std::vector<Index> link_;  // of a side on the front, the next that ends at the same point
  std::vector<Index> corner_, across_;
  std::vector<std::uint8_t> touched_;
  std::size_t sides_ = 0;
};

}  // namespace rbpa
