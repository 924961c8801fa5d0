// What: the bytes before the numbers of an .npy file, version 1.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rbpa::app {

/// `type` is "<u4"; `columns`: what Python writes of a shape behind the number of rows, ", 3" or ",".
std::string npy_header(std::string_view type, std::uint64_t rows, std::string_view columns);

}  // namespace rbpa::app
