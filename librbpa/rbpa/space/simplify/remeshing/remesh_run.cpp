#include "rbpa/space/simplify/remeshing/remesh_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <variant>

#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "rbpa/space/predicate/normal_sign.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/simplify/moving/moved_triangles.h"

namespace rbpa::space {
namespace {

using Vector = Vector3<double>;

constexpr unsigned moves_in_a_round = 3;
constexpr double allowed_part = 1 - 0x1p-20;  // of options.error; the rest is for the rounding of middles of edges

Point3 middle(const Point3& a, const Point3& b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2}; }

double squared(double x) { return x * x; }

double squared_distance(const Point3& a, const Point3& b) {
  const Vector v = from<double>(a, b);
  return dot(v, v);
}

/// Returns whether an angle of the triangle is above 135 degrees.
bool is_cap(const Point3& a, const Point3& b, const Point3& c) {
  const auto is_flat = [](const Point3& p, const Point3& q, const Point3& r) {
    const Vector u = from<double>(p, q), v = from<double>(p, r);
    const double product = dot(u, v);
    return product <= 0 && 2 * product * product >= dot(u, u) * dot(v, v);
  };
  return is_flat(a, b, c) || is_flat(b, c, a) || is_flat(c, a, b);
}

/// The squared length and the number of a waiting edge. Of equal lengths, the number decides.
using Waiting = std::pair<double, int>;

}  // namespace

RemeshRun::RemeshRun(meshops::Connectivity& mesh, std::vector<Point3>& places, MeshCurves curves,
                     std::vector<double> wanted, const SurfaceDistance& given, const RemeshOptions& options,
                     Remeshing& counts)
    : mesh_(mesh),
      places_(places),
      given_(given),
      options_(options),
      counts_(counts),
      curves_(std::move(curves)),
      given_wanted_(std::move(wanted)),
      wanted_(given_wanted_),
      long_(options.length * options.length * 16 / 9),
      short_(options.length * options.length * 16 / 25),
      step_(options.go_on) {}

void RemeshRun::operator()() {
  for (unsigned round = 0; round < options_.rounds; ++round) {
    split_long();
    collapse_short();
    flip_to_regular();
    for (unsigned moves = moves_in_a_round; moves > 0; --moves) move_vertices(moves == 1);
  }
}

/// Returns the squared length of an edge, as if the length that is wanted at its ends, the lesser one, were
/// options.length.
double RemeshRun::squared_length(Edge e) const {
  const Halfedge h = mesh_.halfedge_handle(e, 0);
  const Vertex a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h);
  return squared_distance(at(a), at(b)) / squared(std::min(wanted(a), wanted(b)));
}

Point3 RemeshRun::rounded(const Point3& p) const {
  return options_.single_precision ? Point3{to_single(p.x), to_single(p.y), to_single(p.z)} : p;
}

void RemeshRun::move(Vertex v, const Target& target) {
  places_[index_of(v)] = target.place;
  if (!wanted_.empty()) wanted_[index_of(v)] = target.wanted;
}

/// Splits long edges, the longest first. Each is the longest of its triangles, so no angle becomes much smaller.
void RemeshRun::split_long() {
  std::priority_queue<Waiting> longest;
  const auto add = [&](Edge e) {
    if (const double length = squared_length(e); length > long_) longest.emplace(length, e.idx());
  };
  for (const Edge e : meshops::live_edges(mesh_)) add(e);
  while (!longest.empty()) {
    const Edge e(longest.top().second);
    longest.pop();
    step_(4);
    const std::size_t before = mesh_.n_edges();
    if (!try_split(e)) continue;
    add(e);
    for (std::size_t i = before; i < mesh_.n_edges(); ++i) add(Edge(static_cast<int>(i)));
  }
}

