// What: limits decompression to the size that a file's header claims: some kilobytes of gzip may become gigabytes.
// Law:  a whole file is never refused for its claim, unless more than a mebibyte lies after its data, or one line of
//       its text, with the comments and blank lines before it, is longer than a mebibyte.
// Cost: memory is at most twice the claimed size plus two mebibytes. A claim is computed again whenever the
//       decompressed size has doubled.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace rbpa::app {

struct Claim {
  /// Returns a lower bound of the size, in bytes, of a whole file that begins with `first`, which holds the header; the
  /// longer `first` is, the tighter the bound. Throws BadInput for a header that the format's reader would refuse.
  /// Null if files of the format do not claim a size.
  double (*size)(std::string_view first, const std::string& name) = nullptr;
  std::string_view hint = {};     ///< end of the error message: how to read a longer file
  bool may_be_compressed = true;  ///< false: a file that begins like a gzip file is read as it is
};

/// The claim of a file that claims no size.
constexpr double any_size = std::numeric_limits<double>::infinity();

/// Stands for the size of a compressed file, which is unknown until its end is decompressed.
constexpr std::size_t unknown_size = std::numeric_limits<std::size_t>::max() / 2;

}  // namespace rbpa::app
