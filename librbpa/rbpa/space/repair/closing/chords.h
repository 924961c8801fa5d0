// What: chooses the chords of a rim that its triangulation may use. The sides of the rim count as chords.
// Why:  a rim of n corners has n²/2 chords, and n³/6 triangles on them. For a long rim, the nearest chords on several
//       levels suffice: between all corners, between every second corner, every fourth, and so on, so that wide parts
//       get long chords.
// Law:  a function of the places of the corners and of the corner at which the rim begins.
// Cost: n log n unless the spacing of corners varies much along the rim, n² at most; some tens of chords a corner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/repair/closing/rim.h"

namespace rbpa::space {

/// A chord between corners low < high of a rim.
using Chord = std::pair<std::uint32_t, std::uint32_t>;

/// Returns all candidate chords and the sides of the rim, sorted. Throws: Cancelled.
std::vector<Chord> candidate_chords(const Rim& rim, meshops::Steps& step);

/// Chords, numbered in ascending order of the low end, then of the high end.
class Chords {
 public:
  /// Takes the candidates of a rim of `corners` corners, except the forbidden chords. Requires: both are sorted.
  Chords(std::size_t corners, std::vector<Chord> candidates, std::span<const Chord> forbidden);

  std::size_t size() const { return chords_.size(); }
  const Chord& operator[](std::size_t number) const { return chords_[number]; }
  /// Returns whether every chord of the rim that is not forbidden is among the chords. is_complete() returns whether
  /// every chord of the rim is.
  bool are_all() const { return all_; }
  bool is_complete() const { return chords_.size() == (first_to_.size() - 1) * (first_to_.size() - 2) / 2; }
  /// Returns the number of the first chord with the low end `corner`; for the corner after the last, the number of
  /// chords.
  std::uint32_t first_from(std::uint32_t corner) const { return first_from_[corner]; }
  /// Returns the first place of the chords with the high end `corner`, in the order by high, then low end.
  std::uint32_t first_to(std::uint32_t corner) const { return first_to_[corner]; }
  /// Returns the place of a chord in the order of the high end, then of the low end. number_at() is the inverse.
  std::uint32_t place_to(std::size_t number) const { return place_to_[number]; }
  std::uint32_t number_at(std::size_t place) const { return numbers_[place]; }
  /// Returns the high end of each chord, by its number. lows() returns the low end of each chord, by its place.
  const std::vector<std::uint32_t>& highs() const { return highs_; }
  const std::vector<std::uint32_t>& lows() const { return lows_; }
  /// Returns the number of a chord. Requires: the chord is among the chords.
  std::uint32_t number_of(const Chord& chord) const;

 private:
  bool all_;
  std::vector<Chord> chords_;
  std::vector<std::uint32_t> first_from_, first_to_, place_to_, numbers_, highs_, lows_;
};

}  // namespace rbpa::space
