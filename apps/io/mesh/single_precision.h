// What: rounds positions to single precision, as STL and GLB store them, and counts what a mesh loses by that.
// Law:  the loss is computed exactly, from the positions that triangles use, before the file is written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/formats.h"
#include "io/mesh/equal_positions.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

constexpr bool has_single_precision(Format format) { return format == Format::stl || format == Format::glb; }

/// The choice of --shift: the offset that is subtracted from positions before they are rounded.
struct Shift {
  /// The offset. If absent, it is the center of the bounding box of the positions that triangles use, rounded to
  /// floats; or zero if these positions are floats already.
  std::optional<Position> by = std::nullopt;
};

/// Parses "auto" or "X,Y,Z". Throws WrongUsage that names `option`.
Shift parse_shift(const std::string& option, const std::string& text);

struct SinglePositions {
  std::vector<std::array<float, 3>> at;  ///< one for each vertex; zeros for a vertex that no triangle uses
  Position shift = {};                   ///< the subtracted offset

  std::vector<Position> positions() const;
};

/// Returns the vertices less `shift`, rounded to single precision. If `shift` is absent, nothing is subtracted for STL,
/// and the offset of Shift() for GLB, which stores the offset. Throws BadInput that names `file` for a coordinate that
/// is too large. Requires: has_single_precision(format).
SinglePositions single_positions(Format format, std::span<const Point3> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> triangles,
                                 const std::optional<Shift>& shift, const std::string& file);

/// Numbers of what a mesh loses by rounding.
struct Lost {
  std::size_t areas = 0;     ///< triangles that have no area after rounding, and had one before
  std::size_t vertices = 0;  ///< vertices that rounding moves onto another vertex
  std::size_t used = 0;      ///< vertices of triangles
  bool any() const { return areas > 0 || vertices > 0; }
};

/// Counts what a mesh loses if `rounded` are its positions. Throws Cancelled.
Lost lost(std::span<const Point3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
          const SinglePositions& rounded);

/// Returns "o.stl: single precision leaves 8 of 12 triangles without area (...)" with a way to avoid the loss: --shift
/// auto, if that suffices, or another format. Empty if nothing is lost. Requires: `rounded` is the result of
/// single_positions() for the same mesh. Throws as single_positions(); Cancelled.
std::string why_not_kept(const SinglePositions& rounded, Format format, std::span<const Point3> vertices,
                         std::span<const std::array<std::uint32_t, 3>> triangles, const std::string& file);

/// Returns "o.stl: 500000,4649000,0 is subtracted from all coordinates". Empty if zero is subtracted, if `shift` is
/// absent, or if the format has double precision.
std::string text_of_shift(Format format, std::span<const Point3> vertices,
                          std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                          const std::string& file);

/// Returns three numbers with commas between them, at most 74 characters: each without an exponent if it is 0 or its
/// absolute value is at least 0.001 and below 10^15.
std::string text_of(const Position& position);

/// Returns how to avoid the loss by rounding: " (not with --shift auto, nor as .ply, .obj or .off)", or without the
/// shift unless `shift_keeps`.
std::string way_to_keep(bool shift_keeps);

}  // namespace rbpa::app
