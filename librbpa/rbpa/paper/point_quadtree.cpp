#include "rbpa/paper/point_quadtree.h"

#include <algorithm>
#include <limits>

namespace rbpa::paper {
namespace {

void cut(std::span<Point> points, const Leaf& square, std::size_t capacity, std::vector<Leaf>& leaves) {
  const long double half = square.side / 2, x = square.x + half, y = square.y + half;
  if (points.size() <= capacity || !(x > square.x && y > square.y)) {
    leaves.push_back({square.x, square.y, square.side, points.size()});
    return;
  }
  const auto upper = std::partition(points.begin(), points.end(), [&](const Point& p) { return p.y < y; });
  for (const bool above : {false, true}) {
    const std::span<Point> row = above ? std::span(upper, points.end()) : std::span(points.begin(), upper);
    const auto right = std::partition(row.begin(), row.end(), [&](const Point& p) { return p.x < x; });
    const long double low = above ? y : square.y;
    cut({row.begin(), right}, {square.x, low, half, 0}, capacity, leaves);
    cut({right, row.end()}, {x, low, half, 0}, capacity, leaves);
  }
}

}  // namespace

Box box_of(std::span<const Point> points) {
  Point low = points[0], high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const long double x = low.x, y = low.y;
  return {x, y, high.x - x, high.y - y};
}

std::vector<Leaf> quadtree(std::span<const Point> points, std::size_t capacity) {
  const Box box = paper::box_of(points);
  std::vector<Point> copy(points.begin(), points.end());
  std::vector<Leaf> leaves;
  cut(copy, {box.x, box.y, std::max(box.width, box.height), points.size()}, capacity, leaves);
  return leaves;
}

double minimal_radius(std::span<const Leaf> leaves) {
  const auto smallest =
      std::min_element(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) { return a.side < b.side; });
  return std::max(static_cast<double>(smallest->side / 2), std::numeric_limits<double>::denorm_min());
}

}  // namespace rbpa::paper
