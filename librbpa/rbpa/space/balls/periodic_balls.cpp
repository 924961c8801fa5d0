#include "rbpa/space/balls/periodic_balls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/periodic/cell_axes.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {
namespace {

using Offset = std::array<std::int32_t, 3>;
using Vector = space::Vector3<double>;
constexpr double most_layers = 100;  // of images on each side

/// The balls of a cell, and their images that may meet a ball of the cell.
class Images {
 public:
  Images(std::span<const Point3> centers, std::span<const double> radii, const RepeatingCell& cell, double probe)
      : cell_(cell), axes_(cell) {
    const double greatest = find_greatest(radii, probe);
    std::vector<std::array<double, 3>> place;  // in the cell: 0 to 1 along each edge
    for (std::size_t i = 0; i < centers.size(); ++i) {
      Offset offset{};  // of the own image in the cell
      std::array<double, 3> along = axes_.along(centers[i]);
      for (std::size_t k = 0; k < 3; ++k)
        if (cell.repeats[k]) {
          offset[k] = -space::CellAxes::whole(along[k], i);
          along[k] += offset[k];
        }
      add(centers[i], radii[i], static_cast<std::uint32_t>(i), offset);
      place.push_back(along);
    }
    for (std::uint32_t i = 0; i < centers.size(); ++i) add_images(i, place[i], radii[i] + probe + greatest);
  }

  std::vector<Point3> centers = {};
  std::vector<double> radii = {};
  std::vector<std::uint32_t> of = {};  // input ball of each image
  std::vector<Offset> offsets = {};    // number of edges by which each image is moved from the input ball

 private:
  /// Returns the greatest radius with the probe. Throws InvalidInput if images would be too many.
  double find_greatest(std::span<const double> of_balls, double probe) const {
    double greatest = 0;
    for (std::size_t i = 0; i < of_balls.size(); ++i) {
      greatest = std::max(greatest, of_balls[i] + probe);
      for (std::size_t k = 0; k < 3; ++k)
        if (cell_.repeats[k] && !(2 * (of_balls[i] + probe) * axes_.per_length(k) < most_layers))
          throw InvalidInput("radius " + std::to_string(i) + " is " + text(of_balls[i]) +
                             ", expected at most 50 times the distance of opposite faces of the cell");
    }
    return greatest;
  }
  void add(const Point3& center, double radius, std::uint32_t ball, const Offset& offset) {
    Point3 moved = center;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& edge = cell_.edges[k];
      moved.x += offset[k] * edge.x;
      moved.y += offset[k] * edge.y;
      moved.z += offset[k] * edge.z;
    }
    centers.push_back(moved);
    radii.push_back(radius);
    of.push_back(ball);
    offsets.push_back(offset);
  }

  /// Adds the images of ball i, which is at `place`, that are less than `reach` away from the cell.
  void add_images(std::uint32_t i, const std::array<double, 3>& place, double reach) {
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
            for (std::size_t k = 0; k < 3; ++k) offsets.back()[k] += first[k];
          }
  }

  const RepeatingCell& cell_;
  space::CellAxes axes_;
};

}  // namespace

double RepeatingCell::volume() const {
  const auto& [a, b, c] = edges;
  return std::abs(space::dot(space::cross(Vector{a.x, a.y, a.z}, {b.x, b.y, b.z}), Vector{c.x, c.y, c.z}));
}

PeriodicBallMeasures measure_periodic_balls(std::span<const Point3> centers, std::span<const double> radii,
                                            const RepeatingCell& cell, const MeasureBallsOptions& options) {
  space::check_centers(centers, radii);
  const Images all(centers, radii, cell, options.probe);
  PeriodicBallMeasures result;
  static_cast<BallMeasures&>(result) = measure_balls(all.centers, all.radii, options);
  const auto own = static_cast<std::uint32_t>(centers.size());
  ExactSum volume, area;
  for (std::size_t i = 0; i < own; ++i) {
    volume.add(result.volumes[i]);
    area.add(result.areas[i]);
  }
  result.volume = volume.rounded();
  result.area = area.rounded();
  for (auto* values : {&result.volumes, &result.areas}) values->resize(own);
  result.arcs.resize(own);
  std::erase_if(result.hidden, [&](std::uint32_t i) { return i >= own; });
  if (options.derivatives)
    for (auto* values : {&result.volume_gradient, &result.area_gradient}) values->resize(own);
  std::vector<std::pair<BallContact, Offset>> contacts;
  for (BallContact contact : std::exchange(result.contacts, {})) {
    auto& [a, b] = contact.balls;
    if (a >= own) continue;  // between images
    Offset offset{};
    for (std::size_t k = 0; k < 3; ++k) offset[k] = all.offsets[b][k] - all.offsets[a][k];
    const bool is_own = b < own;
    b = all.of[b];
    if (is_own || a < b || (a == b && offset > Offset{})) contacts.emplace_back(contact, offset);
  }
  std::sort(contacts.begin(), contacts.end(), [](const auto& c, const auto& d) {
    return std::pair(c.first.balls, c.second) < std::pair(d.first.balls, d.second);
  });
  for (const auto& [contact, offset] : contacts) {
    result.contacts.push_back(contact);
    result.contact_offsets.push_back(offset);
  }
  return result;
}

}  // namespace rbpa
