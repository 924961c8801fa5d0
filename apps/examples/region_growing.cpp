// Cuts a mesh into regions by a front that passes over the mesh: the front attaches the triangles of the mesh, and does
// not glue across creases. Copy this file and change the definition of a crease.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/core/live_range.h"
#include "meshops/front/engine.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"

using meshops::Edge;
using meshops::Face;
using meshops::Front;
using meshops::Halfedge;
using meshops::Site;
using meshops::Vertex;
using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// A policy for a triangle mesh in which at most one edge joins two vertices. Sites are the vertices of the mesh. Calls
/// is_crease(edge) for inner edges only.
template <typename IsCrease>
class Regions {
 public:
  Regions(const Mesh& mesh, IsCrease is_crease) : mesh_(mesh), is_crease_(is_crease) {}

  /// Begins a region at each triangle that no region has reached.
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    for (; next_ < static_cast<int>(mesh_.n_faces()); ++next_) {
      const Halfedge h = mesh_.halfedge_handle(Face(next_));
      const std::array<Site, 3> corners = {site(mesh_.from_vertex_handle(h)), site(mesh_.to_vertex_handle(h)), apex(h)};
      if (!front.triangle_on(corners[0], corners[1], corners[2]).is_valid()) return corners;
    }
    return std::nullopt;
  }
  /// Proposes the triangle beyond the edge, unless the region ends at the edge.
  std::optional<Site> propose(const Front& front, Halfedge at) const {
    const Halfedge h = beyond(front, at);
    return ends_at(h) ? std::nullopt : std::optional(apex(h));
  }
  /// Returns whether to glue across the edge: false at a crease, so that the regions on both sides have separate edges.
  bool glues(const Front& front, Halfedge at, Site) const { return !ends_at(beyond(front, at)); }

 private:
  static Site site(Vertex v) { return static_cast<Site>(v.idx()); }
  static Vertex vertex(Site s) { return Vertex(static_cast<int>(s)); }
  Site apex(Halfedge h) const { return site(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h))); }
  Halfedge beyond(const Front& front, Halfedge at) const {
    return mesh_.find_halfedge(vertex(front.from_site(at)), vertex(front.to_site(at)));
  }
  bool ends_at(Halfedge h) const { return mesh_.is_boundary(mesh_.edge_handle(h)) || is_crease_(mesh_.edge_handle(h)); }

  const Mesh& mesh_;
  IsCrease is_crease_;
  int next_ = 0;
};

namespace {

/// Returns the surface of a cube of side³ small cubes, with two triangles for each square. Coordinates are integers, so
/// that normals are exact.
Mesh cube(int side) {
  Mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> point;
  std::vector<std::array<int, 3>> places;
  const auto corner = [&](std::array<int, 3> at) {
    const auto [known, is_new] = point.try_emplace(at, static_cast<std::uint32_t>(places.size()));
    if (is_new) places.push_back(at);
    return known->second;
  };
  meshops::PolygonSoup soup;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true})
      for (int u = 0; u < side; ++u)
        for (int v = 0; v < side; ++v) {
          const auto at = [&](int du, int dv) {
            std::array<int, 3> place{};
            place[axis] = far ? side : 0;
            place[(axis + 1) % 3] = far ? u + du : v + dv;
            place[(axis + 2) % 3] = far ? v + dv : u + du;
            return corner(place);
          };
          const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
          soup.add_face(std::array{a, b, c});
          soup.add_face(std::array{a, c, d});
        }
  soup.points = places.size();
  meshops::build_mesh(mesh, soup);
  for (const Vertex v : meshops::live_vertices(mesh)) {
    const auto& [x, y, z] = places[static_cast<std::size_t>(v.idx())];
    mesh.set_point(v, {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  return mesh;
}

/// Returns whether the two triangles of the edge are in different planes.
bool is_fold(const Mesh& mesh, Edge e) {
  const auto normal = [&](Halfedge h) {
    const auto& a = mesh.point(mesh.from_vertex_handle(h));
    const auto& b = mesh.point(mesh.to_vertex_handle(h));
    return (b - a) % (mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) - a);
  };
  return (normal(mesh.halfedge_handle(e, 0)) % normal(mesh.halfedge_handle(e, 1))).sqrnorm() != 0;
}

/// Returns the regions by their definition: sets of faces that are connected across edges that are not creases.
template <typename IsCrease>
std::map<std::uint32_t, std::size_t> flood(const Mesh& mesh, IsCrease is_crease) {
  meshops::DisjointSets sets(mesh.n_faces());
  const auto number = [&](Edge e, unsigned side) {
    return static_cast<std::uint32_t>(mesh.face_handle(mesh.halfedge_handle(e, side)).idx());
  };
  for (const Edge e : meshops::live_edges(mesh))
    if (!mesh.is_boundary(e) && !is_crease(e)) sets.unite(number(e, 0), number(e, 1));
  std::map<std::uint32_t, std::size_t> faces;
  for (const Face f : meshops::live_faces(mesh)) ++faces[sets.find(static_cast<std::uint32_t>(f.idx()))];
  return faces;
}

/// Cuts the mesh into regions and checks the result: regions are as many components as flood() finds, and exactly the
/// creases and boundary edges of the mesh are boundary edges of regions.
template <typename IsCrease>
void segment(const char* name, const Mesh& mesh, IsCrease is_crease) {
  Mesh regions;
  Front front(regions, mesh.n_vertices());
  Regions<IsCrease> policy(mesh, is_crease);
  meshops::advance(front, policy);
  const std::vector<Site> vertex = front.finish();  // for each vertex of the regions, its vertex in the mesh

  std::size_t wrong_edges = 0;
  const auto stands_on = [&](Vertex v) { return Vertex(static_cast<int>(vertex[static_cast<std::size_t>(v.idx())])); };
  for (const Edge e : meshops::live_edges(regions)) {
    const Halfedge h = regions.halfedge_handle(e, 0);
    const Halfedge of =
        mesh.find_halfedge(stands_on(regions.from_vertex_handle(h)), stands_on(regions.to_vertex_handle(h)));
    const bool ends = mesh.is_boundary(mesh.edge_handle(of)) || is_crease(mesh.edge_handle(of));
    wrong_edges += regions.is_boundary(e) != ends;
  }
  const std::map<std::uint32_t, std::size_t> expected = flood(mesh, is_crease);
  const meshops::TopologyReport found = meshops::report(regions);
  std::printf("%s: %zu triangles in %zu regions; %zu expected, %zu wrong edges\n", name, found.faces, found.components,
              expected.size(), wrong_edges);
  for (const meshops::ComponentReport& region : found.per_component) std::printf(" %zu", region.faces);
  std::printf("\n");
}

}  // namespace

int main() {
  const Mesh mesh = cube(4);
  segment("sides of a cube", mesh, [&](Edge e) { return is_fold(mesh, e); });
  // Test a crease that ends inside a region: the result is one region with a slit.
  segment("a slit", mesh, [&](Edge e) { return e.idx() == 40; });
  segment("every edge", mesh, [](Edge) { return true; });
  segment("none", mesh, [](Edge) { return false; });
}
