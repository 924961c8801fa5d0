// What: the mesh that PatchAssembler makes of patches, with its open sides. A Front can continue the mesh.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/element_counts.h"
#include "meshops/patch/site_vertices.h"

namespace meshops {

/// Sound mesh that PatchAssembler made of patches, with an isolated vertex for each site without triangles. finish()
/// completes the mesh, or a Front continues it; both leave this object empty. Both throw ContractViolation if the
/// object is empty already (unless it never had a site), or if other code has added elements to the mesh or removed
/// some since join(); marking elements deleted is not noticed. The object refers to the mesh. It can be moved, but
/// neither copied nor assigned.
class MESHOPS_API AssembledPatches {
 public:
  const Connectivity& mesh() const { return mesh_; }
  /// Returns the number of triangles.
  std::size_t faces() const { return mesh_.n_faces(); }
  /// Returns the number of sites of the PatchAssembler, or 0 if this object is empty.
  std::size_t sites() const { return vertices_.sites(); }
  /// Returns whether no triangle has a corner on this site. Throws ContractViolation if the site does not exist.
  bool is_free(Site s) const { return vertices_.is_free(s); }
  /// Returns the site on which a vertex stands. Throws ContractViolation if the vertex does not exist.
  Site site(Vertex v) const { return vertices_.site(v); }

  /// Removes the vertices without triangles and renumbers the others, which keep their order and properties.
  /// Returns: the site of each remaining vertex. Cost: linear in the mesh.
  std::vector<Site> finish() &&;

 private:
  friend class PatchAssembler;
  friend class Front;
  AssembledPatches(Connectivity& mesh, SiteVertices vertices)
      : mesh_(mesh), counts_(ElementCounts::of(mesh)), vertices_(std::move(vertices)) {}
  /// Returns the mesh. Requires: the object is not empty, and no element was added to the mesh or removed from it since
  /// join(). Throws ContractViolation.
  Connectivity& unchanged() const;

  Connectivity& mesh_;
  ElementCounts counts_;
  SiteVertices vertices_;
  std::vector<Halfedge> open_;             // boundary halfedges beyond which a further patch could lie
  std::vector<std::array<int, 2>> holes_;  // ranges [first, end) of edges whose halfedge 1 stays boundary
};

}  // namespace meshops
