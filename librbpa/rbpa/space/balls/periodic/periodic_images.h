// What: lists the balls of a cell that repeats, and their images that may meet a ball of the cell.
// Cost: linear in the number of balls and images.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/balls/periodic/cell_axes.h"
#include "rbpa/space/balls/periodic_balls.h"

namespace rbpa::space {

/// The balls, each moved into the cell, and after them images. Two balls of any images meet only if a ball of the cell
/// meets the other one, or its image in the list.
class PeriodicImages {
 public:
  using Offset = Boxes;

  /// Throws InvalidInput that names the violated requirement of measure_periodic_balls().
  PeriodicImages(std::span<const Point3> of_centers, std::span<const double> of_radii, const RepeatingCell& cell,
                 double probe);

  std::vector<Point3> centers = {};
  std::vector<double> radii = {};
  std::vector<std::uint32_t> of = {};  ///< input ball of each image
  std::vector<Offset> offsets = {};    ///< number of edges by which each image is moved from the input ball

 private:
  double find_greatest(std::span<const double> of_balls, double probe) const;
  void add(const Point3& center, double radius, std::uint32_t ball, const Offset& offset);
  void add_images(std::uint32_t i, const std::array<double, 3>& place, double reach);

  const RepeatingCell cell_;
  CellAxes axes_;
};

}  // namespace rbpa::space
