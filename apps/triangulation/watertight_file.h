// What: checks whether a watertight surface remains watertight when a file rounds its coordinates to single precision.
// Law:  the check is exact for the rounded coordinates, which are those that a reader of the file gets.
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

/// Returns why the file is not watertight, and how to mend that: triangles lose their area, coincide or cross, or STL
/// joins vertices that differ only by number. Returns "" if it is watertight, and for formats in double precision.
/// Requires: triangles of a closed surface without crossings. Throws as crossing_triangles() and single_positions().
std::string why_file_is_open(Format format, const std::string& file, std::span<const Point3> points,
                             std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                             const SurfaceOptions& options);

}  // namespace rbpa::app
