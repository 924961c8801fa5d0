// LZF data built by its rules, without its library: runs of literals, and copies of earlier bytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace apps_test {

/// Returns bytes as literals, at most 32 after each head.
inline std::string lzf_literals(std::string_view bytes) {
  std::string compressed;
  for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(32, bytes.size()))) {
    const std::string_view some = bytes.substr(0, 32);
    compressed += static_cast<char>(some.size() - 1);
    compressed += some;
  }
  return compressed;
}

/// Returns a copy of `size` bytes, 3 to 264, that begin `distance` before, 1 to 8192.
inline std::string lzf_copy(std::size_t size, std::size_t distance) {
  const std::size_t length = size - 2, back = distance - 1;
  std::string compressed(1, static_cast<char>(std::min<std::size_t>(length, 7) << 5U | back >> 8U));
  if (length >= 7) compressed += static_cast<char>(length - 7);
  return compressed + static_cast<char>(back & 0xffU);
}

/// Returns the shortest data for so many equal bytes: the first, and copies of it.
inline std::string lzf_repeated(char byte, std::size_t count) {
  std::string compressed = lzf_literals(std::string(1, byte));
  std::size_t left = count - 1;
  for (; left >= 264 + 3; left -= 264) compressed += lzf_copy(264, 1);
  for (std::size_t some = 0; left >= 3; left -= some)
    compressed += lzf_copy(some = std::min<std::size_t>(left, 264), 1);
  return compressed + lzf_literals(std::string(left, byte));
}

}  // namespace apps_test
