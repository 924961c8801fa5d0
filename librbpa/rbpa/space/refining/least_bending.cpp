#include "rbpa/space/refining/least_bending.h"

#include <Eigen/SparseCholesky>
#include <cmath>

namespace rbpa::space {

void BendingRows::add(const Vector3<double>& place, std::uint32_t free, std::span<const BendingNeighbor> neighbors) {
  double sum = 0;
  std::vector<double> weights;
  for (const BendingNeighbor& neighbor : neighbors) {
    const Vector3<double> d = {neighbor.place.x - place.x, neighbor.place.y - place.y, neighbor.place.z - place.z};
    const double distance = std::sqrt(dot(d, d));
    weights.push_back(distance > 0 ? 1 / distance : 0);
    sum += weights.back();
  }
  if (!(sum > 0) || !std::isfinite(sum)) return;
  const auto row = static_cast<std::uint32_t>(known_.size());
  Vector3<double> known{0, 0, 0};
  const auto add_entry = [&](std::uint32_t at, const Vector3<double>& p, double factor) {
    if (at != BendingNeighbor::fixed)
      entries_.push_back({row, at, factor});
    else
      known = {known.x - factor * p.x, known.y - factor * p.y, known.z - factor * p.z};
  };
  for (std::size_t i = 0; i < neighbors.size(); ++i) add_entry(neighbors[i].free, neighbors[i].place, weights[i] / sum);
  add_entry(free, place, -1);
  known_.push_back(known);
}

std::optional<std::vector<Vector3<double>>> BendingRows::least() const {
  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Entry& e : entries_) entries.emplace_back(static_cast<int>(e.row), static_cast<int>(e.column), e.factor);
  Matrix rows(static_cast<Eigen::Index>(known_.size()), static_cast<Eigen::Index>(free_));
  rows.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixX3d known(static_cast<Eigen::Index>(known_.size()), 3);
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Vector3<double>& v = known_[i];
    known.row(static_cast<Eigen::Index>(i)) << v.x, v.y, v.z;
  }
  const Matrix square = rows.transpose() * rows;
  const Eigen::SimplicialLDLT<Matrix> solver(square);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixX3d found = solver.solve(rows.transpose() * known);
  if (solver.info() != Eigen::Success || !found.allFinite()) return std::nullopt;
  std::vector<Vector3<double>> places;
  for (Eigen::Index i = 0; i < found.rows(); ++i) places.push_back({found(i, 0), found(i, 1), found(i, 2)});
  return places;
}

}  // namespace rbpa::space
