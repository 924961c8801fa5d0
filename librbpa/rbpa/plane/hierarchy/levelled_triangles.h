// What: collects the triangles of patches in canonical order, with the level of each.
// Why:  levels are computed while a patch is filled in, as the patch and its points are then in a cache; later, each
//       triangle would have to fetch three points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_order.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/hierarchy/site_levels.h"

namespace rbpa {

class LevelledTriangles {
 public:
  /// Keeps references, which sorted() does not use. The corners in the result are input indices, less than `bound`.
  LevelledTriangles(const Sites& sites, const Ladder& ladder, std::size_t bound, const Threads& threads)
      : sites_(sites), levels_(sites, ladder), order_(bound, 2 * sites.size(), threads.count()) {}

  /// The interface of TriangleList.
  struct Place {};
  void prepare(const meshops::Patch&, Place&) const {}
  void place(const meshops::Patch& patch, Place&) { size_ += patch.triangles.size(); }
  void fill(const meshops::Patch& patch, const Place&) {
    order_.with_writer([&](CanonicalOrder<NumberedTriangle>::Writer& writer) {
      auto sites = patch.triangles.begin();
      for_each_triangle(patch, sites_.input_index(), [&](const Triangle& triple) {
        writer.add({triple, static_cast<std::uint32_t>(levels_.of(*sites++))});
      });
    });
  }

  std::size_t size() const { return size_; }
  /// Returns the triangles in order; called once, after all patches. `numbers` becomes the levels of the triangles, in
  /// the same order. Calls `checkpoint`, if any, repeatedly, one call at a time; `checkpoint` may throw.
  std::vector<Triangle> sorted(Threads& threads, meshops::FreshVector<std::uint32_t>& numbers,
                               const Checkpoint& checkpoint = {}) {
    numbers.resize(size_);
    return order_.sorted_with_numbers(threads, numbers.data(), checkpoint);
  }

 private:
  const Sites& sites_;
  SiteLevels levels_;
  CanonicalOrder<NumberedTriangle> order_;
  std::size_t size_ = 0;
};

}  // namespace rbpa
