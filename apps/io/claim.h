// What: how long a file is as its first bytes claim, so that a packed one is unpacked no further.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

#include "io/lines.h"

namespace rbpa::app {

struct Claim {
  /// At least how many bytes a file has that begins with `first`, its whole header among them: no more than it has where
  /// it is whole, and the longer `first` is, the nearer to that. Throws BadInput where its reader would, for the header.
  /// Null: the format claims nothing.
  double (*size)(std::string_view first, const std::string& name) = nullptr;
  std::string_view hint = {};  ///< what reads a longer file, for the end of a sentence
};

/// Of a file that claims nothing.
constexpr double any_size = std::numeric_limits<double>::infinity();

/// What a header may claim of a file that is packed, of which nobody knows how long it will be.
constexpr std::size_t unknown_size = std::numeric_limits<std::size_t>::max() / 2;

/// Where in `first`, of which `lines` reads, so many lines with content end; each that is not there takes two bytes more.
double end_of_lines(std::string_view first, Lines lines, double count);

}  // namespace rbpa::app
