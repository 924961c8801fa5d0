// What: where a triangle goes in a front.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "meshops/front/refusal.h"
#include "meshops/handle/insert_triangle.h"
#include "meshops/patch/site.h"

namespace meshops {

class Front;

/// Where a triangle goes, and what it will be glued to; or why it cannot go there. What Front::fit() returns holds until a
/// triangle is attached or detached. A caller that has determined corners and sides itself can construct one of them, and
/// then ensures that no triangle comes twice and that the sides glued are those meant.
struct Fit {
  explicit Fit(const std::array<Site, 3>& sites) : corners(sites) {}

  std::array<Site, 3> corners;
  TriangleSides sides;  ///< those that are boundary halfedges already; `corner` is not looked at
  std::optional<Refusal> refusal;

 private:
  friend class Front;
  Fit(const std::array<Site, 3>& sites, const Front& front, std::size_t revision)
      : corners(sites), front_(&front), revision_(revision) {}

  const Front* front_ = nullptr;  // that made it; none where it was made by hand
  std::size_t revision_ = 0;      // of the front then
};

}  // namespace meshops
