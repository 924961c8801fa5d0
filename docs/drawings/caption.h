// What: formats numbers for captions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

namespace figures {

inline std::string rounded(double value, const char* format = "%.3g") {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/// Returns a text such as "points 68".
inline std::string of(const char* name, std::size_t value) { return std::string(name) + " " + std::to_string(value); }

}  // namespace figures
