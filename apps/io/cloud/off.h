// What: the header of an ASCII OFF file: the number of vertices and faces that follow it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/cloud/ply.h"
#include "io/text/lines.h"

namespace rbpa::app {

struct OffHeader {
  bool normals;  ///< N is among the prefixes: three numbers after the coordinates of a vertex
  bool colors;   ///< C is among the prefixes: red, green, blue and mostly opacity after the normal
  std::size_t vertices, faces;
  std::size_t line;  ///< with these counts
  Lines lines;       ///< the vertices are next

  /// Returns vertices of `numbers` numbers, and faces, as elements of PLY.
  PlyHeader elements(std::size_t numbers) const;
};

/// Reads a header: OFF with any of the prefixes ST, C, N, or none; then the counts, in the same line or in the next.
/// The vertices may follow the counts in their line. Throws BadInput naming the line, also if the file is too short for
/// so many vertices of at least two coordinates.
OffHeader read_off_header(std::string_view text, const std::string& name);

}  // namespace rbpa::app
