#include "rbpa/remainder/remainder.h"

#include <algorithm>
#include <cstddef>

#include "rbpa/remainder/delaunay.h"

namespace rbpa {
namespace {

/// The same triangle, from its least site on.
std::array<meshops::Site, 3> from_least(const std::array<meshops::Site, 3>& t) {
  if (t[0] < t[1] && t[0] < t[2]) return t;
  return t[1] < t[2] ? std::array{t[1], t[2], t[0]} : std::array{t[2], t[0], t[1]};
}

}  // namespace

void Remainder::add(const TileTriangles& tile) {
  for (const std::uint32_t s : tile.known) missing_[s] = 0;
  for (const auto& star : tile.shared) missing_[star.site] += static_cast<int>(star.foreign) - unseen;
  for (const std::uint32_t s : tile.given) --missing_[s];
  beside_.insert(beside_.end(), tile.beside.begin(), tile.beside.end());
  for (const std::uint32_t t : tile.unsure) unsure_.push_back(from_least(tile.patch.triangles[t]));
}

std::vector<std::uint32_t> Remainder::not_done() const {
  std::vector<bool> done(sites_.size());
  for (std::uint32_t s = 0; s < sites_.size(); ++s) done[s] = is_complete(s);
  for (const auto& [site, neighbour] : beside_)
    if (!is_complete(neighbour)) done[site] = false;
  std::vector<std::uint32_t> sites;
  for (std::uint32_t s = 0; s < sites_.size(); ++s)
    if (!done[s]) sites.push_back(s);
  return sites;
}

/// In ascending order.
std::vector<Remainder::Corners> Remainder::told_among_incomplete() const {
  std::vector<Corners> told;
  for (const Corners& t : unsure_)
    if (std::none_of(t.begin(), t.end(), [&](meshops::Site s) { return is_complete(s); })) told.push_back(t);
  std::sort(told.begin(), told.end());
  return told;
}

void Remainder::complete(meshops::Patch& patch, meshops::Outline& outline, Threads& threads,
                         const std::function<void()>& working) const {
  if (sites_.beyond().empty()) {
    const auto points = sites_.grid().points();
    const auto at = [&](std::uint32_t s) { return points[s]; };
    complete<double>(at, sites_.window().scaled(alpha_), patch, outline, threads, working);
  } else {
    const auto at = [&](std::uint32_t s) { return sites_.at(s); };
    complete<long double>(at, alpha_, patch, outline, threads, working);
  }
}

/// `at` tells where a site lies, and the radius is alpha as it is there.
template <typename Real, typename At>
void Remainder::complete(At at, const Radius& radius, meshops::Patch& patch, meshops::Outline& outline,
                         Threads& threads, const std::function<void()>& working) const {
  std::vector<Place> places;
  for (const std::uint32_t s : not_done()) places.push_back({at(s), s});

  // Of the triangles of these only those without a complete corner are surely Delaunay among all points.
  const std::vector<Corners> told = told_among_incomplete();
  const auto fate = [&](const Place& a, const Place& b, const Place& c) -> int {
    if (!radius.admits<Real>(a.at, b.at, c.at)) return meshops::Patch::nothing;
    if (is_complete(a.site) || is_complete(b.site) || is_complete(c.site)) return meshops::Patch::open;
    if (told.empty()) return 0;
    const auto site = [](const Place& p) { return p.site; };
    const Corners corners = from_least({site(a), site(b), site(c)});
    return std::binary_search(told.begin(), told.end(), corners) ? meshops::Patch::open : 0;
  };
  delaunay<Real>(places, fate, threads, patch, outline, working);
}

}  // namespace rbpa
