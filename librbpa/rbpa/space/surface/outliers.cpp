#include "rbpa/space/surface/outliers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/surface/neighbors/distinct_points.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"

namespace rbpa {
namespace {

/// Finds the outliers of points that were multiplied by 2^exponent so that squares fit double.
template <typename Real>
Outliers outliers_of(const std::vector<Point3>& points, int exponent, const OutlierOptions& options) {
  space::DistinctPoints sites = space::distinct_points(points);
  Outliers result;
  if (sites.points.size() < 2) return result;
  const Checkpoint go_on = checkpoint_of(options.progress, sites.points.size());
  Threads threads(sites.points.size() < 1000 ? 1 : options.threads);
  const space::Neighborhoods near =
      space::find_nearest<Real>(std::move(sites.points), options.neighbors, threads, go_on);
  std::vector<Real> squares;  // squared distances to the last neighbor
  for (std::size_t i = 0; i < near.points.size(); ++i) {
    const Point3 &p = near.points[i], &q = near.points[near.around(i).back()];
    const Real x = Real(q.x) - p.x, y = Real(q.y) - p.y, z = Real(q.z) - p.z;
    squares.push_back(x * x + y * y + z * z);
  }
  std::vector<Real> sorted = squares;
  const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), median, sorted.end());
  result.distance = static_cast<double>(std::ldexp(std::sqrt(*median), -exponent));
  const Real most = static_cast<Real>(options.factor) * static_cast<Real>(options.factor) * *median;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (squares[near.place[sites.number[i]]] > most) result.points.push_back(i);
  return result;
}

}  // namespace

Outliers outliers(std::span<const Point3> points, const OutlierOptions& options) {
  space::check_points(points);
  if (!(options.factor >= 1)) throw InvalidInput("the outlier factor is below 1 or not a number, expected at least 1");
  if (options.neighbors < 1) throw InvalidInput("outliers from 0 neighbors, expected at least 1");
  std::vector<Point3> scaled(points.begin(), points.end());
  const std::optional<int> exponent = space::fit_double(scaled);
  return exponent ? outliers_of<double>(scaled, *exponent, options) : outliers_of<long double>(scaled, 0, options);
}

}  // namespace rbpa
