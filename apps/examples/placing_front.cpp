// A front that creates its points, in the manner of Lo (1985): the front meshes a round plate with triangles of one
// size, and begins with a triangle of three new points. Copy this file and change it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

#include "meshops/front/engine.h"
#include "meshops/topology/report.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;
using Vec = OpenMesh::Vec2d;

class EvenTriangles {
 public:
  explicit EvenTriangles(double radius) : radius_(radius) {}
  const std::vector<Vec>& places() const { return places_; }

  /// Proposes a first triangle at the center of the plate, on sites 0, 1 and 2; nothing if the front has faces.
  std::optional<std::array<Site, 3>> seed(const Front& front) {
    if (front.faces() > 0) return std::nullopt;
    places_ = {{0, 0}, {1, 0}, third_corner({0, 0}, {1, 0})};
    return std::array<Site, 3>{0, 1, 2};
  }

  /// Proposes an existing point near the ideal third corner, or a new point there; nothing if that corner is off the
  /// plate.
  std::optional<Site> propose(const Front& front, Halfedge h) {
    places_.resize(front.sites());
    const Vec apex = third_corner(places_[front.from_site(h)], places_[front.to_site(h)]);
    if (apex.norm() > radius_) return std::nullopt;
    for (Site s = 0; s < front.sites(); ++s)
      if ((places_[s] - apex).norm() < 0.5) return s;
    places_.push_back(apex);
    return static_cast<Site>(front.sites());  // the next site: the front adds it with the triangle
  }

 private:
  static Vec third_corner(const Vec& a, const Vec& b) {
    const Vec along = b - a;
    return (a + b) / 2 + std::sqrt(0.75) * Vec(-along[1], along[0]);
  }

  double radius_;
  std::vector<Vec> places_;  // the place of each site
};

int main() {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  Front front(mesh, 0);
  EvenTriangles policy(10);
  meshops::advance(front, policy);

  const std::vector<Site> site = front.finish();
  for (std::size_t v = 0; v < site.size(); ++v) {
    const Vec& place = policy.places()[site[v]];
    mesh.set_point(meshops::Vertex(static_cast<int>(v)),
                   {static_cast<float>(place[0]), static_cast<float>(place[1]), 0.0F});
  }
  const meshops::TopologyReport topology = meshops::report(mesh, site);
  std::cout << topology.vertices << " vertices, " << topology.faces << " triangles, " << topology.components
            << " component, " << topology.boundary_curves << " boundary curve, genus " << *topology.genus << '\n';
}
