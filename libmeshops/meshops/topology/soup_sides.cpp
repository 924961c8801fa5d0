#include "meshops/topology/soup_sides.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "meshops/core/contract.h"

namespace meshops::detail {
namespace {

FaceFault fault_of(std::span<const std::uint32_t> face, std::size_t points, std::vector<std::uint32_t>& scratch,
                   Steps& step) {
  for (const std::uint32_t corner : face)
    if (corner >= points) return FaceFault::out_of_range;
  if (face.size() < 3) return FaceFault::degenerate;
  if (face.size() == 3)
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0] ? FaceFault::degenerate : FaceFault::none;
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end(), [&](std::uint32_t a, std::uint32_t b) {
    step();
    return a < b;
  });
  return std::adjacent_find(scratch.begin(), scratch.end()) == scratch.end() ? FaceFault::none : FaceFault::degenerate;
}

/// Sets `cycle` to the corners of `face`, from the least corner on, toward its lesser neighbor. The result is the same
/// for every way to write a face.
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

/// Filter that excludes nearly all faces without a duplicate before faces are compared in full.
class SeenTwice {
 public:
  SeenTwice(const PolygonSoup& soup, const FaceFaults& faults, Steps& step)
      : shift_(65U - std::bit_width(32 * std::max(soup.faces(), std::size_t{1}))),
        once_(words(), 0),
        twice_(words(), 0) {
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      step();
      if (faults.of[f] != FaceFault::none) continue;
      const Place at = place_of(soup.face(f));
      (once_[at.word] & at.bit ? twice_ : once_)[at.word] |= at.bit;
    }
  }
  /// Returns false only if no other face has these corners.
  bool operator()(std::span<const std::uint32_t> face) const {
    const Place at = place_of(face);
    return (twice_[at.word] & at.bit) != 0;
  }

 private:
  struct Place {
    std::size_t word;
    std::uint64_t bit;
  };
  /// Returns one of about 16 to 32 slots per face, by a sum over the corners, in whatever order.
  Place place_of(std::span<const std::uint32_t> face) const {
    std::uint64_t sum = 0;
    for (const std::uint32_t corner : face) {
      const std::uint64_t mixed = (corner + std::uint64_t{1}) * 0x9E3779B97F4A7C15ULL;
      sum += (mixed ^ mixed >> 32U) * 0xD6E8FEB86659FD93ULL;
    }
    const std::uint64_t place = sum >> shift_;
    return {place / 64, std::uint64_t{1} << place % 64};
  }
  std::size_t words() const { return (std::size_t{1} << (64U - shift_)) / 64 + 1; }

  std::size_t shift_;
  FreshVector<std::uint64_t> once_, twice_;
};

void find_duplicates(const PolygonSoup& soup, FaceFaults& faults, const GoOn& go_on) {
  struct Key {
    std::uint64_t hash;
    std::size_t face;
  };
  std::vector<Key> keys;
  std::vector<std::uint32_t> cycle, other;
  Steps step(go_on);
  const SeenTwice seen_twice(soup, faults, step);
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step();
    if (faults.of[f] != FaceFault::none || !seen_twice(soup.face(f))) continue;
    canonical_cycle(soup.face(f), cycle);
    keys.push_back({hash_of(cycle), f});
  }
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    step();
    return a.hash != b.hash ? a.hash < b.hash : a.face < b.face;
  });
  for (std::size_t i = 0; i < keys.size(); ++i) {
    // Searches the earlier faces with this hash. They are few unless one face has many duplicates.
    canonical_cycle(soup.face(keys[i].face), cycle);
    for (std::size_t k = i; k-- > 0 && keys[k].hash == keys[i].hash;) {
      step();
      const std::size_t earlier = keys[k].face;
      canonical_cycle(soup.face(earlier), other);
      if (other != cycle) continue;
      faults.of[keys[i].face] = FaceFault::duplicate;
      faults.repeats.resize(soup.faces());
      faults.repeats[keys[i].face] = faults.of[earlier] == FaceFault::duplicate ? faults.repeats[earlier] : earlier;
      break;
    }
  }
}

