#include "meshtopo/measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/interrupt.h"
#include "io/mesh/fan_triangles.h"
#include "meshops/topology/orient.h"

namespace rbpa::app {
namespace {

using Vector = std::array<double, 3>;

/// A sum with compensated rounding errors (Neumaier).
class Sum {
 public:
  void add(double x) {
    const double sum = sum_ + x;
    rest_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0, rest_ = 0;
};

Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

std::array<Vector, 2> box_of(const std::vector<Vector>& positions) {
  std::array<Vector, 2> box{positions.front(), positions.front()};
  for (const Vector& p : positions)
    for (std::size_t k = 0; k < 3; ++k) {
      box[0][k] = std::min(box[0][k], p[k]);
      box[1][k] = std::max(box[1][k], p[k]);
    }
  return box;
}

/// Returns for each component whether it has a volume: whether it is closed and its faces agree in direction.
std::vector<bool> pieces_with_volume(const MeshFile& mesh, const meshops::Orientation& orientation) {
  std::vector<bool> have(orientation.pieces.size());
  for (std::size_t p = 0; p < have.size(); ++p)
    have[p] = orientation.pieces[p].closed && orientation.pieces[p].orientable;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f)
    if (orientation.piece[f] != meshops::Orientation::none && orientation.reversed[f])
      have[orientation.piece[f]] = false;
  return have;
}

}  // namespace

Measures measure(const MeshFile& mesh) {
  Measures result;
  if (mesh.positions.empty()) return result;
  result.box = box_of(mesh.positions);
  const auto& [low, high] = *result.box;
  const Vector middle = {low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2, low[2] / 2 + high[2] / 2};
  const meshops::Orientation orientation = meshops::orient(mesh.soup, until_interrupted());
  const std::vector<bool> has_volume = pieces_with_volume(mesh, orientation);
  Sum area, volume;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const std::uint32_t piece = orientation.piece[f];
    for_each_fan_triangle(mesh.soup.face(f), mesh.positions, [&](const std::array<std::uint32_t, 3>& triangle) {
      const Vector &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]], &c = mesh.positions[triangle[2]];
      const Vector normal = cross(difference(b, a), difference(c, a));
      area.add(std::hypot(normal[0], normal[1], normal[2]) / 2);
      if (piece == meshops::Orientation::none || !has_volume[piece]) return;
      const Vector from = difference(a, middle);
      for (std::size_t k = 0; k < 3; ++k) volume.add(from[k] * normal[k] / 6);
    });
  }
  result.area = area.value();
  if (std::find(has_volume.begin(), has_volume.end(), true) != has_volume.end()) result.volume = volume.value();
  return result;
}

}  // namespace rbpa::app
