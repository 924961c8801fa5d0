#include "meshops/front/boundary_curve.h"

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/reach.h"

namespace meshops {

BoundaryCurve::BoundaryCurve(const Connectivity& mesh, Halfedge through) : mesh_(&mesh), through_(through) {
  require(is_live(mesh, through) && mesh.is_boundary(through), "BoundaryCurve: halfedge ", through.idx(),
          " is not a boundary halfedge");
}

std::size_t BoundaryCurve::length() const {
  std::size_t edges = 0;
  for ([[maybe_unused]] const Halfedge h : *this) ++edges;
  return edges;
}

bool BoundaryCurve::contains(Halfedge h) const { return on_same_curve(*mesh_, through_, h); }

std::optional<BoundaryCurve> boundary_curve_at(const Connectivity& mesh, Vertex v) {
  require(is_live(mesh, v), "boundary_curve_at: vertex ", v.idx(), " does not exist or is deleted");
  if (mesh.is_isolated(v) || !mesh.is_boundary(v)) return std::nullopt;
  return BoundaryCurve(mesh, mesh.halfedge_handle(v));
}

std::vector<BoundaryCurve> boundary_curves(const Connectivity& mesh) {
  std::vector<BoundaryCurve> curves;
  std::vector<bool> seen(mesh.n_halfedges(), false);
  for_each_halfedge(mesh, [&](Halfedge h) {
    if (seen[static_cast<std::size_t>(h.idx())] || !mesh.is_boundary(h)) return;
    curves.emplace_back(mesh, h);
    for (const Halfedge on_curve : curves.back()) seen[static_cast<std::size_t>(on_curve.idx())] = true;
  });
  return curves;
}

}  // namespace meshops
