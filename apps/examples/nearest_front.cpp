// An example of a user's own advancing-front method on the engine: every front edge gets the nearest possible point.
// Copy this file and change it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <iostream>
#include <optional>
#include <random>
#include <vector>

#include "meshops/front/engine.h"
#include "meshops/topology/report.h"

struct Place {
  std::int64_t x, y;  // integers, so that every decision is exact
};

/// Returns a number that is positive if c is left of the line from a to b.
std::int64_t side(const Place& a, const Place& b, const Place& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class NearestPoint {
 public:
  explicit NearestPoint(const std::vector<Place>& places) : places_(places) {}

  /// Proposes the first triangle: an edge to the nearest point, and the nearest point that makes a triangle with it.
  std::optional<std::array<meshops::Site, 3>> seed(const meshops::Front& front) const {
    if (front.faces() > 0 || places_.size() < 3) return std::nullopt;
    const meshops::Site first = 0;
    meshops::Site second = 1;
    for (meshops::Site s = 2; s < count(); ++s)
      if (distance(first, first, s) < distance(first, first, second)) second = s;
    if (const auto third = nearest(front, first, second)) return std::array{first, second, *third};
    if (const auto third = nearest(front, second, first)) return std::array{second, first, *third};
    return std::nullopt;  // all points are on one line
  }

  /// Proposes the point to attach to the edge h, whose left side is empty.
  std::optional<meshops::Site> propose(const meshops::Front& front, meshops::Halfedge h) const {
    return nearest(front, front.from_site(h), front.to_site(h));
  }

 private:
  meshops::Site count() const { return static_cast<meshops::Site>(places_.size()); }
  const Place& at(meshops::Site s) const { return places_[s]; }

  /// Returns four times the square of the distance of s from the middle of a and b.
  std::int64_t distance(meshops::Site a, meshops::Site b, meshops::Site s) const {
    const std::int64_t x = 2 * at(s).x - at(a).x - at(b).x, y = 2 * at(s).y - at(a).y - at(b).y;
    return x * x + y * y;
  }

  std::optional<meshops::Site> nearest(const meshops::Front& front, meshops::Site a, meshops::Site b) const {
    std::optional<meshops::Site> best;
    for (meshops::Site s = 0; s < count(); ++s)
      if (side(at(a), at(b), at(s)) > 0 && (!best || distance(a, b, s) < distance(a, b, *best)) && fits(front, a, b, s))
        best = s;
    return best;
  }

  /// Returns whether the triangle contains no other point, and no edge of the front crosses its new sides.
  bool fits(const meshops::Front& front, meshops::Site a, meshops::Site b, meshops::Site c) const {
    for (meshops::Site s = 0; s < count(); ++s)
      if (s != a && s != b && s != c && side(at(a), at(b), at(s)) >= 0 && side(at(b), at(c), at(s)) >= 0 &&
          side(at(c), at(a), at(s)) >= 0)
        return false;
    for (const meshops::BoundaryCurve& curve : front.curves())
      for (const meshops::Halfedge h : curve)
        if (cross(b, c, front.from_site(h), front.to_site(h)) || cross(c, a, front.from_site(h), front.to_site(h)))
          return false;
    return true;
  }

  bool cross(meshops::Site a, meshops::Site b, meshops::Site c, meshops::Site d) const {
    const auto apart = [](std::int64_t u, std::int64_t v) { return (u < 0 && v > 0) || (u > 0 && v < 0); };
    return apart(side(at(a), at(b), at(c)), side(at(a), at(b), at(d))) &&
           apart(side(at(c), at(d), at(a)), side(at(c), at(d), at(b)));
  }

  const std::vector<Place>& places_;
};

int main() {
  std::mt19937 random(1985);
  std::vector<Place> places;
  for (int i = 0; i < 300; ++i) {
    const auto x = static_cast<std::int64_t>(random() % 10000), y = static_cast<std::int64_t>(random() % 10000);
    places.push_back({x, y});
  }

  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  meshops::Front front(mesh, places.size());
  NearestPoint policy(places);
  meshops::advance(front, policy);

  const std::vector<meshops::Site> site = front.finish();  // the site of each vertex of the mesh
  for (std::size_t v = 0; v < site.size(); ++v) {
    const Place& place = places[site[v]];
    mesh.set_point(meshops::Vertex(static_cast<int>(v)),
                   {static_cast<float>(place.x), static_cast<float>(place.y), 0.0F});
  }
  const meshops::TopologyReport topology = meshops::report(mesh, site);
  std::cout << topology.vertices << " vertices, " << topology.faces << " triangles, " << topology.components
            << " component, " << topology.boundary_curves << " boundary curve, genus " << *topology.genus << '\n';
}
