#include "rbpa/plane/constrained_delaunay.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "meshops/core/fresh_vector.h"
#include "meshops/core/large_pages.h"
#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/point_text.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/arrays/boundary_sides.h"
#include "rbpa/plane/constrained/insert_segments.h"
#include "rbpa/plane/constrained/split_crossings.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

/// Returns "segment 3 from (0, 0) to (1, 2)".
std::string name_of(std::size_t i, std::span<const Point> points, std::span<const Segment> segments) {
  return "segment " + std::to_string(i) + " from " + place_of(points[segments[i][0]]) + " to " +
         place_of(points[segments[i][1]]);
}

void check(std::span<const Point> points, std::span<const Segment> segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const std::uint32_t end : segments[i])
      if (end >= points.size())
        throw InvalidInput("segment " + std::to_string(i) + ": found point " + std::to_string(end) +
                           ", expected one of " + std::to_string(points.size()));
    if (points[segments[i][0]] == points[segments[i][1]])
      throw InvalidInput(name_of(i, points, segments) + ": found no length, expected ends at two places");
  }
}

/// Splits segments where they cross. Appends the places to the points of `result`, unless they are among them, and
/// returns the parts.
std::vector<Segment> split(std::span<const Segment> segments, ConstrainedDelaunay& result, Steps& step) {
  std::vector<Point>& points = result.points;
  std::vector<SegmentPart> parts;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const auto [low, high] = std::minmax(points[segments[i][0]], points[segments[i][1]]);
    parts.push_back({low, high, i});
  }
  const std::vector<SplitPlace> places = split_crossings(parts, step);
  std::vector<std::uint32_t> by_place(points.size());
  std::iota(by_place.begin(), by_place.end(), 0U);
  sort(by_place, step, [&](auto a, auto b) { return std::tie(points[a], a) < std::tie(points[b], b); });
  const std::size_t given = points.size();
  const auto index_of = [&](const Point& place) {
    const auto at = std::lower_bound(by_place.begin(), by_place.end(), place,
                                     [&](std::uint32_t i, const Point& p) { return points[i] < p; });
    if (at != by_place.end() && points[*at] == place) return *at;
    const auto added = std::lower_bound(points.begin() + static_cast<std::ptrdiff_t>(given), points.end(), place);
    return static_cast<std::uint32_t>(added - points.begin());
  };
  for (const SplitPlace& split : places) {
    if (const std::uint32_t i = index_of(split.at); i < points.size()) continue;
    points.push_back(split.at);
    result.crossed.push_back(split.segments);
  }
  std::vector<Segment> found;
  for (const SegmentPart& part : parts) {
    step();
    for (int copies = part.is_odd ? 1 : 2; copies > 0; --copies)
      found.push_back({index_of(part.low), index_of(part.high)});
  }
  return found;
}

/// Throws the InvalidInput of two segments that cross.
[[noreturn]] void refuse(const SegmentCrossing& crossing, std::span<const Point> points,
                         std::span<const Segment> segments) {
  const auto is_on = [&](std::uint32_t end, const Segment& segment) {
    const auto [low, high] = std::minmax(points[segment[0]], points[segment[1]]);
    return low <= points[end] && points[end] <= high && plane_orientation(low, high, points[end]) == 0;
  };
  const auto other = std::find_if(segments.begin(), segments.end(), [&](const Segment& segment) {
    return is_on(crossing.part[0], segment) && is_on(crossing.part[1], segment);
  });
  const auto [first, second] = std::minmax({crossing.segment, static_cast<std::size_t>(other - segments.begin())});
  throw InvalidInput(name_of(first, points, segments) + " and " + name_of(second, points, segments) +
                     ": found a crossing, expected segments that meet in points (split_crossings splits them)");
}

/// Returns the edges on segments. Requires: all points are on one line.
std::vector<Segment> edges_on_line(const ConstrainedDelaunay& of, std::span<const Segment> segments, Steps& step) {
  std::vector<std::uint32_t> along;
  for_each_distinct(of.points.size(), of.duplicates, [&](std::uint32_t i) { along.push_back(i); });
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return of.points[a] < of.points[b]; };
  sort(along, step, less);
  const auto rank = [&](std::uint32_t i) {
    return std::lower_bound(along.begin(), along.end(), i, less) - along.begin();
  };
  std::vector<std::ptrdiff_t> begins(along.size() + 1, 0);  // segments that begin at a point, less those that end
  for (const Segment& segment : segments) {
    const auto [low, high] = std::minmax({rank(segment[0]), rank(segment[1])});
    ++begins[static_cast<std::size_t>(low)];
    --begins[static_cast<std::size_t>(high)];
  }
  std::vector<Segment> edges;
  std::ptrdiff_t open = 0;
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
    if ((open += begins[i]) > 0) edges.push_back({std::min(along[i], along[i + 1]), std::max(along[i], along[i + 1])});
  sort(edges, step, std::less<>());
  return edges;
}

