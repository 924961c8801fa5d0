// What: characters and words of text.
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace rbpa::app {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

inline std::string_view trimmed(std::string_view text) {
  const char* first = text.data();
  const char* last = first + text.size();
  while (first != last && is_blank(*first)) ++first;
  while (first != last && is_blank(last[-1])) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

/// Returns whether two words are equal, apart from the case of letters.
inline bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) {
    return std::tolower(static_cast<unsigned char>(p)) == std::tolower(static_cast<unsigned char>(q));
  });
}

/// Returns whether `name` is one of `names`, which spaces separate. The case of letters does not matter.
inline bool is_word_of(std::string_view name, std::string_view names) {
  while (!names.empty()) {
    const std::size_t size = std::min(names.find(' '), names.size());
    if (same_letters(name, names.substr(0, size))) return true;
    names.remove_prefix(std::min(size + 1, names.size()));
  }
  return false;
}

inline std::string in_capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// Returns words as a name in JSON: "non_manifold_edge" for "non-manifold edge".
inline std::string identifier(std::string_view words) {
  std::string text(words);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return text;
}

/// Returns `text` as a field of CSV: in double quotes if it has a separator, a quote, a blank or a line end.
inline std::string csv_text(std::string_view text) {
  const auto needs_quotes = [](char c) { return is_blank(c) || c == ',' || c == ';' || c == '"' || c == '\n'; };
  if (std::none_of(text.begin(), text.end(), needs_quotes)) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

/// Returns the number in a word of decimal digits; nothing for any other word, and for a number beyond std::size_t.
inline std::optional<std::size_t> parse_count(std::string_view word) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return count;
}

}  // namespace rbpa::app
