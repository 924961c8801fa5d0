// What: chooses the most persistent of many persistence pairs.
// Cost: linear, and a sort of the chosen pairs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace rbpa {

/// Limits by which chosen() selects pairs.
struct PairChoice {
  double min_persistence = 0;  ///< least value of death − birth, in units of the points
  /// Maximum number of pairs of each dimension; the most persistent pairs are kept.
  std::size_t top = std::numeric_limits<std::size_t>::max();
};

/// Returns death − birth of a pair; infinity if the pair never dies (death is absent).
template <typename Pair>
double persistence_of(const Pair& pair) {
  return pair.death ? *pair.death - pair.birth : std::numeric_limits<double>::infinity();
}

/// Returns the chosen pairs in the order of `pairs`. A pair that never dies is more persistent than any other; of
/// equally persistent pairs the first is preferred.
/// Requires: pairs of one dimension are consecutive; not checked. `Pair` is PersistencePair, SolidPair, or a type with
///           the same members `dimension`, `birth` and `death`.
template <typename Pair>
std::vector<Pair> chosen(const std::vector<Pair>& pairs, const PairChoice& choice) {
  const auto lasts_longer = [&](std::uint32_t i, std::uint32_t j) {
    const double of_i = persistence_of(pairs[i]), of_j = persistence_of(pairs[j]);
    return of_i != of_j ? of_i > of_j : i < j;
  };
  std::vector<std::uint32_t> kept;
  for (std::size_t first = 0, last; first < pairs.size(); first = last) {  // of one dimension
    std::vector<std::uint32_t> of;
    for (last = first; last < pairs.size() && pairs[last].dimension == pairs[first].dimension; ++last)
      if (persistence_of(pairs[last]) >= choice.min_persistence) of.push_back(static_cast<std::uint32_t>(last));
    if (of.size() > choice.top) {
      std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(choice.top), of.end(), lasts_longer);
      of.resize(choice.top);
    }
    kept.insert(kept.end(), of.begin(), of.end());
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Pair> result;
  result.reserve(kept.size());
  for (const std::uint32_t i : kept) result.push_back(pairs[i]);
  return result;
}

}  // namespace rbpa
