// What: the header of NumPy's array format: what an array of a file is, versions 1 to 3, and that of one to write.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/bytes/scalar.h"

namespace rbpa::app {

/// Where the numbers of an array are.
struct NpyLayout {
  std::size_t rows, columns;
  Scalar type;
  std::endian order;
  bool columns_first;  ///< all x before all y
  std::size_t data;    ///< offset of the first number

  std::size_t item() const { return size_of(type); }
  std::size_t row() const { return item() * columns; }
  double end() const { return static_cast<double>(data) + static_cast<double>(rows) * static_cast<double>(row()); }
};

/// Of a file of `size` bytes that begins with `bytes`, all of its header among them. Its columns are as many as one of `fits`,
/// or any where there are none. Numbers are float32, float64 or integers, in either byte order. Throws BadInput, also when the
/// file is too short for the shape.
NpyLayout read_npy_layout(std::string_view bytes, std::size_t size, const std::string& name,
                          std::span<const std::size_t> fits = {});

/// The bytes before the numbers, version 1. `type` is "<u4"; `columns`: what Python writes of a shape behind the number of
/// rows, ", 3" or ",".
std::string npy_header(std::string_view type, std::uint64_t rows, std::string_view columns);

}  // namespace rbpa::app
