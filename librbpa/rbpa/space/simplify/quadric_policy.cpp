#include "rbpa/space/simplify/quadric_policy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/core/live_range.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/normal_sign.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/simplify/moving/live_triangles.h"
#include "rbpa/space/simplify/moving/moved_triangles.h"
#include "rbpa/space/simplify/moving/vertex_ranks.h"

namespace rbpa {
namespace {

using meshops::Connectivity;
using meshops::Edge;
using meshops::Halfedge;
using meshops::Vertex;
using Vector = space::Vector3<double>;

/// Sums of quadrics around vertices. The order of the terms of each sum does not depend on numbers.
struct Sums {
  struct Plane {
    Point3 normal, through;  // unit normal and centroid of a triangle
    double weight = 0;       // the square root of the area; 0 if there is no triangle
  };

  const Connectivity& mesh;
  const std::vector<Point3>& at;  // the scaled place of each vertex
  const std::vector<std::uint32_t>& rank;
  const QuadricOptions& options;
  const double noise = options.normal_deviation * options.normal_deviation;
  const double least_cosine = std::cos(options.sharp_angle * std::numbers::pi / 180);
  const std::vector<Plane> planes = planes_of_faces();

  Quadric around(Vertex v) const {
    Quadric sum;
    if (mesh.is_isolated(v)) return sum;
    const Halfedge first = first_of(v);
    Halfedge out = first;
    do {
      if (!mesh.is_boundary(out)) {
        const Plane& plane = plane_of(out);
        sum += Quadric::plane(plane.normal, plane.through, plane.weight, noise);
      }
      add_edge(sum, out);
      out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
    } while (out != first);
    return sum;
  }

  std::uint32_t rank_at_end(Halfedge h) const { return rank[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())]; }
  const Point3& at_end(Halfedge h) const { return at[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())]; }

  /// Returns the boundary halfedge that leaves a vertex; if there is none, the halfedge to the neighbor of least rank.
  Halfedge first_of(Vertex v) const {
    Halfedge first = mesh.halfedge_handle(v);
    if (mesh.is_boundary(first)) return first;
    for (const Halfedge h : mesh.voh_range(v))
      if (rank_at_end(h) < rank_at_end(first)) first = h;
    return first;
  }

  /// Returns the plane of the triangle of a halfedge.
  const Plane& plane_of(Halfedge h) const {
    static const Plane none;
    return mesh.is_boundary(h) ? none : planes[static_cast<std::size_t>(mesh.face_handle(h).idx())];
  }

  /// Returns the plane of each triangle by index, computed from the triangle's corner of least rank on.
  std::vector<Plane> planes_of_faces() const {
    std::vector<Plane> result(mesh.n_faces());
    for (const meshops::Face f : meshops::live_faces(mesh)) {
      const Halfedge h = mesh.halfedge_handle(f);
      std::array<Halfedge, 3> sides = {h, mesh.next_halfedge_handle(h), mesh.prev_halfedge_handle(h)};
      std::rotate(sides.begin(),
                  std::min_element(sides.begin(), sides.end(),
                                   [&](Halfedge a, Halfedge b) { return rank_at_end(a) < rank_at_end(b); }),
                  sides.end());
      const Point3 &a = at_end(sides[0]), &b = at_end(sides[1]), &c = at_end(sides[2]);
      const Vector n = space::cross(space::from<double>(a, b), space::from<double>(a, c));
      if (const double length = std::sqrt(space::dot(n, n)); length != 0)
        result[static_cast<std::size_t>(f.idx())] = {
            {n.x / length, n.y / length, n.z / length},
            {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3},
            std::sqrt(length / 2)};
    }
    return result;
  }

  /// Adds the planes that stand on the edge of a halfedge, if the edge is on the boundary or sharp: for each triangle
  /// at the edge, the plane through the edge perpendicular to the triangle.
  void add_edge(Quadric& sum, Halfedge h) const {
    if (rank_at_end(mesh.opposite_halfedge_handle(h)) > rank_at_end(h)) h = mesh.opposite_halfedge_handle(h);
    const Halfedge o = mesh.opposite_halfedge_handle(h);
    const Plane &left = plane_of(h), &right = plane_of(o);
    const bool on_boundary = mesh.is_boundary(h) || mesh.is_boundary(o);
    const double cosine =
        left.normal.x * right.normal.x + left.normal.y * right.normal.y + left.normal.z * right.normal.z;
    if (!on_boundary && !(left.weight > 0 && right.weight > 0 && cosine < least_cosine)) return;
    const Vector along = space::from<double>(at_end(o), at_end(h));
    const double weight =
        (on_boundary ? options.boundary_weight : options.sharp_weight) * std::sqrt(space::dot(along, along));
    for (const Plane& plane : {left, right}) {
      const Vector across = space::cross(along, Vector{plane.normal.x, plane.normal.y, plane.normal.z});
      const double length = std::sqrt(space::dot(across, across));
      if (plane.weight > 0 && length > 0)
        sum += Quadric::plane({across.x / length, across.y / length, across.z / length}, at_end(h), weight);
    }
  }
};

/// Returns the options. Throws ContractViolation that names one that is out of its range.
const QuadricOptions& checked(const QuadricOptions& options) {
  const auto require = [](bool fits, const char* name, const char* expected) {
    if (!fits) throw meshops::ContractViolation(std::string("QuadricOptions: ") + name + " is not " + expected);
  };
  const auto is_weight = [](double x) { return x >= 0 && std::isfinite(x); };
  constexpr const char* weight = "a finite number, at least 0";
  require(is_weight(options.boundary_weight), "boundary_weight", weight);
  require(is_weight(options.sharp_weight), "sharp_weight", weight);
  require(is_weight(options.normal_deviation), "normal_deviation", weight);
  require(options.sharp_angle >= 0 && options.sharp_angle <= 180, "sharp_angle", "an angle from 0 to 180 degrees");
  return options;
}

}  // namespace

