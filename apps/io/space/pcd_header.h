// What: the header of a file of the Point Cloud Library, version 0.5 to 0.7: which fields its points have.
// Source: https://pointclouds.org/documentation/tutorials/pcd_file_format.html
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scalar.h"

namespace rbpa::app {

struct PcdField {
  std::string name;
  Scalar type;
  std::size_t count;   ///< numbers of it in each point
  std::size_t first;   ///< which number of the point is its first
  std::size_t offset;  ///< where it begins among the bytes of a point
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t points;
  std::size_t line;         ///< that says how many
  bool binary;              ///< else ASCII
  std::size_t lines;        ///< of the header
  std::string_view data;    ///< what follows it
  std::size_t numbers = 0;  ///< of a point
  std::size_t size = 0;     ///< of a point in bytes

  const PcdField* find(std::string_view name) const;  ///< null when there is none
};

/// Throws BadInput naming the line; also when what follows is too short for so many points.
PcdHeader read_pcd_header(std::string_view bytes, const std::string& name);

/// A Claim: the bytes of all points, or as many lines.
double claimed_pcd_size(std::string_view first, const std::string& name);

/// "3 points as line 9 says".
std::string announced(const PcdHeader& header);

}  // namespace rbpa::app
