#include "io/cloud/colors.h"

#include <algorithm>
#include <cmath>

#include "io/failure.h"
#include "io/number.h"
#include "io/text/lines.h"

namespace rbpa::app {

void TextColors::take(std::string_view rest, std::size_t line, CloudBlock& block) {
  std::array<std::string_view, 3> words;
  for (std::string_view& word : words) word = take_word(rest);
  take(words, line, block);
}

void TextColors::take(const std::array<std::string_view, 3>& words, std::size_t line, CloudBlock& block) {
  std::array<double, 3> channels{};
  if (take_channels(words, line, channels))
    any_ = true;
  else if (line_without_ == 0)
    line_without_ = line;
  for (std::size_t k = 0; k < 3; ++k) block.column[CloudBlock::color + k].push_back(channels[k]);
}

bool TextColors::take_channels(const std::array<std::string_view, 3>& words, std::size_t line,
                               std::array<double, 3>& channels) {
  for (std::size_t k = 0; k < 3; ++k) {
    const ParsedNumber number = parse_whole_number(words[k]);
    if (number.fault != NumberFault::none) return false;
    if (!(number.value >= 0 && number.value <= allowed_) && line_beyond_ == 0) {
      line_beyond_ = line;
      beyond_ = in_quotes(words[k]);
    }
    greatest_ = std::max(greatest_, number.value);
    channels[k] = number.value;
  }
  return true;
}

std::string TextColors::fault() const {
  if (line_without_ > 0) return "line " + std::to_string(line_without_) + " has none";
  if (line_beyond_ > 0)
    return "line " + std::to_string(line_beyond_) + " has a channel of " + beyond_ + ", and not from 0 to 1 or to " +
           std::to_string(static_cast<int>(allowed_));
  return "";
}

void TextColors::settle(bool announced, CloudFacts& facts) const {
  facts.colors.reset();
  if (!any_ && !announced) return;
  if (const std::string why = fault(); !why.empty()) {
    facts.file.warnings.push_back("colors are left out, as " + why);
    return;
  }
  facts.colors = greatest_ > 255 ? Channels::wide : greatest_ > 1 ? Channels::bytes : Channels::unit;
}

void LastColumns::take(const std::array<double, 3>& numbers) {
  no_direction_ = no_direction_ || numbers == std::array<double, 3>{};
  for (const double number : numbers) {
    all_channels_ = all_channels_ && number >= 0 && number <= widest_channel && std::trunc(number) == number;
    greatest_ = std::max(greatest_, number);
  }
}

void LastColumns::settle(bool is_by_content, CloudFacts& facts) const {
  facts.last_are_colors = is_by_content && all_channels_ && greatest_ > 1;
  facts.last_have_no_direction = is_by_content && !facts.last_are_colors && no_direction_;
  if (facts.last_are_colors) facts.colors = greatest_ > 255 ? Channels::wide : Channels::bytes;
  facts.file.warnings.push_back(
      facts.last_are_colors
          ? "columns 4 to 6 are read as colors, as they are whole numbers (--columns 1,2,3,4,5,6 reads normals)"
          : "columns 4 to 6 are read as normals (a header 'x y z r g b' makes them colors)");
}

void clear_colors(CloudBlock& block) {
  for (std::size_t k = 0; k < 3; ++k) block.column[CloudBlock::color + k].clear();
}

std::uint8_t channel_byte(double channel, Channels channels) {
  const auto value = static_cast<float>(channel);  // in float, as rounding depends on it
  if (channels == Channels::wide) return static_cast<std::uint8_t>(static_cast<long>(value) / 256);
  return static_cast<std::uint8_t>(std::lround(channels == Channels::unit ? 255 * value : value));
}

}  // namespace rbpa::app
