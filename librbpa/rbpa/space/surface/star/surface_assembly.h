// What: makes arrays of triangles and neighbors, in canonical order, from the rings of all sites.
// Law:  each triangle is read from the ring of its corner with the lowest input index, its neighbors from the rings of
//       that corner and of the next one.
// Cost: linear; for each triangle a few short searches in the rings of its corners, which are near in memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/surface/star/find_rings.h"

namespace rbpa::space {

class SurfaceAssembly {
 public:
  using Triple = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t none = 0xffffffff;  // the value for no neighbor
  static constexpr std::size_t part_size = 256;      // number of sites; few, so that cancelling takes effect soon

  /// A triangle (v, x, y) that v owns: the ball rolls about x to (v, after, x), and about y to (v, y, before).
  struct Owned {
    Site x, y, before, after;
  };
  struct Part {
    std::vector<Site> points;                // the needed rings, as in Rings
    std::vector<std::uint32_t> first;        // for each site: the position of its rings in points; and the end
    std::vector<Owned> owned;                // triangles (v, x, y) in which v has the lowest index, in canonical order
    std::vector<std::uint32_t> owned_first;  // for each site: the position of its triangles in owned; and the end
  };

  /// Keeps a reference to the cells.
  explicit SurfaceAssembly(const Cells& cells)
      : cells_(cells), parts_((cells.sites().size() + part_size - 1) / part_size) {}

  std::size_t parts() const { return parts_.size(); }
  Site first_in(std::size_t part) const { return static_cast<Site>(part * part_size); }
  Site end_of(std::size_t part) const {
    return static_cast<Site>(std::min((part + 1) * part_size, cells_.sites().size()));
  }

  /// Adds the triangles of a part for which keep(v, x, y) returns true; keep() is called once for each triangle. Stores
  /// the cycles for which is_needed(v, cycle) returns true, which it must if a triangle of the cycle is kept. Parts may
  /// be added in any order, by any thread. `scratch` is overwritten; each thread has its own, so that long-lived memory
  /// is not fragmented. Returns the number of triangles added.
  template <typename Keep, typename IsNeeded>
  std::size_t add(std::size_t part, const Rings& rings, Keep keep, IsNeeded is_needed, Part& scratch);

  /// Fills in all triangles and their neighbors. Requires: all parts have been added; there were `input_points` points.
  /// Throws: InvalidInput when there are too many triangles for 32 bits.
  void finish(std::size_t input_points, Threads& threads, std::vector<Triple>& triangles,
              std::vector<Triple>& neighbors) const;

 private:
  const Cells& cells_;
  std::vector<Part> parts_;
};

template <typename Keep, typename IsNeeded>
std::size_t SurfaceAssembly::add(std::size_t number, const Rings& rings, Keep keep, IsNeeded is_needed, Part& part) {
  part.points.clear();
  part.first.clear();
  part.owned.clear();
  part.owned_first.clear();
  const std::span<const std::uint32_t> index = cells_.input_index();
  for (Site v = first_in(number); v < end_of(number); ++v) {
    part.first.push_back(static_cast<std::uint32_t>(part.points.size()));
    const std::size_t owned_before = part.owned.size();
    part.owned_first.push_back(static_cast<std::uint32_t>(owned_before));
    const std::size_t i = v - first_in(number);
    const Site* cycle = rings.points.data() + rings.first[i];
    const Site* const end = rings.points.data() + rings.first[i + 1];
    while (cycle != end) {
      const Site* last = cycle;
      while (*last != Rings::end_of_cycle) ++last;
      const std::span<const Site> sites(cycle, last);
      if (is_needed(v, sites)) {
        const std::size_t size = sites.size();
        for (std::size_t k = 0; k < size; ++k) {
          const Site x = sites[k], y = sites[k == 0 ? size - 1 : k - 1];
          if (index[v] < index[x] && index[v] < index[y] && keep(v, x, y))
            part.owned.push_back({x, y, sites[k < 2 ? k + size - 2 : k - 2], sites[k + 1 == size ? 0 : k + 1]});
        }
        part.points.insert(part.points.end(), cycle, last + 1);
      }
      cycle = last + 1;
    }
    std::sort(
        part.owned.begin() + static_cast<std::ptrdiff_t>(owned_before), part.owned.end(),
        [&](const Owned& p, const Owned& q) { return p.x != q.x ? index[p.x] < index[q.x] : index[p.y] < index[q.y]; });
  }
  part.first.push_back(static_cast<std::uint32_t>(part.points.size()));
  part.owned_first.push_back(static_cast<std::uint32_t>(part.owned.size()));
  parts_[number] = part;
  return parts_[number].owned.size();
}

}  // namespace rbpa::space
