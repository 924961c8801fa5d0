// What: reads colors that follow the vertices of a text file as numbers.
// Law:  every vertex has a color, or none has: partial colors are dropped with a warning. The greatest channel of the
//       file gives the range of all channels: 0 to 1; else 0 to 255; else, if `allowed` is 65535, 0 to 65535.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "io/cloud/cloud.h"

namespace rbpa::app {

constexpr double widest_channel = 65535;

/// Decides whether three columns without names after x, y, z are colors or normals.
class LastColumns {
 public:
  /// Takes the three numbers of a point.
  void take(const std::array<double, 3>& numbers);
  /// Sets the meaning of the columns in `facts`, and adds a warning: colors if `is_by_content` and all are whole
  /// numbers up to widest_channel, one of them greater than 1; otherwise normals.
  void settle(bool is_by_content, CloudFacts& facts) const;

 private:
  bool all_channels_ = true;   // all numbers are whole and from 0 to widest_channel
  bool no_direction_ = false;  // some three numbers are not the direction of a normal
  double greatest_ = 0;
};

class TextColors {
 public:
  explicit TextColors(double allowed = 255) : allowed_(allowed) {}

  /// Appends the color of a vertex to `block`: the first three words of `rest`, the text after the vertex in line
  /// number `line`. Words that are not numbers are not a color; further words are ignored.
  void take(std::string_view rest, std::size_t line, CloudBlock& block);

  /// Appends the color of a vertex in line number `line`, the three `words`, to `block`.
  void take(const std::array<std::string_view, 3>& words, std::size_t line, CloudBlock& block);

  /// Sets the range of the channels in `facts`; call after the last take(). Adds a warning if colors are dropped, or if
  /// there are none although the header has `announced` them.
  void settle(bool announced, CloudFacts& facts) const;

 private:
  bool take_channels(const std::array<std::string_view, 3>& words, std::size_t line, std::array<double, 3>& channels);
  std::string fault() const;

  double allowed_;  // the greatest channel
  double greatest_ = 0;
  bool any_ = false;
  std::size_t line_without_ = 0;  // number of the first line without a color; 0: there is none
  std::size_t line_beyond_ = 0;   // number of the first line with a channel below 0 or above allowed_
  std::string beyond_ = {};       // the text of that channel
};

/// Empties the columns of colors of a block.
void clear_colors(CloudBlock& block);

/// Returns a channel, which has the range `channels`, as a byte.
std::uint8_t channel_byte(double channel, Channels channels);

}  // namespace rbpa::app
