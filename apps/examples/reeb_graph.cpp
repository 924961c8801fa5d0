// Computes the Reeb graph of a function on the vertices of a closed surface, by a front that passes over the surface
// from low to high. The boundary curves of the front are the level curves; the vertices at which curves begin, join,
// split and close are the nodes of the graph. The front takes one vertex after another, each with its dual cell: the
// parts of the triangles around the vertex that are nearest to the vertex. The cells up to a level are a neighborhood
// of all vertices below the level, so the graph is exact. Copy this file and change main(), which orders the vertices
// by the function.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "meshops/front/engine.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"

using meshops::Front;
using meshops::Halfedge;
using meshops::Site;
using meshops::Vertex;
using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
using Triangle = std::array<Site, 3>;

/// Returns the triangles of all dual cells, the cell of the lowest vertex first. The first corner of a triangle is the
/// vertex; the other corners are sites in the middle of edges and triangles.
std::vector<Triangle> dual_cells(const Mesh& mesh, const std::vector<Vertex>& from_low_to_high) {
  std::vector<Triangle> all;
  const auto middle = [&](Halfedge h) {
    return static_cast<Site>(mesh.n_vertices()) + Site(mesh.edge_handle(h).idx());
  };
  for (const Vertex v : from_low_to_high)
    for (const Halfedge h : mesh.voh_range(v)) {
      if (mesh.is_boundary(h)) continue;
      const Site center = static_cast<Site>(mesh.n_vertices() + mesh.n_edges()) + Site(mesh.face_handle(h).idx());
      all.push_back({Site(v.idx()), center, middle(mesh.prev_halfedge_handle(h))});
      all.push_back({Site(v.idx()), middle(h), center});
    }
  return all;
}

/// Policy that inserts triangles in a given order, each as a seed, which the front glues where it fits.
struct InOrder {
  const std::vector<Triangle>& triangles;
  std::size_t next = 0;

  std::optional<Triangle> seed(const Front&) {
    return next < triangles.size() ? std::optional(triangles[next++]) : std::nullopt;
  }
  std::optional<Site> propose(const Front&, Halfedge) const { return std::nullopt; }
};

/// Visitor that makes an arc of each curve, from the vertex at which the curve begins to the vertex at which it ends. A
/// curve that begins and ends at one vertex, while the cell of the vertex is incomplete, makes no arc.
class Arcs : public meshops::CurveVisitor {
 public:
  explicit Arcs(const std::vector<Triangle>& triangles) : triangles_(triangles) {}

  void seeded(const Front& front, const meshops::InsertedTriangle& triangle) {
    now_ = triangles_[next_++][0];
    first_ = from_.size();
    ending_.clear();
    for (const Halfedge side : triangle.side)
      if (const auto known = arc_of_.find(side); known != arc_of_.end()) {
        ending_.insert(known->second);
        arc_of_.erase(known);
      }
    // If no event follows, the new sides are on the curve of the glued sides.
    for (const Halfedge side : triangle.side)
      if (const Halfedge out = front.mesh().opposite_halfedge_handle(side); !ending_.empty())
        if (front.mesh().is_boundary(out)) arc_of_[out] = *ending_.begin();
  }
  void curve_begun(const Front& front, Halfedge h) { begin(front, h); }
  void curves_joined(const Front& front, Halfedge h) {
    curve_closed(front);
    if (h.is_valid()) begin(front, h);
  }
  void curve_split(const Front& front, Halfedge h, Halfedge other) {
    curve_closed(front);
    begin(front, h);
    begin(front, other);
  }
  void curve_closed(const Front&) {
    for (const std::size_t arc : ending_)
      if (from_[arc] != now_) arcs.push_back({from_[arc], now_});
    ending_.clear();
  }

  std::vector<std::array<Site, 2>> arcs = {};  ///< for each arc, the vertices at which it begins and ends

 private:
  void begin(const Front& front, Halfedge h) {
    if (const auto known = arc_of_.find(h); known != arc_of_.end() && known->second >= first_) return;
    for (const Halfedge g : meshops::BoundaryCurve(front.mesh(), h)) arc_of_[g] = from_.size();
    from_.push_back(now_);
  }

  const std::vector<Triangle>& triangles_;
  std::size_t next_ = 0, first_ = 0;  // the next triangle, and the first arc that the last triangle made
  Site now_ = 0;
  std::set<std::size_t> ending_;  // arcs whose curves had a glued side of the last triangle
  std::map<Halfedge, std::size_t> arc_of_;
  std::vector<Site> from_;  // for each curve, even one that makes no arc, the vertex at which it begins
};

