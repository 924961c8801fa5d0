#include "rbpa/space/surface/star/find_rings.h"

#include <algorithm>
#include <span>
#include <utility>

#include "rbpa/space/predicate/resting_ball.h"
#include "rbpa/space/surface/pivot/roll_about_edge.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/space/surface/star/find_rings.cpp"
#include <hwy/foreach_target.h>
// The code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/space/surface/star/bounding_cones-inl.h"
#include "rbpa/space/surface/star/free_region-inl.h"
#include "rbpa/space/surface/star/initial_region-inl.h"
#include "rbpa/space/surface/star/neighbor.h"
#include "rbpa/space/surface/star/surroundings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

/// Searches the rings of sites, one after the other, by caps.
class RegionSearch {
 public:
  explicit RegionSearch(const Cells& cells) : cells_(cells) {}

  /// Appends the rings of v:
  ///   1. gather the nearest points, about as many as bound a region;
  ///   2. subtract the caps of up to eight of them together, and the other caps one by one, nearest first;
  ///   3. bound the region by cones, and subtract the caps of farther points that meet a cone, with new cones as it
  ///      shrinks;
  ///   4. retry the caps whose circles were free as a whole;
  ///   5. read the rings off the corners.
  /// Returns false if the region is lost (FreeRegion). Requires: `around` has the surroundings of v's cell.
  bool find(Surroundings& around, Site v, Rings& found) {
    const std::span<const Point3> sites = cells_.sites();
    const auto is_in_ball = [&](std::size_t x, std::size_t y, std::size_t p) {
      return RestingBall<double>(sites[v], sites[x], sites[y], cells_.radius()).contains(sites[p]);
    };
    region_.reset(cells_.radius());
    const float from = find_near(around, v);
    if (near_.empty()) return true;
    if (!subtract_near(is_in_ball) || !subtract_far(around, v, from, is_in_ball) || !region_.finish(is_in_ball))
      return false;
    region_.for_each_cycle([&](std::uint32_t site) { found.points.push_back(site); },
                           [&] { found.points.push_back(Rings::end_of_cycle); });
    return true;
  }

 private:
  /// Does step 1: fills near_. Returns the squared distance, in squared radii, up to which near_ has all points.
  float find_near(Surroundings& around, Site v) {
    constexpr double wanted = 8;  // about six of these bound a region
    constexpr std::size_t least = 4;
    const std::span<const Point3> sites = cells_.sites();
    while (true) {
      const float square = static_cast<float>(share_) * Surroundings::whole;
      const Surroundings::Near near = around.within(sites[v], square);
      if (near.sites.size() <= least && near.sites.size() < near.all) {
        share_ = std::min(1.0, 4 * share_);
        continue;
      }
      near_.clear();
      for (const Site p : near.sites)
        if (p != v) near_.push_back(Neighbor::seen_from(sites[v], sites[p], p));
      share_ = std::min(1.0, wanted / static_cast<double>(near.all));
      return square;
    }
  }

  /// Does step 2. Returns false if the region is lost.
  template <typename IsInBall>
  bool subtract_near(IsInBall is_in_ball) {
    const std::size_t few = std::min<std::size_t>(near_.size(), InitialRegion::most);
    if (near_.size() > few) sort_near();
    std::size_t done = 0;
    if (region_.start({near_.data(), few}))
      done = few;
    else if (near_.size() == few)
      sort_near();
    for (; done < near_.size() && !region_.is_empty(); ++done)
      if (!region_.subtract(near_[done], is_in_ball)) return false;
    return true;
  }

  /// Does step 3, for points whose squared distance is above `from`: for all such points if the region is bounded,
  /// otherwise shell by shell, each of twice the squared distance. Returns false if the region is lost.
  template <typename IsInBall>
  bool subtract_far(Surroundings& around, Site v, float from, IsInBall is_in_ball) {
    const std::span<const Point3> sites = cells_.sites();
    for (float to = from; from < Surroundings::whole && !region_.is_empty(); from = to) {
      region_.update_bound(bound_);
      std::size_t caps_in_bound = region_.caps();
      to = bound_.is_bounded() ? Surroundings::whole : std::min(2 * to, Surroundings::whole);
      const bool is_certain = around.for_each_candidate(bound_, from, to, [&](Site p) {
        const Neighbor neighbor = Neighbor::seen_from(sites[v], sites[p], p);
        if (region_.is_empty() || !bound_.may_meet_cap_of(neighbor)) return true;
        if (!region_.subtract(neighbor, is_in_ball)) return false;
        // Without a bound, there may be none again: to save time, it is then updated only after every fourth cap.
        if (region_.caps() - caps_in_bound >= (bound_.is_bounded() ? 1 : 4)) {
          region_.update_bound(bound_);
          caps_in_bound = region_.caps();
        }
        return true;
      });
      if (!is_certain) return false;
    }
    return true;
  }

