#include "rbpa/plane/remainder/remainder.h"

#include <algorithm>

#include "meshops/core/large_pages.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/plane/divide/divide_and_conquer.h"

namespace rbpa {
namespace {

/// Returns the triangle with its lowest site first, in the same orientation.
std::array<meshops::Site, 3> from_least(const std::array<meshops::Site, 3>& t) {
  if (t[0] < t[1] && t[0] < t[2]) return t;
  return t[1] < t[2] ? std::array{t[1], t[2], t[0]} : std::array{t[2], t[0], t[1]};
}

}  // namespace

void Remainder::add(const TilePatch& tile) {
  for (const std::uint32_t s : tile.settled) missing_[s] = 0;
  for (const auto& star : tile.shared) missing_[star.site] += static_cast<int>(star.elsewhere) - unseen;
  for (const std::uint32_t s : tile.ghost_corners) --missing_[s];
  unsettled_neighbors_.insert(unsettled_neighbors_.end(), tile.unsettled_neighbors.begin(),
                              tile.unsettled_neighbors.end());
  for (const std::uint32_t t : tile.loose_triangles) loose_triangles_.push_back(from_least(tile.patch.triangles[t]));
}

std::vector<std::uint32_t> Remainder::not_done() const {
  std::vector<std::uint32_t> unsettled, beside;
  meshops::reserve_in_large_pages(unsettled, sites_.size());
  for (std::uint32_t s = 0; s < sites_.size(); ++s)
    if (!is_settled(s)) unsettled.push_back(s);
  for (const auto& [site, neighbor] : unsettled_neighbors_)
    if (is_settled(site) && !is_settled(neighbor)) beside.push_back(site);
  if (beside.empty()) return unsettled;
  sort_unique(beside);
  std::vector<std::uint32_t> sites(unsettled.size() + beside.size());
  std::merge(unsettled.begin(), unsettled.end(), beside.begin(), beside.end(), sites.begin());
  return sites;
}

/// Returns the triangles of patches that have no settled corner, ascending.
std::vector<Remainder::Corners> Remainder::found_without_settled() const {
  std::vector<Corners> found;
  for (const Corners& t : loose_triangles_)
    if (std::none_of(t.begin(), t.end(), [&](meshops::Site s) { return is_settled(s); })) found.push_back(t);
  std::sort(found.begin(), found.end());
  return found;
}

void Remainder::complete(Threads& threads, const Checkpoint& working, TilePatch& rest) const {
  // If all sites fit double, the grid's coordinates are used, otherwise those of the input.
  const bool fits = sites_.beyond().empty();
  const auto points = sites_.grid().points();
  const Radius radius = fits ? sites_.window().scaled(alpha_) : alpha_;
  const std::vector<std::uint32_t> sites = not_done();
  meshops::FreshVector<SitePoint> places;
  places.reserve(sites.size());
  for (const std::uint32_t s : sites) places.push_back({fits ? points[s] : sites_.at(s), s});

  // Among the triangles of these sites, only those without a settled corner are surely Delaunay among all points.
  const std::vector<Corners> found = found_without_settled();
  const auto fate = [&](const SitePoint& a, const SitePoint& b, const SitePoint& c) -> int {
    if (!(fits ? radius.admits<double>(a.at, b.at, c.at) : radius.admits<long double>(a.at, b.at, c.at)))
      return meshops::Patch::nothing;
    if (is_settled(a.site) || is_settled(b.site) || is_settled(c.site)) return meshops::Patch::open;
    if (found.empty()) return 0;
    const Corners corners = from_least({a.site, b.site, c.site});
    return std::binary_search(found.begin(), found.end(), corners) ? meshops::Patch::open : 0;
  };
  const auto divide = fits ? divide_and_conquer<double> : divide_and_conquer<long double>;
  // If the radius is infinite and no tile found anything, all triangles are missing.
  const bool are_all_missing = radius.is_infinite() && found.empty() &&
                               std::none_of(missing_.begin(), missing_.end(), [](int n) { return n == 0; });
  rest.clear();
  rest.patch =
      divide(places, are_all_missing ? Fate() : fate, threads, working, rest.with_outline ? &rest.outline : nullptr);
}

}  // namespace rbpa
