// Gzip files made in memory.
#pragma once

#include <cstddef>
#include <string>

namespace apps_test {

/// `content` as a gzip file.
std::string packed(const std::string& content);

/// `content` and behind it `filler`, over and over, `size` bytes of it or a little more: what is small and unpacks to
/// much.
std::string bomb(const std::string& content, const std::string& filler, std::size_t size);

}  // namespace apps_test
