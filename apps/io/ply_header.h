// What: the header of a PLY file: which elements it holds, and what of each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scalar.h"

namespace rbpa::app {

struct PlyProperty {
  std::string name;
  Scalar type;                       ///< of the value, or of each value of the list
  std::optional<Scalar> count_type;  ///< of the length before the values, when it is a list
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::size_t line;  ///< of the header, that says so
  std::vector<PlyProperty> properties;

  bool has_lists() const;
  /// Bytes that one takes in a binary file, with every list empty.
  std::size_t least_size() const;
};

struct PlyHeader {
  std::optional<std::endian> binary;  ///< the byte order; none when the file is ASCII
  std::vector<PlyElement> elements;
  std::size_t lines;      ///< of the header
  std::string_view data;  ///< what follows it
};

/// Throws BadInput naming the line.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace rbpa::app
