#include "io/npy_header.h"

namespace rbpa::app {

std::string npy_header(std::string_view type, std::uint64_t rows, std::string_view columns) {
  std::string text = "{'descr': '";
  text += type;
  text += "', 'fortran_order': False, 'shape': (";
  text += std::to_string(rows);
  text += columns;
  text += "), }";
  constexpr std::size_t before = 10, alignment = 64;  // bytes before the text; where NumPy wants the data
  text.append(alignment - (before + text.size() + 1) % alignment, ' ');
  text += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(text.size() & 0xFFU);
  bytes += static_cast<char>(text.size() >> 8U);
  return bytes + text;
}

}  // namespace rbpa::app
