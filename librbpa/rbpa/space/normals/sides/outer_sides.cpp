#include "rbpa/space/normals/sides/outer_sides.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/space/surface/neighbors/fit_plane.h"

namespace rbpa::space {
namespace {

using Eigen::Vector3d;
using Number = std::uint32_t;

// The numbers were chosen on some two hundred sets of points with known normals, and tried on others
// (docs/explanation/surfaces.md, section 19).
constexpr double one_sided = 0.35;        // least agreement of the surface around a point at which its side is known
constexpr double least_satisfied = 0.91;  // least share of the opposition of poles at which sides are trusted
constexpr double most_closed = 0.1;       // greatest share of the area of the surface that wide facets may close
constexpr double wide = 4;                // length of the longest edge of a facet, in spacings
constexpr double one_ball = 0.99;         // agreement of two circumspheres from which on the cells are one
constexpr double outlying = 4;            // distance of the 8th nearest other point, in medians
constexpr double flat = 1e-9;             // six times the volume of a cell, in cubes of its longest edge
constexpr double least_weight = 1e-6;

/// Corners of the facet across from each corner of a cell. Seen from outside the cell, they are counterclockwise.
constexpr std::array<std::array<std::size_t, 3>, 4> facets = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The Delaunay tetrahedra of points, called cells, and their circumcenters. One more cell, whose number is their
/// count, is outside of the hull. Requires: coordinates that fit_double() has scaled, so that no product overflows.
class DelaunayCells {
 public:
  DelaunayCells(const Neighborhoods& near, const SolidOptions& options)
      : solid_(solid(near.points, std::numeric_limits<double>::infinity(), options)) {
    const Point3& origin = near.points[0];  // near it, centers far from 0 are rounded less
    for (const Point3& p : near.points) points_.emplace_back(p.x - origin.x, p.y - origin.y, p.z - origin.z);
    for (Number t = 0; t < count(); ++t) centers_.push_back(circumcenter(t));
  }

  Number count() const { return static_cast<Number>(solid_.simplices.size()); }
  const std::vector<Vector3d>& points() const { return points_; }
  const std::array<Number, 4>& corners(Number cell) const { return solid_.simplices[cell]; }
  Number corner(Number cell, std::size_t facet, std::size_t k) const { return corners(cell)[facets[facet][k % 3]]; }
  bool is_flat(Number cell) const { return !std::isfinite(centers_[cell].x()); }
  Vector3d center_from(Number point, Number cell) const { return centers_[cell] - points_[point]; }
  /// Returns the area vector of the facet, twice as long and outward.
  Vector3d area(Number cell, std::size_t facet) const {
    const Vector3d& a = points_[corner(cell, facet, 0)];
    return (points_[corner(cell, facet, 1)] - a).cross(points_[corner(cell, facet, 2)] - a);
  }
  /// Calls visit(cell, facet, other) once for each facet, where `other` is the cell beyond the facet.
  template <typename Visit>
  void for_each_facet(Visit visit) const {
    for (Number cell = 0; cell < count(); ++cell)
      for (std::size_t facet = 0; facet < facets.size(); ++facet) {
        const Number other = std::min(solid_.neighbors[cell][facet], count());
        if (other > cell) visit(cell, facet, other);
      }
  }
  /// Returns the cosine of the angle between the circumspheres of two cells at their facet, 1 for the same sphere. The
  /// sphere of the cell beyond the hull is the plane of the facet. Returns a half if a sphere is not determined.
  double agreement(Number cell, std::size_t facet, Number other) const {
    const Number p = corner(cell, facet, 0);
    if (is_flat(cell) || (other < count() && is_flat(other))) return 0.5;
    const Vector3d u = center_from(p, cell), v = other < count() ? center_from(p, other) : area(cell, facet);
    return u.normalized().dot(v.normalized());
  }

