// What: the header of NumPy's array format: reads versions 1 to 3, writes version 1.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/bytes/scalar.h"

namespace rbpa::app {

/// Shape, type and place of the numbers of an array in its file.
struct NpyLayout {
  std::size_t rows, columns;
  Scalar type;
  std::endian order;
  bool columns_first;  ///< Fortran order: all x before all y
  std::size_t data;    ///< offset of the first number

  std::size_t item() const { return size_of(type); }
  std::size_t row() const { return item() * columns; }
};

/// Reads the layout of a file of `size` bytes that begins with `bytes`, which must hold its whole header. Accepts
/// float32, float64 and integers of either byte order, and a number of columns among `fits`. Throws BadInput otherwise,
/// also if the file is too short for its shape.
NpyLayout read_npy_layout(std::string_view bytes, std::size_t size, const std::string& name,
                          std::span<const std::size_t> fits);

/// Returns the bytes before the numbers, of version 1. `type` is NumPy's name, such as "<u4". `columns` is the text of
/// the shape after the number of rows: ", 3" for three columns, "," for a one-dimensional array.
std::string npy_header(std::string_view type, std::uint64_t rows, std::string_view columns);

}  // namespace rbpa::app