bool RemeshRun::try_split(Edge e) {
  if (is_kept(e) || meshops::split_edge_blocker(mesh_, e)) return false;
  const Halfedge h = mesh_.halfedge_handle(e, 0);
  const Point3 a = at(mesh_.from_vertex_handle(h)), b = at_end(h), m = rounded(middle(a, b));
  if (std::max(squared_distance(a, m), squared_distance(m, b)) >= squared_distance(a, b)) return false;  // by rounding
  for (const Halfedge side : {h, mesh_.opposite_halfedge_handle(h)}) {
    if (mesh_.is_boundary(side)) continue;
    const Halfedge next = mesh_.next_halfedge_handle(side);
    // Do not split next to a longer edge, which had its turn and stays: such splits would never end.
    for (const Halfedge other : {next, mesh_.next_halfedge_handle(next)})
      if (squared_length(mesh_.edge_handle(other)) > squared_length(e)) return false;
    const Point3 &p = at(mesh_.from_vertex_handle(side)), &q = at_end(side), &r = at_end(next);
    if (!keeps_direction(p, q, r, p, m, r) || !keeps_direction(p, q, r, m, q, r)) return false;
  }
  // With the greater of both wanted lengths no new edge is longer than this one, as squared_length() measures it.
  const double greater = std::max(wanted(mesh_.from_vertex_handle(h)), wanted(mesh_.to_vertex_handle(h)));
  const meshops::SplitEdgeEffect effect = meshops::split_edge(mesh_, e);
  const int curve = curves_.of_edge[index_of(e)];
  curves_.of_edge.resize(mesh_.n_edges(), MeshCurves::none);
  curves_.of_edge[index_of(effect.added.edge[0])] = curve;
  curves_.of_vertex.push_back(curve);
  curves_.degree.push_back(MeshCurves::usual_degree(mesh_, effect.added.vertex));
  places_.push_back(m);
  if (!wanted_.empty()) wanted_.push_back(greater);
  ++counts_.splits;
  return true;
}

/// Collapses short edges, the shortest first.
void RemeshRun::collapse_short() {
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> shortest;
  const auto add = [&](Edge e) {
    if (const double length = squared_length(e); length < short_) shortest.emplace(length, e.idx());
  };
  for (const Edge e : meshops::live_edges(mesh_)) add(e);
  while (!shortest.empty()) {
    const auto [length, number] = shortest.top();
    shortest.pop();
    step_(8);
    const Edge e(number);
    if (!meshops::is_live(mesh_, e) || squared_length(e) != length) continue;
    if (const std::optional<Vertex> survivor = try_collapse(e))
      for (const Halfedge out : mesh_.voh_range(*survivor)) add(mesh_.edge_handle(out));
  }
}

/// Collapses the edge to its middle, or else to one of its ends. Returns the vertex that is left; nothing if none.
std::optional<RemeshRun::Vertex> RemeshRun::try_collapse(Edge e) {
  const Halfedge h = mesh_.halfedge_handle(e, 0), o = mesh_.opposite_halfedge_handle(h);
  const auto end_of = [&](Halfedge way) { return Target{at_end(way), wanted(mesh_.to_vertex_handle(way))}; };
  const std::array<std::pair<Halfedge, std::optional<Target>>, 3> ways = {
      {{h, middle_of(h)}, {h, end_of(h)}, {o, end_of(o)}}};
  for (const auto& [way, target] : ways) {
    if (!target || !may_collapse(way, *target)) continue;
    const Vertex survivor = mesh_.to_vertex_handle(way);
    if (std::holds_alternative<meshops::Blocker>(meshops::try_collapse(mesh_, way))) continue;
    move(survivor, *target);
    ++counts_.collapses;
    return survivor;
  }
  return std::nullopt;
}

/// Returns the middle of the edge of h, moved to the curve that both ends are on, if any. Returns nothing if an end is
/// fixed or the ends are not on one curve.
std::optional<RemeshRun::Target> RemeshRun::middle_of(Halfedge h) const {
  const Vertex a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h);
  const int curve = curves_.of_vertex[index_of(a)];
  if (curve == MeshCurves::fixed || curves_.of_vertex[index_of(b)] != curve) return std::nullopt;
  return on_curve({middle(at(a), at(b)), (wanted(a) + wanted(b)) / 2}, curve);
}

/// Returns whether the start of h may vanish while the end of h moves to the place: no curve is lost, no edge becomes
/// too long, and no triangle turns.
bool RemeshRun::may_collapse(Halfedge h, const Target& target) const {
  const Point3& place = target.place;
  const Vertex v = mesh_.from_vertex_handle(h), w = mesh_.to_vertex_handle(h);
  const int curve = curves_.of_vertex[index_of(v)];
  if (curve == MeshCurves::fixed) return false;
  if (curve != MeshCurves::none) {
    const auto is_on_curve = [&](Halfedge side) { return curves_.of_edge[index_of(mesh_.edge_handle(side))] == curve; };
    const Halfedge o = mesh_.opposite_halfedge_handle(h);
    if (!is_on_curve(h)) return false;
    // The other edge of the curve at v must not be merged with an edge to an apex.
    if (!mesh_.is_boundary(h) && is_on_curve(mesh_.prev_halfedge_handle(h))) return false;
    if (!mesh_.is_boundary(o) && is_on_curve(mesh_.next_halfedge_handle(o))) return false;
  }
  for (const auto& [moved, other] : {std::pair(v, w), std::pair(w, v)}) {
    if (at(moved) == place) continue;
    for (const Halfedge out : mesh_.voh_range(moved)) {
      const Vertex u = mesh_.to_vertex_handle(out);
      if (u == other) continue;
      if (squared_distance(at(u), place) / squared(std::min(wanted(u), target.wanted)) > long_) return false;
      if (!is_near_curve(mesh_.edge_handle(out), {at(u), place, place})) return false;
    }
  }
  return for_each_moved_triangle(
      mesh_, mesh_.edge_handle(h), places_, place, [&](const Point3& old, const Point3& p, const Point3& q) {
        return place != p && place != q && keeps_direction(old, p, q, place, p, q) && is_near({place, p, q});
      });
}

