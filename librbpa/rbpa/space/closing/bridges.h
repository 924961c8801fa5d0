// What: pairs of edges of two boundary loops between which a strip of two triangles may join the loops to one.
// Law:  a function of the points along the loops, not of where they begin.
// Cost: the product of their edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/closing/work.h"

namespace rbpa::space {

/// An edge of each loop, by its first corner.
struct Bridge {
  std::uint32_t edge, other;
};

/// Those whose corners are nearest to each other, the best first, at most so many. Loops have the hole to their left. None where
/// the work is over before all were compared.
std::vector<Bridge> nearest_bridges(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                    std::span<const std::uint32_t> other, std::size_t most, Work& work);

/// The two triangles of a strip.
std::array<std::array<std::uint32_t, 3>, 2> strip_of(const Bridge& bridge, std::span<const std::uint32_t> loop,
                                                     std::span<const std::uint32_t> other);

/// The boundary of the hole without the strip: one loop.
std::vector<std::uint32_t> joined_loop(const Bridge& bridge, std::span<const std::uint32_t> loop,
                                       std::span<const std::uint32_t> other);

}  // namespace rbpa::space
