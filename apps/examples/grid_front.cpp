// A front that uses a grid to test whether a new side would cross the front, instead of testing every side. The example
// compares each result of the grid with a test of all sides; omit this test in your own front.
#include "examples/front_grid.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

#include "meshops/front/engine.h"
#include "meshops/topology/report.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;

/// A policy that attaches to every edge the nearest possible point on its left.
class NearestByGrid {
 public:
  NearestByGrid(const std::vector<Place>& places, FrontGrid& grid) : places_(places), grid_(grid) {}

  std::optional<std::array<Site, 3>> seed(const Front& front) {
    if (front.faces() > 0) return std::nullopt;
    for (Site s = 1; s < places_.size(); ++s)
      if (const auto apex = nearest(front, 0, s)) return std::array<Site, 3>{0, s, *apex};
    return std::nullopt;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    return nearest(front, front.from_site(h), front.to_site(h));
  }

  std::size_t asked = 0, crossings = 0, wrong = 0;

 private:
  std::int64_t distance(Site a, Site b, Site s) const {
    const std::int64_t x = 2 * places_[s].x - places_[a].x - places_[b].x,
                       y = 2 * places_[s].y - places_[a].y - places_[b].y;
    return x * x + y * y;
  }
  std::optional<Site> nearest(const Front& front, Site a, Site b) {
    std::optional<Site> best;
    for (Site s = 0; s < places_.size(); ++s)
      if (grid_.turn(a, b, s) > 0 && (!best || distance(a, b, s) < distance(a, b, *best)) && is_empty(a, b, s) &&
          !crosses(front, b, s) && !crosses(front, s, a))
        best = s;
    return best;
  }
  bool is_empty(Site a, Site b, Site c) const {
    for (Site s = 0; s < places_.size(); ++s)
      if (s != a && s != b && s != c && grid_.turn(a, b, s) >= 0 && grid_.turn(b, c, s) >= 0 &&
          grid_.turn(c, a, s) >= 0)
        return false;
    return true;
  }
  bool crosses(const Front& front, Site a, Site b) {
    const bool found = grid_.crosses(front, a, b);
    bool expected = false;
    for (const meshops::BoundaryCurve& curve : front.curves())
      for (const Halfedge h : curve) expected = expected || grid_.cross(a, b, front.from_site(h), front.to_site(h));
    ++asked;
    crossings += expected;
    wrong += found != expected;
    return found;
  }

  const std::vector<Place>& places_;
  FrontGrid& grid_;
};

namespace {

void run(const char* name, const std::vector<Place>& places) {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  Front front(mesh, places.size());
  FrontGrid grid(places);
  NearestByGrid policy(places, grid);
  meshops::advance(front, policy, grid);
  const meshops::TopologyReport topology = meshops::report(mesh, front.finish());
  std::printf("%s: %zu vertices, %zu triangles, %zu boundary curves; %s crossings, %zu of %s answers wrong\n", name,
              topology.vertices, topology.faces, topology.boundary_curves, policy.crossings > 0 ? "some" : "no",
              policy.wrong, policy.asked > 0 ? "all" : "no");
}

}  // namespace

int main() {
  std::mt19937 random(1985);
  const auto whole = [&](std::uint32_t below) { return static_cast<std::int64_t>(random() % below); };
  std::vector<Place> scattered, rows, flat;
  for (int i = 0; i < 200; ++i) scattered.push_back({whole(10000), whole(10000)});
  for (int i = 0; i < 144; ++i) rows.push_back({i % 12, i / 12});
  for (int i = 0; i < 120; ++i) flat.push_back({whole(1000000000), whole(3)});
  run("scattered", scattered);
  run("rows", rows);
  run("nearly on a line", flat);
}
