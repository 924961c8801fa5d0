#include "rbpa/fill/front/outline.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/run/steps.h"

namespace rbpa {
namespace {

using meshops::Site;

/// Returns the positions at which to cut the edge from a to b, as fractions of its length, ascending; an empty list if
/// the edge stays whole, or if the pieces would be too short for doubles.
std::vector<double> cuts(const Point& a, const Point& b, const SizeField& field, Steps& step) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  // A walk along the edge in steps of an eighth of the size. Each entry is a position on the edge, as a fraction of its
  // length, and the integral of 1 / size from a to the position.
  std::vector<std::pair<double, double>> counted = {{0, 0}};
  for (double share = 0, count = 0; share < 1;) {
    step();
    const double size = field.at({a.x + share * dx, a.y + share * dy});
    const double next = std::min(share + size / 8 / length, 1.0);
    if (!(next > share)) return {};  // the pieces are too short for doubles
    count += (next - share) * length / size;
    share = next;
    counted.emplace_back(share, count);
  }
  const double total = counted.back().second, pieces = std::floor(total + 0.5);
  std::vector<double> shares;
  std::size_t at = 0;
  for (double piece = 1; piece < pieces; ++piece) {
    const double wanted = total * piece / pieces;
    while (counted[at + 1].second < wanted) ++at;
    const auto [share, count] = counted[at];
    const auto [next_share, next_count] = counted[at + 1];
    shares.push_back(share + (next_share - share) * (wanted - count) / (next_count - count));
  }
  return shares;
}

/// The edges of all rings, each once for both directions. Each edge has its added points, in the direction from the
/// lower to the higher site.
class CutEdges {
 public:
  CutEdges(const Outline& outline, const SizeField& field, Steps& step) {
    for (const OutlineRing& ring : outline.rings)
      for (std::size_t i = 0; i < ring.sites.size(); ++i) uses_.push_back({ends_of(ring, i), ring.group});
    sort(uses_, step, std::less<>());
    uses_.erase(std::unique(uses_.begin(), uses_.end()), uses_.end());
    for (const Use& use : uses_) {
      if (!ends_.empty() && ends_.back() == use.ends) continue;
      ends_.push_back(use.ends);
      // Added points are computed from the lower site, so they do not depend on the direction of the ring.
      const Point &a = outline.places[use.ends.first], &b = outline.places[use.ends.second];
      std::vector<Point>& points = points_.emplace_back();
      for (const double share : cuts(a, b, field, step))
        points.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
    for (const OutlineRing& ring : outline.rings) {
      std::vector<std::size_t>& numbers = of_ring_.emplace_back();
      for (std::size_t i = 0; i < ring.sites.size(); ++i) {
        step();
        const auto found = std::lower_bound(ends_.begin(), ends_.end(), ends_of(ring, i));
        numbers.push_back(static_cast<std::size_t>(found - ends_.begin()));
      }
    }
  }

  std::size_t size() const { return ends_.size(); }
  /// Returns the number of the edge that is edge i of a ring.
  std::size_t number(std::size_t ring, std::size_t i) const { return of_ring_[ring][i]; }
  const std::vector<Point>& points(std::size_t edge) const { return points_[edge]; }

  /// Removes all added points of an edge, and calls visit(group) for each group that has the edge.
  template <typename Visit>
  void keep_whole(std::size_t edge, Visit visit) {
    points_[edge].clear();
    auto use = std::lower_bound(uses_.begin(), uses_.end(), Use{ends_[edge], 0});
    for (; use != uses_.end() && use->ends == ends_[edge]; ++use) visit(use->group);
  }

 private:
  using Ends = std::pair<Site, Site>;
  struct Use {
    Ends ends;
    std::size_t group;
    friend auto operator<=>(const Use&, const Use&) = default;
  };
  static Ends ends_of(const OutlineRing& ring, std::size_t i) {
    const Site from = ring.sites[i], to = ring.sites[(i + 1) % ring.sites.size()];
    return {std::min(from, to), std::max(from, to)};
  }

  std::vector<Use> uses_;
  std::vector<Ends> ends_;                           // ascending
  std::vector<std::vector<Point>> points_;           // for each edge
  std::vector<std::vector<std::size_t>> of_ring_{};  // for each edge of each ring, the number of the edge
};

/// Rings that include the points added on their edges.
struct CutRings {
  std::vector<Point> places = {};
  std::vector<Ring> rings = {};
  // for each piece of each ring, the number of the edge in CutEdges that contains the piece
  std::vector<std::vector<std::size_t>> edge_of = {};
};

/// A builder of CutRings from the rings of an outline and the added points of their edges.
class OutlineAssembly {
 public:
  OutlineAssembly(const Outline& outline, const CutEdges& edges)
      : outline_(outline), edges_(edges), number_(outline.places.size(), no_index), first_(edges.size()) {}

