// What: how long a file is as its first bytes claim, and how far a gzip file is unpacked: some kilobytes may become
//       gigabytes.
// Law:  a whole file is never refused for its claim, unless more than a mebibyte lies behind its data, or is one line of
//       its text, with the comments and blank lines before it.
// Cost: memory is at most twice what is claimed, and two mebibytes; a claim is computed again when as much more is there.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace rbpa::app {

struct Claim {
  /// At least how many bytes a file has that begins with `first`, its whole header among them: no more than it has where
  /// it is whole, and the longer `first` is, the nearer to that. Throws BadInput where its reader would, for the header.
  /// Null: the format claims nothing.
  double (*size)(std::string_view first, const std::string& name) = nullptr;
  std::string_view hint = {};  ///< what reads a longer file, for the end of a sentence
  bool may_be_packed = true;   ///< else a file that begins as a gzip file does is none
};

/// Of a file that claims nothing.
constexpr double any_size = std::numeric_limits<double>::infinity();

/// What a header may claim of a file that is packed, of which nobody knows how long it will be.
constexpr std::size_t unknown_size = std::numeric_limits<std::size_t>::max() / 2;

}  // namespace rbpa::app
