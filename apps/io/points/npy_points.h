// What: points from NumPy's array format, versions 1 to 3.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rbpa/core/point.h"

namespace rbpa::app {

/// An array of shape (n, 2), or (n, 3) whose third column is left out; float32, float64 or integers, either byte order,
/// rows or columns first. What follows the array is left alone, as NumPy does. Throws BadInput, before anything is
/// allocated when the file is too short for the shape.
std::vector<Point> read_npy_points(std::string_view bytes, const std::string& name);

}  // namespace rbpa::app
