// What: finds edges, triangles and places for triangles on a mesh by sites.
// Law:  nothing is changed. Unless the caller decides which sides are glued, a triangle that would put a second edge
//       between two sites is refused.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/front/fit.h"
#include "meshops/patch/site_vertices.h"

namespace meshops::detail {

/// Lookups by sites. Keeps references to the mesh and the map.
/// Requires: halfedges in arguments exist; the sides of a fit are sought only after check_corners(); not checked.
class MESHOPS_API Fitting {
 public:
  Fitting(const Connectivity& mesh, const SiteVertices& vertices) : mesh_(mesh), vertices_(vertices) {}

  Site start(Halfedge h) const { return vertices_.site(mesh_.from_vertex_handle(h)); }
  Site end(Halfedge h) const { return vertices_.site(mesh_.to_vertex_handle(h)); }

  // Front documents the functions of the same names.
  Halfedge edge_between(Site from, Site to) const;
  std::vector<Halfedge> edges_between(Site from, Site to) const;
  Halfedge boundary_between(Site from, Site to) const;
  Face triangle_on(Site a, Site b, Site c) const;

  /// Sets the refusal of `fit` unless the corners are distinct, and exist or are the next new sites.
  void check_corners(Fit& fit) const;
  /// Sets each side of `fit` to the boundary halfedge between its sites, if there is one. Sets the refusal if the sites
  /// of a side have an edge but no such halfedge (side_taken), or if nothing is glued at a corner that has fans, all
  /// closed (site_closed). find_other_sides() does this for sides 1 and 2 only; side 0 must be a boundary halfedge from
  /// corner 0 to corner 1.
  void find_sides(Fit& fit) const;
  void find_other_sides(Fit& fit) const;
  /// Sets the sides of `fit` that are not set yet, for a caller that decides which sides are glued: calls
  /// glues(halfedge, apex) for the boundary halfedges between the sites of a side, until a call returns true. Only sets
  /// the refusal if the triangle exists already.
  template <typename Glues>
  void find_sides(Fit& fit, Glues glues) const;

 private:
  bool is_new(Site s) const { return s >= vertices_.sites(); }
  bool finds_side(Fit& fit, unsigned side) const;
  void refuse_closed(Fit& fit) const;
  void refuse_twice(Fit& fit) const;

  const Connectivity& mesh_;
  const SiteVertices& vertices_;
};

template <typename Glues>
void Fitting::find_sides(Fit& fit, Glues glues) const {
  refuse_twice(fit);
  for (unsigned i = 0; i < 3 && !fit.refusal; ++i) {
    const Site from = fit.corners[i], to = fit.corners[(i + 1) % 3];
    Halfedge& side = fit.sides.side[i];
    if (side.is_valid() || is_new(from) || is_new(to)) continue;
    // Exactly one boundary halfedge leaves the vertex of an open fan.
    for (Vertex v = vertices_.first(from); v.is_valid() && !side.is_valid(); v = vertices_.next(v)) {
      const Halfedge h = mesh_.halfedge_handle(v);
      if (mesh_.is_boundary(h) && end(h) == to && glues(h, fit.corners[(i + 2) % 3])) side = h;
    }
  }
}

}  // namespace meshops::detail
