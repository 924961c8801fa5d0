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

}  // namespace

FaceFaults find_face_faults(const PolygonSoup& soup) {
  constexpr std::size_t limit = std::size_t{1} << 30U;
  require(soup.corners.size() < limit && soup.points < limit && soup.faces() < limit,
          "a soup has 2^30 corners, points or faces, or more");
  FaceFaults faults{std::vector<FaceFault>(soup.faces()), std::vector<std::size_t>(soup.faces())};
  std::vector<std::uint32_t> scratch;
  for (std::size_t f = 0; f < soup.faces(); ++f) faults.of[f] = fault_of(soup.face(f), soup.points, scratch);
  find_duplicates(soup, faults);
  return faults;
}

SoupSides::SoupSides(const PolygonSoup& soup, const FaceFaults& faults) : soup_(soup) {
  // Counted into buckets by the lower point first: sorting is then local.
  std::vector<std::size_t> bucket(soup.points + 1, 0);
  const auto for_each_side = [&](auto visit) {
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      if (faults.of[f] != FaceFault::none) continue;
      const auto face = soup.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t from = face[i], to = face[i + 1 < face.size() ? i + 1 : 0];
        visit(SoupSide{std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(soup.begin[f] + i),
                       static_cast<std::uint32_t>(f), from < to});
      }
    }
  };
  for_each_side([&](const SoupSide& s) { ++bucket[s.low + 1]; });
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  sides_.resize(bucket.back());
  std::vector<std::size_t> next = bucket;
  for_each_side([&](const SoupSide& s) { sides_[next[s.low]++] = s; });
  for (std::size_t p = 0; p < soup.points; ++p)
    std::sort(sides_.begin() + static_cast<std::ptrdiff_t>(bucket[p]),
              sides_.begin() + static_cast<std::ptrdiff_t>(bucket[p + 1]), [](const SoupSide& a, const SoupSide& b) {
                return a.high != b.high ? a.high < b.high : a.face < b.face;
              });
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (i == 0 || sides_[i].low != sides_[i - 1].low || sides_[i].high != sides_[i - 1].high) begin_.push_back(i);
  begin_.push_back(sides_.size());
}

std::uint32_t SoupSides::next_corner(const SoupSide& s) const {
  const std::size_t end = soup_.begin[s.face + 1];
  return s.corner + 1 < end ? s.corner + 1 : static_cast<std::uint32_t>(soup_.begin[s.face]);
}

}  // namespace meshops::detail
