// What: colors written as numbers after the vertices of a text file.
// Law:  every vertex has a color, or none has and a warning says so: partial colors are dropped. Channels are from 0 to
//       1; if one of the file is greater, all are from 0 to 255, or from 0 to 65535 if such are `allowed`.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "io/cloud/cloud.h"

namespace rbpa::app {

constexpr double widest_channel = 65535;

/// Three columns without names behind x, y, z, which are colors or normals.
class LastColumns {
 public:
  /// Takes the three numbers of a point.
  void take(const std::array<double, 3>& numbers);
  /// Sets their meaning, and warns of it: colors if `is_by_content` and they are whole numbers up to widest_channel,
  /// one of them greater than 1; otherwise normals.
  void settle(bool is_by_content, CloudFacts& facts) const;

 private:
  bool all_channels_ = true;   // so far they are whole numbers up to widest_channel
  bool no_direction_ = false;  // one of them cannot be the direction of a normal
  double greatest_ = 0;
};

class TextColors {
 public:
  explicit TextColors(double allowed = 255) : allowed_(allowed) {}

  /// Appends the color of a vertex to the block: the first three words of `rest`, which follows the vertex in line
  /// `line`. Words that are not numbers are not a color; further words are ignored.
  void take(std::string_view rest, std::size_t line, CloudBlock& block);

  /// Appends the color of a vertex, from three words, to the block.
  void take(const std::array<std::string_view, 3>& words, std::size_t line, CloudBlock& block);

  /// Sets the range of the channels, when the colors of all vertices are taken. Warns if colors are dropped, or if
  /// there are none although the header has `announced` them.
  void settle(bool announced, CloudFacts& facts) const;

 private:
  bool take_channels(const std::array<std::string_view, 3>& words, std::size_t line, std::array<double, 3>& channels);
  std::string fault() const;

  double allowed_;  // the greatest channel
  double greatest_ = 0;
  bool any_ = false;
  std::size_t line_without_ = 0;  // the first line without a color; 0: there is none
  std::size_t line_beyond_ = 0;   // the first with a channel below 0 or above what is allowed
  std::string beyond_ = {};       // that channel
};

/// Empties the colors of a block, before new ones are taken.
void clear_colors(CloudBlock& block);

/// Returns a channel as a byte.
std::uint8_t channel_byte(double channel, Channels channels);

}  // namespace rbpa::app
