#include "picture/space_view.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/sort.h"

namespace rbpa::app {
namespace {

using Vector = Eigen::Vector3d;

/// Returns the points, centered and scaled so that the longest side of their box is 2, even for coordinates near the
/// largest double.
std::vector<Vector> normalized(std::span<const Point3> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector low = Vector::Constant(infinity), high = -low;
  for (const Point3& p : points) {
    low = low.cwiseMin(Vector(p.x, p.y, p.z));
    high = high.cwiseMax(Vector(p.x, p.y, p.z));
  }
  const Vector middle = low / 2 + high / 2;
  double half = (high / 2 - low / 2).maxCoeff();
  if (!(half > 0)) half = 1;
  std::vector<Vector> moved;
  moved.reserve(points.size());
  for (const Point3& p : points) moved.emplace_back((Vector(p.x, p.y, p.z) - middle) / half);
  return moved;
}

/// Returns `axis` or its opposite, whichever has a positive largest component: an eigenvector has no orientation.
Vector upward(const Vector& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vector(-axis) : axis;
}

/// Returns the coordinate axis, 1 (y) or 2 (z), that is upright for a viewer in the direction `viewer`. The points do
/// not determine this axis: it is y in most models and z in most scans. If the viewer looks along y or z, the other
/// axis is upright; otherwise y is, unless the points extend much more in z.
Eigen::Index upright(const Vector& viewer, const Vector& variances) {
  constexpr double taller = 1.5;
  Eigen::Index along = 0;
  viewer.cwiseAbs().maxCoeff(&along);
  if (along != 0) return 3 - along;
  return variances.z() > taller * taller * variances.y() ? 2 : 1;
}

/// Returns the matrix whose rows point to the right, up and to the viewer. `axis` points up in the picture.
Eigen::Matrix3d with_upright(const Vector& axis, const Vector& viewer) {
  const Vector up = (axis - axis.dot(viewer) * viewer).normalized();
  Eigen::Matrix3d view;
  view << up.cross(viewer).transpose(), up.transpose(), viewer.transpose();
  return view;
}

/// Returns the view of the points, a matrix like that of with_upright(). The viewer is at least 45 degrees from the
/// upright axis before the turn of 20 degrees toward it, and at least 25 degrees after the turn.
Eigen::Matrix3d directions(std::vector<Vector> points) {
  // Sort first: sums of floating-point numbers depend on their order.
  sort(points, [](const Vector& a, const Vector& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  Vector mean = Vector::Zero();
  for (const Vector& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vector& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  const Vector viewer = upward(axes.eigenvectors().col(0));
  const Vector axis = Vector::Unit(upright(viewer, covariance.diagonal()));
  constexpr double degree = std::numbers::pi / 180;
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(20 * degree, Vector::UnitX()) * Eigen::AngleAxisd(-25 * degree, Vector::UnitY()))
          .toRotationMatrix();
  return with_upright(axis, with_upright(axis, viewer).transpose() * turn.row(2).transpose());
}

}  // namespace

SpaceView view_of(std::span<const Point3> points, int width) {
  SpaceView view{.width = width, .height = width, .at = {}};
  if (points.empty()) return view;
  const std::vector<Vector> moved = normalized(points);
  const Eigen::Matrix3d turn = directions(moved);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector low = Vector::Constant(infinity), high = -low;
  for (const Vector& p : moved) {
    low = low.cwiseMin(turn * p);
    high = high.cwiseMax(turn * p);
  }
  const double margin = std::max(8.0, width / 40.0), room = width - 2 * margin;
  const double wide = std::max(high.x() - low.x(), 1e-6), tall = std::max(high.y() - low.y(), 1e-6);
  const double wanted = std::clamp(tall / wide * room + 2 * margin, width / 4.0, width * 2.0);
  view.height = static_cast<int>(std::lround(wanted));
  const double scale = std::min(room / wide, (view.height - 2 * margin) / tall);
  const Vector middle = (low + high) / 2;
  view.at.reserve(moved.size());
  for (const Vector& p : moved) {
    const Vector seen = (turn * p - middle) * scale;
    view.at.push_back({view.width / 2.0 + seen.x(), view.height / 2.0 - seen.y(), seen.z()});
  }
  return view;
}

}  // namespace rbpa::app
