// What: the beginning of an ASCII OFF file: how many vertices and faces follow it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/cloud/ply.h"
#include "io/text/lines.h"

namespace rbpa::app {

struct OffHeader {
  bool normals;  ///< N is among the prefixes: three numbers behind the coordinates of a vertex
  bool colors;   ///< C is: red, green, blue and mostly opacity behind these
  std::size_t vertices, faces;
  std::size_t line;  ///< that says so
  Lines lines;       ///< the vertices are next

  /// Vertices of so many numbers, and faces, as elements.
  PlyHeader elements(std::size_t numbers) const;
};

/// OFF with any of the prefixes ST, C, N, or none; the counts in the line of the word, also right behind it, or in the
/// next; the vertices may follow them in that line. Throws BadInput naming the line, also when the file is too short
/// for so many vertices of at least two coordinates. `text` are the first of `size` bytes, all of the header among
/// them.
OffHeader read_off_header(std::string_view text, std::size_t size, const std::string& name);

/// A Claim: so many lines of vertices and faces.
double claimed_off_size(std::string_view first, const std::string& name);

}  // namespace rbpa::app
