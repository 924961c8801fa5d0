#include "rbpa/space/star/find_rings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "rbpa/space/pivot/roll_about_edge.h"
#include "rbpa/space/predicate/ball.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/space/star/find_rings.cpp"
#include <hwy/foreach_target.h>
// After it: what follows is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/space/star/free_region-inl.h"

#ifndef RBPA_SPACE_STAR_FIND_RINGS_ONCE
#define RBPA_SPACE_STAR_FIND_RINGS_ONCE
namespace rbpa::space {

/// For eight bits, the numbers of those that are set and then of the others, four bits each.
inline constexpr std::array<std::uint64_t, 256> in_front = [] {
  std::array<std::uint64_t, 256> all{};
  for (std::uint64_t bits = 0; bits < 256; ++bits) {
    int at = 0;
    for (const std::uint64_t wanted : {1u, 0u})
      for (std::uint64_t lane = 0; lane < 8; ++lane)
        if ((bits >> lane & 1) == wanted) all[bits] |= lane << (4 * at++);
  }
  return all;
}();

/// Points about a site, coordinate by coordinate.
struct Surroundings {
  std::vector<double> x, y, z, square, number;
  std::size_t count = 0;

  void reserve(std::size_t most) {
    if (x.size() >= most) return;
    for (auto* of : {&x, &y, &z, &square, &number}) of->resize(most + most / 2);
  }
};

struct RingFinder::Workspace {
  Surroundings around;     // sites in the cells around one
  Surroundings near, far;  // of one site, what a ball there can touch or hold, as seen from it
  std::vector<std::uint32_t> order;
  double share = 0.25;  // of the square of two radii, within which there are about as many as bound a region
};

}  // namespace rbpa::space
#endif

HWY_BEFORE_NAMESPACE();
namespace rbpa::space {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using rbpa::HWY_NAMESPACE::bits_of;

/// Moves the lanes of set bits to the front. (Where vectors are compressed by the library or the processor, it may take longer
/// than all of the rest.)
template <typename D>
HWY_INLINE auto lanes_in_front(D d, std::uint64_t bits) {
  const hn::RebindToUnsigned<D> du;
  const auto lanes = hn::Shr(hn::Set(du, in_front[bits]), hn::ShiftLeft<2>(hn::Iota(du, 0)));
  return hn::IndicesFromVec(d, hn::And(lanes, hn::Set(du, 7)));
}

/// The points of `around` within two radii of v, v left out: near ones and others, as seen from v.
void look_around(const Surroundings& around, const Point3& v, double farthest, double nearby, Surroundings& near,
                 Surroundings& far) {
  const hn::CappedTag<double, 8> d;
  const auto vx = hn::Set(d, v.x), vy = hn::Set(d, v.y), vz = hn::Set(d, v.z);
  near.reserve(around.count + hn::Lanes(d));
  far.reserve(around.count + hn::Lanes(d));
  near.count = far.count = 0;
  for (std::size_t i = 0; i < around.count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, &around.x[i]) - vx, y = hn::LoadU(d, &around.y[i]) - vy,
               z = hn::LoadU(d, &around.z[i]) - vz, number = hn::LoadU(d, &around.number[i]);
    const auto square = x * x + y * y + z * z;
    const auto is_other = square > hn::Zero(d), is_near = hn::And(is_other, square <= hn::Set(d, nearby)),
               is_far = hn::And(square > hn::Set(d, nearby), square <= hn::Set(d, farthest));
    const auto store = [&](auto mask, Surroundings& to) {
      const std::uint64_t bits = bits_of(d, mask);
      if (bits == 0) return;
      const auto lanes = lanes_in_front(d, bits);
      // Whole vectors are stored, as there is room.
      hn::StoreU(hn::TableLookupLanes(x, lanes), d, &to.x[to.count]);
      hn::StoreU(hn::TableLookupLanes(y, lanes), d, &to.y[to.count]);
      hn::StoreU(hn::TableLookupLanes(z, lanes), d, &to.z[to.count]);
      hn::StoreU(hn::TableLookupLanes(number, lanes), d, &to.number[to.count]);
      hn::StoreU(hn::TableLookupLanes(square, lanes), d, &to.square[to.count]);
      to.count += static_cast<std::size_t>(std::popcount(bits));
    };
    store(is_near, near);
    store(is_far, far);
  }
}

/// The rings of one site, by caps; false where the region is lost.
class RegionSearch {
 public:
  RegionSearch(const Cells& cells, RingFinder::Workspace& workspace) : cells_(cells), w_(workspace) {}

