// What: the triangles of patches in canonical order, with the sides at which nothing lies.
// Why:  a fifth of what all neighbours cost: most sides lie inside a patch, and are only looked at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/patch/patch.h"
#include "meshops/patch/seams.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/arrays/triangle_list.h"

namespace rbpa {

class OutlinedTriangles {
 public:
  /// From one point to another, by name.
  using Side = std::array<std::uint32_t, 2>;

  /// For triangles on so many sites; `names`, less than `bound`, are the names of corners.
  OutlinedTriangles(std::size_t sites, std::span<const std::uint32_t> names, std::size_t bound, const Threads& threads)
      : names_(names), list_(sites, names, bound, threads) {
    seams_.begin(sites);
  }

  /// What one patch has to remember between the steps.
  struct Place {
    TriangleList::Place of_list;
    std::vector<std::array<meshops::Site, 2>> open;  // sides beyond which another patch may have a triangle
    std::vector<Side> outer;
  };
  /// In any thread, before place().
  void prepare(const meshops::Patch& patch, Place& place) const;
  /// One patch after another.
  void place(const meshops::Patch& patch, Place& place);
  /// In any thread, after place().
  void fill(const meshops::Patch& patch, const Place& place) { list_.fill(patch, place.of_list); }

  /// How many were placed.
  std::size_t size() const { return list_.size(); }
  /// After all patches. Once. Calls `ask`, if any, now and then, one call at a time; it may throw.
  std::vector<Triangle> sorted(Threads& threads, const std::function<void()>& ask = {}) {
    return list_.sorted(threads, ask);
  }
  /// After all patches: the sides at which no triangle lies, in lexicographic order.
  std::vector<Side> boundary() const;

 private:
  /// An open side that waits for the one beyond.
  struct Open {
    meshops::Site to;
    std::size_t number;  // in rim_
  };
  static constexpr Side closed = {0, 0};

  std::span<const std::uint32_t> names_;
  TriangleList list_;
  meshops::Seams<Open> seams_;
  std::vector<Side> outer_, rim_;  // of those in rim_ some are closed
};

}  // namespace rbpa
