#include "rbpa/union_of_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/input.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/simplices_at.h"
#include "rbpa/solid_radii.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/full/faces_within.h"
#include "rbpa/space/outer_faces.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {
namespace {

using Vector = space::Vector3<double>;
using std::numbers::pi;

Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double length(const Vector& v) { return std::hypot(v.x, v.y, v.z); }  // of points that nearly coincide too
Vector unit(const Vector& v) {
  const double size = length(v);
  return size > 0 ? 1 / size * v : v;
}

/// Of a corner whose edges lead along three unit vectors, as a share of all directions. Source: Van Oosterom, Strackee (1983).
double solid_angle(const Vector& a, const Vector& b, const Vector& c) {
  return 2 * std::atan2(std::abs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(a, c) + dot(b, c)) / (4 * pi);
}

/// Of an edge between the faces towards a and b, which begin at its origin, as a share of a whole turn: all three unit vectors.
double dihedral_angle(const Vector& edge, const Vector& a, const Vector& b) {
  const Vector to_a = unit(cross(edge, a)), to_b = unit(cross(edge, b));
  return std::atan2(length(cross(to_a, to_b)), dot(to_a, to_b)) / (2 * pi);
}

/// What balls have in common: volume, and area of the surface.
struct Measure {
  double volume, area;
};

// Of balls of radius 1.
constexpr Measure one_ball = {4 * pi / 3, 4 * pi};

/// At so much of a distance, at most 2.
Measure two_balls(double distance) {
  const double height = std::max(2 - distance, 0.0);  // of both caps together
  return {pi / 12 * (4 + distance) * height * height, 2 * pi * height};
}

/// Around 0, u and v, whose circumradius is at most 1. The three spheres meet in two points; the tetrahedron with one of them is made of what
/// it has of one ball, less what it has of two, and of half of three.
Measure three_balls(const Vector& u, const Vector& v) {
  const double lu = length(u), lv = length(v);
  const Vector eu = unit(u), ev = unit(v), n = cross(eu, ev), ew = unit(v - u);
  const double nn = dot(n, n);
  if (!(nn > 0)) return two_balls(std::max(lu, lv));  // two of the three are at one point
  const Vector centre = 1 / (2 * nn) * (lu * cross(ev, n) + lv * cross(n, eu));
  const double height = std::sqrt(std::max(1 - dot(centre, centre), 0.0));
  const Vector apex = centre + height / std::sqrt(nn) * n;
  const Vector from_o = unit(apex), from_u = unit(apex - u), from_v = unit(apex - v);
  const double balls =
      solid_angle(eu, ev, from_o) + solid_angle(-1 * eu, ew, from_u) + solid_angle(-1 * ev, -1 * ew, from_v);
  Measure common = {lu * lv * std::sqrt(nn) * height / 6 - balls * one_ball.volume, -balls * one_ball.area};
  const auto add = [&](double distance, double angle) {
    const Measure two = two_balls(distance);
    common.volume += angle * two.volume;
    common.area += angle * two.area;
  };
  add(lu, dihedral_angle(eu, ev, from_o));
  add(lv, dihedral_angle(ev, eu, from_o));
  add(length(v - u), dihedral_angle(ew, -1 * eu, from_u));
  return {std::max(2 * common.volume, 0.0), std::max(2 * common.area, 0.0)};
}

/// Sums that do not depend on the order.
class Sum {
 public:
  void add(double times, const Measure& of) {
    volume_.add(times * of.volume);
    area_.add(times * of.area);
  }
  Sum& operator+=(const Sum& other) {
    volume_ += other.volume_;
    area_ += other.area_;
    return *this;
  }
  Measure rounded() const { return {volume_.rounded(), area_.rounded()}; }

 private:
  ExactSum volume_, area_;
};

/// The formula over one triangulation. Points from `own` on have no ball.
class Union {
 public:
  Union(std::span<const Point3> points, std::size_t own, const Solid& delaunay, std::span<const double> radii,
        double radius, Threads& threads)
      : points_(points),
        own_(own),
        delaunay_(delaunay),
        radius_(radius),
        threads_(threads),
        faces_(points, delaunay, radii, radius, threads),
        bound_(corner_bound<4>(delaunay.simplices)),
        stars_(delaunay.simplices, bound_) {}

  BallUnion measure() {
    Sum sum;
    struct Workspace {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
      Sum sum;
    };
    constexpr std::size_t at_a_time = 1u << 10;
    in_order<Workspace>(
        threads_, (bound_ + at_a_time - 1) / at_a_time,
        [&](std::size_t part, Workspace& w) {
          w.sum = {};
          const std::size_t end = std::min((part + 1) * at_a_time, std::min(bound_, own_));
          for (auto a = static_cast<std::uint32_t>(part * at_a_time); a < end; ++a) add_star(a, w.ends, w.sum);
        },
        [&](std::size_t, Workspace& w) { sum += w.sum; }, [](std::size_t, Workspace&) {});
    const Measure unit = sum.rounded();
    return {unit.volume * radius_ * radius_ * radius_, unit.area * radius_ * radius_};
  }

