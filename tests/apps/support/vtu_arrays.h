// What: the arrays of a .vtu with appended raw data, by name.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace apps_test {

/// Returns the numbers of the first array after `mark`; none without such a mark.
template <typename T>
std::vector<T> array_behind(const std::string& vtu, const std::string& mark) {
  const std::size_t at = vtu.find(mark);
  if (at == std::string::npos) return {};
  const std::size_t offset = std::stoul(vtu.substr(vtu.find("offset=\"", at) + 8, 20));
  const std::size_t data = vtu.find("\n_") + 2 + offset;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, vtu.data() + data, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), vtu.data() + data + sizeof bytes, bytes);
  return values;
}

/// Returns the numbers of an array; none if there is no array of that name.
template <typename T>
std::vector<T> array_of(const std::string& vtu, const std::string& name) {
  return array_behind<T>(vtu, "Name=\"" + name + "\"");
}

}  // namespace apps_test
