// What: characters of texts in UTF-8, and the conversion of other texts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
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
  for (;;) {
    const auto* const ascii_end =
        std::find_if(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80U; });
    text.remove_prefix(static_cast<std::size_t>(ascii_end - text.begin()));
    if (text.empty()) return true;
    const std::size_t size = first_character(text).size;
    if (size == 0) return false;
    text.remove_prefix(size);
  }
}

/// Returns a text in UTF-8: unchanged if it is, and otherwise read as Windows-1252, as older programs write it. The
/// five bytes that Windows-1252 lacks become the control characters of their numbers.
inline std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  static constexpr std::array<char16_t, 32> from_0x80 = {
      0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
      0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
      0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
  std::string result;
  const auto append = [&](unsigned byte) { result += static_cast<char>(byte); };
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const unsigned code = byte >= 0x80U && byte < 0xA0U ? from_0x80[byte - 0x80U] : byte;
    if (code < 0x80U) {
      append(code);
    } else if (code < 0x800U) {
      append(0xC0U | code >> 6U);
      append(0x80U | (code & 0x3FU));
    } else {
      append(0xE0U | code >> 12U);
      append(0x80U | (code >> 6U & 0x3FU));
      append(0x80U | (code & 0x3FU));
    }
  }
  return result;
}

}  // namespace rbpa::app