  bool find(Site v, Rings& found) {
    const Surroundings &near = w_.near, &far = w_.far;
    const std::span<const Point3> sites = cells_.sites();
    const auto is_in_ball = [&](std::size_t x, std::size_t y, std::size_t p) {
      return Ball<double>(sites[v], sites[x], sites[y], cells_.radius()).contains(sites[p]);
    };
    const auto take = [&](const Surroundings& of, std::size_t i) {
      return region_.take({{of.x[i], of.y[i], of.z[i]},
                           of.square[i] / 2,
                           std::sqrt(of.square[i]),
                           static_cast<std::size_t>(of.number[i])},
                          is_in_ball);
    };
    region_.begin(cells_.radius());
    sort_near();
    for (std::size_t i = 0; i < near.count && !region_.is_empty(); ++i)
      if (!take(near, w_.order[i])) return false;
    // Where a few corners tell how far anything reaches, all others at once; else those come first that are nearer.
    const double whole = 4 * cells_.radius() * cells_.radius() * (1 + 0x1p-40);
    for (double from = 0, to = w_.share * whole; from < whole && far.count != 0 && !region_.is_empty(); from = to) {
      to = region_.tell_reach(reach_) ? whole : std::min(2 * to, whole);
      if (!take_far(from, to, take)) return false;
    }
    if (!region_.finish(is_in_ball)) return false;
    region_.for_each_cycle([&](std::uint32_t site) { found.points.push_back(site); },
                           [&] { found.points.push_back(Rings::end_of_cycle); });
    return true;
  }

 private:
  /// Those at distances whose squares are above `from` and at most `to`; what is beyond the last one is never looked at.
  template <typename Take>
  bool take_far(double from, double to, Take take) {
    const hn::CappedTag<double, 8> d;
    const Surroundings& far = w_.far;
    for (std::size_t i = 0; i < far.count && !region_.is_empty(); i += hn::Lanes(d)) {
      const auto square = hn::LoadU(d, &far.square[i]);
      std::uint64_t wanted = bits_of(d, hn::And(square > hn::Set(d, from), square <= hn::Set(d, to)));
      if (i + hn::Lanes(d) > far.count) wanted &= (std::uint64_t{1} << (far.count - i)) - 1;
      if (wanted == 0 || (wanted &= reached_of(i)) == 0) continue;
      for (; wanted != 0; wanted &= wanted - 1)
        if (!take(far, i + static_cast<std::size_t>(std::countr_zero(wanted)))) return false;
      region_.tell_reach(reach_);
    }
    return true;
  }

  void sort_near() {
    const Surroundings& near = w_.near;
    w_.order.resize(near.count);
    for (std::uint32_t i = 0; i < near.count; ++i) {
      std::uint32_t at = i;
      for (; at > 0 && near.square[w_.order[at - 1]] > near.square[i]; --at) w_.order[at] = w_.order[at - 1];
      w_.order[at] = i;
    }
  }

  /// Those of the far points from i on that may take something away.
  std::uint64_t reached_of(std::size_t i) const {
    const hn::CappedTag<double, 8> d;
    const Surroundings& far = w_.far;
    const auto x = hn::LoadU(d, &far.x[i]), y = hn::LoadU(d, &far.y[i]), z = hn::LoadU(d, &far.z[i]);
    const auto power = hn::LoadU(d, &far.square[i]) * hn::Set(d, 0.5);
    // The corners are told up to a share of the radius.
    const auto error = (hn::Abs(x) + hn::Abs(y) + hn::Abs(z)) * hn::Set(d, 2 * FreeRegion::max_error * cells_.radius());
    auto most = hn::Set(d, -1.0);
    for (std::size_t k = 0; k < reach_.count; ++k) {
      const auto product =
          hn::MulAdd(hn::Set(d, reach_.x[k]), x,
                     hn::MulAdd(hn::Set(d, reach_.y[k]), y, hn::MulAdd(hn::Set(d, reach_.z[k]), z, error)));
      most = hn::Max(most, hn::NegMulAdd(hn::Set(d, reach_.share[k]), power, product));
    }
    return bits_of(d, most > hn::Zero(d));
  }

  const Cells& cells_;
  RingFinder::Workspace& w_;
  FreeRegion region_;
  FreeRegion::Reach reach_;
};

/// The rings of one site by rolling about each edge. Requires: near holds all points within two radii, far none.
template <typename Real>
void roll_about_all(const Cells& cells, Site v, RingFinder::Workspace& w, Rings& found) {
  const std::span<const Point3> sites = cells.sites();
  std::vector<Point3> places;
  for (const std::uint32_t i : w.order) places.push_back(sites[static_cast<Site>(w.near.number[i])]);
  const auto site = [&](std::size_t i) { return static_cast<Site>(w.near.number[w.order[i]]); };
  // The ball leaves (v, about, left) and comes to (v, touched, about).
  struct Arc {
    std::size_t about, left, touched;
  };
  std::vector<Arc> arcs;
  for (std::size_t b = 0; b < places.size(); ++b)
    EdgeRoll<Real>(sites[v], b, cells.radius(), places).for_each_free_arc([&](std::size_t left, std::size_t touched) {
      arcs.push_back({b, left, touched});
    });
  // They come by (about, left): each is followed by the one about what is touched that leaves what this was about.
  std::sort(arcs.begin(), arcs.end(),
            [](const Arc& p, const Arc& q) { return p.about != q.about ? p.about < q.about : p.left < q.left; });
  std::vector<std::uint8_t> is_done(arcs.size(), 0);
  for (std::size_t start = 0; start < arcs.size(); ++start) {
    if (is_done[start] != 0) continue;
    std::size_t i = start;
    do {
      is_done[i] = 1;
      found.points.push_back(site(arcs[i].about));
      const Arc next = {arcs[i].touched, arcs[i].about, 0};
      i = static_cast<std::size_t>(std::lower_bound(arcs.begin(), arcs.end(), next,
                                                    [](const Arc& p, const Arc& q) {
                                                      return p.about != q.about ? p.about < q.about : p.left < q.left;
                                                    }) -
                                   arcs.begin());
    } while (i != start);
    found.points.push_back(Rings::end_of_cycle);
  }
}

