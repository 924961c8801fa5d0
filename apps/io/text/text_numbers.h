// What: numbers distinct texts in the order of their first occurrence, so that a column of texts becomes a column of
//       numbers and a list of texts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rbpa::app {

class TextNumbers {
 public:
  double number_of(std::string_view text) {
    const auto [place, is_new] = numbers_.try_emplace(std::string(text), texts_.size());
    if (is_new) texts_.emplace_back(text);
    return static_cast<double>(place->second);
  }
  /// Returns the distinct texts in the order of their numbers. Call once.
  std::vector<std::string> take_texts() { return std::move(texts_); }

 private:
  std::vector<std::string> texts_ = {};
  std::unordered_map<std::string, std::size_t> numbers_ = {};
};

}  // namespace rbpa::app