QuadricPolicy::QuadricPolicy(const Connectivity& mesh, std::vector<Point3> places, const QuadricOptions& options)
    : costs_grow(!options.at_ends),
      options_(checked(options)),
      places_(std::move(places)),
      quadrics_(mesh.n_vertices()) {
  meshops::require_one_each("QuadricPolicy", places_.size(), "places", mesh.n_vertices(), "vertices");
  rank_ = space::vertex_ranks(mesh, places_);
  space::Box box;
  for (const Vertex v : meshops::live_vertices(mesh)) box.include(places_[index(v)]);
  const auto middle = [](double low, double high) { return low / 2 + high / 2; };
  if (box.low.x <= box.high.x)
    center_ = {middle(box.low.x, box.high.x), middle(box.low.y, box.high.y), middle(box.low.z, box.high.z)};
  const double size =
      std::max({box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2, box.high.z / 2 - box.low.z / 2});
  if (size > 0 && std::isfinite(size)) scale_ = std::ldexp(1.0, std::min(-std::ilogb(size), 1000));
  std::vector<Point3> at(places_.size());
  std::transform(places_.begin(), places_.end(), at.begin(), [&](const Point3& p) { return local(p); });
  const Sums sums{mesh, at, rank_, options_};
  for (const Vertex v : meshops::live_vertices(mesh)) quadrics_[index(v)] = sums.around(v);
  if (options.no_crossings) triangles_ = std::make_unique<space::LiveTriangles>(mesh, places_);
}

QuadricPolicy::QuadricPolicy(QuadricPolicy&&) noexcept = default;
QuadricPolicy::~QuadricPolicy() = default;

Point3 QuadricPolicy::local(const Point3& p) const {
  return {(p.x - center_.x) * scale_, (p.y - center_.y) * scale_, (p.z - center_.z) * scale_};
}

Point3 QuadricPolicy::unscaled(const Point3& p) const {
  const auto rounded = [&](double x) { return options_.single_precision ? space::to_single(x) : x; };
  return {rounded(center_.x + p.x / scale_), rounded(center_.y + p.y / scale_), rounded(center_.z + p.z / scale_)};
}

/// Returns the ends of an edge, the end of lesser rank first.
std::pair<Vertex, Vertex> QuadricPolicy::ends(const Connectivity& mesh, Edge e) const {
  const Halfedge h = mesh.halfedge_handle(e, 0);
  const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  return rank_[index(b)] < rank_[index(a)] ? std::pair(b, a) : std::pair(a, b);
}

QuadricPolicy::Target QuadricPolicy::target(const Connectivity& mesh, Edge e) const {
  const auto [a, b] = ends(mesh, e);
  const Quadric sum = quadrics_[index(a)] + quadrics_[index(b)];
  if (!options_.at_ends)
    if (const auto least = sum.minimum()) return {unscaled(*least), std::max(sum(*least), 0.0)};
  const Point3 at_a = local(places_[index(a)]), at_b = local(places_[index(b)]);
  Target best = {places_[index(a)], sum(at_a)};
  if (const double error = sum(at_b); error < best.error) best = {places_[index(b)], error};
  const Point3 middle = {(at_a.x + at_b.x) / 2, (at_a.y + at_b.y) / 2, (at_a.z + at_b.z) / 2};
  if (const double error = sum(middle); !options_.at_ends && error < best.error) best = {unscaled(middle), error};
  best.error = std::max(best.error, 0.0);  // NaN stays
  return best;
}

double QuadricPolicy::cost(const Connectivity& mesh, Edge e) const { return target(mesh, e).error; }

Point3 QuadricPolicy::place(const Connectivity& mesh, Edge e) const { return target(mesh, e).place; }

bool QuadricPolicy::turns(const Connectivity& mesh, Edge e, const Point3& place) const {
  return !space::for_each_moved_triangle(
      mesh, e, places_, place, [&](const Point3& old, const Point3& p, const Point3& q) {
        return place != p && place != q && space::keeps_direction(old, p, q, place, p, q);
      });
}

bool QuadricPolicy::crosses(const Connectivity& mesh, Edge e, const Point3& place) const {
  return triangles_ && triangles_->would_cross(mesh, e, places_, place);
}

Vertex QuadricPolicy::survivor(const Connectivity& mesh, Edge e, const Point3& place) const {
  const auto [a, b] = ends(mesh, e);
  return places_[index(b)] == place && places_[index(a)] != place ? b : a;
}

void QuadricPolicy::merge(const Connectivity& mesh, const meshops::WeldEffect& effect, const Point3& place) {
  quadrics_[index(effect.survivor)] += quadrics_[index(effect.removed.vertex)];
  places_[index(effect.survivor)] = place;
  if (triangles_) triangles_->update(mesh, effect, places_);
}

std::vector<QuadricPolicy::State> QuadricPolicy::states(const Connectivity& mesh) const {
  std::vector<State> all;
  for (const Vertex v : meshops::live_vertices(mesh)) all.push_back({v, places_[index(v)], quadrics_[index(v)]});
  return all;
}

void QuadricPolicy::restore(const Connectivity& mesh, const std::vector<State>& states,
                            const std::vector<double>& weights) {
  for (const auto& [v, place, quadric] : states) {
    places_[index(v)] = place;
    quadrics_[index(v)] = quadric;
    quadrics_[index(v)] *= weights[index(v)];
  }
  if (triangles_) triangles_ = std::make_unique<space::LiveTriangles>(mesh, places_);
}

}  // namespace rbpa
