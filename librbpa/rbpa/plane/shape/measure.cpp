#include "rbpa/plane/shape/measure.h"

#include <algorithm>

namespace rbpa {
namespace {

/// Calls visit(from, to) for every edge of the ring.
template <typename Visit>
void for_each_edge(const Ring& ring, std::span<const Point> points, Visit&& visit) {
  std::uint32_t from = ring.points.back();
  for (const std::uint32_t to : ring.points) {
    visit(points[from], points[to]);
    from = to;
  }
}

/// Returns the distance of a and b, with a relative error of at most 3 · 2⁻⁵³: one rounding for the differences, one
/// for squares and sum under the root, one for the root. Only correctly rounded operations of the standard are used, so
/// the bits are the same everywhere.
double length(const Point& a, const Point& b) {
  const double dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
  const double larger = std::max(dx, dy), smaller = std::min(dx, dy);
  // If no square overflows, and one that underflows is negligible beside the other, scaling changes no bit.
  if (larger > 0x1p-400 && larger < 0x1p400) return std::sqrt(dx * dx + dy * dy);
  if (larger == 0 || std::isinf(larger)) return larger;
  const int exponent = std::ilogb(larger);
  const double u = std::scalbn(larger, -exponent), v = std::scalbn(smaller, -exponent);
  return std::scalbn(std::sqrt(u * u + v * v), exponent);
}

void add_twice_area(ExactSum& sum, const Point& from, const Point& to) {
  sum.add_product(from.x, to.y);
  sum.add_product(-from.y, to.x);
}

}  // namespace

void BoundaryMeasure::add_edge(const Point& from, const Point& to) {
  add_twice_area(twice_, from, to);
  lengths_.add(length(from, to));
}

void add_twice_area(ExactSum& sum, const Ring& ring, std::span<const Point> points) {
  for_each_edge(ring, points, [&](const Point& a, const Point& b) { add_twice_area(sum, a, b); });
}

double enclosed_area(const Ring& ring, std::span<const Point> points) {
  ExactSum twice;
  add_twice_area(twice, ring, points);
  return std::abs(twice.rounded(-1));
}

void measure(Polygon& polygon, std::span<const Point> points) {
  BoundaryMeasure boundary;
  const auto add = [&](const Point& from, const Point& to) { boundary.add_edge(from, to); };
  for_each_edge(polygon.shell, points, add);
  for (const Ring& hole : polygon.holes) for_each_edge(hole, points, add);
  polygon.area = boundary.area();
  polygon.perimeter = boundary.perimeter();
}

struct RunningTotals::Sums {
  std::size_t holes = 0;
  LengthSum area = {}, perimeter = {};
};

RunningTotals::RunningTotals() : sums_(std::make_unique<Sums>()) {}
RunningTotals::~RunningTotals() = default;

void RunningTotals::add(std::size_t holes, double area, double perimeter) {
  sums_->holes += holes;
  sums_->area.add(area);
  sums_->perimeter.add(perimeter);
}

PolygonTotals RunningTotals::totals() const {
  return {.holes = sums_->holes, .area = sums_->area.rounded(), .perimeter = sums_->perimeter.rounded()};
}

PolygonTotals total(std::span<const Polygon> polygons) {
  RunningTotals sums;
  for (const Polygon& polygon : polygons) sums.add(polygon.holes.size(), polygon.area, polygon.perimeter);
  return sums.totals();
}

}  // namespace rbpa
