// What: finds bridges: pairs of edges of two boundary loops, which a strip of two triangles between the edges joins.
// Law:  a function of the points along the loops; it does not depend on where the loops begin.
// Cost: the product of the numbers of edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/repair/closing/work.h"

namespace rbpa::space {

/// A pair of edges, one of each loop. An edge is given by the position of its first corner in the loop.
struct Bridge {
  std::uint32_t edge, other;
};

/// Returns the bridges whose corners are nearest to each other, the best first, at most `most`. Returns none if the
/// work is used up before all pairs are compared.
/// Requires: both loops have the hole to their left.
std::vector<Bridge> nearest_bridges(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                    std::span<const std::uint32_t> other, std::size_t most, Work& work);

/// Returns the two triangles of the strip between the edges of `bridge`.
std::array<std::array<std::uint32_t, 3>, 2> strip_of(const Bridge& bridge, std::span<const std::uint32_t> loop,
                                                     std::span<const std::uint32_t> other);

/// Returns the loop that bounds what the strip of `bridge` leaves of the hole.
std::vector<std::uint32_t> joined_loop(const Bridge& bridge, std::span<const std::uint32_t> loop,
                                       std::span<const std::uint32_t> other);

}  // namespace rbpa::space
