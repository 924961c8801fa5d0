// Subdivision of triangle meshes: Loop's rule makes four triangles of one, the √3 rule three. Both are made of splits
// and flips in librbpa/rbpa/space/simplify/subdivide.cpp.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cstdio>
#include <span>

#include "meshops/meshops.h"
#include "rbpa/space/simplify/subdivide.h"

using namespace meshops;
using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using Point = Mesh::Point;

namespace {

void show(const char* what, std::size_t triangles, rbpa::SubdivisionRule rule) {
  Mesh mesh;
  for (const Point& p : {Point(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}) mesh.add_vertex(p);
  const std::array<std::array<int, 3>, 8> octahedron{
      {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};
  for (const auto& [a, b, c] : std::span(octahedron).first(triangles)) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  rbpa::subdivide(mesh, {.rule = rule, .times = 3});
  std::size_t irregular = 0;
  for (const Vertex v : mesh.vertices()) irregular += !mesh.is_boundary(v) && mesh.valence(v) != 6;
  const TopologyReport r = report(mesh);
  std::printf("%s: %zu triangles, Euler characteristic %ld, inner degrees other than 6: %zu, a corner at %.3f\n", what,
              r.faces, r.euler() - static_cast<long>(r.isolated), irregular, mesh.point(Vertex(2)).norm());
}

}  // namespace

int main() {
  show("Loop, octahedron", 8, rbpa::SubdivisionRule::loop);
  show("Loop, half of it", 4, rbpa::SubdivisionRule::loop);
  show("sqrt3, octahedron", 8, rbpa::SubdivisionRule::sqrt3);
}
