#include "support/shrink.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

namespace rbpa_test {
namespace {

/// Returns the points on one side of the middle (by rank) of a coordinate.
Points half(const Points& points, double rbpa::Point::*coordinate, bool upper) {
  std::vector<double> sorted;
  for (const rbpa::Point& p : points) sorted.push_back(p.*coordinate);
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[sorted.size() / 2];
  Points kept;
  for (const rbpa::Point& p : points)
    if (upper ? p.*coordinate >= middle : p.*coordinate < middle) kept.push_back(p);
  return kept;
}

/// Drops half of the plane as long as the other half still fails: most failures are local.
Points halved(Points points, const std::function<bool(const Points&)>& fails) {
  for (bool smaller = true; smaller && points.size() > 2;) {
    smaller = false;
    for (double rbpa::Point::*const coordinate : {&rbpa::Point::x, &rbpa::Point::y})
      for (const bool upper : {false, true}) {
        Points kept = points.size() > 2 ? half(points, coordinate, upper) : points;
        if (kept.size() == points.size() || !fails(kept)) continue;
        points = std::move(kept);
        smaller = true;
      }
  }
  return points;
}

}  // namespace

Points shrink(Points points, const std::function<bool(const Points&)>& fails) {
  points = halved(std::move(points), fails);
  for (std::size_t run = std::max<std::size_t>(points.size() / 2, 1);; run = std::max<std::size_t>(run / 2, 1)) {
    bool removed = false;
    for (std::size_t first = 0; first < points.size();) {
      const std::size_t last = std::min(first + run, points.size());
      Points fewer(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
      fewer.insert(fewer.end(), points.begin() + static_cast<std::ptrdiff_t>(last), points.end());
      if (fails(fewer)) {
        points = std::move(fewer);
        removed = true;
      } else {
        first = last;
      }
    }
    if (run == 1 && !removed) return points;
  }
}

std::string literal(double value) {
  if (std::isinf(value)) return value < 0 ? "-INFINITY" : "INFINITY";
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string literal(std::span<const rbpa::Point> points) {
  std::string text = "{";
  for (const rbpa::Point& p : points) {
    if (text.size() > 1) text += ", ";
    text.append("{").append(literal(p.x)).append(", ").append(literal(p.y)).append("}");
  }
  return text.append("}");
}

}  // namespace rbpa_test
