// What: which triangles of a mesh in space cross each other.
// Law:  exact, and a function of the triangles.
// Cost: a tree of their boxes, and an exact test for each two whose boxes meet: some tens of nanoseconds where a plane parts them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

/// Pairs of triangles that have more in common than a corner at one point, or a side between two: they overlap, one pierces the
/// other, or they touch elsewhere. Sorted; the first `most`. Triangles without an area cross nothing.
/// Requires: finite points. Throws: InvalidInput; ContractViolation when a corner is none of the points; Cancelled.
RBPA_API std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_triangles(
    std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t most,
    const SurfaceOptions& options = {});

}  // namespace rbpa
