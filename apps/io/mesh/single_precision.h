// What: positions in single precision, as STL and GLB store them, and the loss of a mesh by rounding to it.
// Law:  the loss is computed exactly, from the positions that triangles use, so that it is known before the file is
//       written.
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

/// The offset that is subtracted from positions before they are rounded: --shift.
struct Shift {
  /// Absent: the center of the positions' box, in floats, if rounding would change a position; otherwise zero.
  std::optional<Position> by = std::nullopt;
};

/// Parses "auto" or "X,Y,Z". Throws WrongUsage naming `option`.
Shift parse_shift(const std::string& option, const std::string& text);

struct SinglePositions {
  std::vector<std::array<float, 3>> at;  ///< one per vertex; zeros for a vertex that no triangle uses
  Position shift = {};                   ///< the subtracted offset

  std::vector<Position> positions() const;
};

/// Rounds positions to single precision after subtracting `shift`. Without a shift, STL subtracts nothing, and GLB,
/// which stores the offset, subtracts that of Shift(). Throws BadInput naming `file` for a coordinate that is too
/// large.
SinglePositions single_positions(Format format, std::span<const Point3> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> triangles,
                                 const std::optional<Shift>& shift, const std::string& file);

/// The loss of a mesh by rounding.
struct Lost {
  std::size_t areas = 0;     ///< triangles that had an area and have none
  std::size_t vertices = 0;  ///< vertices that are now at the position of another
  bool any() const { return areas > 0 || vertices > 0; }
};

/// Counts the loss of a mesh by rounding. Throws Cancelled.
Lost lost(std::span<const Point3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
          const SinglePositions& rounded);

/// Returns "o.stl: single precision leaves 8 of 12 triangles without area (...)" with a repair: a shift, if one
/// suffices, or another format. Empty if nothing is lost. Throws as single_positions(), which returns `rounded`.
std::string why_not_kept(const SinglePositions& rounded, Format format, std::span<const Point3> vertices,
                         std::span<const std::array<std::uint32_t, 3>> triangles, const std::string& file);

/// Returns "o.stl: 500000,4649000,0 is subtracted from all coordinates". Empty if nothing is subtracted, if no shift
/// was requested, or if the format has double precision.
std::string text_of_shift(Format format, std::span<const Point3> vertices,
                          std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                          const std::string& file);

/// Returns three numbers with commas between them, at most 74 characters, without exponents if they are short.
std::string text_of(const Position& position);

/// Returns " (not with --shift auto, ...)": how to avoid the loss by rounding.
std::string way_to_keep(bool shift_keeps);

}  // namespace rbpa::app
