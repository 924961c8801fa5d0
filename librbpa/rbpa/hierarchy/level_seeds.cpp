#include "rbpa/hierarchy/level_seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/hierarchy/circumradius.h"
#include "rbpa/seed/nearest.h"

namespace rbpa {
namespace {

using P = Predicates<LevelSeeds::Real>;

constexpr std::size_t most_near = 16;  // a star is walked where more points are within reach
constexpr LevelSeeds::Real infinity = std::numeric_limits<LevelSeeds::Real>::infinity();

bool has_edge(const meshops::Front& front, meshops::Site a, meshops::Site b) {
  bool found = false;
  front.for_each_fan(a, [&](meshops::Vertex fan) {
    for (const auto h : front.mesh().voh_range(fan)) found = found || front.to_site(h) == b;
  });
  return found;
}

}  // namespace

LevelSeeds::LevelSeeds(const PointGrid<Real>& grid, const Ladder<Real>& ladder, const Pivot<Real>& pivot,
                       Apexes& apexes, Report& report)
    : grid_(grid),
      points_(grid.points()),
      ladder_(ladder),
      pivot_(pivot),
      apexes_(apexes),
      report_(report),
      wake_(grid.points().size(), 0),
      reached_(grid.points().size(), false) {}

void LevelSeeds::begin(int level, std::vector<meshops::Site> free) {
  level_ = level;
  radius_ = ladder_.radius(level);
  due_ = std::move(free);
  next_ = 0;
  on_free_sites_ = true;
}

std::optional<std::array<meshops::Site, 3>> LevelSeeds::next(const meshops::Front& front) {
  for (;;) {
    while (!pending_.empty()) {
      const auto seed = pending_.back();
      pending_.pop_back();
      if (!has_edge(front, seed[0], seed[1])) return seed;
    }
    // Without a radius the complex is connected through edges: one seed is all it needs.
    if (radius_.is_infinite() && front.faces() > 0) return std::nullopt;
    if (next_ == due_.size()) {
      if (!on_free_sites_) return std::nullopt;
      turn_to_boundary(front);
      continue;
    }
    const Site v = due_[next_++];
    if (!on_free_sites_)
      look_into_gaps(front, v);
    else if (!front.is_free(v))
      continue;
    else if (radius_.is_infinite())
      look_all_around(v);
    else
      look_near(v);
    report_.searched(front);
  }
}

/// From free sites to those on the boundary. No triangle of the level is missing at a site that was free till now.
void LevelSeeds::turn_to_boundary(const meshops::Front& front) {
  on_free_sites_ = false;
  due_.clear();
  next_ = 0;
  for (const meshops::Halfedge h : front.frozen())
    if (front.mesh().is_boundary(h) && wake(front.from_site(h)) <= level_) due_.push_back(front.from_site(h));
  std::sort(due_.begin(), due_.end());
  due_.erase(std::unique(due_.begin(), due_.end()), due_.end());
}

/// Around a free site: the triangles within the radius of which it is the least corner. The others are found from
/// theirs, which is awake as well.
void LevelSeeds::look_near(Site v) {
  constexpr Real inflated = 1 + 64 * P::unit;
  const Real reach = 2 * Real(radius_.value()) * inflated;
  const Real looked = std::max(reach, grid_.cell_size_at(points_[v]));
  gather(v, looked);
  Real second = infinity;  // the distance to the second nearest, squared
  if (near_.size() >= 2) {
    std::nth_element(near_.begin(), near_.begin() + 1, near_.end(),
                     [](const Near& a, const Near& b) { return a.distance < b.distance; });
    second = near_[1].distance;
  }
  // Both other corners of a triangle at v are within twice its circumradius.
  sleep(v, std::min(std::sqrt(second), looked) / 2);
  if (second > reach * reach) return;
  // Near others and in no triangle again: only its star tells how long it can sleep.
  if (reached_[v]) return look_all_around(v);
  reached_[v] = true;
  std::erase_if(near_, [&](const Near& n) { return n.distance > reach * reach; });
  if (near_.size() > most_near) return look_all_around(v);
  for (const Near& p : near_)
    for (const Near& q : near_)
      if (p.site > v && q.site > v && is_triangle(v, p.site, q.site)) pending_.push_back({v, p.site, q.site});
}

/// (v, p, q) is a counter-clockwise Delaunay triangle within the radius. All points within its diameter of v are near.
bool LevelSeeds::is_triangle(Site v, Site p, Site q) const {
  const Point &a = points_[v], &b = points_[p], &c = points_[q];
  if (P::orientation(a, b, c) <= 0 || !radius_.admits<Real>(a, b, c)) return false;
  for (const Near& n : near_)
    if (n.site != p && n.site != q && P::in_perturbed_circle(a, b, c, points_[n.site]) > 0) return false;
  return true;
}

/// The points other than v not farther than `reach`, roughly.
void LevelSeeds::gather(Site v, Real reach) {
  near_.clear();
  const Point& centre = points_[v];
  grid_.scan(Region<Real>::disc({Real(centre.x), Real(centre.y)}, reach), [&](Site first, Site last) {
    for (Site i = first; i < last; ++i) {
      const auto d = P::from(centre, points_[i]);
      const Real distance = P::dot(d, d);
      if (distance <= reach * reach && i != v) near_.push_back({distance, i});
    }
  });
}

/// The whole star of a free site, from its nearest neighbour on: that edge is Delaunay.
void LevelSeeds::look_all_around(Site v) {
  const Site u = *nearest(grid_, Radius(), v);
  Real least = infinity;
  const auto is_back = [&](Site q) { return q == u; };
  if (!walk_counter_clockwise(v, u, is_back, least, u)) walk_clockwise(v, u, least);
  sleep(v, least);
}

/// The gaps between the fans on a site. The triangles at their frozen edges are the front's, and known.
void LevelSeeds::look_into_gaps(const meshops::Front& front, Site v) {
  const auto& mesh = front.mesh();
  fans_.clear();
  front.for_each_fan(v, [&](meshops::Vertex fan) {
    const auto out = mesh.halfedge_handle(fan);
    if (mesh.is_boundary(out))
      fans_.push_back({apexes_(front, mesh.prev_halfedge_handle(out)), apexes_(front, out),
                       front.from_site(mesh.prev_halfedge_handle(out))});
  });
  Real least = infinity;
  for (const Fan& fan : fans_) {
    if (!fan.after) continue;
    const auto reaches_fan = [&](auto matches) {
      const auto next = std::find_if(fans_.begin(), fans_.end(), matches);
      if (next != fans_.end()) next->reached = true;
      return next != fans_.end();
    };
    const auto at_last_triangle = [&](Site q) { return reaches_fan([&](const Fan& f) { return f.before == q; }); };
    if (reaches_fan([&](const Fan& f) { return f.first == *fan.after; }) || at_last_triangle(*fan.after)) continue;
    walk_counter_clockwise(v, *fan.after, at_last_triangle, least, fans_.front().before.value_or(fan.first));
  }
  for (const Fan& fan : fans_) {
    // From the other side to the hull.
    if (!fan.reached && fan.before) walk_clockwise(v, *fan.before, least);
  }
  sleep(v, least);
}

/// The triangles at v from v–q on until one ends at v–p with ends_at(p), or at the hull: false. `hint` is for the pivots.
template <typename EndsAt>
bool LevelSeeds::walk_counter_clockwise(Site v, Site q, EndsAt ends_at, Real& least, Site hint) {
  do {
    const auto apex = pivot_(v, q, {hint});
    if (!apex) return false;
    consider(v, q, *apex, least);
    q = *apex;
  } while (!ends_at(q));
  return true;
}

/// The triangles at v from v–q on to the hull.
void LevelSeeds::walk_clockwise(Site v, Site q, Real& least) {
  while (const auto apex = pivot_(q, v)) {
    consider(v, *apex, q, least);
    q = *apex;
  }
}

/// A Delaunay triangle: a seed, or the radius of one.
void LevelSeeds::consider(Site v, Site p, Site q, Real& least) {
  const Point &a = points_[v], &b = points_[p], &c = points_[q];
  if (radius_.admits<Real>(a, b, c))
    pending_.push_back({v, p, q});
  else
    least = std::min(least, circumradius<Real>(a, b, c));
}

void LevelSeeds::sleep(Site v, Real least) {
  wake_[v] = static_cast<std::uint16_t>(std::max(level_ + 1, ladder_.first_reaching(least)));
}

}  // namespace rbpa
