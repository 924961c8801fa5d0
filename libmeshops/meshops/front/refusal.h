// What: the reasons for which a front refuses to insert or to detach a triangle.
#pragma once

#include <string>
#include <string_view>

#include "meshops/core/api.h"
#include "meshops/patch/site.h"

namespace meshops {

/// Kind of a refusal. The comment of each kind names the fields of Refusal that the kind uses.
enum class RefusalKind {
  no_boundary_halfedge,  ///< halfedge `index` does not exist, is deleted, or has a face
  no_such_site,          ///< `site` neither exists nor is one of the next new sites
  corner_repeated,       ///< two corners of the triangle are `site`
  site_closed,           ///< every fan at `site` is a closed ring of faces, so that no further fan may begin there
  side_taken,            ///< a face already lies on the left of the edge from `site` to `to`
  no_such_face,          ///< face `index` does not exist or is deleted
  no_triangle,           ///< face `index` is not a triangle
  not_at_front,          ///< no side of face `index` is on the boundary
  triangle_there,        ///< face `index` has the same corners in the same order; `site` and `to` are two of them
  no_status              ///< the mesh lacks status of some kind, so that face `index` cannot be marked deleted
};

/// Reason why a front refuses. Fields that the kind does not use keep their defaults.
struct Refusal {
  RefusalKind kind;
  Site site = 0;   ///< a corner of the triangle
  Site to = 0;     ///< the corner after `site`
  int index = -1;  ///< index of the halfedge or the face
  friend bool operator==(const Refusal&, const Refusal&) = default;
};

/// Returns the name of a kind in words, for example "side taken".
MESHOPS_API std::string_view name(RefusalKind kind);

/// Returns a text for people, for example "a face already lies on the left of the edge from site 3 to site 7".
MESHOPS_API std::string describe(const Refusal& refusal);

}  // namespace meshops
