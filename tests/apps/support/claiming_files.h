// Small complete files of every format that declares sizes in its header.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/las_file.h"

namespace apps_test {

/// A file; the ending of its name is the format.
struct File {
  std::string name, content;
  std::size_t behind = 0;  ///< number of bytes that the header does not describe
};

/// Return files to be read as points of the plane, as points in space, and as meshes.
std::vector<File> claiming_points();
std::vector<File> claiming_space();
std::vector<File> claiming_meshes();

/// Returns an .npy file of zeros of type float32.
std::string npy_of_zeros(const std::string& shape, std::size_t numbers);

/// Returns a LAS file of points on a diagonal, with records after them.
std::string las_of(std::size_t points, const std::vector<LasRecord>& extended = {});

}  // namespace apps_test
