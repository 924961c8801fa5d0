#include "rbpa/fill/rings/polygon_rings.h"

#include <algorithm>
#include <utility>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/point_text.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/rings/placed_rings.h"
#include "rbpa/fill/validity.h"

namespace rbpa {
namespace {

std::string name_of(const RingRole& role) {
  const std::string polygon = "polygon " + std::to_string(role.polygon);
  return role.hole ? "hole " + std::to_string(*role.hole) + " of " + polygon : "the shell of " + polygon;
}

/// Returns the noded rings of polygons. Leaves out polygons without points, which are valid.
PolygonRings noded_rings(std::span<const Point> points, std::span<const Polygon> polygons, const GoOn& go_on) {
  PolygonRings rings;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    if (polygons[p].shell.points.empty() && polygons[p].holes.empty()) continue;
    rings.input.push_back(polygons[p].shell);
    rings.roles.push_back({p, std::nullopt});
    for (std::size_t h = 0; h < polygons[p].holes.size(); ++h) {
      rings.input.push_back(polygons[p].holes[h]);
      rings.roles.push_back({p, h});
    }
  }
  check_points(
      points, rings.input, [&](std::size_t ring) { return name_of(rings.roles[ring]); }, go_on);
  Steps step(go_on);
  rings.noded = node(points, rings.input, step);
  rings.places.resize(rings.input.size());
  return rings;
}

/// A range of consecutive rings.
struct Range {
  std::size_t first, last;
};

/// Sets rings.places for a range of rings, and checks that each shell and hole lies in the ring that its role requires.
void place(PolygonRings& rings, const Range& range, std::span<const Point> points, const GoOn& go_on) {
  const auto some = [&](auto& of) {
    return std::vector(of.begin() + static_cast<std::ptrdiff_t>(range.first),
                       of.begin() + static_cast<std::ptrdiff_t>(range.last));
  };
  const NodedRings noded{some(rings.noded.rings), some(rings.noded.edge_of)};
  const std::span<const Ring> input = std::span(rings.input).subspan(range.first, range.last - range.first);
  const RingName name = [&](std::size_t ring) { return name_of(rings.roles[range.first + ring]); };
  const std::vector<RingPlace> places = place_rings(points, input, noded, name, go_on);
  for (std::size_t r = 0; r < places.size(); ++r) {
    const RingRole& role = rings.roles[range.first + r];
    const RingRole* const around = places[r].inside ? &rings.roles[range.first + *places[r].inside] : nullptr;
    const std::string found = name_of(role) + " at " + place_of(points[noded.rings[r].points[0]]) + ": found it " +
                              (around != nullptr ? "in " + name_of(*around) : "in no ring");
    const bool in_own_shell = around != nullptr && !around->hole && around->polygon == role.polygon;
    if (role.hole && !in_own_shell) throw InvalidInput(found + ", expected it in the shell of its polygon");
    const bool is_outside = around == nullptr || around->hole;
    if (!role.hole && !is_outside) throw InvalidInput(found + ", expected it outside of other polygons, or in a hole");
    rings.places[range.first + r] = places[r];
  }
}

/// Checks that the interior of a polygon is connected: the graph of its rings and of the points at which rings touch
/// must not have a cycle.
void check_in_one_piece(const PolygonRings& rings, const Range& range, std::span<const Point> points) {
  std::vector<std::pair<std::uint32_t, std::size_t>> vertices;  // points, each with a ring through the point
  for (std::size_t r = range.first; r < range.last; ++r)
    for (const std::uint32_t point : rings.noded.rings[r].points) vertices.emplace_back(point, r - range.first);
  std::sort(vertices.begin(), vertices.end());
  meshops::DisjointSets together(range.last - range.first);
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const auto [point, ring] = vertices[i];
    if (vertices[i + 1].first != point) continue;
    const auto a = static_cast<std::uint32_t>(ring), b = static_cast<std::uint32_t>(vertices[i + 1].second);
    if (together.find(a) == together.find(b))
      throw InvalidInput("polygon " + std::to_string(rings.roles[range.first].polygon) + ": found " +
                         name_of(rings.roles[range.first + a]) + " and " + name_of(rings.roles[range.first + b]) +
                         " that touch at " + place_of(points[point]) +
                         ", and are joined by rings that touch elsewhere, expected an inside in one piece");
    together.unite(a, b);
  }
}

std::vector<Range> polygons_in(const PolygonRings& rings, const Range& group) {
  std::vector<Range> ranges;
  for (std::size_t r = group.first; r < group.last; ++r) {
    if (!rings.roles[r].hole) ranges.push_back({r, r});
    ranges.back().last = r + 1;
  }
  return ranges;
}

std::vector<Range> groups_in(const PolygonRings& rings) {
  std::vector<Range> ranges;
  for (std::size_t r = 0; r < rings.groups.size(); ++r) {
    if (r == 0 || rings.groups[r] != rings.groups[r - 1]) ranges.push_back({r, r});
    ranges.back().last = r + 1;
  }
  return ranges;
}

/// Returns for each ring the number of its group: the last group that begins at or before the polygon of the ring.
/// Throws: InvalidInput when `begins` does not ascend from 0 to at most `polygons`.
std::vector<std::size_t> groups_of(const PolygonRings& rings, std::span<const std::size_t> begins,
                                   std::size_t polygons) {
  if (begins.empty()) return std::vector<std::size_t>(rings.roles.size(), 0);
  if (begins[0] != 0 || begins.back() > polygons || !std::is_sorted(begins.begin(), begins.end()))
    throw InvalidInput("groups: found numbers that do not ascend from 0 to at most " + std::to_string(polygons) +
                       ", expected the number of the first polygon of each group");
  std::vector<std::size_t> groups;
  for (const RingRole& role : rings.roles)
    groups.push_back(
        static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), role.polygon) - begins.begin()) - 1);
  return groups;
}

}  // namespace

PolygonRings valid_polygons(std::span<const Point> points, std::span<const Polygon> polygons,
                            std::span<const std::size_t> groups, const GoOn& go_on) {
  PolygonRings rings = noded_rings(points, polygons, go_on);
  rings.groups = groups_of(rings, groups, polygons.size());
  for (const Range& group : groups_in(rings)) {
    place(rings, group, points, go_on);
    for (const Range& polygon : polygons_in(rings, group)) check_in_one_piece(rings, polygon, points);
  }
  return rings;
}

std::optional<std::string> why_invalid(std::span<const Point> points, std::span<const Polygon> polygons,
                                       const GoOn& go_on) {
  try {
    valid_polygons(points, polygons, {}, go_on);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return std::nullopt;
}

}  // namespace rbpa
