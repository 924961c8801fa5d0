// A front that begins on a mesh and has its own order of edges: the front fills a hole, the shortest edge first. Copy
// this file and change it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <iostream>
#include <optional>
#include <vector>

#include "meshops/front/engine.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Policy for a mesh in the plane, with integer coordinates, so that every decision is exact. Site v is vertex v.
class ShortestFirst {
 public:
  explicit ShortestFirst(const Mesh& mesh, Halfedge hole) : mesh_(mesh) {
    for (const Halfedge h : meshops::BoundaryCurve(mesh, hole))
      rim_.push_back(static_cast<Site>(mesh.from_vertex_handle(h).idx()));
  }

  /// Returns the square of the length of h: the least key is next.
  double key(const Front& front, Halfedge h) const { return (at(front.from_site(h)) - at(front.to_site(h))).sqrnorm(); }

  /// Proposes no separate triangle.
  std::optional<std::array<Site, 3>> seed(const Front&) const { return std::nullopt; }

  /// Proposes the nearest point of the rim whose triangle with `h` contains no other point of the rim and is crossed by
  /// no edge of the front.
  std::optional<Site> propose(const Front& front, Halfedge h) const {
    const Site a = front.from_site(h), b = front.to_site(h);
    std::optional<Site> best;
    for (const Site s : rim_)
      if (side(a, b, s) > 0 && (!best || distance(a, b, s) < distance(a, b, *best)) && !front.attach_blocker(h, s) &&
          is_empty(front, a, b, s))
        best = s;
    return best;
  }

 private:
  const Mesh::Point& at(Site s) const { return mesh_.point(meshops::Vertex(static_cast<int>(s))); }
  double distance(Site a, Site b, Site s) const { return (at(a) + at(b) - 2 * at(s)).sqrnorm(); }

  /// Returns a number that is positive if c is left of the line from a to b.
  double side(Site a, Site b, Site c) const { return ((at(b) - at(a)) % (at(c) - at(a)))[2]; }

  bool is_empty(const Front& front, Site a, Site b, Site c) const {
    const auto apart = [](double u, double v) { return (u < 0 && v > 0) || (u > 0 && v < 0); };
    const auto cross = [&](Site p, Site q, Site r, Site s) {
      return apart(side(p, q, r), side(p, q, s)) && apart(side(r, s, p), side(r, s, q));
    };
    for (const Site s : rim_)
      if (s != a && s != b && s != c && side(a, b, s) >= 0 && side(b, c, s) >= 0 && side(c, a, s) >= 0) return false;
    for (const meshops::BoundaryCurve& curve : front.curves())
      for (const Halfedge h : curve)
        if (cross(b, c, front.from_site(h), front.to_site(h)) || cross(c, a, front.from_site(h), front.to_site(h)))
          return false;
    return true;
  }

  const Mesh& mesh_;
  std::vector<Site> rim_;
};

/// Returns a square sheet of triangles with a hole that is not convex: the squares near a slanting line are missing.
Mesh sheet_with_hole(int side) {
  Mesh mesh;
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) mesh.add_vertex(Mesh::Point(x, y, 0));
  const auto corner = [&](int x, int y) { return meshops::Vertex(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x > 2 && x < side - 3 && 2 * y > x - 1 && 2 * y < x + 7) continue;
      mesh.add_face(corner(x, y), corner(x + 1, y), corner(x + 1, y + 1));
      mesh.add_face(corner(x, y), corner(x + 1, y + 1), corner(x, y + 1));
    }
  return mesh;
}

int main() {
  Mesh mesh = sheet_with_hole(20);
  const std::size_t faces = mesh.n_faces();
  const std::vector<meshops::BoundaryCurve> curves = meshops::boundary_curves(mesh);
  const meshops::BoundaryCurve& hole = curves[0].length() < curves[1].length() ? curves[0] : curves[1];
  std::cout << "a hole of " << hole.length() << " edges";
  ShortestFirst policy(mesh, hole.front());
  Front front(mesh);
  meshops::advance(front, policy);
  front.finish();
  std::cout << ", filled with " << mesh.n_faces() - faces
            << " triangles; boundary curves left: " << meshops::boundary_curves(mesh).size() << '\n';
}
