// Cuts a polygon into ears, the shortest cut first: an example of keys that depend on neighboring edges, and of
// deferred edges. Copy this file and change it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <vector>

#include "meshops/front/engine.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Proposal;
using meshops::Site;

struct Place {
  std::int64_t x, y;  // integers, so that every decision is exact
};

/// Returns twice the area of a triangle; positive if the triangle is counter-clockwise.
std::int64_t area(const Place& a, const Place& b, const Place& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Ears {
 public:
  explicit Ears(const std::vector<Place>& polygon) : at_(polygon) {}

  /// Makes the engine compute key(), the square of the length of a cut, again for the edges beside a cut that is made.
  static constexpr bool rekeys_neighbors = true;
  std::int64_t key(const Front& front, Halfedge h) const {
    const auto [a, b, c] = ear(front, h);
    const std::int64_t x = at_[c].x - at_[a].x, y = at_[c].y - at_[a].y;
    return x * x + y * y;
  }

  /// Proposes no separate triangle.
  std::optional<Proposal::Triangle> seed(const Front&) const { return std::nullopt; }

  /// Proposes the ear, or defers the edge until another ear has been cut off.
  Proposal propose(const Front& front, Halfedge h) {
    const auto [a, b, c] = ear(front, h);
    if (is_empty(a, b, c)) return c;
    ++deferred;
    return Proposal::defer();
  }

  std::size_t deferred = 0;

 private:
  static Proposal::Triangle ear(const Front& front, Halfedge h) {
    return {front.from_site(h), front.to_site(h), front.to_site(front.mesh().next_halfedge_handle(h))};
  }
  bool is_empty(Site a, Site b, Site c) const {
    if (area(at_[a], at_[b], at_[c]) <= 0) return false;
    for (Site s = 0; s < at_.size(); ++s)
      if (s != a && s != b && s != c && area(at_[a], at_[b], at_[s]) >= 0 && area(at_[b], at_[c], at_[s]) >= 0 &&
          area(at_[c], at_[a], at_[s]) >= 0)
        return false;
    return true;
  }

  const std::vector<Place>& at_;
};

/// Returns a corridor that zigzags up and down. The cuts across bends are the shortest, but the opposite corner of a
/// bend blocks its cut.
std::vector<Place> zigzag(std::int64_t turns) {
  std::vector<Place> corners;
  for (std::int64_t i = 0; i <= turns; ++i) corners.push_back({4 * i, i % 2 * 10});
  for (std::int64_t i = turns; i >= 0; --i) corners.push_back({4 * i, i % 2 * 10 + 3});
  return corners;
}

int main() {
  const std::vector<Place> polygon = zigzag(24);
  const auto count = static_cast<Site>(polygon.size());
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  Front front(mesh, count + 1);
  // Create the faces behind the front that the engine needs: a cone, whose apex is a site without a place.
  for (Site s = 0; s < count; ++s) front.create(count, (s + 1) % count, s);

  Ears ears(polygon);
  meshops::advance(front, ears);
  const std::vector<Site> site = front.finish();

  std::int64_t covered = 0, enclosed = 0;
  std::size_t triangles = 0;
  for (const meshops::Face f : mesh.faces()) {
    std::vector<Site> corner;
    for (const meshops::Vertex v : mesh.fv_range(f)) corner.push_back(site[static_cast<std::size_t>(v.idx())]);
    if (std::find(corner.begin(), corner.end(), count) != corner.end()) continue;  // skip triangles of the cone
    ++triangles;
    covered += area(polygon[corner[0]], polygon[corner[1]], polygon[corner[2]]);
  }
  for (std::size_t i = 0; i < polygon.size(); ++i)
    enclosed += area({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]);
  std::cout << "a zigzag of " << count << " corners and area " << enclosed / 2 << ": " << triangles
            << " triangles of area " << covered / 2 << ", " << ears.deferred << " times an edge was deferred\n";
}
