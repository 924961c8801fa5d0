// What: what a gzip file holds.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace rbpa::app {

/// Whether the bytes begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// Inflates all members of a gzip file, one behind the other. `room(size)` gives where the next `size` bytes may go, and
/// `written(size)` says how many were put there. Memory follows what comes out, not what the file claims.
/// Throws BadInput naming what is wrong; Cancelled.
void gunzip(std::string_view bytes, const std::string& name, const std::function<char*(std::size_t size)>& room,
            const std::function<void(std::size_t size)>& written);

}  // namespace rbpa::app
