#include "io/space/text_colors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/failure.h"
#include "io/lines.h"
#include "io/number.h"

namespace rbpa::app {

void TextColors::take(std::string_view rest, std::size_t line) {
  std::array<std::string_view, 3> words;
  for (std::string_view& word : words) word = take_word(rest);
  take(words, line);
}

void TextColors::take(const std::array<std::string_view, 3>& words, std::size_t line) {
  std::array<float, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view word = words[i];
    const ParsedNumber number = parse_whole_number(word);
    if (number.fault != NumberFault::none) {
      if (line_without_ == 0) line_without_ = line;
      return;
    }
    if (!(number.value >= 0 && number.value <= allowed_) && line_beyond_ == 0) {
      line_beyond_ = line;
      beyond_ = in_quotes(word);
    }
    greatest_ = std::max(greatest_, number.value);
    channels[i] = static_cast<float>(number.value);
  }
  channels_.push_back(channels);
}

std::string TextColors::fault(bool announced) const {
  if (channels_.empty() && !announced) return "";
  if (line_without_ > 0) return "line " + std::to_string(line_without_) + " has none";
  if (line_beyond_ > 0)
    return "line " + std::to_string(line_beyond_) + " has a channel of " + beyond_ + ", and not from 0 to 1 or to " +
           std::to_string(static_cast<int>(allowed_));
  return "";
}

void TextColors::settle(bool announced, SpacePoints& file) const {
  if (const std::string why = fault(announced); !why.empty()) {
    file.remarks.push_back("colours are left out, as " + why);
    return;
  }
  const double unit = greatest_ > 1 ? 1 : 255;
  const bool wide = greatest_ > 255;  // of 16 bits, of which the upper 8 count
  const auto byte = [&](float channel) {
    return static_cast<std::uint8_t>(wide ? static_cast<long>(channel) / 256 : std::lround(unit * channel));
  };
  file.colors.reserve(channels_.size());
  for (const auto& [red, green, blue] : channels_) file.colors.push_back({byte(red), byte(green), byte(blue)});
}

}  // namespace rbpa::app
