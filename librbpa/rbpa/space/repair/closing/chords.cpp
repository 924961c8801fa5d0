#include "rbpa/space/repair/closing/chords.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "rbpa/base/run/steps.h"
#include "rbpa/space/cells/box_tree.h"

namespace rbpa::space {
namespace {

constexpr std::size_t all_up_to = 256;  // corners; up to this number all chords are candidates
constexpr std::size_t nearest = 24, along = 8;

/// Adds the chords of one level: from each of `corners` to its 24 nearest others, and to the next 8 along the rim.
/// Requires: more than 24 corners.
void add_level(const Rim& rim, std::span<const std::uint32_t> corners, std::vector<Chord>& chords,
               meshops::Steps& step) {
  std::vector<Box> boxes(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector& at = rim.places[corners[i]];
    boxes[i].include(Point3{at.x, at.y, at.z});
  }
  const BoxTree tree(boxes, step);
  std::vector<std::pair<double, std::uint32_t>> others;
  double reach = 1;  // reaches all corners at first; later, a bit more than the corner before needed
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto is_within = [&](const auto& other) { return other.first <= reach * reach; };
    // The box is a bit wider than the reach, so that rounding excludes no corner within the reach.
    for (bool enough = false; !enough; reach *= enough ? 1 : 2) {
      others.clear();
      const double wide = reach * (1 + 0x1p-30);
      const auto [x, y, z] = boxes[i].low;
      tree.for_each_meeting({{x - wide, y - wide, z - wide}, {x + wide, y + wide, z + wide}}, [&](std::uint32_t k) {
        step();
        const Vector d = rim.places[corners[k]] - rim.places[corners[i]];
        if (k != i) others.emplace_back(dot(d, d), corners[k]);
      });
      enough = static_cast<std::size_t>(std::count_if(others.begin(), others.end(), is_within)) >= nearest;
    }
    std::nth_element(others.begin(), others.begin() + nearest - 1, others.end());
    others.resize(nearest);
    constexpr double least = 0x1p-60;  // so that its square does not underflow
    reach = std::max(1.25 * std::sqrt(others.back().first), least);
    for (std::size_t ahead = 1; ahead <= std::min(along, corners.size() - 1); ++ahead)
      others.emplace_back(0, corners[(i + ahead) % corners.size()]);
    for (const auto& [square, other] : others) chords.push_back(std::minmax(corners[i], other));
  }
}

}  // namespace

std::vector<Chord> candidate_chords(const Rim& rim, meshops::Steps& step) {
  const bool all = rim.size() <= all_up_to;
  const auto size = static_cast<std::uint32_t>(rim.size());
  std::vector<Chord> chords;
  std::vector<std::uint32_t> corners(size);
  std::iota(corners.begin(), corners.end(), std::uint32_t{0});
  constexpr std::size_t all_at_the_top = 64;
  while (!all && corners.size() > all_at_the_top) {
    add_level(rim, corners, chords, step);
    for (std::size_t i = 0; 2 * i < corners.size(); ++i) corners[i] = corners[2 * i];
    corners.resize((corners.size() + 1) / 2);
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) chords.emplace_back(corners[i], corners[j]);
  if (!all) sort(chords, step, std::less<>());
  chords.erase(std::unique(chords.begin(), chords.end()), chords.end());
  return chords;
}

Chords::Chords(std::size_t corners, std::vector<Chord> candidates, std::span<const Chord> forbidden)
    : all_(corners <= all_up_to),
      chords_(std::move(candidates)),
      first_from_(corners + 1, 0),
      first_to_(corners + 1, 0) {
  const auto last = static_cast<std::uint32_t>(corners) - 1;
  std::erase_if(chords_, [&](const Chord& chord) {
    const bool is_side = chord.second == chord.first + 1 || (chord.first == 0 && chord.second == last);
    return !is_side && std::binary_search(forbidden.begin(), forbidden.end(), chord);
  });
  for (const auto& [low, high] : chords_) {
    ++first_from_[low + 1];
    ++first_to_[high + 1];
  }
  std::partial_sum(first_from_.begin(), first_from_.end(), first_from_.begin());
  std::partial_sum(first_to_.begin(), first_to_.end(), first_to_.begin());
  std::vector<std::uint32_t> next(first_to_.begin(), first_to_.end() - 1);
  lows_.resize(chords_.size());
  numbers_.resize(chords_.size());
  for (const auto& [low, high] : chords_) {
    place_to_.push_back(next[high]++);
    numbers_[place_to_.back()] = static_cast<std::uint32_t>(highs_.size());
    highs_.push_back(high);
    lows_[place_to_.back()] = low;
  }
}

std::uint32_t Chords::number_of(const Chord& chord) const {
  const auto first = highs_.begin() + first_from_[chord.first], last = highs_.begin() + first_from_[chord.first + 1];
  return static_cast<std::uint32_t>(std::lower_bound(first, last, chord.second) - highs_.begin());
}

}  // namespace rbpa::space
