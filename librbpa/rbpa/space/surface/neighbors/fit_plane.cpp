#include "rbpa/space/surface/neighbors/fit_plane.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace rbpa::space {
namespace {

template <typename Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

template <typename Real>
Vector<Real> difference(const Point3& p, const Point3& q) {
  return {Real(q.x) - Real(p.x), Real(q.y) - Real(p.y), Real(q.z) - Real(p.z)};
}

/// Returns the vector as a point, with 0 in place of −0.
Point3 point(const Eigen::Vector3d& v) { return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}; }

/// Returns the direction across a line that is nearest to the z axis, or to the y axis if the line is parallel to z.
/// Requires: `line` is a unit vector.
Eigen::Vector3d across(const Eigen::Vector3d& line) {
  constexpr double parallel = 0x1p-20;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  if (std::hypot(line.x(), line.y()) > parallel) return (z - line.z() * line).normalized();
  const Eigen::Vector3d direction = line.cross(x).normalized();
  return direction.y() < 0 ? Eigen::Vector3d(-direction) : direction;
}

}  // namespace

template <typename Real>
Plane fit_plane(const Neighborhoods& points, std::size_t i) {
  const Point3& at = points.points[i];
  const auto around = points.around(i);
  if (around.empty()) return {.normal = {0, 0, 1}, .roundness = 0, .flatness = 0};
  // Offsets are scaled by a power of two, so that squares are about 1 however near the points are. The last point of
  // `around` is the farthest.
  const int exponent =
      std::ilogb(difference<Real>(at, points.points[around.back()]).template lpNorm<Eigen::Infinity>());
  const Real scale = std::ldexp(Real(1), -exponent);
  const auto each = [&](auto visit) {
    visit(Eigen::Vector3d(Eigen::Vector3d::Zero()));
    for (const std::uint32_t p : around)
      visit(Eigen::Vector3d((difference<Real>(at, points.points[p]) * scale).template cast<double>()));
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  each([&](const Eigen::Vector3d& d) { sum += d; });
  const Eigen::Vector3d centroid = sum / static_cast<double>(around.size() + 1);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  each([&](const Eigen::Vector3d& d) {
    const Eigen::Vector3d e = d - centroid;
    covariance.noalias() += e * e.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& spread = solver.eigenvalues();  // ascending
  constexpr double rounding = 0x1p-48;                   // relative error of the covariance, a sum over a few points
  if (spread[1] <= rounding * spread[2])
    return {.normal = point(across(solver.eigenvectors().col(2))), .roundness = 0, .flatness = 0};
  return {.normal = point(solver.eigenvectors().col(0)),
          .roundness = spread[1] / spread[2],
          .flatness = 1 - std::max(0.0, spread[0]) / spread[1]};
}

template <typename Real>
PlanesOfPoints fit_planes(std::vector<Point3> points, std::size_t count, Threads& threads, const Checkpoint& go_on) {
  PlanesOfPoints fitted;
  fitted.normals.resize(points.size());
  fitted.flatness.resize(points.size());
  const bool may_widen = count >= 8;
  const auto fit = [&](const Neighborhoods& near, std::size_t i) {
    const Plane plane = fit_plane<Real>(near, i);
    fitted.normals[i] = plane.normal;
    fitted.flatness[i] = plane.flatness;
    return plane.is_certain() || !may_widen;
  };
  fitted.near = find_nearest<Real>(std::move(points), count, threads, go_on, fit);
  return fitted;
}

template Plane fit_plane<double>(const Neighborhoods&, std::size_t);
template Plane fit_plane<long double>(const Neighborhoods&, std::size_t);
template PlanesOfPoints fit_planes<double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&);
template PlanesOfPoints fit_planes<long double>(std::vector<Point3>, std::size_t, Threads&, const Checkpoint&);

}  // namespace rbpa::space