 private:
  using Row = std::array<std::uint32_t, 4>;

  /// What a point adds, and the edges, triangles and tetrahedra of which it is the least corner.
  void add_star(std::uint32_t a, std::vector<std::pair<std::uint32_t, std::uint32_t>>& ends, Sum& sum) const {
    const auto star = stars_[a];
    if (star.empty()) return;  // it repeats another point
    for (const std::uint32_t t : star) {
      const Row& row = delaunay_.simplices[t];
      if (!faces_.has_tetrahedron(t) || a != *std::min_element(row.begin(), row.end())) continue;
      const Row of = from_corner(t, a);
      sum.add(1, {std::abs(dot(edge(a, of[1]), cross(edge(a, of[2]), edge(a, of[3])))) / 6, 0});
    }
    if (!is_inside(star, {a, a})) {
      double outside = 1;
      for (const std::uint32_t t : star) {
        if (!faces_.has_tetrahedron(t)) continue;
        const Row of = from_corner(t, a);
        outside -= solid_angle(unit(edge(a, of[1])), unit(edge(a, of[2])), unit(edge(a, of[3])));
      }
      sum.add(outside, one_ball);
    }
    for (const std::uint32_t t : star)
      for (std::size_t k = 0; k < 4; ++k)
        if (faces_.is_first(t, k)) add_triangle(a, t, k, sum);
    space::for_each_edge_up(a, star, delaunay_, ends, [&](std::uint32_t b, std::span<const std::uint32_t> around) {
      add_edge(a, b, around, sum);
    });
  }

  /// All of these tetrahedra are in the complex, and no face of theirs at the corner, or at both, is on the hull: what is
  /// there adds nothing.
  bool is_inside(std::span<const std::uint32_t> tetrahedra, std::array<std::uint32_t, 2> corners) const {
    return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](std::uint32_t t) {
      if (!faces_.has_tetrahedron(t)) return false;
      for (std::size_t k = 0; k < 4; ++k)
        if (const std::uint32_t across = delaunay_.simplices[t][k]; across != corners[0] && across != corners[1])
          if (faces_.is_on_hull(t, k)) return false;
      return true;
    });
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

  void add_edge(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around, Sum& sum) const {
    if (is_inside(around, {a, b}) || !faces_.has_edge(a, b, around)) return;
    const Vector along = edge(a, b), direction = unit(along);
    double outside = 1;
    for (const std::uint32_t t : around) {
      if (!faces_.has_tetrahedron(t)) continue;
      std::array<Vector, 2> to{};
      std::size_t found = 0;
      for (const std::uint32_t corner : delaunay_.simplices[t])
        if (corner != a && corner != b) to[found++] = unit(edge(a, corner));
      outside -= dihedral_angle(direction, to[0], to[1]);
    }
    sum.add(-outside, two_balls(length(along)));
  }

  /// In units of the radius.
  Vector edge(std::uint32_t a, std::uint32_t b) const {
    return 1 / radius_ * space::from<double>(points_[a], points_[b]);
  }
  /// The corners of a tetrahedron, one of them first.
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
  space::FacesWithin faces_;
  std::size_t bound_;
  TetrahedraAt stars_;
};

void check_radius(double radius) {
  if (!(radius > 0) || std::isinf(radius))
    throw InvalidInput("the radius is " + text(radius) + ", expected a finite number above 0");
}

}  // namespace

BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                         double radius, unsigned wanted) {
  check_radius(radius);
  meshops::require(radii.size() == delaunay.simplices.size(), "union_of_balls: expected a radius for each tetrahedron");
  meshops::require(delaunay.neighbors.size() == radii.size() && !radii.empty(),
                   "union_of_balls: the triangulation has no tetrahedra or no neighbors");
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
    // All are in a plane. Points so far away that no ball reaches them make a triangulation.
    Point3 low = points[0], high = points[0];
    for (const Point3& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double far = 4 * (radius + (high.x - low.x) + (high.y - low.y) + (high.z - low.z));
    more.assign(points.begin(), points.end());
    for (const Point3& p : {Point3{high.x + far, high.y, high.z}, Point3{high.x, high.y + far, high.z},
                            Point3{high.x, high.y, high.z + far}})
      more.push_back(p);
    if (!std::isfinite(high.x + far) || !std::isfinite(high.y + far) || !std::isfinite(high.z + far))
      throw InvalidInput("the points are in a plane, and too far apart or balls too large for doubles beyond them");
    delaunay = solid(more, infinity, with_neighbors);
  }
  const std::span<const Point3> all = more.empty() ? points : std::span<const Point3>(more);
  const std::vector<double> radii = circumradii(all, delaunay.simplices, options.threads);
  Threads threads = threads_for(points.size(), options.threads);
  return Union(all, points.size(), delaunay, radii, radius, threads).measure();
}

}  // namespace rbpa
