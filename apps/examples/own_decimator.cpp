// Two decimators. One has costs of its own: the shortest edge collapses to its middle, unless it touches the boundary
// or a triangle would turn over. The other has quadric errors, and a condition of its own: no vertex of the boundary
// moves. The engine keeps the topology.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "meshops/simplify/simplify.h"
#include "meshops/topology/report.h"
#include "rbpa/space/simplify/quadric_policy.h"

using namespace meshops;
using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using Point = Mesh::Point;

namespace {

std::array<Vertex, 2> ends_of(const Mesh& mesh, Edge e) {
  const Halfedge h = mesh.halfedge_handle(e, 0);
  return {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)};
}

class ShortestEdges {
 public:
  std::optional<double> cost(const Mesh& mesh, Edge e) const {
    for (const Vertex v : ends_of(mesh, e))
      if (mesh.is_boundary(v)) return std::nullopt;
    return mesh.calc_edge_sqr_length(e);
  }
  Point place(const Mesh& mesh, Edge e) const { return mesh.calc_edge_midpoint(e); }
  bool allows(const Mesh& mesh, Edge e, const Point& place) const {
    const auto [a, b] = ends_of(mesh, e);
    for (const Vertex v : {a, b})
      for (const Face f : mesh.vf_range(v)) {
        std::array<Point, 3> before, after;
        std::size_t k = 0, moved = 0;
        for (const Vertex corner : mesh.fv_range(f)) {
          const bool moves = corner == a || corner == b;
          before[k] = mesh.point(corner);
          after[k++] = moves ? place : mesh.point(corner);
          moved += moves;
        }
        if (moved == 1 && (normal(before) | normal(after)) <= 0)
          return false;  // with both ends the triangle disappears
      }
    return true;
  }
  std::array<double, 3> key(const Mesh& mesh, Vertex v) const {
    const Point& p = mesh.point(v);
    return {p[0], p[1], p[2]};
  }

 private:
  static Point normal(const std::array<Point, 3>& t) { return (t[1] - t[0]) % (t[2] - t[0]); }
};

class BoundaryStays : public rbpa::MeshQuadrics<Mesh> {
 public:
  using MeshQuadrics::MeshQuadrics;
  static constexpr bool costs_grow = false;
  std::optional<double> cost(const Mesh& mesh, Edge e) const {
    for (const Vertex v : ends_of(mesh, e))
      if (mesh.is_boundary(v)) return std::nullopt;
    return MeshQuadrics::cost(mesh, e);
  }
};

/// Returns a torus of 2 · 48 · 24 triangles without two of them.
Mesh torus_with_hole() {
  constexpr int around = 48, across = 24;
  Mesh mesh;
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / across;
      mesh.add_vertex(Point((3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)));
    }
  const auto at = [](int i, int k) { return Vertex(i % around * across + k % across); };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k) {
      if (i == 0 && k == 0) continue;
      mesh.add_face(at(i, k), at(i + 1, k), at(i + 1, k + 1));
      mesh.add_face(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    }
  return mesh;
}

void print(const char* what, const Mesh& mesh) {
  const TopologyReport of = report(mesh);
  std::printf("%s: %zu triangles, genus %ld, %zu boundary curve\n", what, of.faces, of.genus.value_or(-1),
              of.boundary_curves);
}

}  // namespace

int main() {
  Mesh mesh = torus_with_hole();
  request_status(mesh);
  print("before", mesh);
  const SimplifyResult result = simplify(mesh, ShortestEdges(), {.faces = 300});
  mesh.garbage_collection();
  print("after", mesh);
  std::printf("%zu collapses, the longest edge among them: %.3f\n", result.collapses,
              std::sqrt(result.cost.value_or(0)));

  mesh = torus_with_hole();
  request_status(mesh);
  simplify(mesh, BoundaryStays(mesh), {.faces = 300});
  mesh.garbage_collection();
  print("by quadric errors", mesh);
}
