#include "rbpa/plane/partial/region_complex.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"

namespace rbpa {

RegionComplex::RegionComplex(const Region& region, const RegionPoints& points, double alpha,
                             const PartialOptions& options)
    : points_(points.points), indices_(points.indices) {
  check_finite(alpha);
  check(region);
  if (points.points.size() != points.indices.size())
    throw InvalidInput(std::to_string(points.points.size()) + " points with " + std::to_string(points.indices.size()) +
                       " indices, expected as many");
  check_number(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!is_finite(points_[i]))
      throw InvalidInput("point " + std::to_string(indices_[i]) + " is (" + text(points_[i].x) + ", " +
                         text(points_[i].y) + "), expected finite coordinates");
  sort(points);
  owned_.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) owned_[i] = region.contains(points_[i]) ? 1 : 0;
  triangulation_ =
      alpha_complex(points_, alpha, {.neighbors = true, .threads = options.threads, .progress = options.progress});
}

void RegionComplex::sort(const RegionPoints& given) {
  if (!std::is_sorted(indices_.begin(), indices_.end())) {
    std::vector<std::uint32_t> order(given.points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return given.indices[a] < given.indices[b]; });
    sorted_points_.reserve(order.size());
    sorted_indices_.reserve(order.size());
    for (const std::uint32_t i : order) {
      sorted_points_.push_back(given.points[i]);
      sorted_indices_.push_back(given.indices[i]);
    }
    points_ = sorted_points_;
    indices_ = sorted_indices_;
  }
  const auto twice = std::adjacent_find(indices_.begin(), indices_.end());
  if (twice != indices_.end())
    throw InvalidInput("indices: index " + std::to_string(*twice) + " is given twice, expected each point once");
}

bool RegionComplex::owns_triangle(std::uint32_t t, unsigned owned) const {
  if (owned == 7) return true;
  const auto& corners = triangulation_.triangles[t];
  return owns(*std::min_element(corners.begin(), corners.end(),
                                [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; }));
}

}  // namespace rbpa
