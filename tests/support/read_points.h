// What: reads the point files of a data folder.
// Formats: .xy      text, two columns, one point a line;
//          .f64xy   little-endian doubles x, y without header; NAME.part1.f64xy, NAME.part2.f64xy … are one set.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

/// Set of points, with the files that hold it, in order.
struct PointFile {
  std::string name;  ///< without folder, part and ending
  std::vector<std::filesystem::path> parts;
};

/// Returns the point sets of a folder by name; none when there is no such folder.
std::vector<PointFile> point_files(const std::filesystem::path& folder);

/// Reads the points of a set. Throws: std::runtime_error naming the file (and line) that does not match the format of
/// its ending.
Points read_points(const PointFile& file);

}  // namespace rbpa_test
