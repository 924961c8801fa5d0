#include "space/added_points.h"

#include <cstddef>
#include <vector>

namespace rbpa::app {
namespace {

/// Appends the mean of three values for each added point. Does nothing if there are no values.
template <typename Value, typename Mean>
void add_means(std::vector<Value>& values, const AddedPoints& added, const Mean& mean) {
  if (values.empty()) return;
  for (const auto& [a, b, c] : added.between) values.push_back(mean(values[a], values[b], values[c]));
}

void add_normals(std::vector<Point3>& normals, const AddedPoints& added) {
  if (normals.empty()) return;
  const std::vector<Point3> further = normals_between(normals, added.between);
  normals.insert(normals.end(), further.begin(), further.end());
}

using Rgb = std::array<std::uint8_t, 3>;

Rgb mean_color(const Rgb& a, const Rgb& b, const Rgb& c) {
  Rgb mean{};
  for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<std::uint8_t>((a[k] + b[k] + c[k] + 1) / 3);
  return mean;
}

double mean_number(double a, double b, double c) { return a / 3 + b / 3 + c / 3; }

}  // namespace

void add_points(const AddedPoints& added, SpacePoints& cloud, EstimatedNormals& estimated, LeftOutPoints& left_out) {
  cloud.points.insert(cloud.points.end(), added.points.begin(), added.points.end());
  add_normals(cloud.normals, added);
  add_means(cloud.colors, added, mean_color);
  add_normals(estimated.normals, added);
  add_means(estimated.confidence, added, mean_number);
  left_out.add_last(cloud, added.points.size());
}

}  // namespace rbpa::app
