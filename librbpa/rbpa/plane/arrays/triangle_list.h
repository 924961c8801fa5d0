// What: collects the triangles of patches in canonical order.
// Why:  as with a mesh (meshops/patch/assembler.h), one thread at a time places patches, and any thread fills them in.
//       A list does not link patches, so placing a patch only counts its triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_order.h"

namespace rbpa {

class TriangleList {
 public:
  /// Prepares for triangles on `sites` sites. names[s] < bound is the number of site s in the result. Keeps the span.
  TriangleList(std::size_t sites, std::span<const std::uint32_t> names, std::size_t bound, const Threads& threads)
      : names_(names), order_(bound, 2 * sites, threads.count()) {}

  /// The state of one patch between the steps.
  struct Place {};
  /// Prepares a patch; called in any thread, before place().
  void prepare(const meshops::Patch&, Place&) const {}
  /// Places a patch; called for one patch after another.
  void place(const meshops::Patch& patch, Place&) { size_ += patch.triangles.size(); }
  /// Fills in a patch; called in any thread, after place().
  void fill(const meshops::Patch& patch, const Place&) {
    order_.with_writer([&](CanonicalOrder<Triangle>::Writer& writer) {
      for_each_triangle(patch, names_, [&](const Triangle& triple) { writer.add(triple); });
    });
  }

  /// Returns the number of triangles placed.
  std::size_t size() const { return size_; }
  /// Returns the triangles in order; called once, after all patches. Calls `checkpoint`, if any, repeatedly, one call
  /// at a time; `checkpoint` may throw.
  std::vector<Triangle> sorted(Threads& threads, const Checkpoint& checkpoint = {}) {
    return order_.sorted(threads, checkpoint);
  }

 private:
  std::span<const std::uint32_t> names_;
  CanonicalOrder<Triangle> order_;
  std::size_t size_ = 0;
};

}  // namespace rbpa
