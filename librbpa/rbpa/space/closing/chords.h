// What: the chords of a rim that a triangulation of it may use, sides included.
// Why:  all of them are n²/2, and the triangles on them n³/6. Of a long rim the nearest are enough, on each of several levels:
//       every second corner, every fourth and so on, so that there are triangulations in which wide parts have long chords.
// Law:  a function of the places of the corners and where the rim begins.
// Cost: n² for the nearest, some tens of chords a corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/closing/rim.h"

namespace rbpa::space {

/// Corners low < high of a rim.
using Chord = std::pair<std::uint32_t, std::uint32_t>;

/// All that are candidates, and the sides, sorted. Throws: Cancelled.
std::vector<Chord> candidate_chords(const Rim& rim, meshops::Steps& step);

/// Chords by number: sorted by low, then high.
class Chords {
 public:
  /// The candidates of a rim of so many corners, without the forbidden ones, which are sorted.
  Chords(std::size_t corners, std::vector<Chord> candidates, std::span<const Chord> forbidden);

  std::size_t size() const { return chords_.size(); }
  const Chord& operator[](std::size_t number) const { return chords_[number]; }
  /// Whether every chord that is not forbidden is a candidate, and whether none is missing.
  bool are_all() const { return all_; }
  bool is_complete() const { return chords_.size() == (first_to_.size() - 1) * (first_to_.size() - 2) / 2; }
  /// Of those from a corner upward the first number; of the corner behind the last one the end.
  std::uint32_t first_from(std::uint32_t corner) const { return first_from_[corner]; }
  /// The same by their higher ends: of all sorted by high, then low, the first place of those to a corner.
  std::uint32_t first_to(std::uint32_t corner) const { return first_to_[corner]; }
  /// Where a chord is in that order, and which is at a place.
  std::uint32_t place_to(std::size_t number) const { return place_to_[number]; }
  std::uint32_t number_at(std::size_t place) const { return numbers_[place]; }
  /// The higher end of a number, the lower end at a place.
  const std::vector<std::uint32_t>& highs() const { return highs_; }
  const std::vector<std::uint32_t>& lows() const { return lows_; }
  /// The number of a chord that there is.
  std::uint32_t number_of(const Chord& chord) const;

 private:
  bool all_;
  std::vector<Chord> chords_;
  std::vector<std::uint32_t> first_from_, first_to_, place_to_, numbers_, highs_, lows_;
};

}  // namespace rbpa::space
