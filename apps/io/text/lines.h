// What: splits a text into lines, and a line into words.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "io/interrupt.h"
#include "io/words.h"

namespace rbpa::app {

/// Returns the number of line ends (LF) in `text`. Throws Cancelled.
inline std::size_t count_line_ends(std::string_view text) {
  constexpr std::size_t block_size = 240;  // bytes; a count of them fits into a byte, and many counts into one register
  std::size_t count = 0;
  for (std::size_t blocks = 0; !text.empty(); ++blocks) {
    if (blocks % 65536 == 0) stop_if_interrupted();
    const std::string_view block = text.substr(0, block_size);
    std::uint8_t ends = 0;
    for (const char c : block) ends = static_cast<std::uint8_t>(ends + (c == '\n' ? 1 : 0));
    count += ends;
    text.remove_prefix(block.size());
  }
  return count;
}

/// The lines of a text, one after another, without their ends (LF or CRLF) and without blanks around them.
class Lines {
 public:
  /// Begins before the first line of `text`, which must outlive this object. `before` is the number of lines that
  /// precede `text` in the file.
  explicit Lines(std::string_view text, std::size_t before = 0)
      : at_(text.data()), end_(text.data() + text.size()), number_(before) {}

  /// Goes to the next line; returns false if there is none. Throws Cancelled.
  bool next() {
    if (at_ == end_) return false;
    const auto left = static_cast<std::size_t>(end_ - at_);
    const char* stop = static_cast<const char*>(std::memchr(at_, '\n', left));
    if (stop == nullptr) stop = end_;
    line_ = trimmed({at_, static_cast<std::size_t>(stop - at_)});
    at_ = stop == end_ ? end_ : stop + 1;
    if (++number_ % 65536 == 0) stop_if_interrupted();  // also while many lines are skipped
    return true;
  }
  /// Goes to the next line that is not blank and does not begin with '#'; returns false if there is none. Throws
  /// Cancelled.
  bool next_with_content() {
    while (next())
      if (!line_.empty() && line_.front() != '#') return true;
    return false;
  }

  /// Skips the next line, which the caller has read in rest(); `behind` points to its line end or to the end of the
  /// text. line() does not change.
  void pass_line(const char* behind) {
    at_ = behind == end_ ? end_ : behind + 1;
    ++number_;
  }

  std::string_view line() const { return line_; }
  /// Returns whether this line has an end; the last line of a text may lack it.
  bool has_end() const { return at_ != end_ || (at_ != line_.data() && at_[-1] == '\n'); }
  std::size_t number() const { return number_; }                                         ///< of this line, from 1
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }  ///< text after line()

 private:
  const char* at_;
  const char* end_;
  std::string_view line_;
  std::size_t number_;
};

/// Removes the first word, and blanks before it, from `text`. Returns the word; empty if there is none.
inline std::string_view take_word(std::string_view& text) {
  std::size_t first = 0;
  while (first < text.size() && is_blank(text[first])) ++first;
  std::size_t last = first;
  while (last < text.size() && !is_blank(text[last])) ++last;
  const std::string_view word = text.substr(first, last - first);
  text.remove_prefix(last);
  return word;
}

/// Returns the words of a text.
inline std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) words.push_back(word);
  return words;
}

}  // namespace rbpa::app