 private:
  /// Returns NaN if the cell is so flat that rounding decides.
  Vector3d circumcenter(Number cell) const {
    const Vector3d& a = points_[corners(cell)[0]];
    const Vector3d u = points_[corners(cell)[1]] - a, v = points_[corners(cell)[2]] - a,
                   w = points_[corners(cell)[3]] - a;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm(), volume = u.cross(v).dot(w);
    const double longest =
        std::sqrt(std::max({uu, vv, ww, (u - v).squaredNorm(), (u - w).squaredNorm(), (v - w).squaredNorm()}));
    if (!(volume > flat * longest * longest * longest))
      return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return a + (uu * v.cross(w) + vv * w.cross(u) + ww * u.cross(v)) / (2 * volume);
  }

  Solid solid_;
  std::vector<Vector3d> points_, centers_;
};

/// The cells of a point whose circumcenters are the farthest ones in opposite directions.
struct Poles {
  Number first = Solid::none, second = Solid::none;
  double opposition = 0;  ///< confidence that one of them is inside and the other one outside, from 0 to 1
};

std::vector<double> distances_to(const std::vector<Vector3d>& points, const Neighborhoods& near, std::size_t k) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.size(); ++i) distances.push_back((points[near.around(i)[k]] - points[i]).norm());
  return distances;
}

/// Returns the poles of each point. The cell beyond the hull is the first pole of points on the hull. Poles do not
/// oppose each other at outliers, and where they are nearer than half the spacing.
std::vector<Poles> poles_of(const DelaunayCells& cells, const Neighborhoods& near, std::span<const double> spacing) {
  const std::vector<Vector3d>& points = cells.points();
  std::vector<Poles> poles(points.size());
  std::vector<Vector3d> axis(points.size(), Vector3d::Zero());  // from the point to its first pole
  cells.for_each_facet([&](Number cell, std::size_t facet, Number other) {
    if (other < cells.count()) return;
    const Vector3d outward = cells.area(cell, facet).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      poles[cells.corner(cell, facet, k)].first = other;
      axis[cells.corner(cell, facet, k)] += outward;
    }
  });
  std::vector<double> farthest(points.size(), 0);
  const auto for_each_center = [&](auto visit) {
    for (Number cell = 0; cell < cells.count(); ++cell)
      if (!cells.is_flat(cell))
        for (const Number i : cells.corners(cell)) {
          const Vector3d to_center = cells.center_from(i, cell);
          if (to_center.squaredNorm() > farthest[i]) visit(i, cell, to_center);
        }
  };
  for_each_center([&](Number i, Number cell, const Vector3d& to_center) {
    if (poles[i].first == cells.count()) return;
    farthest[i] = to_center.squaredNorm();
    axis[i] = to_center;
    poles[i].first = cell;
  });
  std::fill(farthest.begin(), farthest.end(), 0);
  for_each_center([&](Number i, Number cell, const Vector3d& to_center) {
    if (!(to_center.dot(axis[i]) < 0)) return;
    farthest[i] = to_center.squaredNorm();
    poles[i].second = cell;
  });
  const std::vector<double> eighth = distances_to(points, near, std::min<std::size_t>(8, near.count) - 1);
  std::vector<double> sorted = eighth;
  const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), median, sorted.end());
  for (Number i = 0; i < points.size(); ++i) {
    if (poles[i].second == Solid::none || eighth[i] > outlying * *median) continue;
    const Vector3d second = cells.center_from(i, poles[i].second);
    const double radius =
        std::sqrt(poles[i].first == cells.count() ? farthest[i] : std::min(farthest[i], axis[i].squaredNorm()));
    poles[i].opposition =
        -axis[i].normalized().dot(second.normalized()) * std::clamp(1 - spacing[i] / (2 * radius), 0.0, 1.0);
  }
  return poles;
}

