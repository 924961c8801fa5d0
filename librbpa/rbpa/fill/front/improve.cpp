#include "rbpa/fill/front/improve.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshops/stellar/flip.h"
#include "rbpa/fill/front/shape_quality.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

constexpr int rounds = 6;            // rounds, each of moves and then flips
constexpr int moves_in_a_round = 2;  // moves of each point in a round

Point at(const Mesh& mesh, meshops::Vertex v) {
  const auto& p = mesh.point(v);
  return {p[0], p[1]};
}

/// A stack of edges to be tested, which contains each edge at most once.
class EdgeQueue {
 public:
  explicit EdgeQueue(const Mesh& mesh) : queued_(mesh.n_edges(), false) {}
  void push(meshops::Edge e) {
    if (queued_[static_cast<std::size_t>(e.idx())]) return;
    queued_[static_cast<std::size_t>(e.idx())] = true;
    edges_.push_back(e);
  }
  bool empty() const { return edges_.empty(); }
  meshops::Edge pop() {
    const meshops::Edge e = edges_.back();
    edges_.pop_back();
    queued_[static_cast<std::size_t>(e.idx())] = false;
    return e;
  }

 private:
  std::vector<bool> queued_;
  std::vector<meshops::Edge> edges_;
};

/// Returns whether an apex beside the edge is inside the circumcircle of the other triangle. The two triangles then
/// form a convex quadrilateral.
bool is_illegal(const Mesh& mesh, meshops::Edge e) {
  if (mesh.is_boundary(e)) return false;
  const meshops::Halfedge h = mesh.halfedge_handle(e, 0), other = mesh.halfedge_handle(e, 1);
  return plane_in_circle(at(mesh, mesh.from_vertex_handle(h)), at(mesh, mesh.to_vertex_handle(h)),
                         at(mesh, mesh.to_vertex_handle(mesh.next_halfedge_handle(h))),
                         at(mesh, mesh.to_vertex_handle(mesh.next_halfedge_handle(other)))) > 0;
}

/// Flips until no edge is illegal. Each flip lowers the surface of the triangles lifted to the paraboloid, so no
/// triangulation recurs.
void flip_all(Mesh& mesh, const Checkpoint& checkpoint) {
  EdgeQueue queue(mesh);
  for (std::size_t e = mesh.n_edges(); e-- > 0;) queue.push(meshops::Edge(static_cast<int>(e)));
  for (std::size_t steps = 0; !queue.empty(); ++steps) {
    if (steps % 4096 == 0) checkpoint();
    const meshops::Edge e = queue.pop();
    if (!is_illegal(mesh, e)) continue;
    meshops::flip(mesh, e);
    for (const unsigned side : {0U, 1U}) {
      const meshops::Halfedge h = mesh.halfedge_handle(e, side);
      queue.push(mesh.edge_handle(mesh.next_halfedge_handle(h)));
      queue.push(mesh.edge_handle(mesh.prev_halfedge_handle(h)));
    }
  }
}

/// Replaces `ring` by the neighbors of an inner vertex, counter-clockwise.
void ring_of(const Mesh& mesh, meshops::Vertex v, std::vector<Point>& ring) {
  ring.clear();
  for (const auto neighbor : mesh.vv_ccw_range(v)) ring.push_back(at(mesh, neighbor));
}

/// Returns the least quality of the triangles between p and the sides of the ring; negative if a triangle turns right.
double least_quality(const Point& p, const std::vector<Point>& ring) {
  double least = 1;
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, shape_quality(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

bool is_star(const Point& p, const std::vector<Point>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (plane_orientation(p, ring[i], ring[(i + 1) % ring.size()]) <= 0) return false;
  return true;
}

/// Returns the target position of p: each side of the ring around p proposes the apex of an isosceles triangle whose
/// legs have the target length; the result is the mean of these apexes.
Point wanted(const Point& p, const std::vector<Point>& ring, const SizeField& field) {
  const double size = field.at(p);
  double x = 0, y = 0, weights = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) continue;
    const double side = std::clamp(size, 0.6 * length, 1.6 * length);
    const double rise = std::sqrt(std::max(side * side - length * length / 4, 0.0)) / length;
    x += a.x - p.x + dx / 2 - rise * dy;
    y += a.y - p.y + dy / 2 + rise * dx;
    weights += 1;
  }
  return weights > 0 ? Point{p.x + x / weights, p.y + y / weights} : p;
}

void move_all(Mesh& mesh, std::size_t fixed, const SizeField& field, const Checkpoint& checkpoint) {
  std::vector<Point> ring;
  for (std::size_t i = fixed; i < mesh.n_vertices(); ++i) {
    if (i % 1024 == 0) checkpoint();
    const meshops::Vertex v(static_cast<int>(i));
    if (mesh.is_boundary(v)) continue;  // an additional vertex at a point where the boundary touches itself
    ring_of(mesh, v, ring);
    const Point p = at(mesh, v), goal = wanted(p, ring, field);
    const double before = least_quality(p, ring);
    for (const double share : {1.0, 0.5, 0.25}) {
      const Point moved{p.x + share * (goal.x - p.x), p.y + share * (goal.y - p.y)};
      if (!is_finite(moved) || least_quality(moved, ring) <= before || !is_star(moved, ring)) continue;
      mesh.set_point(v, {moved.x, moved.y, 0});
      break;
    }
  }
}

}  // namespace

void improve(Mesh& mesh, std::size_t fixed, const SizeField& field, const Checkpoint& checkpoint) {
  flip_all(mesh, checkpoint);
  for (int round = 0; round < rounds; ++round) {
    for (int move = 0; move < moves_in_a_round; ++move) move_all(mesh, fixed, field, checkpoint);
    flip_all(mesh, checkpoint);
  }
}

}  // namespace rbpa
