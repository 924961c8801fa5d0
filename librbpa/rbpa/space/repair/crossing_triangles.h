// What: finds the triangles of a mesh in space that cross each other.
// Law:  exact; a function of the points and triangles.
// Cost: that of a tree of the triangles' bounding boxes, and of an exact test for each pair whose boxes meet: some tens
//       of nanoseconds if a plane separates the pair.
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

/// Returns the pairs of triangles that cross: they overlap, one pierces the other, or they touch elsewhere than in a
/// common corner or along a common side. Corners are common if they are equal as points. Pairs are indices i < j in
/// lexicographic order; only the first `most` are returned. Triangles of no area cross nothing.
/// Requires: finite points, fewer than 2^32 − 1.
/// Throws:   InvalidInput that names the violated requirement; ContractViolation when a corner is not an index of a
///           point; Cancelled.
RBPA_API std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_triangles(
    std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t most,
    const SurfaceOptions& options = {});

}  // namespace rbpa
