// What: collects the triangles of patches in canonical order, with their neighbors.
// Law:  the result depends on the triangles only.
// Why:  only the rim of a patch depends on other patches: one thread at a time places the rim. Any thread fills in the
//       rest of the patch, which is nearly all.
#pragma once

#include <cstddef>
#include <cstdint>
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

  /// Prepares for triangles on `sites` sites. names[s] < bound is the number of site s in the result. Keeps the span.
  LinkedTriangles(std::size_t sites, std::span<const std::uint32_t> names, std::size_t bound, const Threads& threads);

  /// The state of one patch between the steps.
  struct Place {
    std::size_t first = 0;            // number of the patch's first triangle
    std::vector<int> open;            // open sides of the patch
    std::vector<std::uint8_t> turns;  // for each triangle, the corner that comes first
  };
  /// Prepares a patch; called in any thread, before place().
  void prepare(const meshops::Patch& patch, Place& place) const;
  /// Places a patch; called for one patch after another.
  void place(const meshops::Patch& patch, Place& place);
  /// Fills in a patch; called in any thread, after place().
  void fill(const meshops::Patch& patch, const Place& place);

  /// Returns the number of triangles placed.
  std::size_t size() const { return size_; }
  /// Returns the triangles; called once, after all patches. Calls `checkpoint`, if any, repeatedly, one call at a time;
  /// `checkpoint` may throw.
  OwnedTriangles sorted(Threads& threads, const Checkpoint& checkpoint = {});

 private:
  /// An open side that waits for the side beyond: the site at its end, and its entry in neighbors_.
  struct Open {
    meshops::Site to;
    std::uint32_t triangle, corner;
  };
  /// Returns which entry of a triangle's neighbors belongs to a side, if corner `turn` of the triangle comes first.
  static std::size_t across_from(std::size_t side, std::size_t turn) { return (side + 5 - turn) % 3; }

  std::span<const std::uint32_t> names_;
  CanonicalOrder<NumberedTriangle> order_;
  meshops::FreshVector<Triangle> neighbors_;  // by number; longer than the part in use, and untouched beyond it
  meshops::Seams<Open> seams_;
  std::size_t size_ = 0;
};

}  // namespace rbpa
