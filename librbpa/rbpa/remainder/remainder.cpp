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
  std::vector<bool> done(points_.size());
  for (std::uint32_t s = 0; s < points_.size(); ++s) done[s] = is_complete(s);
  for (const auto& [site, neighbour] : beside_)
    if (!is_complete(neighbour)) done[site] = false;
  std::vector<std::uint32_t> sites;
  for (std::uint32_t s = 0; s < points_.size(); ++s)
    if (!done[s]) sites.push_back(s);
  return sites;
}

/// In ascending order.
std::vector<Remainder::Corners> Remainder::told_among_incomplete() const {
  std::vector<Corners> told;
  for (const Corners& t : unsure_)
    if (std::none_of(t.begin(), t.end(), [&](meshops::Site s) { return is_complete(static_cast<std::uint32_t>(s)); }))
      told.push_back(t);
  std::sort(told.begin(), told.end());
  return told;
}

void Remainder::complete(meshops::Patch& patch, const std::function<void()>& working) const {
  const std::vector<std::uint32_t> sites = not_done();
  std::vector<Point> points;
  points.reserve(sites.size());
  for (const std::uint32_t s : sites) points.push_back(points_[s]);
  delaunay(points, patch, working);

  // Of these triangles only those without a complete corner are surely Delaunay among all points.
  const std::vector<Corners> told = told_among_incomplete();
  std::vector<int> number(patch.triangles.size());  // among those that are missing, or what others are told of it
  int missing = 0;
  for (std::size_t t = 0; t < number.size(); ++t) {
    Corners& corners = patch.triangles[t];
    for (meshops::Site& s : corners) s = static_cast<meshops::Site>(sites[static_cast<std::size_t>(s)]);
    const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
    if (!radius_.admits<double>(points_[at(0)], points_[at(1)], points_[at(2)]))
      number[t] = meshops::Patch::nothing;
    else if (is_complete(at(0)) || is_complete(at(1)) || is_complete(at(2)) ||
             std::binary_search(told.begin(), told.end(), from_least(corners)))
      number[t] = meshops::Patch::open;
    else
      number[t] = missing++;
  }
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (number[t] < 0) continue;
    const auto to = static_cast<std::size_t>(number[t]);
    patch.triangles[to] = patch.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const int across = patch.across[t][i];
      const int other =
          across == meshops::Patch::open ? meshops::Patch::nothing : number[static_cast<std::size_t>(across) / 3];
      patch.across[to][i] = other < 0 ? other : 3 * other + across % 3;
    }
  }
  patch.triangles.resize(static_cast<std::size_t>(missing));
  patch.across.resize(static_cast<std::size_t>(missing));
}

}  // namespace rbpa
