#include <algorithm>
#include <cmath>
#include <limits>

#include "meshops/core/contract.h"
#include "rbpa/fill/front/unfilled.h"
#include "rbpa/plane/predicate/plane_predicates.h"

// Members of Unfilled that add and remove triangles.
namespace rbpa {
namespace {

/// Returns the height of the plane through the lifted points a, b and c above the lifted point p; infinity if the
/// result is not finite. Points are lifted to the paraboloid. While the lifted p rises, the triangles of the
/// triangulation without p replace those around p in ascending order of this height. Rounding can only cause additional
/// flips.
double rise(const Point& a, const Point& b, const Point& c, const Point& p) {
  const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y, cx = c.x - p.x, cy = c.y - p.y;
  const double bc = bx * cy - by * cx, ca = cx * ay - cy * ax, ab = ax * by - ay * bx;
  const double depth = (ax * ax + ay * ay) * bc + (bx * bx + by * by) * ca + (cx * cx + cy * cy) * ab;
  const double result = depth / (ab + bc + ca);
  return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

}  // namespace

void Unfilled::link(Side side, Side beyond) {
  across_[side] = beyond;
  if (beyond == none)
    border_[key_of(from(side), to(side))] = side;
  else
    across_[beyond] = side;
}

std::uint32_t Unfilled::add(Site a, Site b, Site c) {
  ++passed_;
  auto t = static_cast<std::uint32_t>(stamp_.size());
  if (unused_.empty()) {
    stamp_.push_back(0);
    corner_.resize(corner_.size() + 3);
    across_.resize(across_.size() + 3);
  } else {
    t = unused_.back();
    unused_.pop_back();
  }
  std::size_t k = 3 * std::size_t{t};
  for (const Site s : {a, b, c}) {
    corner_[k] = s;
    across_[k++] = none;
  }
  return t;
}

void Unfilled::remove(std::uint32_t triangle) {
  corner_[3 * triangle] = none;
  unused_.push_back(triangle);
}

/// Removes the sides of removed triangles from queue_. Must run before the numbers of these triangles are reused.
void Unfilled::forget_removed() {
  std::erase_if(queue_, [&](Side side) { return corner_[side - side % 3] == none; });
}

void Unfilled::fill(const FrontEdge& edge, Site apex) {
  if (apex >= next_) {
    split(edge, apex);
    next_ = apex + 1;
  }
  const auto [a, b] = edge;
  cross(at(edge), apex);
  for (const std::uint32_t t : crossed_) remove(t);
  forget_removed();
  waiting_.clear();
  border_.erase(key_of(a, b));
  const Side left = cut_ears(left_, false), right = cut_ears(right_, true);
  meshops::require(left_.size() == 2 && right_.size() == 2 && waiting_.empty(), "fill: a triangle was not empty");
  bound(left, apex, a);
  bound(right, b, apex);
  flip_all();
}

/// Updates the side of a filled triangle from `from` to `to`. If `beyond` is none, the side was at the front, and is
/// removed from the front; otherwise side `beyond` becomes an edge of the front.
void Unfilled::bound(Side beyond, Site from, Site to) {
  if (beyond == none)
    border_.erase(key_of(from, to));
  else
    link(beyond, none);
}

/// Inserts `site`, which forms an empty triangle with `edge`, as a corner: splits the triangle that contains the site,
/// or both triangles at the side on which the site lies.
void Unfilled::split(const FrontEdge& edge, Site site) {
  const std::optional<Side> around = this->around(edge, places_[site], unlimited);
  meshops::require(around.has_value(),
                   "fill: found a new point in no empty triangle, expected a point of the unfilled part");
  const Side first = *around - *around % 3;
  std::vector<std::array<std::uint32_t, 3>> rim;  // from, to, beyond
  std::array<std::uint32_t, 2> taken = {first / 3, none};
  for (Side side = first; side < first + 3; ++side) {
    const Side beyond = across_[side];
    if (turn(from(side), to(side), site) != 0) {
      rim.push_back({from(side), to(side), beyond});
      continue;
    }
    meshops::require(beyond != none, "fill: a new point lies on the front");
    taken[1] = beyond / 3;
    for (const Side other : {after(beyond), before(beyond)}) rim.push_back({from(other), to(other), across_[other]});
  }
  for (const std::uint32_t t : taken)
    if (t != none) remove(t);
  std::vector<Side> bases;
  for (const auto& [from, to, beyond] : rim) {
    bases.push_back(3 * add(site, from, to));
    for (Side k = bases.back(); k < bases.back() + 3; ++k) queue_.push_back(k);
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    link(bases[i], rim[i][2]);
    for (std::size_t j = 0; j < rim.size(); ++j)
      if (rim[j][0] == rim[i][1]) link(after(bases[i]), before(bases[j]));
  }
}

/// Gathers in crossed_ the triangles that the triangle of `side` and `apex` crosses, and in left_ and right_ the two
/// rims of these crossed triangles, from the ends of `side` to `apex`.
void Unfilled::cross(Side side, Site apex) {
  const Site a = from(side), b = to(side);
  crossed_.clear();
  ++looks_;
  left_ = {{a, none}};
  right_ = {{b, none}};
  for (;;) {
    meshops::require(side != none, "fill: a triangle was not empty");
    crossed_.push_back(side / 3);
    stamp_[side / 3] = looks_;
    const Site d = corner_[side];
    const bool is_left = d != apex && turn(a, apex, d) > 0;
    if (d == apex || is_left) left_.push_back({d, across_[before(side)]});
    if (d == apex || !is_left) right_.push_back({d, across_[after(side)]});
    if (d == apex) return;
    side = across_[is_left ? after(side) : before(side)];
  }
}

/// Cuts off a triangle wherever a rim turns towards its base, from one end to the other as in a scan for the convex
/// hull. Every corner of the rim sees the base, so that the triangles fill the whole region between rim and base.
/// Returns the side of the new triangle at the base.
Unfilled::Side Unfilled::cut_ears(std::vector<Rim>& rim, bool is_right) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    Rim next = rim[i];
    for (; kept >= 2; --kept) {
      const Rim &last = rim[kept - 1], &first = rim[kept - 2];
      const Site p = is_right ? next.site : first.site, q = is_right ? first.site : next.site;
      if (p == q || turn(p, q, last.site) <= 0) break;
      const Side ear = 3 * add(p, q, last.site);
      close(first.site, last, is_right ? ear : ear + 1, is_right);
      close(last.site, next, is_right ? ear + 1 : ear, is_right);
      next.beyond = ear + 2;
      next.is_new = true;
      for (Side k = ear; k < ear + 3; ++k) queue_.push_back(k);
    }
    rim[kept++] = next;
  }
  rim.resize(kept);
  return rim.back().beyond;
}