/// Flips edges until no edge is left to flip. The flips come to an end, as each flip makes progress in one order.
void RemeshRun::flip_to_regular() {
  std::vector<int> excess(mesh_.n_vertices());
  for (const Vertex v : meshops::live_vertices(mesh_))
    excess[index_of(v)] = static_cast<int>(mesh_.valence(v)) - curves_.degree[index_of(v)];
  for (std::size_t before = counts_.flips + 1; before != counts_.flips;) {
    before = counts_.flips;
    for (const Edge e : meshops::live_edges(mesh_)) {
      step_(2);
      if (try_flip(e, excess)) ++counts_.flips;
    }
  }
}

/// Flips the edge if fewer caps result; or as many, with a lesser sum of squared excesses, else a shorter edge.
bool RemeshRun::try_flip(Edge e, std::vector<int>& excess) {
  if (curves_.of_edge[index_of(e)] != MeshCurves::none) return false;
  const Halfedge h = mesh_.halfedge_handle(e, 0), o = mesh_.opposite_halfedge_handle(h);
  const Vertex a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h),
               c = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)),
               d = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(o));
  const std::array<std::array<Vertex, 3>, 2> was = {{{a, b, c}, {b, a, d}}}, becomes = {{{d, c, a}, {c, d, b}}};
  const auto caps = [&](const auto& triangles) {
    return std::count_if(triangles.begin(), triangles.end(),
                         [&](const auto& t) { return is_cap(at(t[0]), at(t[1]), at(t[2])); });
  };
  // (x − 1)² − x² = 1 − 2x at an end, (x + 1)² − x² = 1 + 2x at an apex.
  const int change = 4 + 2 * (excess[index_of(c)] + excess[index_of(d)] - excess[index_of(a)] - excess[index_of(b)]);
  const bool improves = change < 0 || (change == 0 && squared_distance(at(c), at(d)) < squared_distance(at(a), at(b)));
  const auto before = caps(was);
  if (!improves && before == 0) return false;
  if (const auto after = caps(becomes); after > before || (after == before && !improves)) return false;
  for (const auto& [p, q, r] : was)
    for (const auto& [s, t, u] : becomes)
      if (!keeps_direction(at(p), at(q), at(r), at(s), at(t), at(u))) return false;
  for (const auto& [p, q, r] : becomes)
    if (!is_near({at(p), at(q), at(r)})) return false;
  if (meshops::flip_blocker(mesh_, e)) return false;
  meshops::flip(mesh_, e);
  for (const Vertex v : {a, b}) --excess[index_of(v)];
  for (const Vertex v : {c, d}) ++excess[index_of(v)];
  return true;
}

void RemeshRun::move_vertices(bool onto_given) {
  for (const Vertex v : meshops::live_vertices(mesh_)) {
    step_(onto_given ? 16 : 4);
    if (const std::optional<Target> to = target(v, onto_given); to && may_move(v, to->place)) move(v, *to);
  }
}

/// Returns whether the vertex may move to the place: no edge becomes shorter than a quarter of a short one, no triangle
/// becomes a cap, and no triangle turns.
bool RemeshRun::may_move(Vertex v, const Point3& place) const {
  const Point3& old = at(v);
  if (old == place) return true;
  for (const Halfedge out : mesh_.voh_range(v)) {
    const Point3& p = at_end(out);
    const double length = squared_distance(place, p),
                 least = short_ / 16 * squared(std::min(wanted(v), wanted(mesh_.to_vertex_handle(out))));
    if (place == p || (length < least && length < squared_distance(old, p))) return false;
    if (!is_near_curve(mesh_.edge_handle(out), {place, p, p})) return false;
    if (mesh_.is_boundary(out)) continue;
    const Point3& q = at_end(mesh_.next_halfedge_handle(out));
    if ((is_cap(place, p, q) && !is_cap(old, p, q)) || !keeps_direction(old, p, q, place, p, q) ||
        !is_near({place, p, q}))
      return false;
  }
  return true;
}

