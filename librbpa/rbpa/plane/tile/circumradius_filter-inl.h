// What: tests which triangles have a circumradius ≤ alpha: compares ab² bc² ca² with 4 α² (ab × ac)², a triangle in
//       each lane. Compiled once for each kind of vector unit: HWY_TARGET_TOGGLE makes an include guard for each kind.
// Law:  for the points in double precision, the triangle of a lane set in `inside` has a circumradius ≤ alpha, and that
//       of a lane set in `outside` a circumradius > alpha; a lane set in neither is undecided.
//       docs/explanation/plane.md, section 10, derives the bounds.
#if defined(RBPA_TILE_CIRCUMRADIUS_FILTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_TILE_CIRCUMRADIUS_FILTER_INL_H_
#undef RBPA_TILE_CIRCUMRADIUS_FILTER_INL_H_
#else
#define RBPA_TILE_CIRCUMRADIUS_FILTER_INL_H_
#endif

#include <hwy/highway.h>

#include "rbpa/plane/tile/coordinates.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Returns the error bound of a component of a difference of two points, if no computed component exceeds `extent`.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE V error_of_difference(D d, V extent) {
  return hn::Set(d, 2 * TileCoordinates::rounding) + hn::Set(d, 1.1f * TileCoordinates::unit_roundoff) * extent;
}

template <typename D>
struct Filtered {
  hn::Mask<D> inside, outside;
  hn::Vec<D> cross;  ///< ab × ac; its sign is right where `inside` is set
};

/// Tests triangles, one in each lane. Requires: `factor` is 4 α² in the tile's scale, at most 2³⁰.
template <typename D, typename V = hn::Vec<D>>
HWY_INLINE Filtered<D> filter_circumradius(D d, V ax, V ay, V bx, V by, V cx, V cy, V factor) {
  const auto set = [&](float value) { return hn::Set(d, value); };
  const V ab_x = bx - ax, ab_y = by - ay, bc_x = cx - bx, bc_y = cy - by, ac_x = cx - ax, ac_y = cy - ay;
  const V ab = ab_x * ab_x + ab_y * ab_y, bc = bc_x * bc_x + bc_y * bc_y, ac = ac_x * ac_x + ac_y * ac_y;
  const V cross = ab_x * ac_y - ab_y * ac_x, area = hn::Abs(cross);
  const V extent = hn::Max(hn::Max(hn::Max(hn::Abs(ab_x), hn::Abs(ab_y)), hn::Max(hn::Abs(bc_x), hn::Abs(bc_y))),
                           hn::Max(hn::Abs(ac_x), hn::Abs(ac_y)));
  const V of_difference = error_of_difference(d, extent);
  const V error = of_difference * (set(8.2f) * extent + set(2.1f) * of_difference);
  const V max_ab = ab + error, max_bc = bc + error, max_ac = ac + error;
  const V sides = ab * bc * ac, radii = factor * (area * area);
  const V bound = set(1.02f) * (error * (max_ab * max_bc + max_bc * max_ac + max_ac * max_ab) +
                                factor * (error * (area + area + error)) +
                                set(5 * TileCoordinates::unit_roundoff) * (sides + radii)) +
                  set(0x1p-90f);
  const V excess = sides - radii;
  return {excess<hn::Neg(bound), excess> bound, cross};
}

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