/// Joins side `inner` of a new triangle to the side beyond the edge of the rim from `from` to `to`. If the triangle
/// beyond was crossed as well, the rim passes the edge in both directions, and the edge gets two new triangles; the
/// first waits in waiting_ for the second.
void Unfilled::close(Site from, const Rim& to, Side inner, bool is_right) {
  if (to.is_new || to.beyond == none || stamp_[to.beyond / 3] != looks_) return link(inner, to.beyond);
  const Site begin = is_right ? from : to.site, end = is_right ? to.site : from;
  const auto other =
      std::find_if(waiting_.begin(), waiting_.end(), [&](const auto& w) { return w[0] == end && w[1] == begin; });
  if (other == waiting_.end()) return waiting_.push_back({begin, end, inner});
  link(inner, (*other)[2]);
  waiting_.erase(other);
}

/// Flips queued sides until no apex beyond a side lies in the circumcircle of the triangle before the side. Each flip
/// lowers the surface of the points lifted to the paraboloid, so flips end.
void Unfilled::flip_all() {
  while (!queue_.empty()) {
    const Side side = queue_.back();
    queue_.pop_back();
    const Side other = across_[side];
    if (other == none) continue;
    if (plane_in_circle(places_[from(side)], places_[to(side)], places_[corner_[side]], places_[corner_[other]]) > 0)
      flip(side);
  }
}

void Unfilled::flip(Side side) {
  ++passed_;
  const Side other = across_[side], t = side - side % 3, o = other - other % 3;
  const Site a = from(side), b = to(side), p = corner_[side], q = corner_[other];
  const Side beyond_pa = across_[before(side)], beyond_bp = across_[after(side)];
  const Side beyond_aq = across_[after(other)], beyond_qb = across_[before(other)];
  std::size_t k = 0;
  for (const Site s : {p, a, q}) corner_[t + k++] = s;
  k = 0;
  for (const Site s : {q, b, p}) corner_[o + k++] = s;
  link(t, beyond_aq);
  link(t + 1, o + 1);
  link(t + 2, beyond_pa);
  link(o, beyond_bp);
  link(o + 2, beyond_qb);
  for (const Side outer : {t, t + 2, o, o + 2}) queue_.push_back(outer);
}

