#include "rbpa/space/persistence/pairing/curve_order.h"

#include <algorithm>
#include <utility>

#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/insertion/spatial_order.h"

namespace rbpa::space {

CurveOrder::CurveOrder(std::span<const Point3> points, Threads& threads, const Checkpoint& checkpoint) {
  std::vector<Point3> copy;
  index_ = order_on_curve(points, scaled(points, spread(points), copy), threads, checkpoint);
}

void CurveOrder::rename_corners(Threads& threads, SolidFiltration& filtration) const {
  Solid& delaunay = filtration.delaunay;
  for (auto& row : delaunay.simplices)
    for (std::uint32_t& corner : row) corner = index_[corner];
  for (std::uint32_t& point : delaunay.isolated) point = index_[point];
  std::sort(delaunay.isolated.begin(), delaunay.isolated.end());
  for (Duplicate& duplicate : delaunay.duplicates) duplicate = {index_[duplicate.index], index_[duplicate.stands_for]};
  std::sort(delaunay.duplicates.begin(), delaunay.duplicates.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.index < b.index; });
  for_each_part(threads, filtration.triangles.size(), 1u << 14, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      auto& corners = filtration.triangles[i];
      auto& across = filtration.edges_of[i];
      for (std::uint32_t& corner : corners) corner = index_[corner];
      for (const auto& [k, l] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 1u)})
        if (corners[k] > corners[l]) {
          std::swap(corners[k], corners[l]);
          std::swap(across[k], across[l]);
        }
    }
  });
  for (auto& [a, b] : filtration.edges) {
    a = index_[a];
    b = index_[b];
    if (a > b) std::swap(a, b);
  }
  if (filtration.point_alpha.empty()) return;
  std::vector<double> point_alpha(index_.size());
  for (std::size_t i = 0; i < index_.size(); ++i) point_alpha[index_[i]] = filtration.point_alpha[i];
  filtration.point_alpha = std::move(point_alpha);
}

}  // namespace rbpa::space