/// Returns the solution of S x = b by the method of conjugate gradients, to a residual of 1/1000, after at most 150
/// steps. Requires: S is symmetric, positive definite and has a diagonal near 1; only its upper triangle is given.
Eigen::VectorXd solution(const Eigen::SparseMatrix<double>& s, const Eigen::VectorXd& b, const Checkpoint& go_on) {
  constexpr int most_steps = 150;
  constexpr double residual = 1e-3;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), r = b, p = b, q;
  double square = r.squaredNorm();
  const double enough = residual * residual * square;
  for (int step = 0; step < most_steps && square > enough; ++step) {
    if (go_on) go_on();
    q = s.selfadjointView<Eigen::Upper>() * p;
    const double along = square / p.dot(q);
    x += along * p;
    r -= along * q;
    const double next = r.squaredNorm();
    p = r + next / square * p;
    square = next;
  }
  return x;
}

/// Returns for each cell whether it is outside; for the cell beyond the hull true. Cells that are connected by nearly
/// equal circumspheres are one node of a graph, with an edge of positive weight for each other facet between nodes, and
/// one of negative weight for each pair of opposed poles.
std::vector<bool> outside(const DelaunayCells& cells, std::span<const Poles> poles, const Checkpoint& go_on) {
  const Number beyond = cells.count();
  meshops::DisjointSets sets(beyond + std::size_t{1});
  cells.for_each_facet([&](Number cell, std::size_t facet, Number other) {
    if (cells.agreement(cell, facet, other) > one_ball) sets.join(cell, other);
  });
  std::vector<int> node(beyond + std::size_t{1});
  int nodes = 0;
  for (Number cell = 0; cell <= beyond; ++cell) node[cell] = sets.find(cell) == cell ? nodes++ : node[sets.find(cell)];
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd degree = Eigen::VectorXd::Zero(nodes);
  const auto add = [&](Number cell, Number other, double weight) {
    const auto [low, high] = std::minmax(node[cell], node[other]);
    if (low == high || std::abs(weight) < least_weight) return;
    entries.emplace_back(low, high, -weight);
    degree[low] += std::abs(weight);
    degree[high] += std::abs(weight);
  };
  cells.for_each_facet([&](Number cell, std::size_t facet, Number other) {
    const double agreement = std::max(0.0, cells.agreement(cell, facet, other));
    add(cell, other, agreement * agreement * agreement * agreement);
  });
  for (const Poles& p : poles)
    if (p.opposition > 0) add(p.first, p.second, -p.opposition);

  // The equations of all nodes but that of the cell beyond the hull, whose value is 1, divided by roots of degrees.
  const int known = node[beyond];
  Eigen::VectorXd right = Eigen::VectorXd::Zero(nodes);
  std::erase_if(entries, [&](Eigen::Triplet<double>& entry) {
    const int row = entry.row(), column = entry.col();
    const double value = entry.value() / std::sqrt(degree[row] * degree[column]);
    entry = {row, column, value};
    if (row == known) right[column] -= value;
    if (column == known) right[row] -= value;
    return row == known || column == known;
  });
  for (int i = 0; i < nodes; ++i) entries.emplace_back(i, i, 1);
  Eigen::SparseMatrix<double> matrix(nodes, nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd value = solution(matrix, right, go_on);
  value[known] = 1;
  std::vector<bool> is_outside;
  for (const int i : node) is_outside.push_back(value[i] >= 0);
  return is_outside;
}

/// Returns, for each point, the lowest index among the points that are connected with it through nearest others.
std::vector<Number> components_of(const Neighborhoods& near) {
  meshops::DisjointSets sets(near.points.size());
  for (Number i = 0; i < near.points.size(); ++i)
    for (const Number j : near.around(i)) sets.join(i, j);
  std::vector<Number> component(near.points.size());
  for (Number i = 0; i < component.size(); ++i) component[i] = sets.find(i);
  return component;
}

/// Returns whether, in a sample, more than a tenth of the points lie along curves; false below 2,000 points. Such
/// points may have as many tetrahedra as there are pairs of points.
bool is_of_curves(const Neighborhoods& near) {
  constexpr std::size_t few = 2000, step = 8, share = 10;
  if (near.count < 8 || near.points.size() < few) return false;
  std::size_t along = 0;
  for (std::size_t i = 0; i < near.points.size(); i += step) along += !fit_plane<double>(near, i).is_certain();
  return share * step * along > near.points.size();
}

/// The evidence whether the sides in one component are right.
struct Verdict {
  double opposition = 0, satisfied = 0;  // sums over the points: of all, and of poles on different sides
  double area = 0, closing = 0;          // sums over the facets between inside and outside: of all, and of wide ones

  bool is_trusted() const { return satisfied >= least_satisfied * opposition && closing <= most_closed * area; }
};

}  // namespace

