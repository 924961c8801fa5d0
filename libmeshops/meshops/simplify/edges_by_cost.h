// What: the edges of a mesh that wait for their collapse: the least cost comes first, then the least keys of the ends.
// Law:  an edge waits at most once. Entries that were superseded are stale, and are skipped.
// How:  entries lie in bands of descending costs. Only the last band is a heap. When it is empty, the band before is
//       the last: while it has more than 2,048 entries, about its least eighth becomes a new last band, unless the
//       costs are too equal to split it. The heap then fits the cache.
// Cost: amortized logarithmic time for each entry; memory for about three entries for each edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "meshops/core/connectivity.h"

namespace meshops::detail {

template <typename Key>
class EdgesByCost {
 public:
  struct Entry {
    double cost;
    Key least, greatest;  // keys of the ends
    Edge edge;
    std::uint32_t age;
    /// Returns whether a comes after b, because the heaps of the standard library begin with the greatest element.
    friend bool operator<(const Entry& a, const Entry& b) {
      return std::tie(b.cost, b.least, b.greatest, b.edge) < std::tie(a.cost, a.least, a.greatest, a.edge);
    }
  };

  explicit EdgesByCost(std::size_t edges) : bands_(1), age_(edges, 0), state_(edges, State::absent) {
    bands_[0].entries.reserve(edges);
  }

  bool waits(Edge e) const { return state_[index(e)] != State::absent; }
  /// Makes the edge wait with this cost and these keys, in place of any earlier cost and keys.
  void push(Edge e, double cost, Key a, Key b) {
    if (b < a) std::swap(a, b);
    if (count_ > 3 * age_.size()) drop_stale();
    std::size_t at = bands_.size() - 1;
    while (cost > bands_[at].limit) --at;
    std::vector<Entry>& entries = bands_[at].entries;
    entries.push_back({cost, std::move(a), std::move(b), e, ++age_[index(e)]});
    if (at + 1 == bands_.size() && last_is_heap_) std::push_heap(entries.begin(), entries.end());
    ++count_;
    state_[index(e)] = State::waiting;
  }
  /// Ends the waiting of an edge.
  void remove(Edge e) {
    ++age_[index(e)];
    state_[index(e)] = State::absent;
  }
  /// Notes that the cost of a waiting edge has become a lower bound.
  void mark_outdated(Edge e) { state_[index(e)] = State::outdated; }

  /// Removes and returns the first edge, and whether its cost must be computed again; nothing if no edge waits.
  std::optional<std::pair<Entry, bool>> pop() {
    while (find_heap()) {
      std::vector<Entry>& heap = bands_.back().entries;
      std::pop_heap(heap.begin(), heap.end());
      Entry entry = std::move(heap.back());
      heap.pop_back();
      --count_;
      if (is_stale(entry)) continue;
      const bool is_outdated = state_[index(entry.edge)] == State::outdated;
      state_[index(entry.edge)] = State::absent;
      return std::pair(std::move(entry), is_outdated);
    }
    return std::nullopt;
  }

 private:
  enum class State : std::uint8_t { absent, waiting, outdated };
  static std::size_t index(Edge e) { return static_cast<std::size_t>(e.idx()); }
  bool is_stale(const Entry& entry) const { return age_[index(entry.edge)] != entry.age; }
  void drop_stale() {
    count_ = 0;
    for (Band& band : bands_) {
      std::erase_if(band.entries, [&](const Entry& entry) { return is_stale(entry); });
      count_ += band.entries.size();
    }
    last_is_heap_ = false;
  }

  /// Makes the last band a heap that is not empty, and returns true; returns false if there is no entry.
  bool find_heap() {
    while (bands_.back().entries.empty()) {
      if (bands_.size() == 1) return false;
      bands_.pop_back();
      last_is_heap_ = false;
    }
    if (!last_is_heap_) {
      while (bands_.back().entries.size() > largest_heap && split_last()) {
      }
      std::make_heap(bands_.back().entries.begin(), bands_.back().entries.end());
      last_is_heap_ = true;
    }
    return true;
  }
  /// Moves about the least eighth of the last band to a new one; returns false if all of it would move.
  bool split_last() {
    std::vector<Entry>& entries = bands_.back().entries;
    std::array<double, 128> sample;
    // Steps of the golden ratio are not in step with the rows of a grid, whose costs repeat.
    for (std::uint64_t i = 0; i < sample.size(); ++i)
      sample[i] = entries[(i * 0x9E3779B97F4A7C15U >> 33U) * entries.size() >> 31U].cost;
    std::nth_element(sample.begin(), sample.begin() + sample.size() / 8, sample.end());
    const double limit = sample[sample.size() / 8];
    const auto first = std::partition(entries.begin(), entries.end(), [&](const Entry& e) { return e.cost > limit; });
    if (first == entries.begin()) return false;
    Band least{limit, {first, entries.end()}};
    entries.erase(first, entries.end());
    bands_.push_back(std::move(least));
    return true;
  }

  struct Band {
    double limit = std::numeric_limits<double>::infinity();  // no cost is greater
    std::vector<Entry> entries;
  };
  static constexpr std::size_t largest_heap = 2048;

  std::vector<Band> bands_;         // each has lesser costs than the one before
  bool last_is_heap_ = false;       // otherwise the last band has no order
  std::size_t count_ = 0;           // of entries
  std::vector<std::uint32_t> age_;  // for each edge, the age of its last entry
  std::vector<State> state_;
};

}  // namespace meshops::detail
