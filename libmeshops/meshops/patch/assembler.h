// What:   makes a mesh of patches: gluing in bulk.
// Law:    the mesh is that which Front::create() makes of the same triangles, up to handles.
// How:    patches are placed one after another, which settles what depends on others, and filled in, which is nearly all
//         and can be done beside. Three phases, each of a type: PatchAssembler lays patches, join() makes
//         AssembledPatches of it, and these are a mesh, or a Front to be advanced.
// Cost:   linear; about the time to write the mesh.
// Source: docs/front.md, section 5.
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

/// Patches are laid beside each other, in any order; an open side is glued to the side of another patch on the same
/// sites.
/// Requires: the triangles of all patches are those of a complex; a site around which they close has no other fan, as it
///           is in the plane. Not checked.
class MESHOPS_API PatchAssembler {
 public:
  /// Adds `sites` isolated vertices to an empty mesh, vertex i on site i.
  /// Requires: the mesh has no vertices. Throws ContractViolation.
  PatchAssembler(Connectivity& mesh, std::size_t sites);

  /// The number of faces laid so far.
  std::size_t faces() const { return faces_; }

  /// Lays a patch. Cost: linear in it.
  void lay(const Patch& patch);
  /// The same with a given outline.
  void lay(const Patch& patch, const Outline& outline);

  /// lay() in three steps, so that threads can share the work: survey(), where the outline is not given; place(), one
  /// patch after another, in the order that is to give elements their numbers; and fill(), which may run beside other
  /// fills, surveys and place(), provided that reserve() made room for all patches.
  /// Requires: the outline of the patch; to fill, that it was placed, with the same arguments.
  /// Cost:     place() is linear in the sides at the rim of the patch and its holes, fill() in the patch.
  void reserve(std::size_t edges, std::size_t faces);
  void place(const Patch& patch, const Outline& outline, Placement& placement);
  void fill(const Patch& patch, const Outline& outline, Placement& placement);

  /// Ends the laying of patches: every fan gets a vertex of its own, and sides to which nothing was glued become boundary
  /// halfedges. The mesh is sound then.
  /// Cost: linear in the open sides of all patches, the fans at them, and all other fans but one at each site.
  AssembledPatches join() &&;

 private:
  /// A side of a patch at whose other side nothing lies yet.
  struct Rim {
    Halfedge boundary;
    Site to;  // where it ends
  };
  /// Of sides of patches beyond which there is nothing.
  struct Holes {
    std::vector<std::array<int, 2>> edges;  // the first, and one behind the last
    std::vector<bool> has_vertex;           // of each site: a fan between holes has it for its vertex
    std::vector<Halfedge> into;             // of each further vertex, a boundary halfedge that ends there
    std::vector<Halfedge> loose;            // boundary halfedges that end where another patch decides what follows
  };
  void place_holes(const Patch& patch, const Outline& outline, Placement& placement);
  void fill_holes(const Patch& patch, const Outline& outline, Placement& placement);
  Halfedge next_on_boundary(Halfedge boundary) const;
  void close_fan(Halfedge boundary);
  Vertex further_vertex(Site s, Halfedge into);

  Connectivity& mesh_;
  SiteVertices vertices_;
  std::size_t edges_ = 0;  // in use; there may be more in the mesh
  std::size_t faces_ = 0;
  Seams<Rim> rims_;  // each at the site that its boundary halfedge leaves
  Holes holes_;
  Outline outline_;  // of the patch being laid
  Placement placement_;
};

}  // namespace meshops