template <typename Real>
void roll_at(const Cells& cells, Site v, RingFinder::Workspace& w, Rings& found) {
  const std::span<const Point3> sites = cells.sites();
  // Rounded outward, by more than the roundings of a distance.
  const Real radius = cells.radius(), farthest = 4 * radius * radius * (1 + Real(0x1p-40));
  std::vector<std::pair<Real, std::uint32_t> > order;
  w.near.reserve(w.around.count);
  w.near.count = 0;
  for (std::size_t i = 0; i < w.around.count; ++i) {
    const auto p = static_cast<Site>(w.around.number[i]);
    const Vector3<Real> away = from<Real>(sites[v], sites[p]);
    const Real square = dot(away, away);
    if (p != v && !(square > farthest)) order.emplace_back(square, p);
  }
  std::sort(order.begin(), order.end());
  w.near.reserve(order.size());
  w.order.clear();
  for (const auto& [square, p] : order) {
    w.near.number[w.near.count] = p;
    w.order.push_back(static_cast<std::uint32_t>(w.near.count++));
  }
  ++found.rolled;
  roll_about_all<Real>(cells, v, w, found);
}

}  // namespace

void find_rings(const Cells& cells, bool fits_double, Site first, Site last, RingFinder::Workspace& w, Rings& found) {
  const std::span<const Point3> sites = cells.sites();
  const double whole = 4 * cells.radius() * cells.radius() * (1 + 0x1p-40);
  constexpr double wanted = 8;  // near points, of which about six bound a region
  constexpr std::size_t few = 4;
  found.points.clear();
  found.first.clear();
  found.rolled = 0;
  Cells::Around around(cells);
  RegionSearch search(cells, w);
  for (std::size_t cell = cells.cell_of(first); first < last; ++cell) {
    w.around.count = 0;
    around.for_each_run(cell, [&](Site begin, Site end) {
      w.around.reserve(w.around.count + (end - begin) + 8);
      double *const x = w.around.x.data(), *const y = w.around.y.data(), *const z = w.around.z.data(),
                    *const number = w.around.number.data();
      std::size_t i = w.around.count;
      for (Site p = begin; p < end; ++p) {
        x[i] = sites[p].x;
        y[i] = sites[p].y;
        z[i] = sites[p].z;
        number[i++] = p;
      }
      w.around.count = i;
    });
    // What is read beyond the end is as far as can be.
    for (std::size_t i = w.around.count; i < w.around.count + 8; ++i)
      w.around.x[i] = std::numeric_limits<double>::infinity();
    for (Site v = first; v < std::min(last, cells.first_in(cell + 1)); ++v, ++first) {
      found.first.push_back(static_cast<std::uint32_t>(found.points.size()));
      const std::size_t start = found.points.size();
      if (fits_double) {
        look_around(w.around, sites[v], whole, whole * w.share, w.near, w.far);
        const std::size_t all = w.near.count + w.far.count;
        while (w.near.count < std::min<std::size_t>(all, few)) {
          w.share *= 4;
          look_around(w.around, sites[v], whole, whole * w.share, w.near, w.far);
        }
        if (all == 0) continue;
        w.share = std::min(1.0, wanted / static_cast<double>(all));
        if (search.find(v, found)) continue;
        found.points.resize(start);
        roll_at<double>(cells, v, w, found);
      } else {
        roll_at<long double>(cells, v, w, found);
      }
    }
  }
  found.first.push_back(static_cast<std::uint32_t>(found.points.size()));
}

}  // namespace HWY_NAMESPACE
}  // namespace rbpa::space
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa::space {
namespace {
HWY_EXPORT(find_rings);
}  // namespace

RingFinder::RingFinder() : workspace_(std::make_unique<Workspace>()) {}
RingFinder::~RingFinder() = default;

void RingFinder::find(const Cells& cells, bool fits_double, Site first, Site last, Rings& found) {
  HWY_DYNAMIC_DISPATCH(find_rings)(cells, fits_double, first, last, *workspace_, found);
}

}  // namespace rbpa::space
#endif
