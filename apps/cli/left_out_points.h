// What: points of a cloud that a run leaves out, and the numbers of the file for what is made of the others.
// Law:  without points left out nothing is changed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cli/surface_report.h"
#include "io/cloud/read_space_points.h"
#include "rbpa/split_fans.h"
#include "rbpa/surface.h"

namespace rbpa::app {

/// To the numbers that points have elsewhere, of all that facts name.
void renumber(SurfaceFacts& facts, std::span<const std::uint32_t> number);

class LeftOutPoints {
 public:
  LeftOutPoints() = default;
  /// Takes these points, ascending, at least one, out of the cloud.
  LeftOutPoints(SpacePoints& cloud, std::span<const std::uint32_t> left_out);

  /// The last points of the cloud, so many, are new in the file, behind all others.
  void add_last(const SpacePoints& cloud, std::size_t count);

  bool is_any() const { return !whole_.points.empty(); }

  /// From numbers among the others to those of the file. Orders that follow from numbers stay.
  void renumber(Surface& surface) const;
  void renumber(SplitFans& fans) const;
  void renumber(SurfaceFacts& facts) const;

  /// Those of all points: of the others as given, if there are any, and of the points left out as they came; normals that the file does
  /// not have are 0, and so are certainties.
  std::vector<Point3> all_points(std::span<const Point3> of_others) const;
  std::vector<Point3> all_normals(std::span<const Point3> of_others) const;
  std::vector<double> all_certainty(std::span<const double> of_others) const;
  std::span<const std::array<std::uint8_t, 3>> all_colors() const { return whole_.colors; }
  /// The same where nothing is seen of the points left out: they are where the first of the others is.
  std::vector<Point3> seen_points(std::span<const Point3> of_others) const;

 private:
  template <typename Value>
  std::vector<Value> all(std::span<const Value> of_others, std::vector<Value> values) const;

  SpacePoints whole_ = {};
  std::vector<std::uint32_t> number_ = {};  // of each of the others, in the file
};

}  // namespace rbpa::app
