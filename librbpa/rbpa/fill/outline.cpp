#include "rbpa/fill/outline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "rbpa/shape/steps.h"

namespace rbpa {
namespace {

using meshops::Site;

/// Where to cut the edge from a to b, shares of its length, ascending.
std::vector<double> cuts(const Point& a, const Point& b, const SizeField& field, Steps& step) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  // An eighth of the size at a time, which changes little by then.
  std::vector<std::pair<double, double>> counted = {{0, 0}};  // share, and lengths of the field up to it
  for (double share = 0, count = 0; share < 1;) {
    step();
    const double size = field.at({a.x + share * dx, a.y + share * dy});
    const double next = std::min(share + size / 8 / length, 1.0);
    if (!(next > share)) return {};  // so fine that doubles have no such points
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

/// An edge with the points on it, as it runs.
using Pieces = std::vector<std::vector<Point>>;  // of each edge of a ring

Pieces cut_ring(const Outline& outline, const OutlineRing& ring, const SizeField& field, Steps& step) {
  Pieces pieces;
  for (std::size_t i = 0; i < ring.sites.size(); ++i) {
    const Point& from = outline.places[ring.sites[i]];
    const Point& to = outline.places[ring.sites[(i + 1) % ring.sites.size()]];
    // From the lower end, so that nothing depends on which way it runs.
    const Point &a = std::min(from, to), &b = std::max(from, to);
    std::vector<Point>& points = pieces.emplace_back();
    for (const double share : cuts(a, b, field, step))
      points.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    if (from != a) std::reverse(points.begin(), points.end());
  }
  return pieces;
}

/// The rings with their pieces, and of each edge which edge of the outline it is of.
struct CutOutline {
  Outline outline;
  std::vector<std::vector<std::size_t>> edge_of;  // of each ring, of each of its edges
};

CutOutline assemble(const Outline& whole, const std::vector<Pieces>& pieces) {
  CutOutline result{.outline = {.places = whole.places, .input = whole.input, .rings = {}}, .edge_of = {}};
  for (std::size_t r = 0; r < whole.rings.size(); ++r) {
    OutlineRing& ring = result.outline.rings.emplace_back(whole.rings[r]);
    std::vector<std::size_t>& edge_of = result.edge_of.emplace_back();
    ring.sites.clear();
    for (std::size_t i = 0; i < whole.rings[r].sites.size(); ++i) {
      ring.sites.push_back(whole.rings[r].sites[i]);
      for (const Point& p : pieces[r][i]) {
        ring.sites.push_back(static_cast<Site>(result.outline.places.size()));
        result.outline.places.push_back(p);
      }
      edge_of.resize(ring.sites.size(), i);
    }
  }
  return result;
}

}  // namespace

Outline outline_of(std::span<const Point> points, std::span<const Ring> rings, std::span<const RingPlace> places) {
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
    ring.is_reversed = places[r].is_counter_clockwise == places[r].is_hole();
    for (const std::uint32_t point : rings[r].points) ring.sites.push_back(site_of[point]);
    if (ring.is_reversed) std::reverse(ring.sites.begin(), ring.sites.end());
    std::rotate(ring.sites.begin(), std::min_element(ring.sites.begin(), ring.sites.end()), ring.sites.end());
  }
  std::sort(outline.rings.begin(), outline.rings.end(), [](const OutlineRing& a, const OutlineRing& b) {
    return std::pair(a.sites[0], a.sites[1]) < std::pair(b.sites[0], b.sites[1]);
  });
  return outline;
}

void cut(Outline& outline, const SizeField& field, const std::function<bool()>& go_on) {
  Steps step(go_on);
  std::vector<Pieces> pieces;
  for (const OutlineRing& ring : outline.rings) pieces.push_back(cut_ring(outline, ring, field, step));
  for (;;) {
    CutOutline all = assemble(outline, pieces);
    std::vector<Ring> rings;
    for (const OutlineRing& ring : all.outline.rings) rings.push_back({ring.sites});
    const std::optional<RingsMeet> meet = nest_rings(all.outline.places, rings, go_on).meet;
    if (!meet) {
      outline = std::move(all.outline);
      return;
    }
    for (const RingsMeet::Side& side : {meet->first, meet->second}) {
      const std::size_t edge = all.edge_of[side.ring][side.edge];
      pieces[side.ring][edge].clear();
      // Where a corner meets something, both of its edges do.
      pieces[side.ring][(edge + pieces[side.ring].size() - 1) % pieces[side.ring].size()].clear();
    }
  }
}

}  // namespace rbpa