  /// Returns all rings. The places are those of the outline, with unchanged numbers, then the added points, in the
  /// order in which rings first pass them.
  CutRings all() {
    std::iota(number_.begin(), number_.end(), Site{0});
    CutRings result{.places = outline_.places};
    for (std::size_t r = 0; r < outline_.rings.size(); ++r) add(r, result);
    return result;
  }

  /// Returns the rings with the numbers `rings`, and only the places that these rings pass.
  CutRings of(std::span<const std::size_t> rings) {
    CutRings result;
    for (const std::size_t r : rings) add(r, result);
    for (const std::size_t r : rings)
      for (std::size_t i = 0; i < outline_.rings[r].sites.size(); ++i) {
        number_[outline_.rings[r].sites[i]] = no_index;
        first_[edges_.number(r, i)] = {};
      }
    return result;
  }

 private:
  void add(std::size_t r, CutRings& result) {
    const std::vector<Site>& sites = outline_.rings[r].sites;
    std::vector<std::uint32_t>& ring = result.rings.emplace_back().points;
    std::vector<std::size_t>& edge_of = result.edge_of.emplace_back();
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (number_[sites[i]] == no_index) {
        number_[sites[i]] = static_cast<Site>(result.places.size());
        result.places.push_back(outline_.places[sites[i]]);
      }
      ring.push_back(number_[sites[i]]);
      const std::size_t edge = edges_.number(r, i);
      const auto n = static_cast<Site>(edges_.points(edge).size());
      const bool runs_up = sites[i] < sites[(i + 1) % sites.size()];
      // The first ring that passes an edge numbers the added points of the edge, in the direction of the ring.
      const bool is_new = first_[edge].site == no_index;
      if (is_new) first_[edge] = {static_cast<Site>(result.places.size()), runs_up};
      const auto [begin, began_up] = first_[edge];
      for (Site k = 0; k < n; ++k) {
        if (is_new) result.places.push_back(edges_.points(edge)[runs_up ? k : n - 1 - k]);
        ring.push_back(begin + (runs_up == began_up ? k : n - 1 - k));
      }
      edge_of.resize(ring.size(), edge);
    }
  }

  const Outline& outline_;
  const CutEdges& edges_;
  struct First {
    Site site = no_index;
    bool runs_up = true;
  };
  std::vector<Site> number_;  // for each site of the outline, its new number
  std::vector<First> first_;  // for each edge, its first added point, and whether numbers ascend from the lower site
};

/// Returns the numbers of the rings of each group; groups are in the order of their first rings.
std::vector<std::vector<std::size_t>> groups_of(const Outline& outline) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::size_t, std::size_t> place;
  for (std::size_t r = 0; r < outline.rings.size(); ++r) {
    const auto [at, is_new] = place.emplace(outline.rings[r].group, groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(r);
  }
  return groups;
}

}  // namespace

