// What: finds the triangles of a mesh in space that cross each other.
// Law:  exact, and a function of the triangles.
// Cost: a tree of their bounding boxes, and an exact test for each pair whose boxes meet: some tens of nanoseconds
//       where a plane separates them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// Returns pairs of triangles that share more than a corner at one point or a side between two points: they overlap,
/// one pierces the other, or they touch elsewhere. The pairs are sorted; at most the first `most` are returned.
/// Triangles of no area cross nothing.
/// Requires: finite points.
/// Throws:   InvalidInput; ContractViolation when a corner is none of the points; Cancelled.
RBPA_API std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_triangles(
    std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t most,
    const SurfaceOptions& options = {});

}  // namespace rbpa
