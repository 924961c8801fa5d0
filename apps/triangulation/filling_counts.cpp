#include "triangulation/filling_counts.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/number.h"
#include "triangulation/list_of_causes.h"

namespace rbpa::app {
namespace {

constexpr std::array texts{"filled", "where any filling crosses the surface",
                           "where any filling has an edge that already has two triangles", "with all points on a line",
                           "where the surroundings exceed the limit of work"};

/// Returns the sum of the values. They are added in ascending order, so that the sum does not depend on their order.
double sorted_sum(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

FillingCounts count(std::span<const HoleFill> holes) {
  FillingCounts counts;
  std::vector<double> areas;
  for (const HoleFill& hole : holes) {
    ++counts.holes[static_cast<std::size_t>(hole.outcome)];
    counts.triangles += hole.triangles;
    areas.push_back(hole.area);
  }
  counts.area = sorted_sum(std::move(areas));
  return counts;
}

void count_refined(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                   const std::vector<bool>& is_new, const AddedPoints& added, FillingCounts& counts) {
  std::vector<double> areas;
  for (std::size_t t = 0; t < is_new.size(); ++t) {
    if (!is_new[t]) continue;
    const auto& [i, j, k] = triangles[t];
    const Point3 &a = points[i], &b = points[j], &c = points[k];
    const Point3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    areas.push_back(std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2);
  }
  counts.triangles = areas.size();
  counts.area = sorted_sum(std::move(areas));
  counts.points = added.points.size();
  counts.smooth = added.smooth;
}

std::string filled_text(const FillingCounts& counts) {
  return counted(counts.filled(), "hole") + " filled by " + counted(counts.triangles, "triangle") + " of area " +
         rounded(counts.area, 6) +
         (counts.points == 0 ? ""
                             : ", with " + counted(counts.points, "point") + " added, " +
                                   counted(counts.smooth, "filling") + " made smooth");
}

std::string left_text(const FillingCounts& counts) {
  std::array<std::size_t, outcome_names.size()> left = counts.holes;
  left[0] = 0;
  return counted(counts.left(), "hole") + " not filled: " + list_of_causes(left, texts);
}

nlohmann::ordered_json as_json(const FillingCounts& counts) {
  nlohmann::ordered_json left;
  for (std::size_t i = 1; i < outcome_names.size(); ++i) left[outcome_names[i]] = counts.holes[i];
  return {{"holes", counts.filled()},
          {"triangles", counts.triangles},
          {"area", counts.area},
          {"given_up", counts.given_up},
          {"left", left}};
}

}  // namespace rbpa::app