  void sort_near() {
    std::sort(near_.begin(), near_.end(), [](const Neighbor& p, const Neighbor& q) { return p.power < q.power; });
  }

  const Cells& cells_;
  double share_ = 0.25;  // fraction of the square of two radii in which near points are searched first
  std::vector<Neighbor> near_;
  FreeRegion region_;
  BoundingCones bound_;
};

/// Appends the rings of v by rolling about each edge. Requires: `others` are all sites within two radii, by distance.
template <typename Real>
void roll_about_all(const Cells& cells, Site v, std::span<const Site> others, Rings& found, meshops::Steps& step) {
  const std::span<const Point3> sites = cells.sites();
  std::vector<Point3> places;
  for (const Site p : others) places.push_back(sites[p]);
  // The ball rolls from (v, about, left) to (v, touched, about).
  struct Arc {
    std::size_t about, left, touched;
  };
  std::vector<Arc> arcs;
  for (std::size_t b = 0; b < places.size(); ++b) {
    step(places.size());
    EdgeRoll<Real>(sites[v], b, cells.radius(), places).for_each_free_arc([&](std::size_t left, std::size_t touched) {
      step(places.size());
      arcs.push_back({b, left, touched});
    });
  }
  // Arcs are sorted by (about, left) to find the next arc: its `about` is this arc's `touched`, its `left` this arc's
  // `about`.
  std::sort(arcs.begin(), arcs.end(),
            [](const Arc& p, const Arc& q) { return p.about != q.about ? p.about < q.about : p.left < q.left; });
  std::vector<std::uint8_t> is_done(arcs.size(), 0);
  for (std::size_t start = 0; start < arcs.size(); ++start) {
    if (is_done[start] != 0) continue;
    std::size_t i = start;
    do {
      is_done[i] = 1;
      found.points.push_back(others[arcs[i].about]);
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

/// Appends the rings of v by rolling about each edge. Requires: `around` has the sites around v's cell.
template <typename Real>
void roll_at(const Cells& cells, Site v, std::span<const Site> around, Rings& found, meshops::Steps& step) {
  const std::span<const Point3> sites = cells.sites();
  // The limit is rounded outward, by more than the rounding error of a distance.
  const Real radius = cells.radius(), farthest = 4 * radius * radius * (1 + Real(0x1p-40));
  std::vector<std::pair<Real, Site> > order;
  for (const Site p : around) {
    const Vector3<Real> away = from<Real>(sites[v], sites[p]);
    const Real square = dot(away, away);
    if (p != v && !(square > farthest)) order.emplace_back(square, p);
  }
  std::sort(order.begin(), order.end());
  std::vector<Site> others;
  for (const auto& [square, p] : order) others.push_back(p);
  ++found.rolled;
  roll_about_all<Real>(cells, v, others, found, step);
}

}  // namespace

void find_rings(const Cells& cells, bool fits_double, Site first, Site last, Rings& found, meshops::Steps& step) {
  found.points.clear();
  found.first.clear();
  found.rolled = 0;
  Cells::Around cells_around(cells);
  Surroundings around;
  RegionSearch search(cells);
  for (std::size_t cell = cells.cell_of(first); first < last; ++cell) {
    around.gather(cells, cells_around, cell);
    for (; first < std::min(last, cells.first_in(cell + 1)); ++first) {
      step(16 + around.sites().size() / 16);
      const std::size_t start = found.points.size();
      found.first.push_back(static_cast<std::uint32_t>(start));
      if (fits_double) {
        if (search.find(around, first, found)) continue;
        found.points.resize(start);
        roll_at<double>(cells, first, around.sites(), found, step);
      } else {
        roll_at<long double>(cells, first, around.sites(), found, step);
      }
    }
  }
  found.first.push_back(static_cast<std::uint32_t>(found.points.size()));
}

}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa::space {
namespace {
HWY_EXPORT(find_rings);
}  // namespace

void find_rings(const Cells& cells, bool fits_double, Site first, Site last, Rings& found, meshops::Steps& step) {
  HWY_DYNAMIC_DISPATCH(find_rings)(cells, fits_double, first, last, found, step);
}

}  // namespace rbpa::space
#endif
