#include "rbpa/plane/arrays/linked_triangles.h"

#include <algorithm>
#include <mutex>

#include "meshops/core/large_pages.h"

namespace rbpa {

using meshops::Patch;
using meshops::Site;

LinkedTriangles::LinkedTriangles(std::size_t sites, std::span<const std::uint32_t> names, std::size_t bound,
                                 const Threads& threads)
    // In the plane there are fewer than two triangles a site.
    : names_(names), order_(bound, 2 * sites, threads.count()), neighbors_(2 * sites) {
  seams_.begin(sites);
}

void LinkedTriangles::prepare(const Patch& patch, Place& place) const {
  place.open.clear();
  place.turns.resize(patch.triangles.size());
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto& corner = patch.triangles[t];
    const Triangle named = {names_[corner[0]], names_[corner[1]], names_[corner[2]]};
    place.turns[t] = static_cast<std::uint8_t>(std::min_element(named.begin(), named.end()) - named.begin());
    for (int i = 0; i < 3; ++i)
      if (patch.across[t][static_cast<std::size_t>(i)] == Patch::open)
        place.open.push_back(3 * static_cast<int>(t) + i);
  }
}

void LinkedTriangles::place(const Patch& patch, Place& place) {
  place.first = size_;
  size_ += patch.triangles.size();
  for (const int side : place.open) {
    const auto s = static_cast<std::size_t>(side);
    const auto& corner = patch.triangles[s / 3];
    const Site from = corner[s % 3], to = corner[(s + 1) % 3];
    const Open here{to, static_cast<std::uint32_t>(place.first + s / 3),
                    static_cast<std::uint32_t>(across_from(s % 3, place.turns[s / 3]))};
    const auto beyond = seams_.take(to, [&](const Open& other) { return other.to == from; });
    neighbors_[here.triangle][here.corner] = beyond ? beyond->triangle : none;
    if (beyond)
      neighbors_[beyond->triangle][beyond->corner] = here.triangle;
    else
      seams_.add(from, here);
  }
}

void LinkedTriangles::fill(const Patch& patch, const Place& place) {
  order_.with_writer([&](CanonicalOrder<NumberedTriangle>::Writer& writer) {
    auto number = static_cast<std::uint32_t>(place.first);
    for_each_triangle(patch, names_, [&](const Triangle& triple) { writer.add({triple, number++}); });
  });
  for (std::size_t t = 0; t < patch.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const int across = patch.across[t][i];
      if (across == Patch::open) continue;  // place() has written this neighbor
      neighbors_[place.first + t][across_from(i, place.turns[t])] =
          across == Patch::nothing ? none
                                   : static_cast<std::uint32_t>(place.first + static_cast<std::size_t>(across) / 3);
    }
}

OwnedTriangles LinkedTriangles::sorted(Threads& threads, const Checkpoint& checkpoint) {
  constexpr std::size_t triangles_at_a_time = 1u << 16;
  seams_.end();
  OwnedTriangles result;
  meshops::FreshVector<std::uint32_t> rank(size_);
  result.triangles = order_.sorted_with_ranks(threads, rank.data(), checkpoint);
  order_.end();
  meshops::reserve_in_large_pages(result.neighbors, size_);
  result.neighbors.resize(size_);
  std::mutex calling;
  for_each_part(threads, size_, triangles_at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = neighbors_[t][k];
        result.neighbors[rank[t]][k] = other == none ? none : rank[other];
      }
    if (!checkpoint) return;
    const std::lock_guard lock(calling);
    checkpoint();
  });
  neighbors_ = meshops::FreshVector<Triangle>();
  return result;
}

}  // namespace rbpa
