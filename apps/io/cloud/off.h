// What: the beginning of an ASCII OFF file: how many vertices and faces follow it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/text/lines.h"

namespace rbpa::app {

struct OffHeader {
  bool normals;  ///< N is among the prefixes: three numbers behind the coordinates of a vertex
  bool colors;   ///< C is: red, green, blue and mostly opacity behind these
  std::size_t vertices;
  std::size_t line;         ///< that says so
  std::string_view counts;  ///< its words behind the number of vertices
  Lines lines;              ///< the vertices are next
};

/// OFF with any of the prefixes ST, C, N, or none; the counts in the line of the word or in the next. Throws BadInput
/// naming the line, also when the file is too short for so many vertices of at least two coordinates.
/// `text` are the first of `size` bytes, all of the header among them.
OffHeader read_off_header(std::string_view text, std::size_t size, const std::string& name);

/// A Claim: so many lines of vertices and faces.
double claimed_off_size(std::string_view first, const std::string& name);

/// "3 vertex lines as line 2 says".
std::string announced(const OffHeader& header, std::size_t count, std::string_view noun);

}  // namespace rbpa::app
