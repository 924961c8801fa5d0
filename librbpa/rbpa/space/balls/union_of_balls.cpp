#include "rbpa/space/balls/union_of_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/common_of_balls.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/far_points.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/solid_radii.h"

namespace rbpa {
namespace {

using space::Measure;
using space::Vector;
using Sum = space::MeasureSum;

/// Evaluates the formula over one triangulation. Points from number `own` on have no ball.
class Union {
 public:
  Union(std::span<const Point3> points, std::size_t own, const Solid& delaunay, std::span<const double> radii,
        double radius, Threads& threads)
      : points_(points),
        own_(own),
        delaunay_(delaunay),
        radius_(radius),
        threads_(threads),
        cells_(points, delaunay),
        faces_(cells_, radii, radius, threads),
        stars_(cells_) {}

  BallUnion measure() {
    Sum sum;
    struct Workspace {
      space::EdgesUp up;
      Sum sum;
    };
    constexpr std::size_t at_a_time = 1u << 10;
    in_order<Workspace>(
        threads_, (stars_.bound() + at_a_time - 1) / at_a_time,
        [&](std::size_t part, Workspace& w) {
          w.sum = {};
          const std::size_t end = std::min((part + 1) * at_a_time, std::min(stars_.bound(), own_));
          for (auto a = static_cast<std::uint32_t>(part * at_a_time); a < end; ++a) add_star(a, w.up, w.sum);
        },
        [&](std::size_t, Workspace& w) { sum += w.sum; }, [](std::size_t, Workspace&) {});
    const Measure unit = sum.rounded();
    return {unit.volume * radius_ * radius_ * radius_, unit.area * radius_ * radius_};
  }

 private:
  using Row = std::array<std::uint32_t, 4>;

  /// Adds the terms of a point, and of the edges, triangles and tetrahedra of which it is the corner of lowest index.
  void add_star(std::uint32_t a, space::EdgesUp& up, Sum& sum) const {
    const auto star = stars_[a];
    if (star.empty()) return;  // the point is a duplicate
    for (const std::uint32_t t : star) {
      const Row& row = delaunay_.simplices[t];
      if (!faces_.has_tetrahedron(t) || a != *std::min_element(row.begin(), row.end())) continue;
      const Row of = from_corner(t, a);
      sum.add(1, {std::abs(dot(edge(a, of[1]), cross(edge(a, of[2]), edge(a, of[3])))) / 6, 0});
    }
    if (!std::all_of(star.begin(), star.end(), [&](std::uint32_t t) { return is_inside(t, a, a); })) {
      double outside = 1;
      for (const std::uint32_t t : star) {
        if (!faces_.has_tetrahedron(t)) continue;
        const Row of = from_corner(t, a);
        outside -= solid_angle(unit(edge(a, of[1])), unit(edge(a, of[2])), unit(edge(a, of[3])));
      }
      sum.add(outside, space::one_ball);
    }
    for (const std::uint32_t t : star)
      for (std::size_t k = 0; k < 4; ++k)
        if (faces_.is_first(t, k)) add_triangle(a, t, k, sum);
    space::for_each_edge_up(a, star, cells_, up,
                            [&](std::uint32_t b, std::span<const space::EdgeAt> ring) { add_edge(a, b, ring, sum); });
  }

  /// Returns whether the tetrahedron is in the complex, and no face of it at a, or at the edge from a to b, is on the
  /// hull. If this holds for all tetrahedra around, the angle that they leave is 0.
  bool is_inside(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
    if (!faces_.has_tetrahedron(t)) return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (const std::uint32_t across = delaunay_.simplices[t][k]; across != a && across != b)
        if (faces_.is_on_hull(t, k)) return false;
    return true;
  }

  void add_triangle(std::uint32_t a, std::uint32_t t, std::size_t k, Sum& sum) const {
    const auto& corners = delaunay_.simplices[t];
    std::array<std::uint32_t, 3> triangle = {corners[space::outer_faces[k][0]], corners[space::outer_faces[k][1]],
                                             corners[space::outer_faces[k][2]]};
    std::sort(triangle.begin(), triangle.end());
    const unsigned tetrahedra = faces_.tetrahedra_at(t, k);
    if (triangle[0] != a || tetrahedra == 2 || !faces_.has_triangle(t, k)) return;
    sum.add(1 - 0.5 * tetrahedra, three_balls(edge(a, triangle[1]), edge(a, triangle[2])));
  }

  void add_edge(std::uint32_t a, std::uint32_t b, std::span<const space::EdgeAt> ring, Sum& sum) const {
    if (std::all_of(ring.begin(), ring.end(), [&](const auto& at) { return is_inside(at.tetrahedron, a, b); })) return;
    if (!faces_.has_edge(ring)) return;
    const Vector along = edge(a, b), direction = unit(along);
    double outside = 1;
    for (const space::EdgeAt& at : ring) {
      if (!faces_.has_tetrahedron(at.tetrahedron)) continue;
      const auto [k, l] = others(at);
      const Row& row = delaunay_.simplices[at.tetrahedron];
      outside -= dihedral_angle(direction, unit(edge(a, row[k])), unit(edge(a, row[l])));
    }
    sum.add(-outside, space::two_balls(norm(along)));
  }

  /// Returns the vector from a to b, in units of the radius.
  Vector edge(std::uint32_t a, std::uint32_t b) const {
    return 1 / radius_ * space::from<double>(points_[a], points_[b]);
  }
  /// Returns the corners of a tetrahedron, starting with `first`.
  Row from_corner(std::uint32_t t, std::uint32_t first) const {
    Row row = delaunay_.simplices[t];
    std::swap(row[0], *std::find(row.begin(), row.end(), first));
    return row;
  }

  std::span<const Point3> points_;
  std::size_t own_;
  const Solid& delaunay_;
  double radius_;
  Threads& threads_;
  space::Triangulated cells_;
  space::FacesWithin faces_;
  space::PointStars stars_;
};

void check_radius(double radius) {
  if (!(radius > 0) || std::isinf(radius))
    throw InvalidInput("the radius is " + text(radius) + ", expected a finite number above 0");
}

}  // namespace

BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                         double radius, unsigned wanted) {
  check_radius(radius);
  meshops::require_one_each("union_of_balls", radii.size(), "radii", delaunay.simplices.size(), "tetrahedra");
  meshops::require(delaunay.neighbors.size() == radii.size() && !radii.empty(),
                   "union_of_balls: the triangulation has no tetrahedra or no neighbors, expected solid() at infinity");
  Threads threads = threads_for(points.size(), wanted);
  return Union(points, points.size(), delaunay, radii, radius, threads).measure();
}

BallUnion union_of_balls(std::span<const Point3> points, double radius, const SolidOptions& options) {
  check_radius(radius);
  space::check_points(points);
  if (points.empty()) return {};
  SolidOptions with_neighbors = options;
  with_neighbors.neighbors = true;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Solid delaunay = solid(points, infinity, with_neighbors);
  std::vector<Point3> more;
  if (delaunay.simplices.empty()) {
    // All points are in a plane. Additional points, too far away for any ball to reach them, make a triangulation.
    more = space::with_far_points(points, radius);
    delaunay = solid(more, infinity, with_neighbors);
  }
  const std::span<const Point3> all = more.empty() ? points : std::span<const Point3>(more);
  const std::vector<double> radii = circumradii(all, delaunay.simplices, options.threads);
  Threads threads = threads_for(points.size(), options.threads);
  return Union(all, points.size(), delaunay, radii, radius, threads).measure();
}

}  // namespace rbpa
