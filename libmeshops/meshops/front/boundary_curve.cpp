#include "meshops/front/boundary_curve.h"

#include "meshops/core/contract.h"

namespace meshops {

BoundaryCurve::BoundaryCurve(const Connectivity& mesh, Halfedge through) : mesh_(&mesh), through_(through) {
  require(
      through.is_valid() && static_cast<std::size_t>(through.idx()) < mesh.n_halfedges() && mesh.is_boundary(through),
      "BoundaryCurve: not a boundary halfedge");
}

std::size_t BoundaryCurve::length() const {
  std::size_t edges = 0;
  for ([[maybe_unused]] const Halfedge h : *this) ++edges;
  return edges;
}

std::vector<BoundaryCurve> boundary_curves(const Connectivity& mesh) {
  std::vector<BoundaryCurve> curves;
  std::vector<bool> seen(mesh.n_halfedges(), false);
  for (int i = 0; i < static_cast<int>(mesh.n_halfedges()); ++i) {
    const Halfedge h(i);
    if (seen[static_cast<std::size_t>(i)] || !mesh.is_boundary(h)) continue;
    if (mesh.has_edge_status() && mesh.status(mesh.edge_handle(h)).deleted()) continue;
    curves.emplace_back(mesh, h);
    for (const Halfedge on_curve : curves.back()) seen[static_cast<std::size_t>(on_curve.idx())] = true;
  }
  return curves;
}

}  // namespace meshops
