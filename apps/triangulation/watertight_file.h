// What: checks whether a watertight surface remains watertight when a file rounds its coordinates to single precision.
// Law:  the check is exact for the rounded coordinates, which a reader of the file gets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "io/mesh/single_precision.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::app {

/// Returns the reason why `file` would not be watertight, and a way to mend it: rounding makes triangles lose their
/// area, coincide or cross, or STL joins vertices at equal positions. Returns "" if the file would be watertight, and
/// for formats in double precision. Requires: the triangles are a closed surface without crossings. Throws as
/// crossing_triangles() and single_positions() do.
std::string why_file_is_open(Format format, const std::string& file, std::span<const Point3> points,
                             std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                             const SurfaceOptions& options);

}  // namespace rbpa::app
