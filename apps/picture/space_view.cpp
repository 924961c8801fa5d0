#include "picture/space_view.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rbpa::app {
namespace {

using Vector = Eigen::Vector3d;

/// The points around the middle of their box, which is 2 wide: coordinates near the largest double are safe.
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

/// The greater part of an axis is positive: an eigenvector may be either way.
Vector upward(const Vector& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vector(-axis) : axis;
}

/// Rows are right, up, and to the viewer.
Eigen::Matrix3d directions(std::vector<Vector> points) {
  // Sums of floating-point numbers depend on their order.
  std::sort(points.begin(), points.end(), [](const Vector& a, const Vector& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  Vector mean = Vector::Zero();
  for (const Vector& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vector& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  const Vector up = upward(axes.eigenvectors().col(2)), viewer = upward(axes.eigenvectors().col(0));
  Eigen::Matrix3d view;
  view << up.cross(viewer).transpose(), up.transpose(), viewer.transpose();
  constexpr double degree = std::numbers::pi / 180;
  return Eigen::AngleAxisd(20 * degree, Vector::UnitX()) * Eigen::AngleAxisd(-25 * degree, Vector::UnitY()) * view;
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
