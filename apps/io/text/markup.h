// What: escapes text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace rbpa::app {

/// Returns the text with & < > " as entities, for elements and attributes. Control characters, which XML forbids, are
/// replaced by spaces.
inline std::string markup_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  return result;
}

}  // namespace rbpa::app
