#include "rbpa/plane/filtration/shape_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/plane/filtration/ascending.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/ordered_triangles.h"
#include "rbpa/plane/filtration/solid_parts.h"

namespace rbpa {
namespace {

using Wide = long double;  // for its range of exponents: areas are products of coordinates

/// Returns the faces sorted by alpha and then by area, so that a sum of areas in this order depends on coordinates
/// only.
std::vector<std::uint32_t> by_alpha_and_area(const Filtration& filtration, const std::vector<Wide>& areas,
                                             Steps& pulse) {
  std::vector<std::uint32_t> faces = ascending(filtration.triangle_alpha, pulse);
  const std::vector<double>& alpha = filtration.triangle_alpha;
  for (auto first = faces.begin(); first != faces.end();) {
    const auto last =
        std::find_if(first, faces.end(), [&](std::uint32_t face) { return alpha[face] != alpha[*first]; });
    std::sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
      pulse();
      return areas[a] < areas[b];
    });
    first = last;
  }
  return faces;
}

/// The gaps of the complex while alpha falls: sets of triangles outside of the complex that are connected through sides
/// outside of the complex.
class Gaps {
 public:
  /// Makes each face a gap of its own; the outside is one more face, after the last.
  explicit Gaps(std::uint32_t faces) : outside_(faces), sets_(faces + std::size_t{1}), next_(sets_.size()) {
    std::iota(next_.begin(), next_.end(), 0u);
  }
  /// Joins the gaps of two faces. Calls outside_reaches(face) for each triangle that gets into the gap of the outside.
  template <typename Reaches>
  void join(std::uint32_t a, std::uint32_t b, const Reaches& outside_reaches) {
    // Faces are added in descending order. In reverse numbers, the least of a set is its oldest, and paths stay short.
    const std::uint32_t of_a = sets_.find(outside_ - a), of_b = sets_.find(outside_ - b);
    if (of_a == of_b) return;
    if (of_a == 0 || of_b == 0) {
      const std::uint32_t first = of_a == 0 ? b : a;
      std::uint32_t face = first;
      do outside_reaches(face);
      while ((face = next_[face]) != first);
    }
    std::swap(next_[a], next_[b]);  // two rings become one
    sets_.link(of_a, of_b);
  }

 private:
  std::uint32_t outside_;
  meshops::DisjointSets sets_;
  std::vector<std::uint32_t> next_;  // the faces of a gap are a ring
};

/// Returns for each face the first step at which the face is in the complex or in a hole. Requires: faces are sorted by
/// step.
std::vector<std::uint32_t> enclosed_from(const OwnedTriangles& of, const std::vector<std::uint32_t>& step_of,
                                         Steps& pulse) {
  const auto outside = static_cast<std::uint32_t>(of.triangles.size());
  std::vector<std::uint32_t> enclosed(of.triangles.size());
  Gaps gaps(outside);
  for (std::uint32_t i = outside; i-- > 0;) {
    pulse();
    for (const std::uint32_t neighbor : of.neighbors[i])
      if (neighbor > i)  // the neighbor is outside of the complex too; `none` is the greatest number
        gaps.join(i, std::min(neighbor, outside), [&](std::uint32_t face) { enclosed[face] = step_of[i]; });
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
  const std::vector<std::uint32_t> order = by_alpha_and_area(filtration, areas, pulse);
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
