#include "meshops/topology/soup_sides.h"

#include <algorithm>
#include <numeric>

#include "meshops/core/contract.h"

namespace meshops::detail {
namespace {

FaceFault fault_of(std::span<const std::uint32_t> face, std::size_t points, std::vector<std::uint32_t>& scratch) {
  for (const std::uint32_t corner : face)
    if (corner >= points) return FaceFault::out_of_range;
  if (face.size() < 3) return FaceFault::degenerate;
  if (face.size() == 3)
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0] ? FaceFault::degenerate : FaceFault::none;
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) == scratch.end() ? FaceFault::none : FaceFault::degenerate;
}

/// The cycle from its least corner on, in the direction of the lesser neighbour: the same for every way to write a
/// face.
void canonical_cycle(std::span<const std::uint32_t> face, std::vector<std::uint32_t>& cycle) {
  cycle.assign(face.begin(), face.end());
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  if (cycle[1] > cycle.back()) std::reverse(cycle.begin() + 1, cycle.end());
}

std::uint64_t hash_of(const std::vector<std::uint32_t>& cycle) {
  std::uint64_t hash = cycle.size();
  for (const std::uint32_t corner : cycle) hash = (hash ^ corner) * 0x9E3779B97F4A7C15ULL ^ hash >> 29U;
  return hash;
}

void find_duplicates(const PolygonSoup& soup, FaceFaults& faults) {
  struct Key {
    std::uint64_t hash;
    std::size_t face;
  };
  std::vector<Key> keys;
  std::vector<std::uint32_t> cycle, other;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (faults.of[f] != FaceFault::none) continue;
    canonical_cycle(soup.face(f), cycle);
    keys.push_back({hash_of(cycle), f});
  }
  std::sort(keys.begin(), keys.end(),
            [](const Key& a, const Key& b) { return a.hash != b.hash ? a.hash < b.hash : a.face < b.face; });
  for (std::size_t i = 0; i < keys.size(); ++i) {
    // Among the earlier faces with this hash, which are few unless there are many duplicates of one face.
    canonical_cycle(soup.face(keys[i].face), cycle);
    for (std::size_t k = i; k-- > 0 && keys[k].hash == keys[i].hash;) {
      const std::size_t earlier = keys[k].face;
      canonical_cycle(soup.face(earlier), other);
      if (other != cycle) continue;
      faults.of[keys[i].face] = FaceFault::duplicate;
      faults.repeats[keys[i].face] = faults.of[earlier] == FaceFault::duplicate ? faults.repeats[earlier] : earlier;
      break;
    }
  }
}

void require_handles_suffice(const PolygonSoup& soup) {
  constexpr std::size_t limit = std::size_t{1} << 30U;
  require(soup.corners.size() < limit && soup.points < limit && soup.faces() < limit,
          "a soup has 2^30 corners, points or faces, or more");
}

}  // namespace

FaceFaults find_face_faults(const PolygonSoup& soup) {
  require_handles_suffice(soup);
  FaceFaults faults{std::vector<FaceFault>(soup.faces()), std::vector<std::size_t>(soup.faces())};
  std::vector<std::uint32_t> scratch;
  for (std::size_t f = 0; f < soup.faces(); ++f) faults.of[f] = fault_of(soup.face(f), soup.points, scratch);
  find_duplicates(soup, faults);
  return faults;
}

bool has_sound_faces(const PolygonSoup& soup) {
  require_handles_suffice(soup);
  std::vector<std::uint32_t> scratch;
  for (std::size_t f = 0; f < soup.faces(); ++f)
    if (fault_of(soup.face(f), soup.points, scratch) != FaceFault::none) return false;
  return true;
}

SoupSides::SoupSides(const PolygonSoup& soup, const FaceFaults& faults) : soup_(soup) {
  bring_together([&](std::size_t f) { return faults.of[f] == FaceFault::none; });
}

SoupSides::SoupSides(const PolygonSoup& soup) : soup_(soup) {
  bring_together([](std::size_t) { return true; });
}

template <typename IsGiven>
void SoupSides::bring_together(IsGiven is_given) {
  // Counted into buckets by the lower point first: sorting is then local. A bucket ends where the next one begins;
  // while it is filled, its place in the list says where the next side goes.
  std::vector<std::uint32_t> bucket(soup_.points + 2, 0);
  const auto for_each_side = [&](auto visit) {
    for (std::size_t f = 0; f < soup_.faces(); ++f) {
      if (!is_given(f)) continue;
      const auto face = soup_.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t from = face[i], to = face[i + 1 < face.size() ? i + 1 : 0];
        visit(SoupSide{std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(soup_.begin[f] + i),
                       static_cast<std::uint32_t>(f), from < to});
      }
    }
  };
  for_each_side([&](const SoupSide& s) { ++bucket[s.low + 2]; });
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  sides_.resize(bucket.back());
  for_each_side([&](const SoupSide& s) { sides_[bucket[s.low + 1]++] = s; });
  begin_.reserve(sides_.size() / 2 + soup_.points + 1);
  for (std::size_t p = 0; p < soup_.points; ++p) {
    const auto first = sides_.begin() + bucket[p], last = sides_.begin() + bucket[p + 1];
    std::sort(first, last, [](const SoupSide& a, const SoupSide& b) {
      return a.high != b.high ? a.high < b.high : a.face < b.face;
    });
    for (auto s = first; s != last; ++s)
      if (s == first || s->high != std::prev(s)->high) begin_.push_back(static_cast<std::size_t>(s - sides_.begin()));
  }
  begin_.push_back(sides_.size());
}

bool is_manifold(const PolygonSoup& soup, const SoupSides& sides) {
  std::vector<std::uint32_t> cycle, other;
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    if (!fits(edge)) return false;
    if (edge.size() < 2) continue;
    // Faces with the same corners share all edges, the first of one of them too.
    if (edge[0].corner != soup.begin[edge[0].face]) continue;
    const auto one = soup.face(edge[0].face), two = soup.face(edge[1].face);
    if (one.size() != two.size() || std::find(two.begin(), two.end(), one[2]) == two.end()) continue;
    canonical_cycle(one, cycle);
    canonical_cycle(two, other);
    if (cycle == other) return false;
  }
  return true;
}

std::uint32_t SoupSides::next_corner(const SoupSide& s) const {
  const std::size_t end = soup_.begin[s.face + 1];
  return s.corner + 1 < end ? s.corner + 1 : static_cast<std::uint32_t>(soup_.begin[s.face]);
}

}  // namespace meshops::detail