/// Returns whether options.error allows the triangle.
bool RemeshRun::is_near(const SurfaceDistance::Corners& triangle) const {
  return !options_.error || given_.is_within(triangle, *options_.error * allowed_part);
}

/// Returns whether options.error allows the edge to become the segment, a triangle a, b, b; true if it is on no curve.
bool RemeshRun::is_near_curve(Edge e, const SurfaceDistance::Corners& segment) const {
  const int curve = curves_.of_edge[index_of(e)];
  return !options_.error || curve == MeshCurves::none ||
         curves_.shapes[static_cast<std::size_t>(curve) - 1].is_within(segment, *options_.error * allowed_part);
}

/// Returns the place to which the vertex should move; nothing if it stays.
std::optional<RemeshRun::Target> RemeshRun::target(Vertex v, bool onto_given) const {
  const int curve = curves_.of_vertex[index_of(v)];
  if (curve == MeshCurves::fixed || mesh_.is_isolated(v)) return std::nullopt;
  if (curve == MeshCurves::none) return along_surface(v, onto_given);
  std::array<Point3, 2> beside;
  std::size_t count = 0;
  for (const Halfedge out : mesh_.voh_range(v))
    if (curves_.of_edge[index_of(mesh_.edge_handle(out))] == curve && count < 2) beside[count++] = at_end(out);
  return on_curve({middle(beside[0], beside[1]), wanted(v)}, curve);
}

/// Returns the mean of the centroids of the triangles at v, projected to the tangent plane, weighted by area over the
/// square of the wanted length. With `onto_given`, returns the nearest point of the given triangles that face as v
/// does, as another sheet may be near.
std::optional<RemeshRun::Target> RemeshRun::along_surface(Vertex v, bool onto_given) const {
  const Point3& p = at(v);
  Vector sum{}, normal{};
  double weight = 0;
  for (const Halfedge out : mesh_.voh_range(v)) {
    const Halfedge next = mesh_.next_halfedge_handle(out);
    const Vector u = from<double>(p, at_end(out)), w = from<double>(p, at_end(next));
    const Vector n = cross(u, w);
    const double mean = (wanted(v) + wanted(mesh_.to_vertex_handle(out)) + wanted(mesh_.to_vertex_handle(next))) / 3,
                 area = std::sqrt(dot(n, n)) / squared(mean), third = area / 3;
    sum = plus(sum, {third * (u.x + w.x), third * (u.y + w.y), third * (u.z + w.z)});
    normal = plus(normal, n);
    weight += area;
  }
  const double squared = dot(normal, normal);
  if (!(weight > 0) || !(squared > 0)) return std::nullopt;
  const double along = dot(sum, normal) / squared;
  const Point3 moved = {p.x + (sum.x - along * normal.x) / weight, p.y + (sum.y - along * normal.y) / weight,
                        p.z + (sum.z - along * normal.z) / weight};
  if (!onto_given) return Target{rounded(moved), wanted(v)};
  const std::optional<SurfaceDistance::Foot> foot = given_.nearest_point(moved, options_.length, normal);
  return foot ? std::optional(at_foot(*foot)) : std::nullopt;
}

/// Returns the point of a curve that is nearest to the target; the target itself if `curve` is none.
std::optional<RemeshRun::Target> RemeshRun::on_curve(const Target& target, int curve) const {
  if (curve == MeshCurves::none) return Target{rounded(target.place), target.wanted};
  const SurfaceDistance& shape = curves_.shapes[static_cast<std::size_t>(curve) - 1];
  const std::optional<SurfaceDistance::Foot> foot = shape.nearest_point(target.place, options_.length);
  return foot ? std::optional(at_foot(*foot)) : std::nullopt;
}

RemeshRun::Target RemeshRun::at_foot(const SurfaceDistance::Foot& foot) const {
  Target target{rounded(foot.place), given_wanted_.empty() ? 1.0 : 0.0};
  for (std::size_t k = 0; k < 3 && !given_wanted_.empty(); ++k)
    target.wanted += foot.weights[k] * given_wanted_[foot.corners[k]];
  return target;
}

}  // namespace rbpa::space