Outline outline_of(std::span<const Point> points, std::span<const Ring> rings, std::span<const RingPlace> places,
                   std::span<const std::size_t> groups) {
  Outline outline;
  for (const Ring& ring : rings) outline.input.insert(outline.input.end(), ring.points.begin(), ring.points.end());
  std::sort(outline.input.begin(), outline.input.end(),
            [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  outline.input.erase(std::unique(outline.input.begin(), outline.input.end()), outline.input.end());
  std::vector<Site> site_of(points.size());
  for (Site s = 0; s < outline.input.size(); ++s) {
    site_of[outline.input[s]] = s;
    outline.places.push_back(points[outline.input[s]]);
  }
  for (std::size_t r = 0; r < rings.size(); ++r) {
    OutlineRing& ring = outline.rings.emplace_back();
    ring.input = r;
    ring.group = groups[r];
    ring.is_reversed = places[r].is_counter_clockwise == places[r].is_hole();
    for (const std::uint32_t point : rings[r].points) ring.sites.push_back(site_of[point]);
    if (ring.is_reversed) std::reverse(ring.sites.begin(), ring.sites.end());
    std::rotate(ring.sites.begin(), std::min_element(ring.sites.begin(), ring.sites.end()), ring.sites.end());
  }
  std::stable_sort(outline.rings.begin(), outline.rings.end(),
                   [](const OutlineRing& a, const OutlineRing& b) { return a.sites < b.sites; });
  return outline;
}

void cut(Outline& outline, const SizeField& field, const GoOn& go_on) {
  Steps step(go_on);
  CutEdges edges(outline, field, step);
  OutlineAssembly assembly(outline, edges);
  const std::vector<std::vector<std::size_t>> groups = groups_of(outline);
  std::map<std::size_t, std::size_t> place_of_group;
  for (std::size_t g = 0; g < groups.size(); ++g) place_of_group[outline.rings[groups[g][0]].group] = g;
  std::vector<bool> waits(groups.size(), true);
  for (bool again = true; again;) {
    again = false;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (!waits[g]) continue;
      waits[g] = false;
      const CutRings all = assembly.of(groups[g]);
      const std::optional<RingsMeet> meet = nest_rings(all.places, all.rings, go_on).meet;
      if (!meet) continue;
      again = true;
      const auto keep_whole = [&](std::size_t edge) {
        edges.keep_whole(edge, [&](std::size_t group) { waits[place_of_group[group]] = true; });
      };
      for (const RingsMeet::Side& side : {meet->first, meet->second}) {
        const std::vector<std::size_t>& edge_of = all.edge_of[side.ring];
        keep_whole(edge_of[side.edge]);
        // `side` may stand for a corner, which the edge before meets, too.
        keep_whole(edge_of[(side.edge + edge_of.size() - 1) % edge_of.size()]);
      }
    }
  }
  CutRings all = assembly.all();
  outline.places = std::move(all.places);
  for (std::size_t r = 0; r < outline.rings.size(); ++r) outline.rings[r].sites = std::move(all.rings[r].points);
}

std::vector<OutlinePart> parts_of(const Outline& outline) {
  std::vector<OutlinePart> parts;
  std::vector<Site> number(outline.places.size(), no_index);
  for (const std::vector<std::size_t>& rings : groups_of(outline)) {
    OutlinePart& part = parts.emplace_back();
    part.group = outline.rings[rings[0]].group;
    for (const std::size_t r : rings)
      part.site.insert(part.site.end(), outline.rings[r].sites.begin(), outline.rings[r].sites.end());
    sort_unique(part.site);
    for (Site s = 0; s < part.site.size(); ++s) {
      number[part.site[s]] = s;
      part.outline.places.push_back(outline.places[part.site[s]]);
      if (part.site[s] < outline.input.size()) part.outline.input.push_back(outline.input[part.site[s]]);
    }
    for (const std::size_t r : rings) {
      OutlineRing& ring = part.outline.rings.emplace_back(outline.rings[r]);
      for (Site& s : ring.sites) s = number[s];
    }
  }
  std::sort(parts.begin(), parts.end(), [](const OutlinePart& a, const OutlinePart& b) { return a.group < b.group; });
  return parts;
}

}  // namespace rbpa
