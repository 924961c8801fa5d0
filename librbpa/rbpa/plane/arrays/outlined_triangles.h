// What: collects the boundary sides of patches while a list collects the triangles.
// Why:  most sides lie inside a patch and are only read. Collecting the boundary therefore takes a fifth of the time of
//       computing the neighbors of all triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "meshops/patch/patch.h"
#include "meshops/patch/seams.h"

namespace rbpa {

/// A list of the triangles of patches, and their boundary. `List` is TriangleList or has the same interface.
template <typename List>
class OutlinedTriangles {
 public:
  /// A directed side, by the names of its points.
  using Side = std::array<std::uint32_t, 2>;

  /// Keeps a reference to an empty list of triangles on `sites` sites, and the span of the sites' numbers in the
  /// result.
  OutlinedTriangles(std::size_t sites, std::span<const std::uint32_t> names, List& list) : names_(names), list_(list) {
    seams_.begin(sites);
  }

  /// The state of one patch between the steps.
  struct Place {
    typename List::Place of_list;
    std::vector<std::array<meshops::Site, 2>> open;  // sides beyond which another patch may have a triangle
    std::vector<Side> outer;
  };
  /// Prepares a patch; called in any thread, before place().
  void prepare(const meshops::Patch& patch, Place& place) const;
  /// Places a patch; called for one patch after another.
  void place(const meshops::Patch& patch, Place& place);
  /// Fills in a patch; called in any thread, after place().
  void fill(const meshops::Patch& patch, const Place& place) { list_.fill(patch, place.of_list); }

  /// Returns the number of triangles placed.
  std::size_t size() const { return list_.size(); }
  /// Returns the boundary sides, in lexicographic order; called after all patches.
  std::vector<Side> boundary() const;

 private:
  /// An open side that waits for the side beyond.
  struct Open {
    meshops::Site to;
    std::size_t number;  // in rim_
  };
  static constexpr Side closed = {0, 0};

  std::span<const std::uint32_t> names_;
  List& list_;
  meshops::Seams<Open> seams_;
  std::vector<Side> outer_, rim_;  // boundary sides; entries of rim_ that meet another patch become `closed`
};

template <typename List>
void OutlinedTriangles<List>::prepare(const meshops::Patch& patch, Place& place) const {
  place.open.clear();
  place.outer.clear();
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      if (patch.across[t][i] >= 0) [[likely]]
        continue;
      const meshops::Site from = patch.triangles[t][i], to = patch.triangles[t][(i + 1) % 3];
      if (patch.across[t][i] == meshops::Patch::open)
        place.open.push_back({from, to});
      else
        place.outer.push_back({names_[from], names_[to]});
    }
}

template <typename List>
void OutlinedTriangles<List>::place(const meshops::Patch& patch, Place& place) {
  list_.place(patch, place.of_list);
  outer_.insert(outer_.end(), place.outer.begin(), place.outer.end());
  for (const auto& [from, to] : place.open) {
    const meshops::Site begin = from;
    if (const auto beyond = seams_.take(to, [&](const Open& other) { return other.to == begin; })) {
      rim_[beyond->number] = closed;
    } else {
      seams_.add(from, {to, rim_.size()});
      rim_.push_back({names_[from], names_[to]});
    }
  }
}

template <typename List>
std::vector<typename OutlinedTriangles<List>::Side> OutlinedTriangles<List>::boundary() const {
  std::vector<Side> sides = outer_;
  std::copy_if(rim_.begin(), rim_.end(), std::back_inserter(sides), [](const Side& side) { return side != closed; });
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace rbpa
