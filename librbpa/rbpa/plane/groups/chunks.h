// What: divides groups into chunks, each of which is work for one thread.
// Law:  chunks depend on the groups alone, not on the threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/plane/groups.h"

namespace rbpa {

struct Chunk {
  std::size_t first = 0, last = 0;  // groups first ≤ g < last
};

/// Returns runs of consecutive groups: at most 1,024 groups with at most 4,096 points together, or one larger group.
inline std::vector<Chunk> chunks_of(const Groups& groups) {
  constexpr std::uint64_t enough = 4096;
  std::vector<Chunk> chunks;
  for (std::size_t first = 0; first < groups.size();) {
    std::size_t last = first + 1;
    while (last < groups.size() && last - first < 1024 && groups.offsets[last + 1] - groups.offsets[first] <= enough)
      ++last;
    chunks.push_back({first, last});
    first = last;
  }
  return chunks;
}

/// Checks that `groups` are valid Groups of these points. Throws: InvalidInput as for_each_group().
void check(std::span<const Point> points, const Groups& groups);

/// Memory for the points of one group, which the next call of of() replaces.
class GroupPoints {
 public:
  Group of(std::span<const Point> points, const Groups& groups, std::size_t number) {
    const std::span<const std::uint32_t> members = groups[number];
    side_by_side_.clear();
    for (const std::uint32_t i : members) side_by_side_.push_back(points[i]);
    return {number, side_by_side_, members};
  }

 private:
  std::vector<Point> side_by_side_;
};

}  // namespace rbpa
