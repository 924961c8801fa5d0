// What: reads the fields of the vertices of .ply and .vtu files, and runs the program for tests of them.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/program.h"

namespace apps_test {

/// A field of the vertices of a file: its type, and the bytes of its values.
struct Field {
  std::string type, bytes;

  template <typename T>
  std::vector<T> values() const {
    std::vector<T> all(bytes.size() / sizeof(T));
    std::memcpy(all.data(), bytes.data(), bytes.size());
    return all;
  }
};
using FieldMap = std::map<std::string, Field>;

/// The properties of the vertices of binary PLY.
inline FieldMap fields_of_ply(const std::string& file) {
  const std::map<std::string, std::size_t> sizes = {{"char", 1}, {"uchar", 1}, {"short", 2}, {"ushort", 2},
                                                    {"int", 4},  {"uint", 4},  {"float", 4}, {"double", 8}};
  std::vector<std::pair<std::string, std::string>> properties;  // type and name
  const std::size_t begin = file.find("element vertex "), end = file.find("element face ");
  std::size_t at = file.find('\n', begin), row = 0;
  const std::size_t count = std::stoul(file.substr(begin + 15));
  while (at + 1 < end) {
    const std::size_t next = file.find('\n', at + 1);
    const std::string line = file.substr(at + 1, next - at - 1);
    const std::size_t blank = line.find(' ', 9);
    properties.emplace_back(line.substr(9, blank - 9), line.substr(blank + 1));
    row += sizes.at(properties.back().first);
    at = next;
  }
  FieldMap fields;
  std::size_t data = file.find("end_header\n") + 11;
  REQUIRE(file.size() >= data + count * row);
  for (std::size_t i = 0; i < count; ++i)
    for (const auto& [type, name] : properties) {
      fields[name].type = type;
      fields[name].bytes += file.substr(data, sizes.at(type));
      data += sizes.at(type);
    }
  return fields;
}

/// The arrays of the points of a VTU file.
inline FieldMap fields_of_vtu(const std::string& file) {
  FieldMap fields;
  const std::size_t begin = file.find("<PointData"), end = file.find("</PointData>"), data = file.find("\n_") + 2;
  for (std::size_t at = begin; (at = file.find("<DataArray", at)) < end; ++at) {
    const auto word = [&](const std::string& name) {
      const std::size_t from = file.find(name + "=\"", at) + name.size() + 2;
      return file.substr(from, file.find('"', from) - from);
    };
    const std::size_t place = data + std::stoul(word("offset"));
    std::uint64_t size = 0;
    std::memcpy(&size, &file[place], sizeof size);
    fields[word("Name")] = {word("type"), file.substr(place + sizeof size, size)};
  }
  return fields;
}

inline std::string comments_of(const std::string& file, const std::string& begin) {
  std::string found;
  for (std::size_t at = 0; (at = file.find(begin, at)) != std::string::npos; ++at)
    found += file.substr(at, file.find('\n', at) - at) + "\n";
  return found;
}

}  // namespace apps_test