OuterSides outer_sides(const Neighborhoods& near, std::span<Point3> normals, const SolidOptions& options) {
  if (near.count == 0 || is_of_curves(near)) return {};
  const DelaunayCells cells(near, options);
  if (cells.count() == 0) return {};
  const std::vector<Vector3d>& points = cells.points();
  std::vector<double> spacing = distances_to(points, near, near.count - 1);
  for (double& s : spacing) s *= std::sqrt(std::numbers::pi / static_cast<double>(near.count + 1));
  const std::vector<Poles> poles = poles_of(cells, near, spacing);
  const std::vector<bool> is_outside = outside(cells, poles, checkpoint_of(options.progress, points.size()));

  const std::vector<Number> component = components_of(near);
  std::vector<Verdict> verdicts(points.size());  // each at the lowest index of its component
  for (Number i = 0; i < points.size(); ++i) {
    if (!(poles[i].opposition > 0)) continue;
    verdicts[component[i]].opposition += poles[i].opposition;
    if (is_outside[poles[i].first] != is_outside[poles[i].second])
      verdicts[component[i]].satisfied += poles[i].opposition;
  }
  // Sums, at each point, of the unit normals of the facets between inside and outside, and of their weights: the sines
  // of half their angles at the point, which need no function but the square root.
  std::vector<Vector3d> outward(points.size(), Vector3d::Zero());
  std::vector<double> weight(points.size(), 0);
  cells.for_each_facet([&](Number cell, std::size_t facet, Number other) {
    if (is_outside[cell] == is_outside[other]) return;
    const Vector3d area = cells.area(cell, facet) * (is_outside[other] ? 1 : -1), normal = area.normalized();
    double longest = 0, widest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Number i = cells.corner(cell, facet, k);
      const Vector3d u = points[cells.corner(cell, facet, k + 1)] - points[i],
                     v = points[cells.corner(cell, facet, k + 2)] - points[i];
      longest = std::max(longest, u.squaredNorm());
      widest = std::max(widest, spacing[i]);
      const double half_sine = std::sqrt(std::max(0.0, (1 - u.normalized().dot(v.normalized())) / 2));
      outward[i] += half_sine * normal;
      weight[i] += half_sine;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      Verdict& verdict = verdicts[component[cells.corner(cell, facet, k)]];
      verdict.area += area.norm();
      if (longest > wide * wide * widest * widest) verdict.closing += area.norm();
    }
  });

  OuterSides sides = {.side = std::vector<std::int8_t>(points.size(), 0),
                      .vote = std::vector<double>(points.size(), 0)};
  for (Number i = 0; i < points.size(); ++i) {
    if (!(weight[i] > 0) || !verdicts[component[i]].is_trusted()) continue;
    const Vector3d mean = outward[i] / weight[i];
    const double along = mean.dot(Vector3d(normals[i].x, normals[i].y, normals[i].z)), length = mean.norm();
    if (std::abs(along) > one_sided) {
      sides.side[i] = along > 0 ? 1 : -1;
      sides.vote[i] = std::min(1.0, std::abs(along));
    } else if (length > one_sided) {
      normals[i] = {mean.x() / length + 0.0, mean.y() / length + 0.0, mean.z() / length + 0.0};
      sides.side[i] = 1;
      sides.vote[i] = std::min(1.0, length);
    }
  }
  return sides;
}

}  // namespace rbpa::space
