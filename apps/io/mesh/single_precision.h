// What: positions in single precision, which is all that STL and GLB have, and what a mesh loses by it.
// Law:  exact, and a function of the places that triangles use: what is asked before a file is written holds of the
//       file.
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
  std::optional<Position> by =
      std::nullopt;  ///< absent: the middle of their box, as floats, where rounding changes some
};

/// "auto" or "X,Y,Z". Throws WrongUsage naming `option`.
Shift parse_shift(const std::string& option, const std::string& text);

struct SinglePositions {
  std::vector<std::array<float, 3>> at;  ///< of each vertex; zeros where no triangle uses it
  Position shift = {};                   ///< what was subtracted

  std::vector<Position> positions() const;
};

/// Without a shift nothing is subtracted for STL; GLB, which has a place for it, takes that of Shift(). Throws BadInput
/// naming `file` for a coordinate that is too large.
SinglePositions single_positions(Format format, std::span<const Point3> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> triangles,
                                 const std::optional<Shift>& shift, const std::string& file);

struct Lost {
  std::size_t areas = 0;     ///< triangles that had one
  std::size_t vertices = 0;  ///< that are where another is, and were not
  bool any() const { return areas > 0 || vertices > 0; }
};

/// Counts what a mesh loses by rounding. Throws Cancelled.
Lost lost(std::span<const Point3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
          const SinglePositions& rounded);

/// "o.stl: single precision leaves 8 of 12 triangles without area (...)", with what keeps them: a shift, if one does,
/// or another format. Empty where nothing is lost. Throws as single_positions().
std::string why_not_kept(Format format, std::span<const Point3> vertices,
                         std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                         const std::string& file);

/// "o.stl: 500000,4649000,0 is subtracted from all coordinates". Empty where nothing is, or none of it was asked for.
std::string text_of_shift(Format format, std::span<const Point3> vertices,
                          std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                          const std::string& file);

/// Three numbers with commas between them, at most 80 characters less six, without an exponent where that is short.
std::string text_of(const Position& position);

/// " (not with --shift auto, ...)": what keeps a mesh from what rounding does to it.
std::string way_to_keep(bool shift_keeps);

}  // namespace rbpa::app
