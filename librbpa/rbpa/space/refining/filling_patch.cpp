#include "rbpa/space/refining/filling_patch.h"

#include <algorithm>
#include <cmath>

#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_face.h"
#include "rbpa/space/refining/least_bending.h"
#include "rbpa/surface_mesh.h"

namespace rbpa::space {
namespace {

Vector minus(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// Of the triangle's plane; 0 where it has no area.
Vector unit_normal(const Vector& a, const Vector& b, const Vector& c) {
  const Vector n = cross(minus(b, a), minus(c, a));
  const double size = length(n);
  return size > 0 ? Vector{n.x / size, n.y / size, n.z / size} : Vector{0, 0, 0};
}

std::pair<std::uint32_t, std::uint32_t> key_of(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

SurfaceMesh mesh_of(const FillingRim& rim) {
  std::vector<Point3> points;
  for (const Vector& place : rim.places) points.push_back({place.x, place.y, place.z});
  return surface_mesh(points, rim.triangles);
}

}  // namespace

FillingPatch::FillingPatch(const FillingRim& rim) : rim_(rim), scales_(rim.scales), edges_(rim.edges) {
  SurfaceMesh made = mesh_of(rim);
  mesh_ = std::move(made.mesh);
  names_ = std::move(made.input_index);
  for (const auto e : mesh_.edges()) {
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    edges_.insert(key_of(name(mesh_.from_vertex_handle(h)), name(mesh_.to_vertex_handle(h))));
  }
}

Vector FillingPatch::at(Vertex v) const {
  const auto& p = mesh_.point(v);
  return {p[0], p[1], p[2]};
}

Vector FillingPatch::place(std::size_t added) const {
  return at(Vertex(static_cast<int>(mesh_.n_vertices() - between_.size() + added)));
}

void FillingPatch::refine(std::size_t most) {
  flip_all();
  while (between_.size() < most && split_large()) flip_all();
}

/// Of the triangles that there are now.
bool FillingPatch::split_large() {
  bool has_split = false;
  const std::size_t count = mesh_.n_faces();
  for (std::size_t f = 0; f < count; ++f) {
    const Mesh::FaceHandle face(static_cast<int>(f));
    if (!is_large(face)) continue;
    std::array<std::uint32_t, 3> corners{};
    double scale = 0;
    std::size_t k = 0;
    for (const auto v : mesh_.fv_range(face)) {
      corners[k++] = name(v);
      scale += scales_[name(v)] / 3;
    }
    std::sort(corners.begin(), corners.end());
    meshops::split_face(mesh_, face);
    const auto added = static_cast<std::uint32_t>(rim_.places.size() + between_.size());
    for (const std::uint32_t corner : corners) edges_.insert({corner, added});
    names_.push_back(added);
    scales_.push_back(scale);
    between_.push_back(corners);
    has_split = true;
  }
  return has_split;
}

/// Whether the distance of its centroid to each corner is large for the edges there, and for those in the middle.
bool FillingPatch::is_large(Mesh::FaceHandle f) const {
  std::array<Vector, 3> corners{};
  std::array<double, 3> scales{};
  std::size_t k = 0;
  for (const auto v : mesh_.fv_range(f)) {
    corners[k] = at(v);
    scales[k++] = scales_[name(v)];
  }
  const auto& [a, b, c] = corners;
  const Vector middle = {a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3, a.z / 3 + b.z / 3 + c.z / 3};
  const double scale = scales[0] / 3 + scales[1] / 3 + scales[2] / 3;
  for (k = 0; k < 3; ++k) {
    const double distance = std::sqrt(2.0) * length(minus(corners[k], middle));
    if (distance <= scale || distance <= scales[k]) return false;
  }
  return true;
}

void FillingPatch::flip_all() {
  // In space flips need not end; in a patch of no great turns they do long before.
  std::size_t left = 20 * mesh_.n_edges();
  std::vector<Edge> waiting;
  for (std::size_t e = mesh_.n_edges(); e-- > 0;) waiting.emplace_back(static_cast<int>(e));
  while (!waiting.empty() && left > 0) {
    const Edge e = waiting.back();
    waiting.pop_back();
    if (!is_better_flipped(e)) continue;
    --left;
    const Halfedge h = mesh_.halfedge_handle(e, 0);
    edges_.erase(key_of(name(mesh_.from_vertex_handle(h)), name(mesh_.to_vertex_handle(h))));
    meshops::flip(mesh_, e);
    edges_.insert(key_of(name(mesh_.from_vertex_handle(h)), name(mesh_.to_vertex_handle(h))));
    for (const unsigned side : {0U, 1U}) {
      const Halfedge half = mesh_.halfedge_handle(e, side);
      waiting.push_back(mesh_.edge_handle(mesh_.next_halfedge_handle(half)));
      waiting.push_back(mesh_.edge_handle(mesh_.prev_halfedge_handle(half)));
    }
  }
}

/// Whether the angles across from the edge are more than 180 degrees together, and the flipped edge is free and folds nothing.
bool FillingPatch::is_better_flipped(Edge e) const {
  if (mesh_.is_boundary(e)) return false;
  const Halfedge h = mesh_.halfedge_handle(e, 0);
  const Vertex from = mesh_.from_vertex_handle(h), to = mesh_.to_vertex_handle(h);
  const Vertex left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
  const Vertex right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h)));
  if (edges_.contains(key_of(name(left), name(right))) || meshops::flip_blocker(mesh_, e)) return false;
  const Vector a = at(from), b = at(to), c = at(left), d = at(right);
  const Vector ca = minus(a, c), cb = minus(b, c), da = minus(a, d), db = minus(b, d);
  const double sine_c = length(cross(ca, cb)), sine_d = length(cross(da, db));
  constexpr double clearly = 0x1p-40;
  if (!(dot(ca, cb) * sine_d + dot(da, db) * sine_c < -clearly * sine_c * sine_d)) return false;
  const Vector old_left = unit_normal(a, b, c), old_right = unit_normal(b, a, d);
  const Vector mean = {old_left.x + old_right.x, old_left.y + old_right.y, old_left.z + old_right.z};
  const Vector new_from = unit_normal(d, c, a), new_to = unit_normal(c, d, b);
  return dot(new_from, mean) > 0 && dot(new_to, mean) > 0 && dot(new_from, new_to) > 0;
}

