// Segments: any points on a grid with any segments have a constrained Delaunay triangulation once crossings are split;
//           it does not depend on their order, none of its edges cross, and no side is left that a circle would flip.
// An input is a byte with the bits of coordinates, a byte for the unit, which may be the last place of the coordinates,
// and a byte for the number of points; then two bytes a point, and two bytes a segment.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "fuzz/target.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/constrained_delaunay.h"
#include "rbpa/plane/predicate/predicates.h"

namespace {

using rbpa::ConstrainedDelaunay;
using rbpa::Point;
using rbpa::Segment;
using Predicates = rbpa::Predicates<long double>;
using Edges = std::set<std::pair<Point, Point>>;

constexpr std::size_t most_segments = 40;

Edges edges_of(const ConstrainedDelaunay& made) {
  Edges edges;
  for (const auto& [a, b] : made.edges) edges.insert(std::minmax(made.points[a], made.points[b]));
  return edges;
}

bool cross(const std::pair<Point, Point>& e, const std::pair<Point, Point>& f) {
  const auto parts = [](const auto& line, const auto& ends) {
    return Predicates::orientation(line.first, line.second, ends.first) *
               Predicates::orientation(line.first, line.second, ends.second) <
           0;
  };
  return parts(e, f) && parts(f, e);
}

void check(const ConstrainedDelaunay& made) {
  rbpa::require_linked(made, made.points.size());
  std::set<Point> corners, distinct(made.points.begin(), made.points.end());
  for (std::uint32_t t = 0; t < made.triangles.size(); ++t) {
    const auto& [a, b, c] = made.triangles[t];
    for (const std::uint32_t i : made.triangles[t]) corners.insert(made.points[i]);
    fuzz::require(Predicates::orientation(made.points[a], made.points[b], made.points[c]) > 0, "triangles turn left");
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = made.neighbors[t][k];
      if (other == rbpa::TriangleArrays::none || made.is_constrained(t, k)) continue;
      for (const std::uint32_t q : made.triangles[other])
        fuzz::require(
            q == a || q == b || q == c ||
                Predicates::in_perturbed_circle(made.points[a], made.points[b], made.points[c], made.points[q]) < 0,
            "no side can be flipped");
    }
  }
  fuzz::require(made.triangles.empty() || corners == distinct, "every point is a corner");
  const Edges edges = edges_of(made);
  for (auto e = edges.begin(); e != edges.end(); ++e)
    for (auto f = std::next(e); f != edges.end(); ++f) fuzz::require(!cross(*e, *f), "edges do not cross");
  rbpa::regions(made);
}

/// Returns whether a way along the edges leads from one point to another.
bool are_joined(const Edges& edges, const Point& from, const Point& to) {
  std::set<Point> reached = {from};
  for (std::size_t before = 0; before < reached.size();) {
    before = reached.size();
    for (const auto& [a, b] : edges)
      if (reached.contains(a) || reached.contains(b)) reached.insert({a, b});
  }
  return reached.contains(to);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const unsigned mask = (1U << (1 + data[0] % 8)) - 1;
  const bool is_at_last_place = data[1] % 4 == 0;
  const double unit = std::ldexp(1, is_at_last_place ? -52 : (data[1] - 128) * 4), base = is_at_last_place ? 1 : 0;
  std::vector<Point> points;
  std::size_t at = 3;
  for (std::size_t i = 0; i < data[2] % 64U && at + 2 <= size; ++i, at += 2)
    points.push_back({base + (data[at] & mask) * unit, base + (data[at + 1] & mask) * unit});
  if (points.empty()) return 0;
  std::vector<Segment> segments;
  for (; at + 2 <= size && segments.size() < most_segments; at += 2) {
    const auto a = static_cast<std::uint32_t>(data[at] % points.size()),
               b = static_cast<std::uint32_t>(data[at + 1] % points.size());
    if (points[a] != points[b]) segments.push_back({a, b});
  }
  const ConstrainedDelaunay made = rbpa::constrained_delaunay(points, segments, {.split_crossings = true});
  check(made);
  const Edges edges = edges_of(made);
  for (const auto& [a, b] : segments)
    fuzz::require(are_joined(edges, points[a], points[b]), "the ends of a segment are joined by edges");
  std::reverse(segments.begin(), segments.end());
  for (Segment& segment : segments) std::swap(segment[0], segment[1]);
  fuzz::require(edges_of(rbpa::constrained_delaunay(points, segments, {.split_crossings = true})) == edges,
                "edges do not depend on the order of segments");
  try {
    const ConstrainedDelaunay whole = rbpa::constrained_delaunay(points, segments);
    fuzz::require(made.crossed.empty() && whole.triangles == made.triangles && whole.edges == made.edges,
                  "without a crossing nothing is split");
  } catch (const rbpa::InvalidInput&) {
    fuzz::require(!made.crossed.empty() || edges.size() > 1, "only a crossing is refused");
  }
  return 0;
}
