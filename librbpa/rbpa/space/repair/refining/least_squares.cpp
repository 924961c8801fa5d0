#include "rbpa/space/repair/refining/least_squares.h"

#include <Eigen/SparseCholesky>

namespace rbpa::space {

std::optional<std::vector<Vector3<double>>> LeastSquares::solution() const {
  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Entry& e : entries_) entries.emplace_back(static_cast<int>(e.row), static_cast<int>(e.column), e.factor);
  Matrix rows(static_cast<Eigen::Index>(known_.size()), static_cast<Eigen::Index>(places_));
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
