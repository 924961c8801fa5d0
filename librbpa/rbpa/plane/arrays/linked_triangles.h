// What: the triangles of patches in canonical order, with their neighbors.
// Law:  the result depends on the triangles, and on nothing else.
// Why:  only the rim of a patch depends on others: it is placed by one thread at a time, and the rest, nearly all, is
//       filled in by any.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/patch/patch.h"
#include "meshops/patch/seams.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_order.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

class LinkedTriangles {
 public:
  static constexpr std::uint32_t none = TriangleArrays::none;

  /// For triangles on so many sites; `names`, less than `bound`, are the names of corners.
  LinkedTriangles(std::size_t sites, std::span<const std::uint32_t> names, std::size_t bound, const Threads& threads);

  /// What one patch has to remember between the steps.
  struct Place {
    std::size_t first = 0;            // the number of its first triangle
    std::vector<int> open;            // its open sides
    std::vector<std::uint8_t> turns;  // of each triangle, which corner comes first
  };
  /// In any thread, before place().
  void prepare(const meshops::Patch& patch, Place& place) const;
  /// One patch after another.
  void place(const meshops::Patch& patch, Place& place);
  /// In any thread, after place().
  void fill(const meshops::Patch& patch, const Place& place);

  /// How many were placed.
  std::size_t size() const { return size_; }
  /// After all patches. Once. Calls `ask`, if any, now and then, one call at a time; it may throw.
  OwnedTriangles sorted(Threads& threads, const std::function<void()>& ask = {});

 private:
  /// An open side that waits for the one beyond: where it ends, and where to write what lies beyond.
  struct Open {
    meshops::Site to;
    std::uint32_t triangle, corner;
  };
  /// The place in the list of neighbors of the one across a side of a triangle.
  static std::size_t across_from(std::size_t side, std::size_t turn) { return (side + 5 - turn) % 3; }

  std::span<const std::uint32_t> names_;
  CanonicalOrder<NumberedTriangle> order_;
  meshops::FreshVector<Triangle> neighbors_;  // by number; longer than what is in use, and not touched there
  meshops::Seams<Open> seams_;
  std::size_t size_ = 0;
};

}  // namespace rbpa
