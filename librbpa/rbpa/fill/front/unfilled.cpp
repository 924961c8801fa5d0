#include "rbpa/fill/front/unfilled.h"

#include <algorithm>
#include <functional>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill/front/outline.h"
#include "rbpa/fill/front/triangulate_outline.h"
#include "rbpa/fill/rings/plane_distance.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

bool is_within(const Box& box, const Point& p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

/// Returns whether the bounding box of segment pq meets `box`.
bool meets(const Box& box, const Point& p, const Point& q) {
  return std::max(p.x, q.x) >= box.low.x && std::min(p.x, q.x) <= box.high.x && std::max(p.y, q.y) >= box.low.y &&
         std::min(p.y, q.y) <= box.high.y;
}

}  // namespace

Unfilled::Unfilled(const std::vector<Point>& places, std::span<const std::vector<Site>> rings, const GoOn& go_on)
    : places_(places), next_(static_cast<Site>(places.size())) {
  std::vector<Site> sites;
  for (const std::vector<Site>& ring : rings) sites.insert(sites.end(), ring.begin(), ring.end());
  Steps step(go_on);
  sort(sites, step, std::less<>());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  Outline outline;
  for (const Site s : sites) outline.places.push_back(places[s]);
  for (const std::vector<Site>& ring : rings) {
    outline.rings.emplace_back();
    for (const Site s : ring) {
      step();
      outline.rings.back().sites.push_back(
          static_cast<Site>(std::lower_bound(sites.begin(), sites.end(), s) - sites.begin()));
    }
  }
  for (const auto& [a, b, c] : triangulate(outline, go_on)) add(sites[a], sites[b], sites[c]);
  // Link each side to its partner, the side in the opposite direction. Sides without a partner stay in border_.
  border_.reserve(corner_.size());
  for (Side side = 0; side < corner_.size(); ++side) {
    step();
    const auto partner = border_.find(key_of(to(side), from(side)));
    if (partner == border_.end()) {
      link(side, none);
      continue;
    }
    link(side, partner->second);
    border_.erase(partner);
  }
}

int Unfilled::turn(Site a, Site b, Site c) const { return quick_orientation(places_[a], places_[b], places_[c]); }

Unfilled::Side Unfilled::at(const FrontEdge& edge) const {
  const auto found = border_.find(key_of(edge.from, edge.to));
  meshops::require(found != border_.end(), "fill: an edge is not of the front");
  return found->second;
}

void Unfilled::look_from(const FrontEdge& edge, std::size_t most) const {
  const Side first = at(edge);
  const Site apex = corner_[first];
  eye_ = edge;
  most_ = most;
  of_look_ = 0;
  seen_ = {apex};
  // The apex is one bound of the view through each of the two other sides. An end of the edge as the other bound means
  // no bound, as nothing lies right of the edge.
  closed_ = {{after(first), apex, edge.from}, {before(first), edge.to, apex}};
}

/// Looks through every gate whose bounding box meets `box`, and keeps the other gates for the next call.
std::span<const Unfilled::Site> Unfilled::free_sites(const Box& box) const {
  const auto [a, b] = eye_;
  const Point at_a = places_[a], at_b = places_[b];
  gates_.swap(closed_);
  closed_.clear();
  for (std::size_t i = 0; i < gates_.size() && of_look_ < most_; ++i) {
    const auto [gate, left, right] = gates_[i];
    const Side beyond = across_[gate];
    if (beyond == none) continue;
    if (!meets(box, places_[from(gate)], places_[to(gate)])) {
      closed_.push_back({gate, left, right});
      continue;
    }
    ++passed_;
    ++of_look_;
    // The gate runs from its right end to its left end; in the triangle beyond, the side runs from left to right.
    const Site d = corner_[beyond];
    const Point& p = places_[d];
    const bool is_right = left == b || quick_orientation(at_a, places_[left], p) < 0;
    const bool is_left = right == a || quick_orientation(at_b, places_[right], p) > 0;
    if (is_right && is_left && quick_orientation(at_a, at_b, p) > 0) seen_.push_back(d);
    // If the corner d is out of sight, one of its two sides inherits both bounds of the gate.
    if (is_right && (!is_left || quick_orientation(at_b, p, places_[from(beyond)]) > 0))
      gates_.push_back({before(beyond), left, is_left ? d : right});
    if (is_left && (!is_right || quick_orientation(at_a, p, places_[to(beyond)]) < 0))
      gates_.push_back({after(beyond), is_right ? d : left, right});
  }
  if (of_look_ >= most_) {
    closed_.clear();
    found_.swap(seen_);
    seen_.clear();
    return found_;
  }
  const auto in_box = std::partition(seen_.begin(), seen_.end(), [&](Site s) { return !is_within(box, places_[s]); });
  found_.assign(in_box, seen_.end());
  seen_.erase(in_box, seen_.end());
  return found_;
}

