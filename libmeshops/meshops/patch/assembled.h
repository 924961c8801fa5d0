// What: the mesh that PatchAssembler makes of patches, with its open sides; a Front can continue it.
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
/// completes the mesh, or a Front continues it; both leave this object empty. Both throw ContractViolation when it is
/// empty already (unless it never had a site), or when elements were added to the mesh or removed from it since
/// (marking them deleted is not noticed). The object refers to the mesh, and can be moved, not copied or assigned.
class MESHOPS_API AssembledPatches {
 public:
  const Connectivity& mesh() const { return mesh_; }
  /// Returns the number of triangles.
  std::size_t faces() const { return mesh_.n_faces(); }
  /// Returns the number of sites: that of the PatchAssembler, or 0 when this object is empty.
  std::size_t sites() const { return vertices_.sites(); }
  /// Returns whether no triangle has a corner on this site. Throws ContractViolation when the site does not exist.
  bool is_free(Site s) const { return vertices_.is_free(s); }
  /// Returns the site on which a vertex stands. Throws ContractViolation when the vertex does not exist.
  Site site(Vertex v) const { return vertices_.site(v); }

  /// Removes the vertices without triangles and renumbers the others, which keep their order and properties.
  /// Returns: the site of each vertex of the mesh. Cost: linear.
  std::vector<Site> finish() &&;

 private:
  friend class PatchAssembler;
  friend class Front;
  AssembledPatches(Connectivity& mesh, SiteVertices vertices)
      : mesh_(mesh), counts_(ElementCounts::of(mesh)), vertices_(std::move(vertices)) {}
  /// Returns the mesh. Requires: the object is not empty, and the mesh is as it was assembled. Throws
  /// ContractViolation.
  Connectivity& unchanged() const;

  Connectivity& mesh_;
  ElementCounts counts_;
  SiteVertices vertices_;
  std::vector<Halfedge> open_;             // boundary halfedges beyond which a further patch could lie
  std::vector<std::array<int, 2>> holes_;  // ranges [first, end) of edges; halfedge 1 of each edge stays boundary
};

}  // namespace meshops
