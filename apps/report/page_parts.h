// What: declares the HTML of the pages in page/ and space_page/, with style and script but without data (embed.cmake).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rbpa::app {

extern const std::string_view page_before_title, page_before_data, page_after_data;
extern const std::string_view space_page_before_title, space_page_before_data, space_page_after_data;

/// Returns JSON for a <script> element, with \u003c in place of each '<', so that no text in it can end the element.
inline std::string facts_text(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return json;
}

}  // namespace rbpa::app
