// What: the edges of a mesh that wait for their collapse: the least cost comes first, then the least keys of the ends.
// Law:  an edge waits at most once. Entries that were superseded are stale, and are skipped.
// Cost: logarithmic time for each entry; memory for about three entries for each edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
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

  explicit EdgesByCost(std::size_t edges) : age_(edges, 0), state_(edges, State::absent) { heap_.reserve(edges); }

  bool waits(Edge e) const { return state_[index(e)] != State::absent; }
  /// Makes the edge wait with this cost and these keys, in place of any earlier cost and keys.
  void push(Edge e, double cost, Key a, Key b) {
    if (b < a) std::swap(a, b);
    if (heap_.size() > 3 * age_.size()) drop_stale();
    heap_.push_back({cost, std::move(a), std::move(b), e, ++age_[index(e)]});
    std::push_heap(heap_.begin(), heap_.end());
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
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      Entry entry = std::move(heap_.back());
      heap_.pop_back();
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
    std::erase_if(heap_, [&](const Entry& entry) { return is_stale(entry); });
    std::make_heap(heap_.begin(), heap_.end());
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> age_;  // for each edge, the age of its last entry
  std::vector<State> state_;
};

}  // namespace meshops::detail
