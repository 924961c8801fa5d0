#include "triangulation/filling_counts.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "triangulation/list_of_causes.h"

namespace rbpa::app {
namespace {

constexpr std::array texts{"filled", "where any filling crosses the surface",
                           "where any filling has an edge that already has two triangles", "with all points on a line",
                           "where the surroundings exceed the limit of work"};

}  // namespace

FillingCounts count(std::span<const HoleFill> holes) {
  FillingCounts counts;
  std::vector<double> areas;
  for (const HoleFill& hole : holes) {
    ++counts.holes[static_cast<std::size_t>(hole.outcome)];
    counts.triangles += hole.triangles;
    areas.push_back(hole.area);
  }
  std::sort(
      areas.begin(),
      areas.end());  // sorted, so that the sum does not depend on the order of holes, which depends on that of points
  for (const double area : areas) counts.area += area;
  return counts;
}

std::string filled_text(const FillingCounts& counts) {
  return counted(counts.filled(), "hole") + " filled by " + counted(counts.triangles, "triangle") + " of area " +
         rounded(counts.area, 6) +
         (counts.points == 0
              ? ""
              : ", with " + counted(counts.points, "point") + " added, " + std::to_string(counts.smooth) + " smooth");
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
