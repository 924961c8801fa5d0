// What: the pages of page/ and space_page/ without their data; embed.cmake has put style and script into them.
#pragma once

#include <string_view>

namespace rbpa::app {

extern const std::string_view page_before_title, page_before_data, page_after_data;
extern const std::string_view space_page_before_title, space_page_before_data, space_page_after_data;

}  // namespace rbpa::app
