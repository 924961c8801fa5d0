#include "rbpa/arrays/triangle_list.h"

#include <algorithm>
#include <utility>

namespace rbpa {

using meshops::Patch;
using meshops::Site;

TriangleList::TriangleList(std::size_t sites, std::span<const std::uint32_t> names, bool with_neighbors)
    : names_(names), with_neighbors_(with_neighbors) {
  // In the plane there are fewer than two triangles a site.
  lists_.triangles.resize(2 * sites);
  if (!with_neighbors) return;
  lists_.neighbors.resize(2 * sites);
  seams_.begin(sites);
}

void TriangleList::prepare(const Patch& patch, Place& place) const {
  if (!with_neighbors_) return;
  place.open.clear();
  place.turns.resize(patch.triangles.size());
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto& corner = patch.triangles[t];
    const Triple named = {names_[corner[0]], names_[corner[1]], names_[corner[2]]};
    place.turns[t] = static_cast<std::uint8_t>(std::min_element(named.begin(), named.end()) - named.begin());
    for (int i = 0; i < 3; ++i)
      if (patch.across[t][static_cast<std::size_t>(i)] == Patch::open)
        place.open.push_back(3 * static_cast<int>(t) + i);
  }
}

void TriangleList::place(const Patch& patch, Place& place) {
  place.first = size_;
  size_ += patch.triangles.size();
  if (!with_neighbors_) return;
  for (const int side : place.open) {
    const auto s = static_cast<std::size_t>(side);
    const auto& corner = patch.triangles[s / 3];
    const Site from = corner[s % 3], to = corner[(s + 1) % 3];
    const Open here{to, static_cast<std::uint32_t>(place.first + s / 3),
                    static_cast<std::uint32_t>(across_from(s % 3, place.turns[s / 3]))};
    const auto beyond = seams_.take(to, [&](const Open& other) { return other.to == from; });
    lists_.neighbors[here.triangle][here.corner] = beyond ? beyond->triangle : none;
    if (beyond)
      lists_.neighbors[beyond->triangle][beyond->corner] = here.triangle;
    else
      seams_.add(from, here);
  }
}

void TriangleList::fill(const Patch& patch, const Place& place) {
  Triple* const triangles = lists_.triangles.data() + place.first;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto& corner = patch.triangles[t];
    const std::uint32_t a = names_[corner[0]], b = names_[corner[1]], c = names_[corner[2]];
    // Which is the least is a toss of a coin, so that nothing branches.
    const bool b_first = (b < a) & (b < c), c_first = (c < a) & (c < b);
    const std::uint32_t first = b_first ? b : c_first ? c : a, second = b_first ? c : c_first ? a : b;
    triangles[t] = {first, second, a ^ b ^ c ^ first ^ second};
  }
  if (!with_neighbors_) return;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int across = patch.across[t][i];
      if (across == Patch::open) continue;  // place() has written it
      lists_.neighbors[place.first + t][across_from(i, place.turns[t])] =
          across == Patch::nothing ? none
                                   : static_cast<std::uint32_t>(place.first + static_cast<std::size_t>(across) / 3);
    }
}

TriangleList::Lists TriangleList::take() {
  lists_.triangles.resize(size_);
  if (with_neighbors_) lists_.neighbors.resize(size_);
  seams_.end();
  return std::move(lists_);
}

}  // namespace rbpa