/// Sorts sides of the same lower end by the higher end, then by face. Requires: the sides are in the order of faces.
template <typename Iterator>
void sort_by_high(Iterator first, Iterator last, Steps& step) {
  constexpr auto few = 16;  // nearly all points have at most this number of sides, which are sorted by insertion
  if (last - first > few)
    return std::stable_sort(first, last, [&](const SoupSide& a, const SoupSide& b) {
      step();
      return a.high < b.high;
    });
  for (auto next = first; next != last; ++next) {
    const SoupSide side = *next;
    auto to = next;
    for (; to != first && std::prev(to)->high > side.high; --to) *to = *std::prev(to);
    *to = side;
  }
}

/// Returns whether two faces with the same cycle of corners run in opposite directions.
bool run_against(std::span<const std::uint32_t> one, std::span<const std::uint32_t> other) {
  const auto at = std::find(other.begin(), other.end(), one[0]);
  return (at + 1 == other.end() ? other.front() : at[1]) != one[1];
}

/// Returns whether four sides meet at an edge, two in each direction.
bool is_double(std::span<const SoupSide> edge) {
  return edge.size() == 4 && std::count_if(edge.begin(), edge.end(), [](const auto& s) { return s.ascending(); }) == 2;
}

void require_readable(const PolygonSoup& soup) {
  require_parted(soup);
  constexpr std::size_t limit = std::size_t{1} << 30U;
  const std::size_t most = std::max({soup.corners.size(), std::size_t{soup.points}, soup.faces()});
  require(most < limit, "found a soup of ", static_cast<long long>(most),
          " corners, points or faces, expected fewer than 2^30 of each");
}

}  // namespace

FaceFaults find_face_faults(const PolygonSoup& soup, const GoOn& go_on) {
  require_readable(soup);
  FaceFaults faults{std::vector<FaceFault>(soup.faces()), {}};
  std::vector<std::uint32_t> scratch;
  Steps step(go_on);
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step();
    faults.of[f] = fault_of(soup.face(f), soup.points, scratch, step);
  }
  find_duplicates(soup, faults, go_on);
  return faults;
}

void keep_walls(const PolygonSoup& soup, FaceFaults& faults, const GoOn& go_on) {
  constexpr std::uint32_t none = FaceFaults::none;
  if (faults.repeats.empty()) return;
  Steps step(go_on);
  std::vector<std::uint32_t> copies(soup.faces(), 0), twin(soup.faces(), none);
  for (std::size_t f = 0; f < soup.faces(); ++f) copies[faults.repeats[f]] += faults.of[f] == FaceFault::duplicate;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step();
    const std::size_t first = faults.repeats[f];
    if (faults.of[f] != FaceFault::duplicate || copies[first] != 1 || !run_against(soup.face(first), soup.face(f)))
      continue;
    twin[f] = static_cast<std::uint32_t>(first);
    twin[first] = static_cast<std::uint32_t>(f);
    faults.of[f] = FaceFault::none;
  }
  const SoupSides sides(soup, faults, go_on);
  DisjointSets walls(soup.faces());
  std::vector<std::uint32_t> wrong;
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    const auto edge = sides.edge(e);
    step(edge.size());
    std::uint32_t last = none;
    for (const SoupSide& side : edge) {
      if (twin[side.face()] == none) continue;
      if (last != none) walls.unite(last, side.face());
      last = side.face();
    }
    if (last != none && !is_double(edge)) wrong.push_back(last);
  }
  std::vector<bool> is_wrong(soup.faces(), false);
  for (const std::uint32_t f : wrong) is_wrong[walls.find(f)] = true;
  for (std::uint32_t f = 0; f < soup.faces(); ++f) {
    if (twin[f] == none) continue;
    if (!is_wrong[walls.find(f)]) {
      faults.twin.resize(soup.faces(), none);
      faults.twin[f] = twin[f];
    } else if (twin[f] < f) {
      faults.of[f] = FaceFault::duplicate;
    }
  }
}

