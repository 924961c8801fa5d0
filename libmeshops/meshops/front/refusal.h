// What: why a front refuses to insert a triangle, or to detach one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meshops/core/api.h"
#include "meshops/patch/site.h"

namespace meshops {

enum class RefusalKind {
  no_boundary_halfedge,  ///< `index`: there is no such halfedge, or a face lies on it
  no_such_site,          ///< `site`
  corner_repeated,       ///< `site` is two corners of the triangle
  site_closed,           ///< the faces around `site` close, in each of its fans: it is done
  side_taken,            ///< a face already lies on the left of the edge from `site` to `to`
  no_such_face,          ///< `index`
  no_triangle,           ///< face `index` is not a triangle
  not_at_front,          ///< no side of face `index` is on the boundary
  triangle_there,        ///< face `index` has these corners in this order, `site` and `to` two of them
  no_status              ///< the mesh needs status to mark face `index` as deleted
};

struct Refusal {
  RefusalKind kind;
  Site site = 0;
  Site to = 0;
  int index = -1;  ///< of the halfedge or the face
  friend bool operator==(const Refusal&, const Refusal&) = default;
};

MESHOPS_API std::string_view name(RefusalKind kind);

/// For people: "a face already lies on the left of the edge from site 3 to site 7".
MESHOPS_API std::string describe(const Refusal& refusal);

}  // namespace meshops
