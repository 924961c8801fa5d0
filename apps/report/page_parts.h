// What: the page without its data, as it lies in page/: style and script are in it already (embed.cmake).
#pragma once

#include <string_view>

namespace rbpa::app {

extern const std::string_view page_before_title, page_before_data, page_after_data;

}  // namespace rbpa::app
