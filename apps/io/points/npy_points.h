// What: points from NumPy's array format, versions 1 to 3.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include "io/point_file.h"
#include "io/scalar.h"

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

/// Of a file of `size` bytes that begins with `bytes`, all of its header among them, whose columns are so many or so many.
/// Throws as read_npy_points().
NpyLayout read_npy_layout(std::string_view bytes, std::size_t size, const std::string& name,
                          std::array<std::size_t, 2> columns = {2, 3});

/// A Claim: the bytes of all rows.
double claimed_npy_size(std::string_view first, const std::string& name);

/// An array of shape (n, 2), or (n, 3) whose third column is left out; float32, float64 or integers, either byte order,
/// rows or columns first. What follows the array is left alone, as NumPy does. Throws BadInput, before anything is
/// allocated when the file is too short for the shape.
PointFile read_npy_points(std::string_view bytes, const std::string& name);

}  // namespace rbpa::app
