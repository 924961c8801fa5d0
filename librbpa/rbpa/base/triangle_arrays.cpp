#include "rbpa/base/triangle_arrays.h"

#include <algorithm>
#include <string>

#include "meshops/core/contract.h"

namespace rbpa {
namespace {

/// Returns whether the neighbor of triangle t across from corner k has that side of t in the opposite direction, and
/// names t as its own neighbor there; true if there is no neighbor.
bool is_linked(const TriangleArrays& arrays, std::size_t t, std::size_t k) {
  const std::uint32_t other = arrays.neighbors[t][k];
  if (other == TriangleArrays::none) return true;
  if (other >= arrays.triangles.size()) return false;
  const auto& corners = arrays.triangles[t];
  const auto& beyond = arrays.triangles[other];
  for (std::size_t j = 0; j < 3; ++j)
    if (beyond[(j + 1) % 3] == corners[(k + 2) % 3] && beyond[(j + 2) % 3] == corners[(k + 1) % 3])
      return arrays.neighbors[other][j] == t;
  return false;
}

bool is_triangle(const Triangle& corners, std::size_t points) {
  const auto& [a, b, c] = corners;
  return std::max({a, b, c}) < points && a != b && b != c && c != a;
}

}  // namespace

void require_linked(const TriangleArrays& arrays, std::size_t points, const GoOn& go_on) {
  if (arrays.neighbors.empty() && !arrays.triangles.empty())
    throw meshops::ContractViolation("neighbors: found none for " + std::to_string(arrays.triangles.size()) +
                                     " triangles, expected a row for each (alpha_complex() fills them in with the "
                                     "option neighbors)");
  meshops::require_one_each("neighbors", arrays.neighbors.size(), "rows", arrays.triangles.size(), "triangles");
  for (std::size_t t = 0; t < arrays.triangles.size(); ++t) {
    if (t % 65536 == 0) stop_if_cancelled(go_on);
    if (const auto& [a, b, c] = arrays.triangles[t]; !is_triangle(arrays.triangles[t], points))
      throw meshops::ContractViolation("triangle " + std::to_string(t) + ": found corners " + std::to_string(a) + ", " +
                                       std::to_string(b) + " and " + std::to_string(c) +
                                       ", expected three different indices of points, below " + std::to_string(points));
    for (std::size_t k = 0; k < 3; ++k)
      if (!is_linked(arrays, t, k))
        throw meshops::ContractViolation("triangle " + std::to_string(t) + ": neighbor " + std::to_string(k) +
                                         " is not the triangle across the side opposite corner " + std::to_string(k));
  }
}

}  // namespace rbpa
