// What: colors that stand as numbers behind the vertices of a file of text.
// Law:  one of each vertex, or none and a remark: a file that has them in part has none. Channels are from 0 to 1; where one
//       of the file is greater, all are from 0 to 255, or from 0 to 65535 where such are `allowed`.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "io/cloud/cloud.h"

namespace rbpa::app {

class TextColors {
 public:
  explicit TextColors(double allowed = 255) : allowed_(allowed) {}

  /// The first three words of what follows a vertex, in line `line`, behind the colors of the block; there may be more. Other
  /// words are no color.
  void take(std::string_view rest, std::size_t line, CloudBlock& block);

  /// The same of three words.
  void take(const std::array<std::string_view, 3>& words, std::size_t line, CloudBlock& block);

  /// Of all vertices of the file, once they are taken: what their channels are of. It is no loss to have none, unless they are
  /// `announced`.
  void settle(bool announced, CloudFacts& facts) const;

 private:
  bool take_channels(const std::array<std::string_view, 3>& words, std::size_t line, std::array<double, 3>& channels);
  std::string fault() const;

  double allowed_;  // the greatest channel
  double greatest_ = 0;
  bool any_ = false;
  std::size_t line_without_ = 0;  // the first; 0: there is none
  std::size_t line_beyond_ = 0;   // the first with a channel below 0 or above what is allowed
  std::string beyond_ = {};       // that channel
};

/// Before the colors of a block are taken.
void clear_colors(CloudBlock& block);

/// A channel as a byte.
std::uint8_t channel_byte(double channel, Channels channels);

}  // namespace rbpa::app
