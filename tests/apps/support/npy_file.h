// NumPy's files: built byte by byte, right or wrong, and read.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace apps_test {

/// Returns a file of version 1: `dictionary`, such as "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2)}", and
/// the numbers.
inline std::string npy_file(const std::string& dictionary, const std::string& data) {
  const std::size_t size = dictionary.size() + 1;
  std::string file("\x93NUMPY\x01\x00", 8);
  file += static_cast<char>(size & 0xffU);
  file += static_cast<char>(size >> 8U);
  return file + dictionary + "\n" + data;
}

/// Return the rows of a file of uint32, or its numbers one by one.
template <typename Row = std::uint32_t>
std::vector<Row> npy_rows(const std::string& file) {
  CHECK(file.find("'descr': '<u4'") != std::string::npos);
  const std::size_t begin = 10U + static_cast<unsigned char>(file[8]) + 256U * static_cast<unsigned char>(file[9]);
  std::vector<Row> rows((file.size() - begin) / sizeof(Row));
  if (!rows.empty()) std::memcpy(rows.data(), file.data() + begin, rows.size() * sizeof(Row));
  return rows;
}

}  // namespace apps_test
