#include "rbpa/space/simplify/remeshing/mesh_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

#include "meshops/core/live_range.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using meshops::Connectivity;
using meshops::Edge;
using meshops::Halfedge;
using meshops::Vertex;
using Vector = Vector3<double>;

/// Returns whether the angle between two vectors is greater than the one with the given cosine; false if a vector is 0.
bool is_above(const Vector& u, const Vector& v, double cosine) {
  return dot(u, v) < cosine * std::sqrt(dot(u, u)) * std::sqrt(dot(v, v));
}

/// Tests whether edges of a mesh are on curves, and vertices are corners of curves.
struct Sharpness {
  const Connectivity& mesh;
  const std::vector<Point3>& places;
  const double cosine;

  const Point3& at_end(Halfedge h) const { return places[index_of(mesh.to_vertex_handle(h))]; }
  Vector normal(Halfedge h) const {
    const Halfedge next = mesh.next_halfedge_handle(h);
    const Point3& a = at_end(h);
    return cross(from<double>(a, at_end(next)), from<double>(a, at_end(mesh.next_halfedge_handle(next))));
  }
  bool is_on_curve(Edge e) const {
    return mesh.is_boundary(e) ||
           is_above(normal(mesh.halfedge_handle(e, 0)), normal(mesh.halfedge_handle(e, 1)), cosine);
  }
  /// Returns whether a curve has a corner at the vertex between two halfedges that leave it.
  bool turns(Halfedge one, Halfedge other) const {
    const Point3& middle = at_end(mesh.opposite_halfedge_handle(one));
    return is_above(from<double>(at_end(one), middle), from<double>(middle, at_end(other)), cosine);
  }
  /// Returns the number of edges with which the angles at a vertex are nearest to 60 degrees.
  int degree(Vertex v) const {
    const Point3& p = places[index_of(v)];
    double sum = 0;
    for (const Halfedge out : mesh.voh_range(v)) {
      if (mesh.is_boundary(out)) continue;
      const Vector u = from<double>(p, at_end(out)), w = from<double>(p, at_end(mesh.next_halfedge_handle(out)));
      const Vector across = cross(u, w);
      sum += std::atan2(std::sqrt(dot(across, across)), dot(u, w));
    }
    const auto triangles = static_cast<int>(std::lround(sum * 3 / std::numbers::pi));
    return mesh.is_boundary(v) ? std::max(triangles, 1) + 1 : std::max(triangles, 3);
  }
};

}  // namespace

MeshCurves::MeshCurves(const Connectivity& mesh, const std::vector<Point3>& places, const RemeshOptions& options)
    : of_edge(mesh.n_edges(), none), of_vertex(mesh.n_vertices(), none), degree(mesh.n_vertices()) {
  constexpr int unnumbered = -2;
  const Sharpness sharp{mesh, places, std::cos(options.sharp_angle * std::numbers::pi / 180)};
  for (const Edge e : meshops::live_edges(mesh))
    if (sharp.is_on_curve(e)) of_edge[index_of(e)] = unnumbered;
  std::vector<Halfedge> sides;  // halfedges on curves that leave a vertex
  const auto find_sides = [&](Vertex v) {
    sides.clear();
    for (const Halfedge h : mesh.voh_range(v))
      if (of_edge[index_of(mesh.edge_handle(h))] != none) sides.push_back(h);
  };
  for (const Vertex v : meshops::live_vertices(mesh)) {
    find_sides(v);
    degree[index_of(v)] = usual_degree(mesh, v);
    if (sides.empty()) continue;
    const bool passes = sides.size() == 2 && !sharp.turns(sides[0], sides[1]);
    of_vertex[index_of(v)] = passes && !(options.keep_boundary && mesh.is_boundary(v)) ? unnumbered : fixed;
    if (!passes) degree[index_of(v)] = sharp.degree(v);
  }
  std::vector<Edge> waiting;
  for (const Edge first : meshops::live_edges(mesh)) {
    if (of_edge[index_of(first)] != unnumbered) continue;
    std::vector<std::array<std::uint32_t, 3>> segments;
    const int number = static_cast<int>(shapes.size()) + 1;
    of_edge[index_of(first)] = number;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const Halfedge h = mesh.halfedge_handle(waiting.back(), 0);
      waiting.pop_back();
      const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
      segments.push_back({static_cast<std::uint32_t>(a.idx()), static_cast<std::uint32_t>(b.idx()),
                          static_cast<std::uint32_t>(b.idx())});
      for (const Vertex end : {a, b}) {
        if (of_vertex[index_of(end)] == fixed) continue;
        of_vertex[index_of(end)] = number;
        find_sides(end);
        for (const Halfedge side : sides)
          if (int& of_side = of_edge[index_of(mesh.edge_handle(side))]; std::exchange(of_side, number) != number)
            waiting.push_back(mesh.edge_handle(side));
      }
    }
    shapes.emplace_back(places, segments);
  }
}

}  // namespace rbpa::space