/// Walks from the edge (a, b) toward the site. If a corner lies in the triangle of edge and site, this triangle is not
/// empty, and the walk ends. Any other corner lies left of the line from a to the site or right of the line from b to
/// the site, which decides through which side the walk continues.
bool Unfilled::is_free(const FrontEdge& edge, Site site) const {
  const Point &a = places_[edge.from], &b = places_[edge.to], &p = places_[site];
  if (quick_orientation(a, b, p) <= 0) return false;
  for (Side side = at(edge); side != none;) {
    ++passed_;
    if (corner_[side] == site) return true;
    const Point& d = places_[corner_[side]];
    if (holds(a, b, p, d)) return false;
    side = across_[quick_orientation(a, p, d) > 0 ? after(side) : before(side)];
  }
  return false;
}

/// Returns the triangle that contains `p`, as the side through which a walk from `edge` enters the triangle. Returns
/// nothing if `p` and the edge form no empty triangle, `p` lies on the front, or the walk passes more than `most`
/// triangles.
std::optional<Unfilled::Side> Unfilled::around(const FrontEdge& edge, const Point& p, std::size_t most) const {
  const Point &a = places_[edge.from], &b = places_[edge.to];
  if (quick_orientation(a, b, p) <= 0) return std::nullopt;
  std::size_t passed = 0;
  for (Side side = at(edge); side != none && passed++ < most;) {
    ++passed_;
    const Point& d = places_[corner_[side]];
    if (holds(a, b, p, d)) return std::nullopt;
    const Side next = quick_orientation(a, p, d) > 0 ? after(side) : before(side);
    const int inside = quick_orientation(places_[from(next)], places_[to(next)], p);
    if (inside > 0) return side;
    if (inside == 0) return across_[next] == none ? std::nullopt : std::optional(side);
    side = across_[next];
  }
  return std::nullopt;
}

bool Unfilled::is_free(const FrontEdge& edge, const Point& apex, double clearance, std::size_t most) const {
  const std::optional<Side> side = around(edge, apex, most);
  return side && is_clear(*side, apex, clearance);
}

/// Returns whether every edge of the front is at least `clearance` from `p`, which lies in the triangle of side
/// `around`. The nearest point of the front is visible from `p`, so a search through sides that are nearer than
/// `clearance` finds this point.
bool Unfilled::is_clear(Side around, const Point& p, double clearance) const {
  const double reach = (1 + 0x1p-40) * clearance;  // the margin covers the rounding of distances
  stack_ = {around - around % 3};
  stamp_[around / 3] = ++looks_;
  while (!stack_.empty()) {
    const Side first = stack_.back();
    stack_.pop_back();
    ++passed_;
    for (Side side = first; side < first + 3; ++side) {
      const Point &q = places_[from(side)], &r = places_[to(side)];
      if (is_surely_clear(p, q, r, 2 * clearance)) continue;
      const double far = distance(p, q, r);
      const Side beyond = across_[side];
      if (beyond == none && !(far >= clearance)) return false;
      if (beyond == none || far >= reach || std::exchange(stamp_[beyond / 3], looks_) == looks_) continue;
      stack_.push_back(beyond - beyond % 3);
    }
  }
  return true;
}

std::vector<std::array<Unfilled::Site, 3>> Unfilled::triangles() const {
  std::vector<std::array<Site, 3>> result;
  for (std::size_t t = 0; 3 * t < corner_.size(); ++t)
    if (corner_[3 * t] != none) result.push_back({corner_[3 * t], corner_[3 * t + 1], corner_[3 * t + 2]});
  return result;
}

}  // namespace rbpa
