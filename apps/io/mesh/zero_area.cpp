#include "io/mesh/zero_area.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "rbpa/plane/collinear.h"

namespace rbpa::app {
namespace {

/// The coordinate planes onto which a face is projected, each as two axes.
constexpr std::pair<std::size_t, std::size_t> planes[] = {{0, 1}, {1, 2}, {2, 0}};

/// Returns whether the projections of three points to one of the planes certainly span an area. The error of the
/// determinant is below (3 + 16ε)ε times the sum of its two products (Shewchuk 1997, section 4.4), ε = 2⁻⁵³, unless
/// products underflow, which changes the determinant by less than 2⁻¹⁰⁷³. If products overflow, no comparison is true.
bool surely_span_area(const Position& a, const Position& b, const Position& c) {
  constexpr double error = 4e-16, least = 1e-300;
  return std::any_of(std::begin(planes), std::end(planes), [&](const auto& plane) {
    const auto& [x, y] = plane;
    const double one = (a[x] - c[x]) * (b[y] - c[y]), other = (a[y] - c[y]) * (b[x] - c[x]);
    const double area = std::abs(one - other);
    return area > least && area > error * (std::abs(one) + std::abs(other)) && std::isfinite(area);
  });
}

}  // namespace

// Decide by projections: points are on one line in space if and only if they are on one line in all three projections.
bool is_on_a_line(std::span<const std::uint32_t> face, std::span<const Position> positions) {
  for (std::size_t i = 2; i < face.size(); ++i)
    if (surely_span_area(positions[face[0]], positions[face[1]], positions[face[i]])) return false;
  return std::all_of(std::begin(planes), std::end(planes), [&](const auto& plane) {
    std::vector<Point> points;
    for (const std::uint32_t corner : face)
      points.push_back({positions[corner][plane.first], positions[corner][plane.second]});
    return are_collinear(points);
  });
}

}  // namespace rbpa::app
