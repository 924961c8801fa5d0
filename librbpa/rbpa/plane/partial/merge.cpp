#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial/rings.h"
#include "rbpa/plane/partial/state.h"

namespace rbpa {
namespace {

using PointPair = std::pair<std::uint64_t, std::uint64_t>;

PointPair first_edge(const Chain& chain) { return {chain.path[0].index, chain.path[1].index}; }
PointPair last_edge(const Chain& chain) { return {chain.path.end()[-2].index, chain.path.end()[-1].index}; }

struct End {
  PointPair edge;
  std::uint32_t chain;
};

/// Returns the chains sorted by edge_of(chain), their first or last edge. Throws: InvalidInput when two chains have the
/// same edge.
std::vector<End> sorted_by(const std::vector<Chain>& chains, PointPair (*edge_of)(const Chain&)) {
  std::vector<End> ends;
  ends.reserve(chains.size());
  for (std::uint32_t c = 0; c < chains.size(); ++c) ends.push_back({edge_of(chains[c]), c});
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.edge < b.edge; });
  const auto twice =
      std::adjacent_find(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.edge == b.edge; });
  if (twice != ends.end())
    throw InvalidInput("two boundary chains at the edge from point " + std::to_string(twice->edge.first) +
                       " to point " + std::to_string(twice->edge.second) +
                       ", expected one: halos were not complete, or points differ");
  return ends;
}

/// Returns for each chain the number of the chain that continues it, or no_index.
std::vector<std::uint32_t> followers(const std::vector<Chain>& chains) {
  std::vector<std::uint32_t> next(chains.size(), no_index);
  const std::vector<End> firsts = sorted_by(chains, first_edge), lasts = sorted_by(chains, last_edge);
  auto first = firsts.begin();
  for (const End& last : lasts) {
    while (first != firsts.end() && first->edge < last.edge) ++first;
    if (first != firsts.end() && first->edge == last.edge) next[last.chain] = first->chain;
  }
  return next;
}

/// Joins chains where the last edge of one is the first of another, and calls closed(chain) for each closed curve, with
/// each of its points once, in order.
/// Returns: the chains that stay open, in any order.
/// Throws:  InvalidInput when several chains begin, or end, with the same edge.
/// Cost:    O(n log n) for n chains, plus linear in the points of the chains that are appended to another one; points
///          of the first chain of each result are only moved with their chain.
std::vector<Chain> join_chains(std::vector<Chain>&& chains, const std::function<void(Chain&&)>& closed) {
  const std::vector<std::uint32_t> next = followers(chains);
  std::vector<bool> follows(chains.size(), false), done(chains.size(), false);
  for (const std::uint32_t c : next)
    if (c != no_index) follows[c] = true;

  // Two chains that meet share an edge, which the joined chain has once.
  const auto follow = [&](std::uint32_t from) {
    Chain chain = std::move(chains[from]);
    done[from] = true;
    for (std::uint32_t c = next[from]; c != no_index && !done[c]; c = next[c]) {
      const std::vector<Corner> path = std::move(chains[c].path);
      chain.path.insert(chain.path.end(), path.begin() + 2, path.end());
      done[c] = true;
    }
    return chain;
  };
  std::vector<Chain> open;
  for (std::uint32_t c = 0; c < chains.size(); ++c)
    if (!follows[c]) open.push_back(follow(c));
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    if (done[c]) continue;
    Chain curve = follow(c);
    curve.path.resize(curve.path.size() - 2);  // the last two points repeat the first two
    closed(std::move(curve));
  }
  return open;
}

PartialCounts operator+(PartialCounts a, const PartialCounts& b) {
  for (const auto count : partial_counts) a.*count += b.*count;
  return a;
}

