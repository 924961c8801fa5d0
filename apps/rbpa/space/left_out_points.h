// What: takes points out of a cloud before a run, and afterwards renumbers the result by the points of the whole file.
// Law:  if no point is left out, nothing changes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/cloud/read_space_points.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface.h"
#include "space/surface_report.h"

namespace rbpa::app {

/// Replaces each point number i in the facts by number[i].
void renumber(SurfaceFacts& facts, std::span<const std::uint32_t> number);

class LeftOutPoints {
 public:
  LeftOutPoints() = default;
  /// Takes the points with these numbers out of the cloud: ascending, at least one.
  LeftOutPoints(SpacePoints& cloud, std::span<const std::uint32_t> left_out);

  /// Declares that the last `count` points of the cloud are new: in the whole file they follow all others.
  void add_last(const SpacePoints& cloud, std::size_t count);

  bool is_any() const { return !whole_.points.empty(); }

  /// Replace numbers among the kept points by numbers in the whole file. The kept points stay in order, so orders by
  /// number stay valid.
  void renumber(Surface& surface) const;
  void renumber(SplitFans& fans) const;
  void renumber(SurfaceFacts& facts) const;

  /// Return the values of all points of the file: the given ones for the kept points, and those of the file for the
  /// points left out. Normals and confidences that the file does not have are 0.
  std::vector<Point3> all_points(std::span<const Point3> of_others) const;
  std::vector<Point3> all_normals(std::span<const Point3> of_others) const;
  std::vector<double> all_confidence(std::span<const double> of_others) const;
  std::span<const std::array<std::uint8_t, 3>> all_colors() const { return whole_.colors; }
  /// Returns positions for pictures: points left out are moved onto the first of the kept points, so that they do not
  /// show.
  std::vector<Point3> seen_points(std::span<const Point3> of_others) const;

 private:
  template <typename Value>
  std::vector<Value> all(std::span<const Value> of_others, std::vector<Value> values) const;

  SpacePoints whole_ = {};
  std::vector<std::uint32_t> number_ = {};  // in the file, for each kept point
};

}  // namespace rbpa::app