/// Turns a changed triangle so that its least corner comes first.
void turn(FixedTriangles& of, std::uint32_t t) {
  Triangle& corners = of.triangles[t];
  const auto by = std::min_element(corners.begin(), corners.end()) - corners.begin();
  std::rotate(corners.begin(), corners.begin() + by, corners.end());
  std::rotate(of.neighbors[t].begin(), of.neighbors[t].begin() + by, of.neighbors[t].end());
  const auto turned = [by](unsigned bits) { return (bits >> by | bits << (3 - by)) & 7U; };
  const unsigned bits = of.fixed[t];
  of.fixed[t] = static_cast<std::uint8_t>(turned(bits & 7U) | turned(bits >> 4 & 7U) << 4);
}

/// Brings the triangles into canonical order, in which those are that no segment has changed.
void put_in_order(FixedTriangles& of, Steps& step) {
  const auto n = static_cast<std::uint32_t>(of.triangles.size());
  std::vector<std::uint32_t> changed;
  meshops::FreshVector<std::uint32_t> order, rank(n);
  std::vector<bool> is_changed(n);
  for (std::uint32_t t = 0; t < n; ++t) {
    if ((of.fixed[t] & FixedTriangles::changed) == 0) continue;
    is_changed[t] = true;
    changed.push_back(t);
    turn(of, t);
  }
  if (changed.empty()) return;
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return of.triangles[a] < of.triangles[b]; };
  sort(changed, step, less);
  order.reserve(n);
  auto next = changed.begin();
  for (std::uint32_t t = 0; t < n; ++t) {
    if (is_changed[t]) continue;
    step();
    while (next != changed.end() && less(*next, t)) order.push_back(*next++);
    order.push_back(t);
  }
  order.insert(order.end(), next, changed.end());
  for (std::uint32_t i = 0; i < n; ++i) rank[order[i]] = i;
  FixedTriangles sorted;
  meshops::reserve_in_large_pages(sorted.triangles, n);
  meshops::reserve_in_large_pages(sorted.neighbors, n);
  meshops::reserve_in_large_pages(sorted.fixed, n);
  for (const std::uint32_t t : order) {
    step();
    sorted.triangles.push_back(of.triangles[t]);
    sorted.fixed.push_back(of.fixed[t]);
    for (std::uint32_t& across : of.neighbors[t])
      if (across != no_index) across = rank[across];
    sorted.neighbors.push_back(of.neighbors[t]);
  }
  of = std::move(sorted);
}

/// Returns the edges on segments, in lexicographic order.
std::vector<Segment> edges_of(const ConstrainedDelaunay& of, Steps& step) {
  constexpr unsigned sides = 7;  // the bits of the three sides
  meshops::FreshVector<Segment> found;
  meshops::FreshVector<std::uint32_t> end(of.points.size() + 1, 0);  // for each point, the end of the edges from it
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
    step();
    if ((of.constrained[t] & sides) == 0) continue;
    for (std::uint32_t k = 0; k < 3; ++k)
      if (of.is_constrained(t, k) && t < of.neighbors[t][k]) {
        const auto [low, high] = std::minmax(of.triangles[t][(k + 1) % 3], of.triangles[t][(k + 2) % 3]);
        found.push_back({low, high});
        ++end[low + std::size_t{1}];
      }
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Segment> edges;
  meshops::reserve_in_large_pages(edges, found.size());
  edges.resize(found.size());
  for (const Segment& edge : found) edges[end[edge[0]]++] = edge;
  for (auto first = edges.begin(); first != edges.end();) {
    auto last = first + 1;
    while (last != edges.end() && (*last)[0] == (*first)[0]) ++last;
    std::sort(first, last);
    first = last;
  }
  return edges;
}

