#include "rbpa/space/persistence/pairing/cycles.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

/// Returns the edges that occur an odd number of times in `edges`, ascending.
std::vector<std::uint32_t> sum(std::vector<std::uint32_t> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> odd;
  for (std::size_t i = 0, end; i < edges.size(); i = end) {
    for (end = i; end < edges.size() && edges[end] == edges[i]; ++end) continue;
    if ((end - i) % 2 == 1) odd.push_back(edges[i]);
  }
  return odd;
}

void append(std::vector<std::uint32_t>& edges, const std::vector<std::uint32_t>& more) {
  edges.insert(edges.end(), more.begin(), more.end());
}

}  // namespace

Cycles::Cycles(std::span<const Point3> points, const SolidFiltration& filtration, Pairing& pairing, Steps& step)
    : points_(points),
      filtration_(filtration),
      pairing_(pairing),
      step_(step),
      begin_(points.size() + 2, 0),
      arcs_(2 * filtration.edges.size()),
      parent_edge_(points.size(), Solid::none),
      depth_(points.size(), 0) {
  // In the second loop, begin_[p + 1] moves from the beginning of p's arcs to their end.
  for (const auto& [a, b] : filtration.edges) {
    ++begin_[a + std::size_t{2}];
    ++begin_[b + std::size_t{2}];
  }
  for (std::size_t p = 1; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
  for (std::uint32_t edge = 0; edge < filtration.edges.size(); ++edge) {
    step(2);
    const auto& [a, b] = filtration.edges[edge];
    arcs_[begin_[a + std::size_t{1}]++] = {b, edge};
    arcs_[begin_[b + std::size_t{1}]++] = {a, edge};
  }
  if (filtration.edges.empty()) return;
  // The tree of edges that end components connects all points; it is searched from one point.
  std::vector<std::uint32_t> reached = {filtration.edges.front()[0]};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    step(4);
    const std::uint32_t p = reached[i];
    for (std::size_t at = begin_[p]; at < begin_[p + std::size_t{1}]; ++at) {
      const Arc& arc = arcs_[at];
      if (!pairing.components.joins[arc.edge] || arc.edge == parent_edge_[p]) continue;
      parent_edge_[arc.to] = arc.edge;
      depth_[arc.to] = depth_[p] + 1;
      reached.push_back(arc.to);
    }
  }
}

Cycle Cycles::of(std::uint32_t edge) {
  const std::uint32_t triangle = pairing_.tunnels.ended_by(edge);
  Loops found = loops(with_joining_edges(pairing_.tunnels.cycle(edge)), edge);
  drop_boundaries(found, triangle);
  double whole = length(found.first);
  for (const Edges& other : found.others) whole += length(other);
  const auto& [a, b] = filtration_.edges[edge];
  const std::optional<Edges> path = shorter_path(b, a, edge, whole - length(edge));
  if (!path && found.others.empty()) return {std::move(found.first), whole, true};
  if (path) {
    Edges shortest = {edge};
    append(shortest, *path);
    if (pairing_.tunnels.is_boundary(shortest, triangle)) {
      const double least = length(shortest);
      return {std::move(shortest), least, true};
    }
  }
  // Paths that replaced parts of the cycle may meet, or use an edge twice.
  Edges edges = shortened(found.first, triangle);
  for (const Edges& other : found.others) append(edges, other);
  found = loops(sum(std::move(edges)), edge);
  drop_boundaries(found, triangle);
  Cycle cycle{std::move(found.first)};
  for (const Edges& other : found.others) append(cycle.edges, other);
  cycle.length = length(cycle.edges);
  return cycle;
}

double Cycles::length(std::uint32_t edge) const {
  const auto& [a, b] = filtration_.edges[edge];
  return distance(points_[a], points_[b]);
}

double Cycles::length(std::span<const std::uint32_t> edges) const {
  double all = 0;
  for (const std::uint32_t edge : edges) all += length(edge);
  return all;
}

std::uint32_t Cycles::across(std::uint32_t edge, std::uint32_t point) const {
  const auto& [a, b] = filtration_.edges[edge];
  return a == point ? b : a;
}

/// Returns `others`, edges that end no component, completed to a cycle by edges of the tree. Tree edges join the points
/// at which an odd number of edges ends, the deepest point first.
Cycles::Edges Cycles::with_joining_edges(const Edges& others) const {
  Edges edges = others;
  std::unordered_set<std::uint32_t> odd;
  std::priority_queue<std::pair<std::uint32_t, std::uint32_t>> deepest;
  const auto turn = [&](std::uint32_t point) {
    if (odd.erase(point) != 0) return;
    odd.insert(point);
    deepest.emplace(depth_[point], point);
  };
  for (const std::uint32_t edge : others)
    for (const std::uint32_t point : filtration_.edges[edge]) turn(point);
  while (!odd.empty()) {
    const std::uint32_t point = deepest.top().second;
    deepest.pop();
    if (odd.erase(point) == 0) continue;
    edges.push_back(parent_edge_[point]);
    turn(across(parent_edge_[point], point));
  }
  return edges;
}

