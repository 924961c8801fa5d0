// NumPy's files put together by hand, right or wrong.
#pragma once

#include <string>

namespace apps_test {

/// Version 1: `dictionary`, such as "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2)}", and the numbers.
inline std::string npy_file(const std::string& dictionary, const std::string& data) {
  const std::size_t size = dictionary.size() + 1;
  std::string file("\x93NUMPY\x01\x00", 8);
  file += static_cast<char>(size & 0xffU);
  file += static_cast<char>(size >> 8U);
  return file + dictionary + "\n" + data;
}

}  // namespace apps_test
