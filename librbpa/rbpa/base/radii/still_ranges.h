// What:   finds ranges of radii with a large ratio of their ends, over which a measure of change hardly grows.
// Law:    the ranges depend on the arguments alone; they stay when all radii are multiplied by one factor.
// Cost:   linear in the number of radii, for each range that is wanted.
// Source: docs/explanation/filtration_and_persistence.md, sections 6 and 7.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace rbpa {

/// The steps from `first` to `last`, the last excluded.
struct StepRange {
  std::size_t first, last;
};

class StillRanges {
 public:
  /// Takes for each step its radius, ascending, and the measure of change up to this radius, which never decreases. For
  /// the ratio of a range, an end beyond `reach` counts as `reach`. Keeps the span.
  StillRanges(std::span<const double> alpha, std::vector<long double> change, double reach)
      : alpha_(alpha), change_(std::move(change)), reach_(reach) {}

  /// Returns the ratio of the radii at the ends of a range, at least 1. Requires: the range is not empty.
  double ratio_of(const StepRange& range) const {
    const double to = range.last == alpha_.size() ? reach_ : std::min(reach_, alpha_[range.last]);
    return std::max(1.0, to / alpha_[range.first]);
  }

  /// Returns at most `most` disjoint ranges of the steps in `all`, the longest first: each is the longest range that
  /// overlaps no earlier one. Leaves out ranges with a ratio below `least_ratio`, except the first.
  std::vector<StepRange> longest(const StepRange& all, std::size_t most, double least_ratio) const {
    struct Left {
      StepRange range, longest;
      double ratio;
    };
    std::vector<Left> left;
    const auto leave = [&](const StepRange& range) {
      if (range.first == range.last) return;
      const StepRange its_longest = longest_in(range);
      left.push_back({range, its_longest, ratio_of(its_longest)});
    };
    std::vector<StepRange> found;
    leave(all);
    while (found.size() < most && !left.empty()) {
      const auto next =
          std::max_element(left.begin(), left.end(), [](const Left& a, const Left& b) { return a.ratio < b.ratio; });
      if (next->ratio < least_ratio && !found.empty()) break;
      const auto [range, its_longest, ratio] = *next;
      left.erase(next);
      found.push_back(its_longest);
      leave({range.first, its_longest.first});
      leave({its_longest.last, range.last});
    }
    return found;
  }

 private:
  static constexpr long double tolerance = 1.1L;  // factor by which the change may grow within a range

  /// Returns the longest range of steps in `within`; of equally long ones the first.
  StepRange longest_in(const StepRange& within) const {
    StepRange longest{within.first, within.first};
    double greatest = 0;
    std::size_t last = within.first;
    for (std::size_t first = within.first; first < within.last; ++first) {
      while (last < within.last && change_[last] <= tolerance * change_[first]) ++last;
      const double ratio = ratio_of({first, last});
      if (ratio > greatest) {
        greatest = ratio;
        longest = {first, last};
      }
    }
    return longest;
  }

  std::span<const double> alpha_;
  std::vector<long double> change_;
  double reach_;
};

}  // namespace rbpa
