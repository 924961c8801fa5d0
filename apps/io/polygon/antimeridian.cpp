#include "io/polygon/antimeridian.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/fill/cut_polygon.h"

namespace rbpa::app {
namespace {

constexpr double antimeridians[] = {-180, 180};

template <typename Visit>
void for_each_position(const std::vector<PositionRing>& rings, const Visit& visit) {
  for (const PositionRing& ring : rings)
    for (const Point3& p : ring) visit(p);
}

bool lies_on_both_sides(const std::vector<PositionRing>& polygon, double longitude) {
  bool west = false, east = false;
  for_each_position(polygon, [&](const Point3& p) {
    west = west || p.x < longitude;
    east = east || p.x > longitude;
  });
  return west && east;
}

/// Appends to `parts` the parts of `polygon` west and east of `longitude`. Throws InvalidInput if rounding makes a part
/// invalid.
void append_cut(const std::vector<PositionRing>& polygon, double longitude,
                std::vector<std::vector<PositionRing>>& parts) {
  std::vector<Point> points;
  std::vector<double> z;
  std::vector<Ring> rings;
  for (const PositionRing& ring : polygon) {
    rings.emplace_back();
    for (const Point3& p : ring) {
      rings.back().points.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back({p.x, p.y});
      z.push_back(p.z);
    }
  }
  const PolygonCut cut = cut_at(points, {.shell = rings.front(), .holes = {rings.begin() + 1, rings.end()}}, longitude);
  for (const EdgeCrossing& at : cut.crossings) z.push_back(z[at.from] + (z[at.to] - z[at.from]) * at.share);
  const auto positions = [&](const Ring& ring) {
    PositionRing all;
    for (const std::uint32_t i : ring.points) all.push_back({cut.points[i].x, cut.points[i].y, z[i]});
    return all;
  };
  for (const std::vector<Polygon>* side : {&cut.left, &cut.right})
    for (const Polygon& part : *side) {
      std::vector<PositionRing>& all = parts.emplace_back();
      all.push_back(positions(part.shell));
      for (const Ring& hole : part.holes) all.push_back(positions(hole));
    }
}

/// Returns the change, 0 or ±360, that brings the longitudes of `part` within ±180. Requires: the part is on one side
/// of each antimeridian.
double shift_of(const std::vector<PositionRing>& part) {
  double shift = 0;
  for_each_position(part, [&](const Point3& p) { shift = p.x > 180 ? -360 : p.x < -180 ? 360 : shift; });
  return shift;
}

}  // namespace

bool is_beyond_antimeridian(std::span<const Point> points) {
  double greatest = 0;
  for (const Point& p : points) greatest = std::max(greatest, std::abs(p.x));
  return greatest > 180 && greatest <= 360;
}

double within_antimeridian(double longitude) {
  return longitude > 180 ? longitude - 360 : longitude < -180 ? longitude + 360 : longitude;
}

std::vector<std::vector<PositionRing>> within_antimeridian(const std::vector<PositionRing>& polygon) {
  std::vector<std::vector<PositionRing>> parts = {polygon};
  try {
    for (const double longitude : antimeridians) {
      std::vector<std::vector<PositionRing>> cut;
      for (std::vector<PositionRing>& part : parts)
        lies_on_both_sides(part, longitude) ? append_cut(part, longitude, cut) : cut.push_back(std::move(part));
      parts = std::move(cut);
    }
  } catch (const InvalidInput&) {
    return {polygon};
  }
  for (std::vector<PositionRing>& part : parts) {
    const double shift = shift_of(part);
    for (PositionRing& ring : part)
      for (Point3& p : ring) p.x += shift;
  }
  return parts;
}

std::vector<std::vector<Point3>> within_antimeridian(const Point3& from, const Point3& to) {
  std::vector<std::vector<Point3>> parts = {{from}};
  const auto [west, east] = std::minmax(from.x, to.x);
  for (double longitude : antimeridians) {
    if (from.x > to.x) longitude = -longitude;
    if (west >= longitude || east <= longitude) continue;
    const double share = (longitude - from.x) / (to.x - from.x);
    const Point3 at{longitude, from.y + (to.y - from.y) * share, from.z + (to.z - from.z) * share};
    parts.back().push_back(at);
    parts.push_back({at});
  }
  parts.back().push_back(to);
  for (std::vector<Point3>& part : parts) {
    const double shift = shift_of({part});
    for (Point3& p : part) p.x += shift;
  }
  return parts;
}

}  // namespace rbpa::app
