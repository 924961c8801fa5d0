#include "support/triangle.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace rbpa_test {

std::vector<Triangle> canonical(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Triangle> renumbered(std::vector<Triangle> triangles, std::span<const std::uint32_t> to) {
  for (Triangle& t : triangles)
    for (std::uint32_t& corner : t) corner = to[corner];
  return canonical(std::move(triangles));
}

std::vector<std::uint32_t> lowest_equal(std::span<const rbpa::Point> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    if (points[i] == points[j]) return i < j;
    return points[i] < points[j];
  });
  std::vector<std::uint32_t> lowest(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeats = k > 0 && points[order[k]] == points[order[k - 1]];
    lowest[order[k]] = repeats ? lowest[order[k - 1]] : order[k];
  }
  return lowest;
}

std::vector<Triangle> translated(const std::vector<Triangle>& triangles, std::span<const rbpa::Point> from,
                                 std::span<const rbpa::Point> to) {
  std::vector<std::uint32_t> order(to.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return to[i] < to[j]; });
  std::vector<std::uint32_t> index(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    index[i] = *std::lower_bound(order.begin(), order.end(), from[i],
                                 [&](std::uint32_t j, const rbpa::Point& p) { return to[j] < p; });
  return renumbered(triangles, index);
}

std::string difference(const std::vector<Triangle>& expected, const std::vector<Triangle>& actual) {
  if (expected == actual) return {};
  const auto listed = [](const std::vector<Triangle>& triangles) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, triangles.size()); ++i)
      text += " (" + std::to_string(triangles[i][0]) + ", " + std::to_string(triangles[i][1]) + ", " +
              std::to_string(triangles[i][2]) + ")";
    return text + (triangles.size() > most ? " …" : "");
  };
  std::vector<Triangle> missing, surplus;
  std::set_difference(expected.begin(), expected.end(), actual.begin(), actual.end(), std::back_inserter(missing));
  std::set_difference(actual.begin(), actual.end(), expected.begin(), expected.end(), std::back_inserter(surplus));
  return "expected " + std::to_string(expected.size()) + " triangles, got " + std::to_string(actual.size()) + "; " +
         std::to_string(missing.size()) + " missing:" + listed(missing) + "; " + std::to_string(surplus.size()) +
         " too many:" + listed(surplus);
}

}  // namespace rbpa_test
