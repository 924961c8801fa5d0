// What: writes the points of a run by their input indices, and atoms by the columns that name them.
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
  /// Keeps a reference to `file`. Requires: file.texts is empty, or has the columns of columns_of_names().
  explicit PointNames(const SpacePoints& file) : file_(file) {}

  std::span<const Point3> points() const { return file_.points; }
  /// Returns the input index of point number `point`.
  std::uint32_t index(std::uint32_t point) const { return renumbered(point, file_.index); }
  /// Returns a JSON array of the input indices of `points`, in their order.
  nlohmann::ordered_json indices(std::span<const std::uint32_t> points) const;

  /// Returns whether the input has the column columns_of_names()[column].
  bool has(std::size_t column) const;
  /// Returns whether the input has any of columns_of_names().
  bool has_any() const;
  /// Returns the text of point number `point` in the column columns_of_names()[column]. Requires: has(column).
  const std::string& text(std::size_t column, std::uint32_t point) const;
  /// Returns an object for each of `points`: x, y, z, and the columns of columns_of_names() that the input has. A
  /// column without a value for the point is null.
  nlohmann::ordered_json atoms(std::span<const std::uint32_t> points) const;

 private:
  const SpacePoints& file_;
};

}  // namespace rbpa::app
