// Gzip files made in memory.
#pragma once

#include <cstddef>
#include <string>

namespace apps_test {

/// Returns `content` as a gzip file.
std::string compressed(const std::string& content);

/// Returns a gzip file of `content` followed by repetitions of `filler`, `size` bytes or a little more: a small file
/// that decompresses to much.
std::string bomb(const std::string& content, const std::string& filler, std::size_t size);

}  // namespace apps_test
