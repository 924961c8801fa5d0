#include "rbpa/shape/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rbpa {
namespace {

/// visit(from, to) for every edge.
template <typename Visit>
void for_each_edge(const Ring& ring, std::span<const Point> points, Visit&& visit) {
  std::uint32_t from = ring.points.back();
  for (const std::uint32_t to : ring.points) {
    visit(points[from], points[to]);
    from = to;
  }
}

/// Within 3 · 2⁻⁵³ of itself: one rounding for the differences, one for squares and sum under the root, one for the
/// root. Only what the standard rounds correctly is used, so that the bits are the same everywhere.
double length(const Point& a, const Point& b) {
  const double dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
  const double larger = std::max(dx, dy), smaller = std::min(dx, dy);
  if (std::isinf(larger)) return larger;
  const int exponent = std::ilogb(larger);
  const double u = std::scalbn(larger, -exponent), v = std::scalbn(smaller, -exponent);
  return std::scalbn(std::sqrt(u * u + v * v), exponent);
}

/// Sums of numbers that are not negative, some of them perhaps infinite.
class LengthSum {
 public:
  void add(double value) {
    if (std::isinf(value))
      infinite_ = true;
    else
      sum_.add(value);
  }
  double rounded() const { return infinite_ ? std::numeric_limits<double>::infinity() : sum_.rounded(); }

 private:
  ExactSum sum_;
  bool infinite_ = false;
};

}  // namespace

void add_twice_area(ExactSum& sum, const Ring& ring, std::span<const Point> points) {
  for_each_edge(ring, points, [&](const Point& a, const Point& b) {
    sum.add_product(a.x, b.y);
    sum.add_product(-a.y, b.x);
  });
}

double enclosed_area(const Ring& ring, std::span<const Point> points) {
  ExactSum twice;
  add_twice_area(twice, ring, points);
  return std::abs(twice.rounded(-1));
}

void measure(Polygon& polygon, std::span<const Point> points) {
  ExactSum twice;
  LengthSum perimeter;
  const auto add = [&](const Ring& ring) {
    add_twice_area(twice, ring, points);
    for_each_edge(ring, points, [&](const Point& a, const Point& b) { perimeter.add(length(a, b)); });
  };
  add(polygon.shell);
  for (const Ring& hole : polygon.holes) add(hole);
  polygon.area = twice.rounded(-1);
  polygon.perimeter = perimeter.rounded();
}

PolygonTotals total(std::span<const Polygon> polygons) {
  PolygonTotals totals;
  LengthSum area, perimeter;
  for (const Polygon& polygon : polygons) {
    totals.holes += polygon.holes.size();
    area.add(polygon.area);
    perimeter.add(polygon.perimeter);
  }
  totals.area = area.rounded();
  totals.perimeter = perimeter.rounded();
  return totals;
}

}  // namespace rbpa