namespace {

/// Returns a surface of genus n = `holes`, and its vertices in the order of x: two sheets of squares with n holes, cut
/// into triangles and glued along all boundaries.
std::pair<Mesh, std::vector<Vertex>> pillow(int holes) {
  const auto is_there = [&](int x, int y) {
    return 0 <= x && x < 3 * holes + 2 && 0 <= y && y < 5 && !(y == 2 && x % 3 == 2);
  };
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto point = [&](std::array<int, 3> at) {
    return number.try_emplace(at, static_cast<std::uint32_t>(number.size())).first->second;
  };
  const auto corner = [&](int x, int y, int sheet) {
    const bool inner = is_there(x, y) && is_there(x - 1, y) && is_there(x, y - 1) && is_there(x - 1, y - 1);
    return point({2 * x, 2 * y, inner ? sheet : 0});
  };
  meshops::PolygonSoup soup;
  for (int x = 0; x < 3 * holes + 2; ++x)
    for (int y = 0; y < 5; ++y)
      for (const int sheet : {-1, 1}) {
        if (!is_there(x, y)) continue;
        std::array around = {corner(x, y, sheet), corner(x + 1, y, sheet), corner(x + 1, y + 1, sheet),
                             corner(x, y + 1, sheet)};
        if (sheet < 0) std::swap(around[1], around[3]);
        const std::uint32_t middle = point({2 * x + 1, 2 * y + 1, sheet});
        for (std::size_t k = 0; k < 4; ++k) soup.add_face(std::array{around[k], around[(k + 1) % 4], middle});
      }
  soup.points = number.size();
  std::pair<Mesh, std::vector<Vertex>> result;
  meshops::build_mesh(result.first, soup);
  for (const auto& [at, i] : number) result.second.push_back(Vertex(static_cast<int>(i)));
  return result;
}

/// Sweeps over a connected closed surface, and checks the graph by its definition. Let the lower neighbors of a vertex
/// form k groups in the circle around the vertex, where k = 0 if all or no neighbors are lower. The vertex is a node of
/// 1 + k − 2 h arcs, where h is the number of handles in its level. All other handles are loops of the graph.
void sweep(const char* name, const Mesh& mesh, const std::vector<Vertex>& from_low_to_high) {
  const std::vector<Triangle> triangles = dual_cells(mesh, from_low_to_high);
  Mesh swept;
  Front front(swept, mesh.n_vertices() + mesh.n_edges() + mesh.n_faces());
  InOrder policy{triangles};
  Arcs visitor(triangles);
  meshops::advance(front, policy, visitor);

  std::map<Vertex, int> height, met;
  for (const Vertex v : from_low_to_high) height[v] = static_cast<int>(height.size());
  for (const auto& ends : visitor.arcs)
    for (const Site end : ends) ++met[Vertex(static_cast<int>(end))];
  int extremes = 0, forks = 0, hidden = 0, wrong = 0;
  for (const Vertex v : from_low_to_high) {
    int changes = 0;
    for (const Halfedge h : mesh.voh_range(v)) {
      const Halfedge next = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
      changes += (height[mesh.to_vertex_handle(h)] < height[v]) != (height[mesh.to_vertex_handle(next)] < height[v]);
    }
    extremes += changes == 0;
    forks += changes > 2;
    const int handles = 1 + changes / 2 - (met.contains(v) ? met[v] : 2);
    wrong += handles < 0 || handles % 2 != 0;
    hidden += handles / 2;
  }
  const int loops = static_cast<int>(visitor.arcs.size()) - static_cast<int>(met.size()) + 1;
  const long genus = meshops::report(mesh).genus.value_or(-1);
  std::printf("%s: %d lows and highs, %d forks, %d loops and %d handles in one level of %ld; %d wrong\n", name,
              extremes, forks, loops, hidden, genus, wrong + (loops + hidden != genus));
}

}  // namespace

int main() {
  std::mt19937 random(1);
  for (const int holes : {0, 1, 3}) {
    auto [mesh, order] = pillow(holes);
    sweep("along", mesh, order);
    for (int i = 0; i < 50; ++i) {
      std::shuffle(order.begin(), order.end(), random);
      sweep("in any order", mesh, order);
    }
  }
}
