// What: the triangles of patches in one list, from the smallest corner on, and which lies across of which.
// Law:  the list depends on the order in which patches are placed, and on nothing else.
// Why:  as with a mesh (meshops/patch/assembler.h), only the rim of a patch has to do with others: it is placed by one
//       thread at a time, and what is left, nearly all, is filled in by any.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/patch/patch.h"
#include "meshops/patch/seams.h"

namespace rbpa {

class TriangleList {
 public:
  using Triple = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t none = 0xffffffff;

  /// For triangles on so many sites, at least one; `names` are what corners are called. Neighbours are found if asked for.
  TriangleList(std::size_t sites, std::span<const std::uint32_t> names, bool with_neighbors);

  std::size_t size() const { return size_; }

  /// What one patch has to remember between the steps.
  struct Place {
    std::size_t first = 0;            // the number of its first triangle
    std::vector<int> open;            // its open sides
    std::vector<std::uint8_t> turns;  // of each triangle, which corner comes first; only with neighbours
  };
  /// In any thread, before place().
  void prepare(const meshops::Patch& patch, Place& place) const;
  /// One patch after another.
  void place(const meshops::Patch& patch, Place& place);
  /// In any thread, after place().
  void fill(const meshops::Patch& patch, const Place& place);

  /// After all patches: the triangles and, with neighbours, of each the numbers of those across from its corners. Frees
  /// the rest.
  struct Lists {
    meshops::FreshVector<Triple> triangles, neighbors;
  };
  Lists take();

 private:
  /// An open side that waits for the one beyond: where it ends, and where to write what lies beyond.
  struct Open {
    meshops::Site to;
    std::uint32_t triangle, corner;
  };
  /// Where in the list of neighbours what lies across a side of a triangle belongs.
  static std::size_t across_from(std::size_t side, std::size_t turn) { return (side + 5 - turn) % 3; }

  std::span<const std::uint32_t> names_;
  bool with_neighbors_;
  std::size_t size_ = 0;
  Lists lists_;  // longer than what is in use, and not touched there
  meshops::Seams<Open> seams_;
};

}  // namespace rbpa