std::optional<std::array<std::array<SoupSide, 2>, 2>> sides_of_wall(std::span<const SoupSide> edge,
                                                                    const std::vector<std::uint32_t>& twin) {
  if (twin.empty() || !is_double(edge)) return std::nullopt;
  for (const SoupSide& one : edge) {
    if (twin[one.face()] == FaceFaults::none) continue;
    std::array<std::array<SoupSide, 2>, 2> pairs{{{one, {}}, {}}};
    for (const SoupSide& other : edge) {
      if (other.face() == one.face()) continue;
      if (other.face() == twin[one.face()])
        pairs[1][0] = other;
      else
        pairs[other.ascending() == one.ascending() ? 1 : 0][1] = other;
    }
    return pairs;
  }
  return std::nullopt;
}

bool has_sound_faces(const PolygonSoup& soup, const GoOn& go_on) {
  require_readable(soup);
  std::vector<std::uint32_t> scratch;
  Steps step(go_on);
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step();
    if (fault_of(soup.face(f), soup.points, scratch, step) != FaceFault::none) return false;
  }
  return true;
}

SoupSides::SoupSides(const PolygonSoup& soup, const FaceFaults& faults, const GoOn& go_on) {
  bring_together(
      soup, [&](std::size_t f) { return faults.of[f] == FaceFault::none; }, go_on);
}

SoupSides::SoupSides(const PolygonSoup& soup, const GoOn& go_on) {
  bring_together(
      soup, [](std::size_t) { return true; }, go_on);
}

template <typename IsGiven>
void SoupSides::bring_together(const PolygonSoup& soup, IsGiven is_given, const GoOn& go_on) {
  // Sides are first counted into buckets by the lower point, so that the sorting is local. A bucket ends where the next
  // bucket begins. While a bucket is filled, its entry in `bucket` is the place of its next side.
  std::vector<std::uint32_t> bucket(soup.points + 2, 0);
  Steps step(go_on);
  const auto for_each_side = [&](auto visit) {
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      if (!is_given(f)) continue;
      const auto begin = static_cast<std::uint32_t>(soup.begin[f]), end = static_cast<std::uint32_t>(soup.begin[f + 1]);
      for (std::uint32_t c = begin; c < end; ++c) {
        step();
        const std::uint32_t next = c + 1 < end ? c + 1 : begin, from = soup.corners[c], to = soup.corners[next];
        visit(SoupSide(std::min(from, to), std::max(from, to), c, next, static_cast<std::uint32_t>(f), from < to));
      }
    }
  };
  for_each_side([&](const SoupSide& s) { ++bucket[s.low + 2]; });
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
  sides_.resize(bucket.back());
  for_each_side([&](const SoupSide& s) { sides_[bucket[s.low + 1]++] = s; });
  begin_.reserve(sides_.size() / 2 + soup.points + 1);
  for (std::size_t p = 0; p < soup.points; ++p) {
    step();
    const auto first = sides_.begin() + bucket[p], last = sides_.begin() + bucket[p + 1];
    sort_by_high(first, last, step);
    for (auto s = first; s != last; ++s)
      if (s == first || s->high != std::prev(s)->high) begin_.push_back(static_cast<std::uint32_t>(s - sides_.begin()));
  }
  begin_.push_back(static_cast<std::uint32_t>(sides_.size()));
}

bool is_manifold(const PolygonSoup& soup, const SoupSides& sides, const GoOn& go_on) {
  std::vector<std::uint32_t> cycle, other;
  Steps step(go_on);
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    step();
    const auto edge = sides.edge(e);
    if (!fits(edge)) return false;
    if (edge.size() < 2) continue;
    // Faces with the same corners share all edges, including the edge of the first side of each face.
    if (edge[0].corner != soup.begin[edge[0].face()]) continue;
    const auto one = soup.face(edge[0].face()), two = soup.face(edge[1].face());
    if (one.size() != two.size() || std::find(two.begin(), two.end(), one[2]) == two.end()) continue;
    canonical_cycle(one, cycle);
    canonical_cycle(two, other);
    if (cycle == other) return false;
  }
  return true;
}

}  // namespace meshops::detail
