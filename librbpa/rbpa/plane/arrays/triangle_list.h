// What: the triangles of patches in canonical order.
// Why:  as with a mesh (meshops/patch/assembler.h), patches are placed by one thread at a time, and filled in by any. But
//       nothing here depends on other patches, so that placing one only counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_order.h"

namespace rbpa {

class TriangleList {
 public:
  /// For triangles on so many sites; `names`, less than `bound`, are the names of corners.
  TriangleList(std::size_t sites, std::span<const std::uint32_t> names, std::size_t bound, const Threads& threads)
      : names_(names), order_(bound, 2 * sites, threads.count()) {}

  /// What one patch has to remember between the steps.
  struct Place {};
  /// In any thread, before place().
  void prepare(const meshops::Patch&, Place&) const {}
  /// One patch after another.
  void place(const meshops::Patch& patch, Place&) { size_ += patch.triangles.size(); }
  /// In any thread, after place().
  void fill(const meshops::Patch& patch, const Place&) {
    order_.with_writer([&](CanonicalOrder<Triangle>::Writer& writer) {
      for_each_triangle(patch, names_, [&](const Triangle& triple) { writer.add(triple); });
    });
  }

  /// How many were placed.
  std::size_t size() const { return size_; }
  /// After all patches. Once. Calls `ask`, if any, now and then, one call at a time; it may throw.
  std::vector<Triangle> sorted(Threads& threads, const std::function<void()>& ask = {}) {
    return order_.sorted(threads, nullptr, ask);
  }

 private:
  std::span<const std::uint32_t> names_;
  CanonicalOrder<Triangle> order_;
  std::size_t size_ = 0;
};

}  // namespace rbpa
