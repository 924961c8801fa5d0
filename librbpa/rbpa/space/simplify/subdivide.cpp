#include "rbpa/space/simplify/subdivide.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>

#include "meshops/core/blocker.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/core/progress.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"

namespace rbpa {
namespace {

using meshops::Connectivity;
using meshops::Edge;
using meshops::Face;
using meshops::Halfedge;
using meshops::Vertex;

using space::index_of;

Point3 plus(const Point3& p, double weight, const Point3& q) {
  return {p.x + weight * q.x, p.y + weight * q.y, p.z + weight * q.z};
}

/// Returns the mean of points, which does not depend on their order.
Point3 mean(std::vector<Point3>& points) {
  std::sort(points.begin(), points.end());
  Point3 sum{};
  for (const Point3& p : points) sum = plus(sum, 1 / static_cast<double>(points.size()), p);
  return sum;
}

/// Returns the elements of a range, which may change later.
template <typename Range>
auto all(const Range& range) {
  std::vector<std::remove_cvref_t<decltype(*range.begin())>> elements;
  for (const auto element : range) elements.push_back(element);
  return elements;
}

/// Applies the rules to a mesh.
class Subdividing {
 public:
  Subdividing(Connectivity& mesh, std::vector<Point3>& places, const GoOn& go_on)
      : mesh_(mesh), places_(places), step_(go_on) {}

  void by_loop() {
    std::vector<Point3> moved = smoothed(0.25, [](double degree) {
      const double a = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / degree);
      return 0.625 - a * a;
    });
    const std::vector<Edge> given = all(meshops::live_edges(mesh_));
    std::vector<Point3> middles;
    for (const Edge e : given) {
      const Halfedge h = mesh_.halfedge_handle(e, 0), o = mesh_.opposite_halfedge_handle(h);
      const double at_ends = mesh_.is_boundary(e) ? 0.5 : 0.375;
      Point3& middle = middles.emplace_back(plus(plus({}, at_ends, at_end(h)), at_ends, at_end(o)));
      if (mesh_.is_boundary(e)) continue;
      const Point3 apexes =
          plus(plus({}, 0.125, at_end(mesh_.next_halfedge_handle(h))), 0.125, at_end(mesh_.next_halfedge_handle(o)));
      middle = plus(middle, 1, apexes);
    }
    std::vector<Edge> across;  // from a new vertex to what was the apex of a triangle
    for (const Edge e : given) {
      const meshops::SplitEdgeEffect effect = meshops::split_edge(mesh_, e);
      for (const Edge added : effect.added.edges())
        if (added != effect.added.edge[0]) across.push_back(added);
    }
    const auto is_given = [&](Vertex v) { return index_of(v) < moved.size(); };
    for (const Edge e : across) {
      const Halfedge h = mesh_.halfedge_handle(e, 0);
      if (is_given(mesh_.from_vertex_handle(h)) != is_given(mesh_.to_vertex_handle(h))) meshops::flip(mesh_, e);
    }
    take(std::move(moved), middles);
  }

  void by_sqrt3() {
    std::vector<Point3> moved =
        smoothed(0, [](double degree) { return (4 - 2 * std::cos(2 * std::numbers::pi / degree)) / 9; });
    const std::vector<Edge> given = all(meshops::live_edges(mesh_));
    const std::vector<Face> faces = all(meshops::live_faces(mesh_));
    std::vector<Point3> middles, corners;
    for (const Face f : faces) {
      corners.clear();
      for (const Vertex v : mesh_.fv_range(f)) corners.push_back(places_[index_of(v)]);
      middles.push_back(mean(corners));
    }
    for (const Face f : faces) meshops::split_face(mesh_, f);
    for (const Edge e : given)
      if (!mesh_.is_boundary(e)) meshops::flip(mesh_, e);
    take(std::move(moved), middles);
  }

 private:
  const Point3& at_end(Halfedge h) const { return places_[index_of(mesh_.to_vertex_handle(h))]; }

  /// Returns (1 − α) p + α m for each vertex at p, where m is the mean of its neighbors and α = weight(degree). On the
  /// boundary, m is the mean of the two neighbors there, and α is `on_boundary`.
  template <typename Weight>
  std::vector<Point3> smoothed(double on_boundary, Weight weight) {
    std::vector<Point3> moved = places_, around;
    for (const Vertex v : meshops::live_vertices(mesh_)) {
      around.clear();
      const bool is_boundary = mesh_.is_boundary(v);
      for (const Halfedge h : mesh_.voh_range(v))
        if (!is_boundary || mesh_.is_boundary(mesh_.edge_handle(h))) around.push_back(at_end(h));
      step_(around.size());
      if (around.empty()) continue;
      const double part = is_boundary ? on_boundary : weight(static_cast<double>(around.size()));
      moved[index_of(v)] = plus(plus({}, 1 - part, places_[index_of(v)]), part, mean(around));
    }
    return moved;
  }

  void take(std::vector<Point3> moved, const std::vector<Point3>& added) {
    places_ = std::move(moved);
    places_.insert(places_.end(), added.begin(), added.end());
  }

  Connectivity& mesh_;
  std::vector<Point3>& places_;
  meshops::Steps step_;
};

void require_one_fan_each(const Connectivity& mesh) {
  std::vector<std::size_t> leaving(mesh.n_vertices(), 0);
  for (const Edge e : meshops::live_edges(mesh))
    for (const unsigned side : {0U, 1U}) ++leaving[index_of(mesh.to_vertex_handle(mesh.halfedge_handle(e, side)))];
  for (const Vertex v : meshops::live_vertices(mesh))
    if (leaving[index_of(v)] != mesh.valence(v))
      throw InvalidInput(
          "subdivide: found vertex " + std::to_string(v.idx()) +
          " with several fans of triangles, expected one (meshops::build_mesh() makes a vertex of each)");
}

}  // namespace

void subdivide(Connectivity& mesh, std::vector<Point3>& places, const SubdivisionOptions& options) {
  space::require_places("subdivide", mesh, places);
  std::size_t faces = 0;
  for (const Face f : meshops::live_faces(mesh)) {
    ++faces;
    if (mesh.valence(f) != 3)
      meshops::detail::enforce("subdivide", std::optional(meshops::Blocker(meshops::BlockerKind::not_triangle, f)));
  }
  require_one_fan_each(mesh);
  const bool is_loop = options.rule == SubdivisionRule::loop;
  for (unsigned time = 0; time < options.times && faces > 0; ++time)
    if ((faces *= is_loop ? 4 : 3) > options.most_faces)
      throw InvalidInput("subdivide: found " + std::to_string(options.times) + " times, expected at most " +
                         std::to_string(time) + ", as the limit is " + std::to_string(options.most_faces) +
                         " triangles");
  if (faces == 0) return;
  meshops::request_status(mesh);
  Subdividing run(mesh, places, options.go_on);
  for (unsigned time = 0; time < options.times; ++time) is_loop ? run.by_loop() : run.by_sqrt3();
}

}  // namespace rbpa
