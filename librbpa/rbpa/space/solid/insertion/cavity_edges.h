// What: finds neighbors among the tetrahedra that fill a cavity: pairs whose outer faces share an edge.
// How:  a table from directed edges to faces. Each of the two tetrahedra at an edge writes the entry of its own
//       direction of the edge, and later reads the entry of the opposite direction. Only the hash table is cleared.
//
//           write  (a, b) → the face across from c       read  (b, a)
//
// Cost: a store and a load for each directed edge; with more than 128 vertices, two accesses to a hash table.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/space/solid/insertion/tetrahedra.h"

namespace rbpa::space {

class CavityEdges {
 public:
  /// Prepares for vertices numbered below `vertices`, and for `faces` faces. Requires: afterwards, every edge is
  /// written before the first edge is read.
  void begin(std::size_t vertices, std::size_t faces) {
    is_small_ = vertices <= width;
    if (is_small_) return;
    const std::size_t size = std::bit_ceil(6 * faces);
    shift_ = 64 - std::countr_zero(size);
    mask_ = size - 1;
    hashed_.assign(size, Entry{});
  }

  bool is_small() const { return is_small_; }
  /// Returns the entry of an edge in the small table. Requires: is_small().
  Face& in_table(std::uint32_t from, std::uint32_t to) { return table_[from * width + to]; }

  void put(std::uint32_t from, std::uint32_t to, Face face) {
    if (is_small_)
      in_table(from, to) = face;
    else
      find(from, to) = {from, to, face};
  }
  Face get(std::uint32_t from, std::uint32_t to) { return is_small_ ? in_table(from, to) : find(from, to).face; }

 private:
  static constexpr std::uint32_t width = 128, none = 0xffffffff;
  struct Entry {
    std::uint32_t from = none, to = none;
    Face face = none;
  };

  Entry& find(std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = std::uint64_t{from} << 32U | to;
    std::size_t at = key * 0x9e3779b97f4a7c15U >> shift_;  // the high bits, which depend on all bits of the key
    while (hashed_[at].from != none && (hashed_[at].from != from || hashed_[at].to != to)) at = (at + 1) & mask_;
    return hashed_[at];
  }

  std::vector<Face> table_ = std::vector<Face>(std::size_t{width} * width);
  std::vector<Entry> hashed_;
  std::size_t mask_ = 0;
  int shift_ = 0;
  bool is_small_ = true;
};

}  // namespace rbpa::space
