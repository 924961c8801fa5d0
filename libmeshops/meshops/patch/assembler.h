// What:   makes a mesh of patches of triangles, which it glues together in bulk.
// Law:    the mesh equals, up to handles, the mesh that Front::create() makes of the same triangles.
// How:    place() is called for one patch after another, and decides everything that depends on other patches. fill()
//         writes the rest of a patch, nearly all of the work, and can run in parallel. PatchAssembler lays patches;
//         join() returns AssembledPatches, which becomes a complete mesh or a Front.
// Cost:   linear in the mesh; about the time that it takes to write the mesh.
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

/// Builder of a mesh from patches, which may be laid in any order. An open side of a patch is glued to the open side of
/// another patch that runs between the same sites in the opposite direction.
/// Requires: the triangles of all patches form an oriented complex; their corners are below the number of sites; a side
///           is marked Patch::nothing only if no patch has a triangle across it; a site around which triangles close
///           has no other fan, as always in the plane; no other code changes the mesh until join(). Not checked.
class MESHOPS_API PatchAssembler {
 public:
  /// Adds `sites` isolated vertices to a mesh without vertices, vertex i on site i. Keeps a reference to the mesh.
  /// Requires: the mesh has no vertices. Throws ContractViolation.
  PatchAssembler(Connectivity& mesh, std::size_t sites);

  /// Returns the number of faces of all patches that were placed.
  std::size_t faces() const { return faces_; }

  /// Lays a patch. Throws ContractViolation if survey() does; the mesh is then unchanged. Cost: linear in the patch.
  void lay(const Patch& patch);
  /// Lays a patch whose outline is known. Requires and throws as place() does. Cost: linear in the patch.
  void lay(const Patch& patch, const Outline& outline);

  // Threads can share the work of lay(): survey() computes the outline of a patch, unless the caller knows the outline;
  // place() decides the place of the patch in the mesh; fill() writes its triangles. place() is called for one patch
  // after another, in the order in which elements are to be numbered. If reserve() made room for all patches, calls of
  // survey() and fill() may run in parallel with each other and with place().

  /// Reserves memory for a mesh of `edges` edges and `faces` faces, including those of patches laid before.
  void reserve(std::size_t edges, std::size_t faces);
  /// Decides the place of a patch, and writes the place to `placement`.
  /// Requires: `outline` is the outline that survey() computes of `patch`. Throws ContractViolation, with the mesh
  ///           unchanged, unless `across` has an entry for each triangle and `next_hole` one for each hole, and the
  ///           sides in neither `rim` nor `holes`, which are glued in pairs, are even in number. Nothing else is
  ///           checked.
  /// Cost:     linear in the sides at the rim and at the holes, and in the sides that wait at their sites. The mesh
  ///           also grows by the elements of the patch, which takes less time than fill().
  void place(const Patch& patch, const Outline& outline, Placement& placement);
  /// Writes the triangles of a patch. Afterwards, `placement` can serve another patch.
  /// Requires: place() was called with the same arguments. Not checked. Cost: linear in the patch.
  void fill(const Patch& patch, const Outline& outline, Placement& placement);

  /// Ends the laying of patches: gives every fan its own vertex, and links the boundary halfedges beyond the sides to
  /// which no side was glued. The mesh is sound afterwards, but not before.
  /// Requires: fill() was called for every patch that place() placed. Not checked.
  /// Cost: linear in the open sides of all patches and the fans at these sides; also in the sites, if a site has
  ///       several fans.
  AssembledPatches join() &&;

 private:
  /// Open side of a patch to which no other patch has been glued yet.
  struct Rim {
    Halfedge boundary;
    Site to;  // the end of the halfedge
  };
  /// Data on the sides of patches that are marked Patch::nothing.
  struct Holes {
    std::vector<std::array<int, 2>> edges;  // ranges [first, end) of edges
    std::vector<bool> has_vertex;           // for each site, whether a fan between holes uses the vertex of the site
    std::vector<Halfedge> into;             // for each further vertex, a boundary halfedge that ends at the vertex
    std::vector<Halfedge> loose;            // boundary halfedges whose next boundary halfedge depends on another patch
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
  Seams<Rim> rims_;  // each side is listed at the site where its boundary halfedge starts
  Holes holes_;
  Outline outline_;  // outline of the patch that lay() is laying
  Placement placement_;
};

}  // namespace meshops
