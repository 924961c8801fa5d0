// What: reads and writes the header of NumPy's array format: reads versions 1 to 3, writes version 1.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/scalar.h"

namespace rbpa::app {

/// The shape of an array, the type of its numbers, and their place in the file.
struct NpyLayout {
  std::size_t rows, columns;
  Scalar type;
  std::endian order;
  bool columns_first;  ///< Fortran order: all x before all y
  std::size_t data;    ///< offset of the first number

  std::size_t item() const { return size_of(type); }
  std::size_t row() const { return item() * columns; }
};

/// Reads the layout of a file of `size` bytes, of which `bytes` are the first. Accepts float32, float64 and integers,
/// in either byte order, and a number of columns that is in `fits`. Throws BadInput otherwise, also if `bytes` end
/// within the header or the file is too short for the shape.
NpyLayout read_npy_layout(std::string_view bytes, std::size_t size, const std::string& name,
                          std::span<const std::size_t> fits);

/// Returns the header, in version 1: all bytes before the numbers. `type` is NumPy's name of the type, such as "<u4".
/// `columns` is the text of the shape after the number of rows: ", 3" for three columns, "," for a one-dimensional
/// array.
std::string npy_header(std::string_view type, std::uint64_t rows, std::string_view columns);

}  // namespace rbpa::app
