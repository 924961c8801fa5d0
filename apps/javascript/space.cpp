// What: the functions of surfaces in space that WebAssembly exports.
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "javascript/exports.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/surface/surface.h"

namespace {

using rbpa::Point3;
using rbpa::javascript::completes;
using rbpa::javascript::results;

std::span<const Point3> points3_of(const double* numbers, std::size_t count) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return {reinterpret_cast<const Point3*>(numbers), count};
}

}  // namespace

/// Computes triangles and neighbors of a surface. Estimates normals if `normals` is null.
RBPA_EXPORT bool rbpa_surface(const double* points, const double* normals, std::size_t count, double radius) {
  return completes([&] {
    const auto input = points3_of(points, count);
    std::vector<Point3> estimated;
    if (normals == nullptr) estimated = rbpa::estimate_normals(input);
    rbpa::Surface made = rbpa::surface(
        input, normals == nullptr ? std::span<const Point3>(estimated) : points3_of(normals, count), radius);
    results.add(std::move(made.triangles));
    results.add(std::move(made.neighbors));
  });
}
