#include "rbpa/space/simplify/remeshing/wanted_lengths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "meshops/core/live_range.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using meshops::Connectivity;
using meshops::Edge;
using meshops::Halfedge;
using meshops::Vertex;
using Vector = Vector3<double>;

constexpr double growth = 0.5;  // greatest difference of lengths at neighbors, in units of their distance

/// Returns the curvature across an inner edge: the angle between the normals of its triangles, over two thirds of the
/// lesser height on the edge, as a large triangle on one side does not make an edge flat. It is 1/r for triangles
/// between points of a sphere of radius r, and 0 if a triangle has no area.
double curvature_across(const Connectivity& mesh, const std::vector<Point3>& places, Edge e) {
  const Halfedge h = mesh.halfedge_handle(e, 0), o = mesh.opposite_halfedge_handle(h);
  const auto at_end = [&](Halfedge of) -> const Point3& { return places[index_of(mesh.to_vertex_handle(of))]; };
  const Point3 &a = at_end(o), &b = at_end(h);
  const Vector along = from<double>(a, b);
  const Vector m = cross(along, from<double>(a, at_end(mesh.next_halfedge_handle(h)))),
               n = cross(from<double>(a, at_end(mesh.next_halfedge_handle(o))), along);
  const double of_m = std::sqrt(dot(m, m)), of_n = std::sqrt(dot(n, n));
  if (!(of_m > 0 && of_n > 0)) return 0;
  // Powers of two bring the normals to lengths near 1, as the squares below would leave the range of double.
  const Vector p = times(std::ldexp(1, -std::ilogb(of_m)), m), q = times(std::ldexp(1, -std::ilogb(of_n)), n),
               turn = cross(p, q);
  return 1.5 * std::atan2(std::sqrt(dot(turn, turn)), dot(p, q)) * std::sqrt(dot(along, along)) / std::min(of_m, of_n);
}

/// Returns the length of edges of an equilateral triangle with corners on a sphere, whose points are within `error` of
/// the sphere; at least `error`.
double length_within(double error, double curvature) {
  return std::sqrt(std::max(6 * error / curvature - 3 * error * error, error * error));
}

}  // namespace

std::vector<double> wanted_lengths(const Connectivity& mesh, const std::vector<Point3>& places,
                                   const MeshCurves& curves, const std::vector<double>& lengths,
                                   const RemeshOptions& options) {
  if (lengths.empty() && !options.error) return {};
  std::vector<double> wanted(mesh.n_vertices(), options.length);
  for (std::size_t v = 0; v < lengths.size(); ++v) wanted[v] = std::min(wanted[v], lengths[v]);
  for (const Edge e : meshops::live_edges(mesh)) {
    if (!options.error || curves.of_edge[index_of(e)] != MeshCurves::none) continue;
    const double length = length_within(*options.error, curvature_across(mesh, places, e));
    for (const unsigned side : {0U, 1U}) {
      double& at_end = wanted[index_of(mesh.to_vertex_handle(mesh.halfedge_handle(e, side)))];
      at_end = std::min(at_end, length);
    }
  }
  if (std::count(wanted.begin(), wanted.end(), options.length) == std::ssize(wanted)) return {};
  // The shortest first: a length that is reached cannot become less.
  using Waiting = std::pair<double, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
  for (const Vertex v : meshops::live_vertices(mesh)) waiting.emplace(wanted[index_of(v)], v.idx());
  while (!waiting.empty()) {
    const auto [length, number] = waiting.top();
    waiting.pop();
    const Vertex v(number);
    if (length > wanted[index_of(v)]) continue;
    for (const Vertex u : mesh.vv_range(v))
      if (const double grown = length + growth * distance(places[index_of(v)], places[index_of(u)]);
          grown < wanted[index_of(u)])
        waiting.emplace(wanted[index_of(u)] = grown, u.idx());
  }
  for (double& length : wanted) length /= options.length;
  return wanted;
}

}  // namespace rbpa::space
