// What: the place of a triangle in a front: the result of Front::fit() and the argument of Front::insert().
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "meshops/front/refusal.h"
#include "meshops/handle/insert_triangle.h"
#include "meshops/patch/site.h"

namespace meshops {

class Front;

/// Place of a triangle: its corners and the sides to glue, or the reason why the triangle cannot be inserted. The
/// result of Front::fit() is valid until a triangle is inserted or detached. A caller that knows corners and sides may
/// construct a Fit; the caller must then ensure that no triangle is inserted twice and that the right sides are glued.
struct Fit {
  /// Makes the place of a triangle on these corners, with no side glued.
  explicit Fit(const std::array<Site, 3>& sites) : corners(sites) {}

  std::array<Site, 3> corners;     ///< counter-clockwise; the numbers that follow the last site stand for new sites
  TriangleSides sides;             ///< the boundary halfedges that become sides; `corner` is not read
  std::optional<Refusal> refusal;  ///< why the triangle cannot be inserted; nothing if it can

 private:
  friend class Front;
  Fit(const std::array<Site, 3>& sites, const Front& front, std::size_t revision)
      : corners(sites), front_(&front), revision_(revision) {}

  const Front* front_ = nullptr;  // the front that made this fit; null if a caller constructed it
  std::size_t revision_ = 0;      // the revision of the front when it made this fit
};

}  // namespace meshops
