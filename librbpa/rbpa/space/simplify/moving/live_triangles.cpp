#include "rbpa/space/simplify/moving/live_triangles.h"

#include <algorithm>
#include <array>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/live_range.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/simplify/moving/moved_triangles.h"

namespace rbpa::space {
namespace {

using meshops::Connectivity;
using meshops::Face;
using meshops::Vertex;

constexpr std::size_t group = 16;  // number of triangles for which the tree is searched together

std::size_t index(Vertex v) { return static_cast<std::size_t>(v.idx()); }
std::size_t index(Face f) { return static_cast<std::size_t>(f.idx()); }

std::array<Vertex, 3> vertices_of(const Connectivity& mesh, Face f) {
  const meshops::Halfedge h = mesh.halfedge_handle(f), next = mesh.next_halfedge_handle(h);
  return {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h), mesh.to_vertex_handle(next)};
}

Corners corners_at(const std::array<Vertex, 3>& vertices, std::span<const Point3> places) {
  return {places[index(vertices[0])], places[index(vertices[1])], places[index(vertices[2])]};
}

/// Returns whether two of the triangles cross. Requires: all triangles begin with one common corner.
bool cross_each_other(const std::vector<Corners>& triangles) {
  std::vector<Box> sides;
  for (const Corners& t : triangles) sides.push_back(box_of(std::array{t[1], t[2]}));
  const meshops::GoOn always;
  meshops::Steps step(always);
  const BoxTree tree(sides, step);
  bool cross = false;
  for (std::size_t i = 0; i < triangles.size() && !cross; ++i)
    tree.for_each_meeting(box_of(triangles[i]), [&](std::uint32_t j) {
      cross = cross || (i != j && triangles_cross(triangles[i], triangles[j]));
    });
  return cross;
}

}  // namespace

LiveTriangles::LiveTriangles(const Connectivity& mesh, std::span<const Point3> places) : box_of_face_(mesh.n_faces()) {
  for (const Face f : meshops::live_faces(mesh))
    for (const Vertex v : vertices_of(mesh, f))
      meshops::require(is_finite(places[index(v)]), "no_crossings: found coordinates of vertex ", v.idx(),
                       " that are not finite, expected numbers");
  build(mesh, places);
}

void LiveTriangles::build(const Connectivity& mesh, std::span<const Point3> places) {
  std::vector<Box> boxes;
  face_.clear();
  for (const Face f : meshops::live_faces(mesh)) {
    box_of_face_[index(f)] = static_cast<std::uint32_t>(boxes.size());
    face_.push_back(f);
    boxes.push_back(box_of(corners_at(vertices_of(mesh, f), places)));
  }
  const meshops::GoOn always;
  meshops::Steps step(always);
  tree_ = BoxTree(boxes, step);
  live_ = boxes.size();
}

bool LiveTriangles::would_cross(const Connectivity& mesh, meshops::Edge e, std::span<const Point3> places,
                                const Point3& place) const {
  std::vector<Corners> moved;
  for_each_moved_triangle(mesh, e, places, place, [&](const Point3&, const Point3& second, const Point3& third) {
    if (!are_collinear(place, second, third)) moved.push_back({place, second, third});
    return true;
  });
  const meshops::Halfedge h = mesh.halfedge_handle(e, 0);
  const auto moves = [&, a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h)](Vertex v) {
    return (v == a || v == b) && places[index(v)] != place;
  };
  bool cross = false;
  for (std::size_t first = 0; first < moved.size() && !cross; first += group) {
    const std::span<const Corners> some = std::span(moved).subspan(first, std::min(group, moved.size() - first));
    Box whole;
    std::array<Box, group> boxes;
    for (std::size_t k = 0; k < some.size(); ++k) whole.include(boxes[k] = box_of(some[k]));
    tree_.for_each_meeting(whole, [&](std::uint32_t i) {
      const std::array<Vertex, 3> vertices = vertices_of(mesh, face_[i]);
      if (cross || moves(vertices[0]) || moves(vertices[1]) || moves(vertices[2])) return;
      const Corners other = corners_at(vertices, places);
      const Box box = box_of(other);
      for (std::size_t k = 0; k < some.size() && !cross; ++k)
        cross = boxes[k].meets(box) && !are_collinear(other[0], other[1], other[2]) && triangles_cross(some[k], other);
    });
  }
  return cross || cross_each_other(moved);
}

void LiveTriangles::update(const Connectivity& mesh, const meshops::WeldEffect& effect,
                           std::span<const Point3> places) {
  for (const Face f : effect.removed.faces()) tree_.replace(box_of_face_[index(f)], Box{});
  live_ -= effect.removed.faces().size();
  if (2 * live_ < face_.size()) return build(mesh, places);
  for (const meshops::Halfedge out : mesh.voh_range(effect.survivor))
    if (const Face f = mesh.face_handle(out); f.is_valid())
      tree_.replace(box_of_face_[index(f)], box_of(corners_at(vertices_of(mesh, f), places)));
}

}  // namespace rbpa::space
