// What: declares the HTML of the pages in page/ and space_page/, with style and script but without data (embed.cmake).
#pragma once

#include <string_view>

namespace rbpa::app {

extern const std::string_view page_before_title, page_before_data, page_after_data;
extern const std::string_view space_page_before_title, space_page_before_data, space_page_after_data;

}  // namespace rbpa::app