Cycles::Loops Cycles::loops(const Edges& edges, std::uint32_t first) const {
  std::unordered_map<std::uint32_t, Edges> at;  // for each point: its edges, from which used ones are removed
  for (const std::uint32_t edge : edges)
    for (const std::uint32_t point : filtration_.edges[edge]) at[point].push_back(edge);
  std::unordered_set<std::uint32_t> used;
  Loops result;
  const auto trace = [&](std::uint32_t start_edge) {
    Edges path = {start_edge};
    std::vector<std::uint32_t> points = {filtration_.edges[start_edge][0], filtration_.edges[start_edge][1]};
    std::unordered_map<std::uint32_t, std::size_t> place = {{points[0], 0}, {points[1], 1}};
    used.insert(start_edge);
    while (!path.empty()) {
      Edges& next = at[points.back()];
      while (!next.empty() && used.contains(next.back())) next.pop_back();
      const std::uint32_t edge = next.back();
      used.insert(edge);
      const std::uint32_t point = across(edge, points.back());
      path.push_back(edge);
      const auto [seen, is_new] = place.emplace(point, points.size());
      if (is_new) {
        points.push_back(point);
        continue;
      }
      // The edges since the first visit of `point` are a loop.
      const auto from = static_cast<std::ptrdiff_t>(seen->second);
      Edges loop(path.begin() + from, path.end());
      path.resize(seen->second);
      while (points.size() > seen->second + 1) {
        place.erase(points.back());
        points.pop_back();
      }
      if (start_edge == first && loop.front() == first)
        result.first = std::move(loop);
      else
        result.others.push_back(std::move(loop));
    }
  };
  trace(first);
  for (const std::uint32_t edge : edges)
    if (!used.contains(edge)) trace(edge);
  return result;
}

/// Removes other loops that do not belong to the tunnel: those that are boundaries of triangles up to `triangle`, and
/// all of the rest if these are a boundary together.
void Cycles::drop_boundaries(Loops& loops, std::uint32_t triangle) {
  std::erase_if(loops.others, [&](const Edges& loop) { return pairing_.tunnels.is_boundary(loop, triangle); });
  Edges all;
  for (const Edges& loop : loops.others) append(all, loop);
  if (loops.others.size() > 1 && pairing_.tunnels.is_boundary(all, triangle)) loops.others.clear();
}

/// Returns the shortest path from `from` to `to` along edges earlier than `before`, if it is shorter than `bound`.
std::optional<Cycles::Edges> Cycles::shorter_path(std::uint32_t from, std::uint32_t to, std::uint32_t before,
                                                  double bound) {
  constexpr double roundings = 1e-12;
  bound *= 1 - roundings;
  struct Reached {
    double length;
    std::uint32_t edge;
    bool is_done = false;
  };
  using Open = std::tuple<double, double, std::uint32_t>;  // bound of the path's length, length up to point, point
  std::unordered_map<std::uint32_t, Reached> reached = {{from, {0, Solid::none}}};
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  open.emplace(distance(points_[from], points_[to]), 0, from);
  while (!open.empty()) {
    step_(2);
    const auto [estimate, so_far, point] = open.top();
    open.pop();
    if (std::exchange(reached.at(point).is_done, true)) continue;
    if (point == to) {
      Edges path;
      for (std::uint32_t p = to; p != from; p = across(path.back(), p)) path.push_back(reached.at(p).edge);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (std::size_t at = begin_[point]; at < begin_[point + std::size_t{1}]; ++at) {
      const Arc& arc = arcs_[at];
      if (!pairing_.tunnels.is_before(arc.edge, before)) continue;
      const double all = so_far + length(arc.edge), least = all + distance(points_[arc.to], points_[to]);
      if (!(least < bound)) continue;
      const auto [there, is_new] = reached.emplace(arc.to, Reached{all, arc.edge});
      if (!is_new && (there->second.is_done || !(all < there->second.length))) continue;
      there->second = {all, arc.edge};
      open.emplace(least, all, arc.to);
    }
  }
  return std::nullopt;
}

/// Returns the loop with parts replaced by shorter paths, where part and path together are a boundary of triangles up
/// to `triangle`. The first edge remains the first.
Cycles::Edges Cycles::shortened(const Edges& loop, std::uint32_t triangle) {
  const std::uint32_t first = loop.front();
  Edges path(loop.begin() + 1, loop.end());
  const auto points_on = [&] {
    // The first point of the path is the end of the first edge at which the second edge begins.
    const auto& [a, b] = filtration_.edges[first];
    const auto& ends = filtration_.edges[path.front()];
    std::vector<std::uint32_t> points = {ends[0] == b || ends[1] == b ? b : a};
    for (const std::uint32_t edge : path) points.push_back(across(edge, points.back()));
    return points;
  };
  std::vector<std::uint32_t> points = points_on();
  for (std::size_t size = path.size() / 2; size >= 2; size = std::min(size, path.size()) / 2)
    for (std::size_t at = 0; at + size <= path.size(); at += size / 2) {
      const auto begin = path.begin() + static_cast<std::ptrdiff_t>(at),
                 end = begin + static_cast<std::ptrdiff_t>(size);
      const Edges part(begin, end);
      const std::optional<Edges> other = shorter_path(points[at], points[at + size], first, length(part));
      if (!other) continue;
      Edges both = part;
      append(both, *other);
      if (!pairing_.tunnels.is_boundary(both, triangle)) continue;
      path.insert(path.erase(begin, end), other->begin(), other->end());
      points = points_on();
    }
  path.insert(path.begin(), first);
  return path;
}

}  // namespace rbpa::space
