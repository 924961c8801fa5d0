#include "meshops/simplify/edges_by_cost.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <vector>

using meshops::Edge;

namespace {

/// A queue of edges beside a set of what waits in it.
class CheckedQueue {
 public:
  explicit CheckedQueue(std::size_t edges) : queue_(edges), entries_(edges), outdated_(edges) {}

  bool waits(std::size_t e) const { return entries_[e].has_value(); }
  void push(std::size_t e, double cost, int a, int b) {
    queue_.push(Edge(static_cast<int>(e)), cost, a, b);
    forget(e);
    entries_[e] = {cost, std::min(a, b), std::max(a, b), static_cast<int>(e)};
    order_.insert(*entries_[e]);
  }
  void remove(std::size_t e) {
    queue_.remove(Edge(static_cast<int>(e)));
    forget(e);
  }
  void mark_outdated(std::size_t e) {
    queue_.mark_outdated(Edge(static_cast<int>(e)));
    outdated_[e] = true;
  }
  /// Pops from both; returns whether an edge waited.
  bool pop() {
    const auto next = queue_.pop();
    if (order_.empty()) {
      REQUIRE_FALSE(next);
      return false;
    }
    REQUIRE(next);
    const auto [cost, least, greatest, edge] = *order_.begin();
    const auto e = static_cast<std::size_t>(edge);
    REQUIRE((next->first.edge == Edge(edge) && next->first.cost == cost && next->first.least == least &&
             next->first.greatest == greatest && next->second == outdated_[e] && !queue_.waits(Edge(edge))));
    forget(e);
    return true;
  }

 private:
  using Entry = std::tuple<double, int, int, int>;
  void forget(std::size_t e) {
    if (entries_[e]) order_.erase(*entries_[e]);
    entries_[e].reset();
    outdated_[e] = false;
  }

  meshops::detail::EdgesByCost<int> queue_;
  std::vector<std::optional<Entry>> entries_;
  std::vector<bool> outdated_;
  std::set<Entry> order_;
};

/// Changes the queue at random, with costs drawn by draw_cost(), and then empties it.
template <typename DrawCost>
void walk(std::size_t edges, int steps, std::mt19937_64& random, DrawCost draw_cost) {
  CheckedQueue queue(edges);
  const auto push = [&](std::size_t e) { queue.push(e, draw_cost(), int(random() % 3), int(random() % 3)); };
  for (std::size_t e = 0; e < edges; ++e) push(e);
  for (int i = 0; i < steps; ++i) {
    const std::size_t e = random() % edges;
    const auto what = random() % 8;
    const bool fills = i / 6000 % 2 == 1;  // then stale entries heap up
    if (what < 3 && !fills) queue.pop();
    if (what == 3 && queue.waits(e)) queue.mark_outdated(e);
    if (what == 4) queue.remove(e);
    if (what > 4 || (what < 3 && fills)) push(e);
  }
  while (queue.pop()) {
  }
}

}  // namespace

TEST_SUITE("simplify") {
  TEST_CASE("edges leave the queue in the order of their costs, then of their keys, whatever is pushed meanwhile") {
    std::mt19937_64 random(5);
    double now = 0;
    const auto number = [&] { return static_cast<double>(random() % 1000000); };
    for (const std::size_t edges : {1U, 7U, 2048U, 20000U}) {
      walk(edges, 20000, random, number);
      walk(edges, 20000, random, [&] { return static_cast<double>(random() % 40); });  // many ties
      walk(edges, 20000, random, [&] { return now += number(); });                     // the greatest at any time
      walk(edges, 20000, random, [&] { return now -= number(); });                     // the least at any time
      walk(edges, 20000, random, [&] { return 0.0; });                                 // ties only
      walk(edges, 20000, random, [&] { return random() % 9 == 0 ? -number() : 1e300; });
    }
  }
}
