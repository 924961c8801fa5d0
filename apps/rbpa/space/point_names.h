// What: names the points of a run in its files: by input indices, and atoms by the columns of the input.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "io/cloud/read_space_points.h"
#include "io/values_at.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

class PointNames {
 public:
  /// Keeps a reference to the file. Requires: its texts are those of columns_of_names(), or none.
  explicit PointNames(const SpacePoints& file) : file_(file) {}

  std::span<const Point3> points() const { return file_.points; }
  std::uint32_t index(std::uint32_t point) const { return renumbered(point, file_.index); }
  nlohmann::ordered_json indices(std::span<const std::uint32_t> points) const;

  /// Return whether the input has this one of columns_of_names(), or any of them.
  bool has(std::size_t column) const;
  bool are_any() const;
  const std::string& text(std::size_t column, std::uint32_t point) const;
  /// Returns an object for each point: x, y, z and the columns of the input; null if the point has no value.
  nlohmann::ordered_json atoms(std::span<const std::uint32_t> points) const;

 private:
  const SpacePoints& file_;
};

}  // namespace rbpa::app