bool FillingPatch::make_smooth() {
  constexpr int rounds = 2;  // the weights of the first are those of the flat filling
  bool has_moved = false;
  for (int round = 0; round < rounds; ++round) {
    const std::size_t first = mesh_.n_vertices() - between_.size(), rim = rim_.places.size();
    BendingRows rows(between_.size());
    std::vector<std::vector<BendingNeighbor>> around(rim);
    const auto neighbors_of = [&](Vertex v, std::vector<BendingNeighbor>& of) {
      for (const auto w : mesh_.vv_range(v))
        of.push_back({at(w), name(w) < rim ? BendingNeighbor::fixed : name(w) - static_cast<std::uint32_t>(rim)});
    };
    for (std::size_t v = 0; v < first; ++v) neighbors_of(Vertex(static_cast<int>(v)), around[names_[v]]);
    for (std::size_t v = 0; v < rim; ++v) {
      if (!rim_.is_inner[v]) continue;
      for (const Vector& place : rim_.outside[v]) around[v].push_back({place, BendingNeighbor::fixed});
      rows.add(rim_.places[v], BendingNeighbor::fixed, around[v]);
    }
    for (std::size_t k = 0; k < between_.size(); ++k) {
      std::vector<BendingNeighbor> of;
      const Vertex v(static_cast<int>(first + k));
      neighbors_of(v, of);
      rows.add(at(v), static_cast<std::uint32_t>(k), of);
    }
    const auto places = rows.least();
    if (!places) return has_moved;
    for (std::size_t k = 0; k < places->size(); ++k) {
      const Vector& p = (*places)[k];
      mesh_.set_point(Vertex(static_cast<int>(first + k)), {p.x, p.y, p.z});
    }
    has_moved = true;
    flip_all();
  }
  return has_moved;
}

std::vector<std::array<std::uint32_t, 3>> FillingPatch::triangles() const {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (const auto f : mesh_.faces()) {
    auto& corners = all.emplace_back();
    std::size_t k = 0;
    for (const auto v : mesh_.fv_range(f)) corners[k++] = name(v);
  }
  return all;
}

bool FillingPatch::is_degenerate() const {
  for (const auto f : mesh_.faces()) {
    std::array<Vector, 3> corners{};
    std::size_t k = 0;
    for (const auto v : mesh_.fv_range(f)) corners[k++] = at(v);
    const Vector normal = unit_normal(corners[0], corners[1], corners[2]);
    if (!(dot(normal, normal) > 0)) return true;
  }
  return false;
}

}  // namespace rbpa::space