template <typename Item>
void append(std::vector<Item>& to, std::vector<Item>&& from) {
  if (to.empty()) {
    to = std::move(from);
    return;
  }
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Renumbers components, groups and pinch members of `b` to follow those of `a`. Among members, the open components of
/// both come first, then the held polygons of both.
void number_behind(PartialState& a, PartialState& b) {
  const auto of_a = static_cast<std::uint32_t>(a.open.size()), of_b = static_cast<std::uint32_t>(b.open.size());
  const auto held_a = static_cast<std::uint32_t>(a.held.size());
  for (Pinch& pinch : a.pinches)
    for (std::uint32_t& m : pinch.members)
      if (m >= of_a) m += of_b;
  for (Pinch& pinch : b.pinches)
    for (std::uint32_t& m : pinch.members) m += m < of_b ? of_a : of_a + held_a;
  for (SharedTriangle& triangle : b.shared) triangle.component += of_a;
  for (Chain& chain : b.chains) chain.component += of_a;
  for (OpenComponent& component : b.open) component.group += of_a;  // there are at most as many groups as components
}

/// Adds the counts of `b` to those of `a`, and appends the lists of components, chains, pinches and polygons of `b`.
void append_all(PartialState& a, PartialState&& b) {
  a.counts = a.counts + b.counts;
  append(a.open, std::move(b.open));
  append(a.chains, std::move(b.chains));
  append(a.pinches, std::move(b.pinches));
  append(a.held, std::move(b.held));
  // The larger list is not moved.
  if (a.polygons.size() < b.polygons.size()) std::swap(a.polygons, b.polygons);
  append(a.polygons, std::move(b.polygons));
}

/// Merges two sorted lists of shared triangles. Unites in `components` any two components with a triangle in common,
/// and drops triangles whose three corners are now in merged regions. Throws: InvalidInput when the numbers of owned
/// corners of a triangle add up to more than three.
std::vector<SharedTriangle> merge_shared(const std::vector<SharedTriangle>& a, const std::vector<SharedTriangle>& b,
                                         meshops::DisjointSets& components) {
  std::vector<SharedTriangle> merged;
  merged.reserve(a.size() + b.size());
  auto i = a.begin();
  auto j = b.begin();
  while (i != a.end() && j != b.end()) {
    if (i->corners != j->corners) {
      merged.push_back(i->corners < j->corners ? *i++ : *j++);
      continue;
    }
    components.unite(i->component, j->component);
    SharedTriangle both = *i++;
    both.owned += (j++)->owned;
    if (both.owned > 3)
      throw InvalidInput("triangle " + std::to_string(both.corners[0]) + " " + std::to_string(both.corners[1]) + " " +
                         std::to_string(both.corners[2]) +
                         ": two regions have the same corner of it, expected points of the same input");
    if (both.owned < 3) merged.push_back(both);
  }
  merged.insert(merged.end(), i, a.end());
  merged.insert(merged.end(), j, b.end());
  return merged;
}

/// Moves the contents of `from` to `to`.
void absorb(OpenComponent& to, OpenComponent&& from) {
  to.points += from.points;
  to.least = std::min(to.least, from.least);
  if (to.rings.size() < from.rings.size()) std::swap(to.rings, from.rings);
  append(to.rings, std::move(from.rings));
  add_taken(to, std::move(from));
}

/// Unites the open components that are in one set of `components`, and their groups.
void unite_components(PartialState& state, meshops::DisjointSets& components) {
  const auto count = static_cast<std::uint32_t>(state.open.size());
  meshops::DisjointSets groups(count);
  for (std::uint32_t c = 0; c < count; ++c) groups.unite(state.open[c].group, state.open[components.find(c)].group);
  std::vector<std::uint32_t> number(count);
  std::vector<OpenComponent> united;
  for (std::uint32_t c = 0; c < count; ++c) {
    const std::uint32_t least = components.find(c);
    if (least == c) {
      number[c] = static_cast<std::uint32_t>(united.size());
      united.push_back(std::move(state.open[c]));
      united.back().group = groups.find(united.back().group);
    } else {
      number[c] = number[least];
      absorb(united[number[c]], std::move(state.open[c]));
    }
  }
  const auto gone = count - static_cast<std::uint32_t>(united.size());
  state.open = std::move(united);
  for (SharedTriangle& triangle : state.shared) triangle.component = number[triangle.component];
  for (Chain& chain : state.chains) chain.component = number[chain.component];
  for (Pinch& pinch : state.pinches)
    for (std::uint32_t& m : pinch.members) m = m < count ? number[m] : m - gone;
}

}  // namespace

Partial merge(Partial&& a, Partial&& b) {
  if (a.alpha() == 0) return std::move(b);
  if (b.alpha() == 0) return std::move(a);
  if (a.alpha() != b.alpha())
    throw InvalidInput("merge: found parts of alpha " + text(a.alpha()) + " and of alpha " + text(b.alpha()) +
                       ", expected one alpha (compute all parts with the same)");
  Cover cover = a.state().cover + b.state().cover;
  if (const std::optional<Point> twice = cover.wrong())
    throw InvalidInput("both sets of regions contain the area with the lower left corner (" + text(twice->x) + ", " +
                       text(twice->y) + "), expected disjoint regions");

  PartialState state = std::move(a.state()), other = std::move(b.state());
  number_behind(state, other);
  meshops::DisjointSets components(state.open.size() + other.open.size());
  state.cover = std::move(cover);
  state.shared = merge_shared(state.shared, other.shared, components);
  append_all(state, std::move(other));
  unite_components(state, components);
  state.chains = join_chains(std::move(state.chains), [&](Chain&& curve) {
    add_curve(state.open[curve.component], std::move(curve.path));
    ++state.counts.boundary_curves;
  });
  settle(state);
  return Partial(std::move(state));
}

}  // namespace rbpa