void Unfilled::empty(const std::array<Site, 3>& corners, const std::array<bool, 3>& is_front) {
  const Side t = 3 * add(corners[0], corners[1], corners[2]);
  for (Side i = 0; i < 3; ++i) {
    const Side side = t + (i + 2) % 3;
    if (is_front[i]) {
      link(side, none);
      continue;
    }
    const auto partner = border_.find(key_of(to(side), from(side)));
    meshops::require(partner != border_.end(), "empty: a side of the triangle is not an edge of the front");
    link(side, partner->second);
    border_.erase(partner);
  }
  for (Side i = 0; i < 3; ++i) queue_.push_back(t + i);
  for (Side i = 0; i < 3; ++i) {
    if (is_front[i] || is_front[(i + 2) % 3]) continue;
    // queue_ has all sides of new triangles. If an earlier corner was removed, one of its replacing triangles has
    // corner i.
    const auto at = std::find_if(queue_.begin(), queue_.end(), [&](Side side) { return corner_[side] == corners[i]; });
    if (is_inner(*at)) take_out(*at);
  }
  flip_all();
}

/// Returns whether the corner across from side `at` is not on the front: a walk around the corner meets no edge of the
/// front.
bool Unfilled::is_inner(Side at) const {
  Side side = after(at);
  do side = across_[side] == none ? none : before(across_[side]);
  while (side != none && side != after(at));
  return side != none;
}

/// Removes the inner corner across from side `at`, and triangulates the star of this corner by cutting ears in
/// ascending order of rise().
void Unfilled::take_out(Side at) {
  const Site inner = corner_[at];
  star_.clear();
  Side side = at;
  do {
    const auto i = static_cast<std::uint32_t>(star_.size());
    star_.push_back({.rim = {to(side), across_[side]}, .last = i - 1, .next = i + 1});
    remove(side / 3);
    side = after(across_[after(side)]);  // across from the inner corner in the next triangle around it
  } while (side != at);
  forget_removed();
  star_.front().last = static_cast<std::uint32_t>(star_.size() - 1);
  star_.back().next = 0;
  ears_.clear();
  for (std::uint32_t i = 0; i < star_.size(); ++i) offer_ear(i, inner);
  std::uint32_t i = 0;
  for (std::size_t left = star_.size(); left > 3; --left) {
    i = first_ear();
    cut_ear(i);
    offer_ear(star_[i].last, inner);
    i = star_[i].next;
    offer_ear(i, inner);
  }
  const Side rest = cut_ear(i);
  link(rest + 1, star_[star_[i].last].rim.beyond);
}

/// Offers corner i of a star as an ear if the rim turns left at the corner and the inner corner does not lie within the
/// ear. The rest of the star then is still a star around the inner corner, which may lie on its rim. An ear always
/// exists: in any triangulation of a star of four corners or more, at least two triangles have two sides of the rim,
/// and at most one of these triangles contains the inner corner.
void Unfilled::offer_ear(std::uint32_t i, Site inner) {
  const Site a = star_[star_[i].last].rim.site, b = star_[i].rim.site, c = star_[star_[i].next].rim.site;
  ++star_[i].offers;
  if (turn(a, b, c) <= 0 || turn(inner, a, c) < 0) return;
  ears_.push_back({rise(places_[a], places_[b], places_[c], places_[inner]), i, star_[i].offers});
  std::push_heap(ears_.begin(), ears_.end());
}

std::uint32_t Unfilled::first_ear() {
  for (;;) {
    meshops::require(!ears_.empty(), "fill: a star has no ear");
    const Ear ear = ears_.front();
    std::pop_heap(ears_.begin(), ears_.end());
    ears_.pop_back();
    if (ear.offer == star_[ear.at].offers) return ear.at;
  }
}

Unfilled::Side Unfilled::cut_ear(std::uint32_t i) {
  const auto [rim, last, next, offers] = star_[i];
  const Side ear = 3 * add(star_[last].rim.site, rim.site, star_[next].rim.site);
  link(ear, star_[next].rim.beyond);
  link(ear + 2, rim.beyond);
  for (Side k = ear; k < ear + 3; ++k) queue_.push_back(k);
  star_[last].next = next;
  star_[next].last = last;
  star_[next].rim.beyond = ear + 1;
  return ear;
}

}  // namespace rbpa
