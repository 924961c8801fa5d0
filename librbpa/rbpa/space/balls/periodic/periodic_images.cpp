#include "rbpa/space/balls/periodic/periodic_images.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"

namespace rbpa::space {
namespace {

using Vector = Vector3<double>;
constexpr double most_layers = 100;      // of images on each side
constexpr double near_face = 0x1.7p-31;  // distance from a face, in edges, within which a ball belongs to the face

}  // namespace

PeriodicImages::PeriodicImages(std::span<const Point3> centers, std::span<const double> radii,
                               const RepeatingCell& cell, double probe)
    : cell_(cell) {
  find_normals();
  const double greatest = find_greatest(radii, probe);
  std::vector<std::array<double, 3>> place;  // in the cell: 0 to 1 along each edge
  for (std::size_t i = 0; i < centers.size(); ++i) {
    Offset offset{};  // of the own image in the cell
    std::array<double, 3> along = along_edges(centers[i]);
    for (std::size_t k = 0; k < 3; ++k)
      if (cell.repeats[k]) {
        if (!(std::abs(along[k]) < 0x1p30))
          throw InvalidInput("center " + std::to_string(i) + " is too many cells away, expected fewer than 2^30");
        // Balls that are equal modulo the cell come to the same face of it, whatever rounding does.
        offset[k] = -static_cast<std::int32_t>(std::floor(along[k] + near_face));
        along[k] += offset[k];
      }
    add(centers[i], radii[i], static_cast<std::uint32_t>(i), offset);
    place.push_back(along);
  }
  for (std::uint32_t i = 0; i < centers.size(); ++i) add_images(i, place[i], radii[i] + probe + greatest);
}

void PeriodicImages::find_normals() {
  const auto& [a, b, c] = cell_.edges;
  for (const Point3& edge : cell_.edges)
    if (!is_finite(edge)) throw InvalidInput("found edges of a cell that are not finite, expected finite ones");
  const std::array<Vector, 3> e = {Vector{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
  for (std::size_t k = 0; k < 3; ++k) {
    normals_[k] = cross(e[(k + 1) % 3], e[(k + 2) % 3]);
    const double volume = dot(normals_[k], e[k]);
    const double size = std::sqrt(dot(normals_[k], normals_[k])) * std::sqrt(dot(e[k], e[k]));
    if (!(std::abs(volume) > 0x1p-40 * size && size < std::numeric_limits<double>::infinity()))
      throw InvalidInput(
          "found a cell without a volume, or with one beyond the range of double, expected three edges in different "
          "directions");
    normals_[k] = {normals_[k].x / volume, normals_[k].y / volume, normals_[k].z / volume};
  }
}

/// Returns the greatest radius with the probe. Throws InvalidInput if images would be too many.
double PeriodicImages::find_greatest(std::span<const double> of_balls, double probe) const {
  double greatest = 0;
  for (std::size_t i = 0; i < of_balls.size(); ++i) {
    greatest = std::max(greatest, of_balls[i] + probe);
    for (std::size_t k = 0; k < 3; ++k)
      if (cell_.repeats[k] && !(2 * (of_balls[i] + probe) * std::sqrt(dot(normals_[k], normals_[k])) < most_layers))
        throw InvalidInput("radius " + std::to_string(i) + " is " + text(of_balls[i]) +
                           ", expected at most 50 times the distance of opposite faces of the cell");
  }
  return greatest;
}

std::array<double, 3> PeriodicImages::along_edges(const Point3& p) const {
  std::array<double, 3> along{};
  for (std::size_t k = 0; k < 3; ++k) along[k] = dot(normals_[k], Vector{p.x, p.y, p.z});
  return along;
}

void PeriodicImages::add(const Point3& center, double radius, std::uint32_t ball, const Offset& offset) {
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
void PeriodicImages::add_images(std::uint32_t i, const std::array<double, 3>& place, double reach) {
  std::array<std::int32_t, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k)
    if (cell_.repeats[k]) {
      const double margin = reach * std::sqrt(dot(normals_[k], normals_[k])) + 0x1p-30;
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

}  // namespace rbpa::space
