#include "rbpa/plane/tile/circumradius_filter.h"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/plane/tile/circumradius_filter.cpp"
#include <hwy/foreach_target.h>
// Included last: the code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/plane/tile/circumradius_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void filter_on(const TileCoordinates& at, const LocalFront& front, double alpha, CircumradiusFilter* filtered) {
  using D = hn::CappedTag<float, LocalFront::padding>;
  const D d;
  const hn::RebindToSigned<D> di;
  const hn::Rebind<LocalFront::Index, D> dn;
  using V = hn::Vec<D>;

  constexpr double max_factor = 0x1p30;  // a larger factor excludes nothing either
  const double scaled = alpha * at.scale, exact_factor = 4 * scaled * scaled;
  const bool is_exact = exact_factor < max_factor;
  const V factor = hn::Set(d, static_cast<float>(std::min(exact_factor, max_factor)));
  const auto last = hn::Set(di, static_cast<std::int32_t>(at.x.size() - 1));

  alignas(64) std::int32_t results[LocalFront::padding];
  for (std::size_t t = 0; t < front.triangles(); t += hn::Lanes(d)) {
    hn::Vec<decltype(dn)> a, b, c, again;
    hn::LoadInterleaved4(dn, front.corners() + 4 * t, a, b, c, again);
    const auto coordinates = [&](auto corner, V& x, V& y) {
      const auto i = hn::Min(hn::PromoteTo(di, corner), last);  // entries after the last triangle are undefined
      x = hn::GatherIndex(d, at.x.data(), i);
      y = hn::GatherIndex(d, at.y.data(), i);
    };
    V ax, ay, bx, by, cx, cy;
    coordinates(a, ax, ay);
    coordinates(b, bx, by);
    coordinates(c, cx, cy);
    const auto is = [&](auto mask, CircumradiusFilter word) {
      return hn::IfThenElseZero(hn::RebindMask(di, mask), hn::Set(di, static_cast<std::int32_t>(word)));
    };
    const auto [inside, outside, cross] = filter_circumradius(d, ax, ay, bx, by, cx, cy, factor);
    hn::Store(hn::Or(is(inside, CircumradiusFilter::inside),
                     is(hn::Not(hn::Or(inside, outside)), CircumradiusFilter::uncertain)),
              di, results);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) filtered[t + i] = static_cast<CircumradiusFilter>(results[i]);
  }
  if (!is_exact)
    std::replace(filtered, filtered + front.triangles(), CircumradiusFilter::outside, CircumradiusFilter::uncertain);
}

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa {

HWY_EXPORT(filter_on);

void filter_circumradii(const TileCoordinates& at, const LocalFront& front, double alpha,
                        std::vector<CircumradiusFilter>& filtered) {
  const std::size_t size = front.triangles() + LocalFront::padding;
  if (filtered.size() < size) filtered.resize(size);
  HWY_DYNAMIC_DISPATCH(filter_on)(at, front, alpha, filtered.data());
}

}  // namespace rbpa
#endif
