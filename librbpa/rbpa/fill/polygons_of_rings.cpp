#include "rbpa/fill/polygons_of_rings.h"

#include <algorithm>
#include <optional>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/run/point_text.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/rings/noded_rings.h"
#include "rbpa/fill/rings/placed_rings.h"
#include "rbpa/fill/rings/simple_rings.h"
#include "rbpa/fill/validity.h"
#include "rbpa/plane/shape/measure.h"
#include "rbpa/plane/shape/nesting.h"

namespace rbpa {
namespace {

Ring reversed(const Ring& ring) { return {{ring.points.rbegin(), ring.points.rend()}}; }

/// Rings that meet in single points at most, with their nesting.
class ApartRings {
 public:
  ApartRings(std::span<const Point> points, std::span<const Ring> rings, const GoOn& go_on)
      : points_(points), rings_(rings), go_on_(go_on) {
    const RingName name = [](std::size_t ring) { return "ring " + std::to_string(ring); };
    check_points(points, rings, name, go_on);
    Steps step(go_on);
    place_ = place_rings(points, rings, node(points, rings, step), name, go_on);
  }

  std::vector<Polygon> outline_polygons() const {
    std::vector<Polygon> polygons = regions(false);
    // Rings that touch each other in a cycle split the interior.
    if (const auto why = why_invalid(points_, polygons, go_on_)) throw InvalidInput(*why);
    for (Polygon& polygon : polygons) measure(polygon, points_);
    return polygons;
  }

  /// Returns the regions directly within holes as polygons: each hole becomes a shell, and the shells directly in the
  /// hole become its holes.
  std::vector<Polygon> holes() const { return regions(true); }

 private:
  /// Returns the regions directly within holes if `within_holes`, otherwise within shells, as polygons with
  /// counter-clockwise shells and clockwise holes.
  std::vector<Polygon> regions(bool within_holes) const {
    std::vector<Polygon> regions;
    std::vector<std::size_t> region_of(rings_.size());
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (place_[r].is_hole() != within_holes) continue;
      region_of[r] = regions.size();
      regions.push_back({.shell = turned(r, true)});
    }
    for (std::size_t r = 0; r < rings_.size(); ++r)
      if (place_[r].is_hole() != within_holes && place_[r].inside)
        regions[region_of[*place_[r].inside]].holes.push_back(turned(r, false));
    return regions;
  }

  Ring turned(std::size_t r, bool counter_clockwise) const {
    return place_[r].is_counter_clockwise == counter_clockwise ? rings_[r] : reversed(rings_[r]);
  }

  std::span<const Point> points_;
  std::span<const Ring> rings_;
  const GoOn& go_on_;
  std::vector<RingPlace> place_;
};

}  // namespace

std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings, const GoOn& go_on) {
  return ApartRings(points, rings, go_on).outline_polygons();
}

std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                       std::span<const Point> in_holes, const GoOn& go_on) {
  const ApartRings apart(points, rings, go_on);
  for (std::size_t i = 0; i < in_holes.size(); ++i)
    if (!is_finite(in_holes[i]))
      throw InvalidInput("hole point " + std::to_string(i) + ": found " + place_of(in_holes[i]) +
                         ", expected finite coordinates");
  const std::vector<Polygon> insides = apart.holes();
  Steps step(go_on);
  std::vector<bool> has_point(insides.size(), false);
  const std::vector<std::optional<std::uint32_t>> around = polygons_around(insides, points, in_holes, step);
  for (std::size_t i = 0; i < in_holes.size(); ++i) {
    if (!around[i])
      throw InvalidInput("hole point " + std::to_string(i) + " at " + place_of(in_holes[i]) +
                         ": found it in no hole, expected a ring around it within another");
    has_point[*around[i]] = true;
  }
  const auto without = std::find(has_point.begin(), has_point.end(), false);
  if (without != has_point.end()) {
    const Polygon& hole = insides[static_cast<std::size_t>(without - has_point.begin())];
    throw InvalidInput("the ring through " + place_of(points[hole.shell.points[0]]) +
                       ": found no hole point in this ring within another, expected one (lines inside of a polygon are "
                       "not kept)");
  }
  return apart.outline_polygons();
}

}  // namespace rbpa
