// Small whole files of every format that says how much it holds.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/las_file.h"

namespace apps_test {

/// The ending of its name says the format.
struct File {
  std::string name, content;
  std::size_t behind = 0;  ///< of its bytes, what the header does not speak of
};

/// Of points, of points of space, of meshes.
std::vector<File> claiming_points();
std::vector<File> claiming_space();
std::vector<File> claiming_meshes();

/// So many zeros of type float32.
std::string npy_of_zeros(const std::string& shape, std::size_t numbers);

/// Points on a diagonal, and records behind them.
std::string las_of(std::size_t points, const std::vector<LasRecord>& extended = {});

}  // namespace apps_test
