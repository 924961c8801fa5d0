#include "support/polygon_laws.h"

#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace rbpa_test {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// Solid components of triangles: the edges of each triangle and the number of its component.
struct Components {
  std::map<DirectedEdge, std::size_t> triangle_left_of;
  std::vector<std::size_t> of;                   ///< component of each triangle
  std::map<std::size_t, long> holes;             ///< holes of each component: 1 − V + E − F
  std::map<DirectedEdge, std::size_t> boundary;  ///< edges with a triangle on the left only, and its component
};

Components components_of(const std::vector<Triangle>& triangles) {
  Components result;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) result.triangle_left_of[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
  std::vector<std::size_t> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  for (const auto& [edge, t] : result.triangle_left_of)
    if (const auto other = result.triangle_left_of.find({edge.second, edge.first});
        other != result.triangle_left_of.end())
      parent[root(t)] = root(other->second);

  std::set<std::pair<std::size_t, std::uint32_t>> vertices;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.of.push_back(root(t));
    result.holes.try_emplace(root(t), 1);
    result.holes[root(t)] -= 1;
    for (const std::uint32_t v : triangles[t])
      if (vertices.emplace(root(t), v).second) result.holes[root(t)] -= 1;
  }
  for (const auto& [edge, t] : result.triangle_left_of) {
    const bool inner = result.triangle_left_of.contains({edge.second, edge.first});
    if (!inner) result.boundary[edge] = root(t);
    if (!inner || edge.first < edge.second) result.holes[root(t)] += 1;
  }
  return result;
}

std::string wrong_ring(const rbpa::Ring& ring, std::span<const rbpa::Point> points) {
  if (ring.points.size() < 3) return "a ring of fewer than three points";
  std::set<std::uint32_t> seen;
  for (const std::uint32_t p : ring.points) {
    if (!seen.insert(p).second) return "a ring passes point " + std::to_string(p) + " twice";
    if (points[p] < points[ring.points[0]]) return "a ring does not begin with its least point";
  }
  return "";
}

std::pair<rbpa::Point, rbpa::Point> key(const rbpa::Ring& ring, std::span<const rbpa::Point> points) {
  return {points[ring.points[0]], points[ring.points[1]]};
}

}  // namespace

std::string wrong_with_polygons(const std::vector<rbpa::Polygon>& polygons, const std::vector<Triangle>& triangles,
                                std::span<const rbpa::Point> points) {
  Components components = components_of(triangles);
  if (polygons.size() != components.holes.size())
    return std::to_string(polygons.size()) + " polygons, expected " + std::to_string(components.holes.size());
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const rbpa::Polygon& polygon = polygons[k];
    if (k > 0 && !(key(polygons[k - 1].shell, points) < key(polygon.shell, points))) return "polygons out of order";
    const auto first = components.boundary.find({polygon.shell.points[0], polygon.shell.points[1]});
    if (first == components.boundary.end()) return "a shell begins with an edge that is not on the boundary";
    const std::size_t component = first->second;
    if (static_cast<long>(polygon.holes.size()) != components.holes[component])
      return std::to_string(polygon.holes.size()) + " holes, expected " + std::to_string(components.holes[component]);

    std::vector<const rbpa::Ring*> rings = {&polygon.shell};
    for (const rbpa::Ring& hole : polygon.holes) rings.push_back(&hole);
    for (std::size_t r = 0; r < rings.size(); ++r) {
      if (std::string wrong = wrong_ring(*rings[r], points); !wrong.empty()) return wrong;
      if (r > 1 && !(key(*rings[r - 1], points) < key(*rings[r], points))) return "holes out of order";
      if (r > 0 && points[rings[r]->points[0]] < points[polygon.shell.points[0]])
        return "a hole begins left of its shell";
      const auto& ring = rings[r]->points;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto edge = components.boundary.find({ring[i], ring[(i + 1) % ring.size()]});
        if (edge == components.boundary.end()) return "an edge of a ring is not on the boundary, or is on two rings";
        if (edge->second != component) return "a polygon has edges of two components";
        components.boundary.erase(edge);
      }
    }
  }
  return components.boundary.empty() ? "" : "a boundary edge is on no ring";
}

std::vector<std::vector<Points>> coordinates_of(const std::vector<rbpa::Polygon>& polygons,
                                                std::span<const rbpa::Point> points) {
  std::vector<std::vector<Points>> result;
  for (const rbpa::Polygon& polygon : polygons) {
    std::vector<Points>& rings = result.emplace_back();
    const auto add = [&](const rbpa::Ring& ring) {
      Points& at = rings.emplace_back();
      for (const std::uint32_t p : ring.points) at.push_back(points[p]);
    };
    add(polygon.shell);
    for (const rbpa::Ring& hole : polygon.holes) add(hole);
  }
  return result;
}

long long twice_area(const std::vector<Triangle>& triangles, std::span<const rbpa::Point> points) {
  long long sum = 0;
  for (const Triangle& t : triangles) {
    const auto whole = [&](double value) { return static_cast<long long>(value); };
    const rbpa::Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    sum += whole(b.x - a.x) * whole(c.y - a.y) - whole(b.y - a.y) * whole(c.x - a.x);
  }
  return sum;
}

}  // namespace rbpa_test
