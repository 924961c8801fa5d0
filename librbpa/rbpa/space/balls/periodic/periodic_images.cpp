#include "rbpa/space/balls/periodic/periodic_images.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"

namespace rbpa::space {

PeriodicImages::PeriodicImages(std::span<const Point3> of_centers, std::span<const double> of_radii,
                               const RepeatingCell& cell, double probe)
    : cell_(cell), axes_(cell) {
  const double greatest = find_greatest(of_radii, probe);
  std::vector<std::array<double, 3>> place;  // in the cell: 0 to 1 along each edge
  for (std::size_t i = 0; i < of_centers.size(); ++i) {
    Offset offset{};  // of the own image in the cell
    std::array<double, 3> along = axes_.along(of_centers[i]);
    for (std::size_t k = 0; k < 3; ++k)
      if (cell.repeats[k]) {
        offset[k] = -CellAxes::whole(along[k], i);
        along[k] += offset[k];
      }
    add(of_centers[i], of_radii[i], static_cast<std::uint32_t>(i), offset);
    place.push_back(along);
  }
  for (std::uint32_t i = 0; i < of_centers.size(); ++i) add_images(i, place[i], of_radii[i] + probe + greatest);
}

/// Returns the greatest radius with the probe. Throws InvalidInput if images would be too many.
double PeriodicImages::find_greatest(std::span<const double> of_balls, double probe) const {
  double greatest = 0;
  for (std::size_t i = 0; i < of_balls.size(); ++i) {
    greatest = std::max(greatest, of_balls[i] + probe);
    for (std::size_t k = 0; k < 3; ++k)
      if (cell_.repeats[k] && !(2 * (of_balls[i] + probe) * axes_.per_length(k) < CellAxes::most_layers))
        throw InvalidInput("radius " + std::to_string(i) + " is " + text(of_balls[i]) +
                           ", expected at most 50 times the distance of opposite faces of the cell");
  }
  return greatest;
}

void PeriodicImages::add(const Point3& center, double radius, std::uint32_t ball, const Offset& offset) {
  centers.push_back(moved(center, cell_.edges, offset));
  radii.push_back(radius);
  of.push_back(ball);
  offsets.push_back(offset);
}

/// Adds the images of ball i, which is at `place`, that are less than `reach` away from the cell.
void PeriodicImages::add_images(std::uint32_t i, const std::array<double, 3>& place, double reach) {
  std::array<std::int32_t, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k)
    if (cell_.repeats[k]) {
      const double margin = reach * axes_.per_length(k) + 0x1p-30;
      low[k] = static_cast<std::int32_t>(std::ceil(-margin - place[k]));
      high[k] = static_cast<std::int32_t>(std::floor(1 + margin - place[k]));
    }
  const Point3 own = centers[i];
  const Offset first = offsets[i];
  for (std::int32_t x = low[0]; x <= high[0]; ++x)
    for (std::int32_t y = low[1]; y <= high[1]; ++y)
      for (std::int32_t z = low[2]; z <= high[2]; ++z)
        if (x != 0 || y != 0 || z != 0) {
          add(own, radii[i], i, {x, y, z});
          offsets.back() = plus(first, {x, y, z});
        }
}

}  // namespace rbpa::space
