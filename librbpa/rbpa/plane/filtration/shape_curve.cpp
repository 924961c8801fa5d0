#include "rbpa/plane/filtration/shape_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/ordered_triangles.h"
#include "rbpa/plane/filtration/solid_parts.h"

namespace rbpa {
namespace {

using Wide = long double;  // for its range of exponents: areas are products of coordinates

/// Returns for each face the first step at which the face is in the complex or in a hole. Requires: faces are sorted by
/// step.
std::vector<std::uint32_t> enclosed_from(const OwnedTriangles& of, const std::vector<std::uint32_t>& step_of,
                                         Steps& pulse) {
  const auto outside = static_cast<std::uint32_t>(of.triangles.size());
  std::vector<std::uint32_t> enclosed(of.triangles.size());
  // The gaps of the complex while alpha falls: sets of triangles outside of the complex that are connected through
  // sides outside of the complex; the outside is one more face, after the last. Faces are added in descending order: in
  // reverse numbers, the least of a set is its oldest, and paths stay short.
  meshops::DisjointSets gaps(outside + std::size_t{1});
  meshops::MemberRings faces(gaps.size());
  for (std::uint32_t i = outside; i-- > 0;) {
    pulse();
    for (const std::uint32_t neighbor : of.neighbors[i]) {
      if (neighbor <= i) continue;  // the neighbor is in the complex; `none` is the greatest number
      const std::uint32_t beyond = std::min(neighbor, outside);
      const std::uint32_t gap = gaps.find(outside - i), other = gaps.find(outside - beyond);
      if (gap == other) continue;
      if (gap == 0 || other == 0)  // the outside reaches the faces of the other gap
        faces.for_each(gap == 0 ? beyond : i, [&](std::uint32_t face) { enclosed[face] = step_of[i]; });
      faces.join(i, beyond);
      gaps.link(gap, other);
    }
  }
  return enclosed;
}

/// Returns the area of complex and holes at each step.
std::vector<Wide> enclosed_areas(const OwnedTriangles& of, const std::vector<std::uint32_t>& step_of,
                                 const std::vector<Wide>& areas, Steps& pulse) {
  const std::vector<std::uint32_t> from = enclosed_from(of, step_of, pulse);
  std::vector<Wide> enclosed(step_of.empty() ? 0 : step_of.back() + std::size_t{1});
  for (std::size_t i = 0; i < areas.size(); ++i) enclosed[from[i]] += areas[i];
  std::partial_sum(enclosed.begin(), enclosed.end(), enclosed.begin());
  return enclosed;
}

Wide eighth_root(Wide x) { return std::sqrt(std::sqrt(std::sqrt(x))); }

}  // namespace

std::vector<ShapeState> shape_curve(const Delaunay& of, const Filtration& filtration, Steps& pulse) {
  const AlphaComplex& delaunay = of.triangulation();
  const std::span<const Point> points = of.points();
  const std::vector<double>& alpha = filtration.triangle_alpha;
  std::vector<Wide> areas(delaunay.triangles.size());
  for (std::size_t t = 0; t < areas.size(); ++t) {
    pulse();
    areas[t] = area(corners_of(points, delaunay.triangles[t]));
  }
  auto order = sorted_by_alpha(alpha, pulse);
  sort_equal_by_volume<Wide>(order, alpha, areas, pulse);
  const OwnedTriangles ordered = in_order(delaunay, order);
  std::vector<std::uint32_t> step_of(order.size());
  std::vector<Wide> ordered_areas(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    ordered_areas[i] = areas[order[i]];
    if (i > 0) step_of[i] = step_of[i - 1] + (alpha[order[i]] != alpha[order[i - 1]]);
  }
  areas = std::vector<Wide>();
  const std::vector<Wide> enclosed = enclosed_areas(ordered, step_of, ordered_areas, pulse);

  // The area of a flat triangle may round to 0.
  const auto positive = [](Wide area) { return std::max(area, std::numeric_limits<Wide>::min()); };
  const Wide whole = enclosed.empty() ? 1 : positive(enclosed.back());
  SolidParts parts(ordered, points.size());
  std::uint64_t vertices = 0, squares = 0, most_squares = 0;
  Wide solid = 0, turns = 1, filled_before = 1;
  std::vector<ShapeState> curve;
  curve.reserve(filtration.steps.size());
  std::size_t i = 0;
  for (std::size_t step = 0; step < filtration.steps.size(); ++step) {
    for (; i < order.size() && step_of[i] == step; ++i) {
      pulse();
      solid += ordered_areas[i];
      parts.add_next(
          [&](std::uint64_t size) {
            vertices -= size;
            squares -= size * size;
          },
          [&](std::uint64_t size) {
            vertices += size;
            squares += size * size;
          });
    }
    most_squares = std::max(most_squares, squares);
    const Wide filled = std::min(Wide(1), positive(solid) / positive(enclosed[step]));
    turns *= std::max(filled / filled_before, filled_before / filled);
    filled_before = filled;
    curve.push_back({static_cast<Wide>(most_squares) * turns * eighth_root(positive(enclosed[step]) / whole),
                     static_cast<double>(vertices) * static_cast<double>(vertices) / static_cast<double>(squares),
                     static_cast<double>(1 - filled)});
  }
  return curve;
}

}  // namespace rbpa
