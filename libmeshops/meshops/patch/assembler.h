// What:   makes a mesh of patches of triangles: gluing in bulk.
// Law:    the mesh equals, up to handles, the mesh that Front::create() makes of the same triangles.
// How:    place() gives one patch after another its place, and decides all that depends on other patches; fill() writes
//         the rest, nearly all of the work, and can run in parallel. Three phases, each with a type: PatchAssembler
//         lays patches, join() returns AssembledPatches, and these become a mesh or a Front.
// Cost:   linear; about the time it takes to write the mesh.
// Source: docs/explanation/architecture.md, section 10.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/patch/assembled.h"
#include "meshops/patch/outline.h"
#include "meshops/patch/patch.h"
#include "meshops/patch/placement.h"
#include "meshops/patch/seams.h"
#include "meshops/patch/site_vertices.h"

namespace meshops {

/// Builds a mesh of patches, which are laid in any order. An open side of a patch is glued to the open side of another
/// patch that runs between the same sites in the opposite direction.
/// Requires: the triangles of all patches form an oriented complex, and their corners are below the number of sites;
///           a side is marked `nothing` only if no patch has a triangle across; a site around which triangles close has
///           no other fan, as is always the case in the plane; no other code changes the mesh until join(). Not
///           checked.
class MESHOPS_API PatchAssembler {
 public:
  /// Adds `sites` isolated vertices to an empty mesh, vertex i on site i. Keeps a reference to the mesh.
  /// Requires: the mesh has no vertices. Throws ContractViolation.
  PatchAssembler(Connectivity& mesh, std::size_t sites);

  /// Returns the number of faces laid so far.
  std::size_t faces() const { return faces_; }

  /// Lays a patch. Throws ContractViolation when survey() does; the mesh is then unchanged. Cost: linear in the patch.
  void lay(const Patch& patch);
  /// Lays a patch whose outline is known. Requires and throws as place(). Cost: linear in the patch.
  void lay(const Patch& patch, const Outline& outline);

  // Threads can share the work of lay(): survey() computes the outline of a patch, unless the caller knows it; place()
  // gives the patch its place; fill() writes its triangles. place() is called for one patch after another, in the order
  // in which elements are to be numbered. Surveys and fills may run in parallel with each other and with place(),
  // provided that reserve() made room for all patches.

  /// Reserves memory for a mesh of `edges` edges and `faces` faces, those of the patches laid before included.
  void reserve(std::size_t edges, std::size_t faces);
  /// Decides the place of a patch, and writes it to `placement`.
  /// Requires: `outline` is what survey() computes of `patch`. Of this, only the numbers of sides are checked: throws
  ///           ContractViolation when they differ; the mesh is then unchanged.
  /// Cost:     linear in the sides at the rim and at the holes of the patch.
  void place(const Patch& patch, const Outline& outline, Placement& placement);
  /// Writes the triangles of a patch; `placement` can then serve another patch.
  /// Requires: place() was called with the same arguments. Not checked. Cost: linear in the patch.
  void fill(const Patch& patch, const Outline& outline, Placement& placement);

  /// Ends the laying of patches: every fan gets a vertex of its own, and sides to which nothing was glued become
  /// boundary halfedges. The mesh is sound afterwards.
  /// Requires: every patch that was placed has been filled. Not checked.
  /// Cost: linear in the open sides of all patches, the fans at them, and all further fans beyond the first at each
  ///       site.
  AssembledPatches join() &&;

 private:
  /// Side of a patch on whose other side nothing lies yet.
  struct Rim {
    Halfedge boundary;
    Site to;  // the end of the halfedge
  };
  /// The sides of patches beyond which nothing lies.
  struct Holes {
    std::vector<std::array<int, 2>> edges;  // ranges: the first edge, and one past the last
    std::vector<bool> has_vertex;           // for each site, whether a fan between holes uses its vertex
    std::vector<Halfedge> into;             // for each further vertex, a boundary halfedge that ends there
    std::vector<Halfedge> loose;            // boundary halfedges whose successor another patch decides
  };
  void place_holes(const Patch& patch, const Outline& outline, Placement& placement);
  void fill_holes(const Patch& patch, const Outline& outline, Placement& placement);
  Halfedge next_on_boundary(Halfedge boundary) const;
  void close_fan(Halfedge boundary);
  Vertex further_vertex(Site s, Halfedge into);

  Connectivity& mesh_;
  SiteVertices vertices_;
  std::size_t edges_ = 0;  // number of edges in use; the mesh may have more
  std::size_t faces_ = 0;
  Seams<Rim> rims_;  // each listed at the site that its boundary halfedge leaves
  Holes holes_;
  Outline outline_;  // outline of the patch being laid
  Placement placement_;
};

}  // namespace meshops
