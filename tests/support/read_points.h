// What: the point files of a data folder.
// Formats: .xy      text, two columns, one point a line;
//          .f64xy   little-endian doubles x, y without header; NAME.part1.f64xy, NAME.part2.f64xy … are one set.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

/// One set of points and the files that hold it, in order.
struct PointFile {
  std::string name;  ///< without folder, part and ending
  std::vector<std::filesystem::path> parts;
};

/// The point sets of a folder by name; empty when there is no such folder.
std::vector<PointFile> point_files(const std::filesystem::path& folder);

/// Throws: std::runtime_error naming the file (and line) that is not of the format of its ending.
Points read_points(const PointFile& file);

}  // namespace rbpa_test
