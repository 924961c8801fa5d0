// What: whether a file in single precision is as watertight as the surface that is written to it.
// Law:  what is asked is the surface as a reader of the file finds it, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "io/mesh/single_precision.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa::app {

/// Why not, with what mends it: triangles lose their area, fall together or cross, or STL joins what is apart only by
/// the numbers of its vertices. Empty where it is, and of formats with double precision.
/// Requires: triangles of a closed surface without crossings. Throws as crossing_triangles() and single_positions().
std::string why_file_is_open(Format format, const std::string& file, std::span<const Point3> points,
                             std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                             const SurfaceOptions& options);

}  // namespace rbpa::app