/// Returns for each triangle the smallest number of edges on segments that a path from outside crosses.
std::vector<std::uint32_t> depths(const ConstrainedDelaunay& of, Steps& step) {
  std::vector<std::uint32_t> depth(of.triangles.size(), no_index), now, next;
  const auto add = [&](std::uint32_t t, bool is_behind) { (is_behind ? next : now).push_back(t); };
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (of.neighbors[t][k] == no_index) add(t, of.is_constrained(t, k));
  for (std::uint32_t level = 0; !now.empty() || !next.empty(); ++level) {
    while (!now.empty()) {
      step();
      const std::uint32_t t = now.back();
      now.pop_back();
      if (depth[t] != no_index) continue;
      depth[t] = level;
      for (std::uint32_t k = 0; k < 3; ++k)
        if (of.neighbors[t][k] != no_index) add(of.neighbors[t][k], of.is_constrained(t, k));
    }
    std::swap(now, next);
  }
  return depth;
}

/// Sets is_inside of each region. Of several paths that cross the same number of edges, one that leads inside counts.
void find_inside(const ConstrainedDelaunay& of, SegmentRegions& result, Steps& step) {
  const std::vector<std::uint32_t> depth = depths(of, step);
  std::vector<std::uint32_t> order(of.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return depth[a] < depth[b]; });
  for (const std::uint32_t t : order) {
    step();
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (!of.is_constrained(t, k)) continue;
      const std::uint32_t before = of.neighbors[t][k];
      if (depth[t] != (before == no_index ? 0 : depth[before]) + 1) continue;
      const bool from_inside = before != no_index && result.is_inside[result.region[before]];
      const bool is_odd = (of.constrained[t] >> (4 + k) & 1) != 0;
      if (from_inside != is_odd) result.is_inside[result.region[t]] = true;
    }
  }
}

}  // namespace

ConstrainedDelaunay constrained_delaunay(std::span<const Point> points, std::span<const Segment> segments,
                                         const ConstrainedDelaunayOptions& options) {
  check(points, std::numeric_limits<double>::infinity());
  check(points, segments);
  const GoOn go_on = go_on_of(options.progress, points.size());
  Steps step(go_on);
  ConstrainedDelaunay result;
  meshops::reserve_in_large_pages(result.points, points.size());
  result.points.assign(points.begin(), points.end());
  std::vector<Segment> parts(segments.begin(), segments.end());
  if (options.split_crossings) parts = split(segments, result, step);
  AlphaComplex whole = alpha_complex(result.points, std::numeric_limits<double>::infinity(),
                                     {.neighbors = true, .threads = options.threads, .progress = options.progress});
  result.duplicates = std::move(whole.duplicates);
  for (Segment& part : parts)
    for (std::uint32_t& end : part) {
      const auto at = std::lower_bound(result.duplicates.begin(), result.duplicates.end(), end,
                                       [](const Duplicate& d, std::uint32_t i) { return d.index < i; });
      if (at != result.duplicates.end() && at->index == end) end = at->stands_for;
    }
  FixedTriangles triangles{std::move(whole.triangles), std::move(whole.neighbors), {}};
  meshops::reserve_in_large_pages(triangles.fixed, triangles.triangles.size());
  triangles.fixed.assign(triangles.triangles.size(), 0);
  if (triangles.triangles.empty()) {
    result.edges = edges_on_line(result, parts, step);
    return result;
  }
  if (const auto crossing = insert_segments(result.points, parts, triangles, step)) refuse(*crossing, points, segments);
  put_in_order(triangles, step);
  result.triangles = std::move(triangles.triangles);
  result.neighbors = std::move(triangles.neighbors);
  result.constrained = std::move(triangles.fixed);
  result.edges = edges_of(result, step);
  result.boundary = boundary_sides(result, [&] { step(); });
  return result;
}

SegmentRegions regions(const ConstrainedDelaunay& of, const GoOn& go_on) {
  Steps step(go_on);
  SegmentRegions result;
  result.region.assign(of.triangles.size(), no_index);
  std::vector<std::uint32_t> at;
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
    if (result.region[t] != no_index) continue;
    const auto number = static_cast<std::uint32_t>(result.is_inside.size());
    result.is_inside.push_back(false);
    result.region[t] = number;
    at.assign(1, t);
    while (!at.empty()) {
      step();
      const std::uint32_t now = at.back();
      at.pop_back();
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = of.neighbors[now][k];
        if (next == no_index || of.is_constrained(now, k) || result.region[next] != no_index) continue;
        result.region[next] = number;
        at.push_back(next);
      }
    }
  }
  find_inside(of, result, step);
  return result;
}

}  // namespace rbpa
