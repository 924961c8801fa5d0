#include "rbpa/tile/within_alpha.h"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/tile/within_alpha.cpp"
#include <hwy/foreach_target.h>
// After it: what follows is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/tile/within-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void compare(const TileCoordinates& at, const LocalFront& front, double alpha, Within* within) {
  using D = hn::CappedTag<float, LocalFront::padding>;
  const D d;
  const hn::RebindToSigned<D> di;
  const hn::Rebind<LocalFront::Index, D> dn;
  using V = hn::Vec<D>;

  constexpr double most = 0x1p30;  // a larger one tells as little: nothing is above it
  const double scaled = alpha * at.scale, exact_factor = 4 * scaled * scaled;
  const bool is_least = exact_factor < most;
  const V factor = hn::Set(d, static_cast<float>(std::min(exact_factor, most)));
  const auto last = hn::Set(di, static_cast<std::int32_t>(at.x.size() - 1));

  alignas(64) std::int32_t verdict[LocalFront::padding];
  for (std::size_t t = 0; t < front.triangles(); t += hn::Lanes(d)) {
    hn::Vec<decltype(dn)> a, b, c, again;
    hn::LoadInterleaved4(dn, front.corners() + 4 * t, a, b, c, again);
    const auto coordinates = [&](auto corner, V& x, V& y) {
      const auto i = hn::Min(hn::PromoteTo(di, corner), last);  // there may be anything behind the last triangle
      x = hn::GatherIndex(d, at.x.data(), i);
      y = hn::GatherIndex(d, at.y.data(), i);
    };
    V ax, ay, bx, by, cx, cy;
    coordinates(a, ax, ay);
    coordinates(b, bx, by);
    coordinates(c, cx, cy);
    const auto is = [&](auto mask, Within word) {
      return hn::IfThenElseZero(hn::RebindMask(di, mask), hn::Set(di, static_cast<std::int32_t>(word)));
    };
    const auto [yes, no, cross] = judge(d, ax, ay, bx, by, cx, cy, factor);
    hn::Store(hn::Or(is(yes, Within::yes), is(hn::Not(hn::Or(yes, no)), Within::perhaps)), di, verdict);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) within[t + i] = static_cast<Within>(verdict[i]);
  }
  if (!is_least) std::replace(within, within + front.triangles(), Within::no, Within::perhaps);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace rbpa
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa {

HWY_EXPORT(compare);

void within_alpha(const TileCoordinates& at, const LocalFront& front, double alpha, std::vector<Within>& within) {
  if (within.size() < front.triangles() + LocalFront::padding) within.resize(front.triangles() + LocalFront::padding);
  HWY_DYNAMIC_DISPATCH(compare)(at, front, alpha, within.data());
}

}  // namespace rbpa
#endif
