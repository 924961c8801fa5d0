// What: escapes text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

#include "io/utf8.h"

namespace rbpa::app {

/// Returns the text with & < > " as entities, for elements and attributes. What XML forbids is replaced: control
/// characters by spaces, bytes that are not UTF-8 and noncharacters by U+FFFD.
inline std::string markup_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [code, size] = first_character(text);
    const std::string_view bytes = text.substr(0, size == 0 ? 1 : size);
    text.remove_prefix(bytes.size());
    if (size == 0 || code == 0xFFFE || code == 0xFFFF)
      result += "\xEF\xBF\xBD";
    else if (code == '&')
      result += "&amp;";
    else if (code == '<')
      result += "&lt;";
    else if (code == '>')
      result += "&gt;";
    else if (code == '"')
      result += "&quot;";
    else
      result += code < ' ' ? " " : bytes;
  }
  return result;
}

}  // namespace rbpa::app
