// What: characters of texts in UTF-8.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace rbpa::app {

struct Character {
  char32_t code;
  std::size_t size;  ///< number of bytes
};

/// Returns the first character of `text`, with size 0 if it is not UTF-8: a stray byte, a truncated or overlong
/// sequence, a surrogate, or a number beyond Unicode.
inline Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80U) return {lead, 1};
  struct Form {
    unsigned char mask, mark;
    char32_t least;
  };
  static constexpr std::array<Form, 3> forms = {{{0xE0U, 0xC0U, 0x80}, {0xF0U, 0xE0U, 0x800}, {0xF8U, 0xF0U, 0x10000}}};
  for (std::size_t more = 1; more <= forms.size(); ++more) {
    const Form& form = forms[more - 1];
    if ((lead & form.mask) != form.mark) continue;
    if (text.size() <= more) return {0, 0};
    char32_t code = lead & static_cast<unsigned char>(~form.mask);
    for (std::size_t i = 1; i <= more; ++i) {
      if ((byte(i) & 0xC0U) != 0x80U) return {0, 0};
      code = code << 6U | (byte(i) & 0x3FU);
    }
    const bool is_one = code >= form.least && code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF);
    return {code, is_one ? more + 1 : 0};
  }
  return {0, 0};
}

inline bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = first_character(text).size;
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

}  // namespace rbpa::app
