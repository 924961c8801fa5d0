#include "rbpa/space/cells/check_input.h"

#include <cmath>
#include <cstddef>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa::space {
namespace {

std::string at(const Point3& p) { return "(" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")"; }

}  // namespace

void check_points(std::span<const Point3> points) {
  if (points.size() >= TriangleArrays::none)
    throw InvalidInput(std::to_string(points.size()) + " points, expected at most " +
                       std::to_string(TriangleArrays::none - 1));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InvalidInput("point " + std::to_string(i) + " is " + at(points[i]) + ", expected finite coordinates");
}

void check_centers(std::span<const Point3> centers, std::span<const double> radii) {
  check_points(centers);
  if (radii.size() != centers.size())
    throw InvalidInput(std::to_string(radii.size()) + " radii, expected one for each of " +
                       std::to_string(centers.size()) + " centers");
}

void check_balls(std::span<const Point3> centers, std::span<const double> radii) {
  check_centers(centers, radii);
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (!(radii[i] >= 0) || std::isinf(radii[i]))
      throw InvalidInput("radius " + std::to_string(i) + " is " + text(radii[i]) +
                         ", expected a finite number of at least 0");
}

void check_radius(double radius) {
  if (!(radius > 0) || std::isinf(radius))
    throw InvalidInput("the radius is " + text(radius) + ", expected a finite number above 0");
}

void check_radii(std::span<const double> radii) {
  if (radii.empty()) throw InvalidInput("found no radius, expected at least one above 0");
  for (std::size_t i = 0; i < radii.size(); ++i) {
    check_radius(radii[i]);
    if (i > 0 && !(radii[i - 1] < radii[i]))
      throw InvalidInput("radius " + text(radii[i]) + " comes after " + text(radii[i - 1]) +
                         ", expected strictly ascending radii");
  }
}

void check_normals(std::span<const Point3> points, std::span<const Point3> normals) {
  if (normals.size() != points.size())
    throw InvalidInput(std::to_string(normals.size()) + " normals, expected one for each of " +
                       std::to_string(points.size()) + " points");
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (!is_finite(normals[i]) || normals[i] == Point3{})
      throw InvalidInput("normal " + std::to_string(i) + " is " + at(normals[i]) +
                         ", expected finite coordinates, not all 0");
}

}  // namespace rbpa::space
