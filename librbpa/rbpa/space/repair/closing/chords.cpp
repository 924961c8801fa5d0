#include "rbpa/space/repair/closing/chords.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "rbpa/base/run/steps.h"

namespace rbpa::space {
namespace {

constexpr std::size_t all_up_to = 256;  // corners; up to this number all chords are candidates
constexpr std::size_t nearest = 24, along = 8;

/// Adds the chords of one level: from each of `corners` to the 24 nearest of them, and to the next 8 along the rim.
void add_level(const Rim& rim, std::span<const std::uint32_t> corners, std::vector<Chord>& chords,
               meshops::Steps& step) {
  std::vector<std::pair<double, std::uint32_t>> others;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    step(corners.size() / 8 + 1);
    others.clear();
    for (const std::uint32_t other : corners) {
      const Vector d = rim.places[other] - rim.places[corners[i]];
      if (other != corners[i]) others.emplace_back(dot(d, d), other);
    }
    const std::size_t count = std::min(nearest, others.size());
    std::nth_element(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count) - 1, others.end());
    others.resize(count);
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
