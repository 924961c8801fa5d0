#include "rbpa/plane/partial/state.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/error.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/partial/rings.h"

namespace rbpa {
namespace {

using Numbers = std::vector<std::uint32_t>;  // new numbers by old ones

/// Numbers the components with a shared triangle by their first shared triangle, and sorts state.open by these numbers.
/// Moves the other components to `finished`, and their old numbers to `old_of_finished`. Returns the new numbers;
/// no_index for the finished components.
Numbers number_components(PartialState& state, std::vector<OpenComponent>& finished, Numbers& old_of_finished) {
  Numbers number(state.open.size(), no_index);
  std::vector<OpenComponent> open;
  for (SharedTriangle& triangle : state.shared) {
    std::uint32_t& n = number[triangle.component];
    if (n == no_index) {
      n = static_cast<std::uint32_t>(open.size());
      open.push_back(std::move(state.open[triangle.component]));
    }
    triangle.component = n;
  }
  for (std::uint32_t c = 0; c < number.size(); ++c) {
    if (number[c] != no_index) continue;
    finished.push_back(std::move(state.open[c]));
    old_of_finished.push_back(c);
  }
  state.open = std::move(open);
  return number;
}

/// Numbers groups by their first open component. A group without an open component is finished: it is counted as a
/// component and removed.
void number_groups(PartialState& state, const std::vector<OpenComponent>& finished) {
  std::uint32_t bound = 0;
  for (const auto* components : {&std::as_const(state.open), &finished})
    for (const OpenComponent& component : *components) bound = std::max(bound, component.group + 1);
  Numbers number(bound, no_index);
  std::uint32_t groups = 0;
  for (OpenComponent& component : state.open) {
    std::uint32_t& n = number[component.group];
    if (n == no_index) n = groups++;
    component.group = n;
  }
  for (const OpenComponent& component : finished) {
    std::uint32_t& n = number[component.group];
    if (n != no_index) continue;
    n = groups;  // so that the group is counted once
    ++state.counts.components;
  }
}

void number_chains(PartialState& state, const Numbers& number) {
  for (Chain& chain : state.chains) {
    if (number[chain.component] == no_index)
      throw InvalidInput("a boundary chain at point " + std::to_string(chain.path.front().index) +
                         " is open, expected a triangle at its end that belongs to another region as well");
    chain.component = number[chain.component];
  }
  const auto edge = [](const Chain& chain) { return std::pair(chain.path[0].index, chain.path[1].index); };
  std::sort(state.chains.begin(), state.chains.end(),
            [&](const Chain& a, const Chain& b) { return edge(a) < edge(b); });
}

/// Removes the members of a pinch that cannot be its first polygon: all finished polygons but the first, and the first
/// as well if an open component already has a lesser point. Open components stay, as points of missing regions may
/// still come first.
void drop_losers(Pinch& pinch, const PartialState& state) {
  const auto open = static_cast<std::uint32_t>(state.open.size());
  std::uint32_t first = no_index;
  Point least = {std::numeric_limits<double>::infinity(), 0};
  for (const std::uint32_t m : pinch.members) {
    if (m < open)
      least = std::min(least, state.open[m].least);
    else if (first == no_index || comes_before(state.held[m - open], state.held[first - open]))
      first = m;
  }
  if (first != no_index && least < state.held[first - open].shell[0].at) first = no_index;
  std::erase_if(pinch.members, [&](std::uint32_t m) { return m >= open && m != first; });
}

/// Adds the points of each pinch with a single member left to that member, and unites pinches with equal members.
void settle_pinches(PartialState& state) {
  const auto open = static_cast<std::uint32_t>(state.open.size());
  std::vector<Pinch> undecided;
  for (Pinch& pinch : state.pinches) {
    sort_unique(pinch.members);
    drop_losers(pinch, state);
    if (pinch.members.size() > 1) {
      undecided.push_back(std::move(pinch));
      continue;
    }
    const std::uint32_t winner = pinch.members[0];
    (winner < open ? state.open[winner].points : state.held[winner - open].points) += pinch.points;
  }
  std::sort(undecided.begin(), undecided.end(), [](const Pinch& a, const Pinch& b) { return a.members < b.members; });
  state.pinches.clear();
  for (Pinch& pinch : undecided) {
    if (!state.pinches.empty() && state.pinches.back().members == pinch.members)
      state.pinches.back().points += pinch.points;
    else
      state.pinches.push_back(std::move(pinch));
  }
}

/// Moves the held polygons that are members of no pinch to state.polygons; sorts the other held polygons.
void release_held(PartialState& state) {
  const auto open = static_cast<std::uint32_t>(state.open.size());
  std::vector<bool> waits(state.held.size(), false);
  for (const Pinch& pinch : state.pinches)
    for (const std::uint32_t m : pinch.members)
      if (m >= open) waits[m - open] = true;
  Numbers order;
  for (std::uint32_t h = 0; h < waits.size(); ++h) {
    if (waits[h])
      order.push_back(h);
    else
      state.polygons.push_back(std::move(state.held[h]));
  }
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return comes_before(state.held[a], state.held[b]); });
  Numbers number(waits.size(), no_index);
  std::vector<CornerPolygon> held;
  for (const std::uint32_t h : order) {
    number[h] = static_cast<std::uint32_t>(held.size());
    held.push_back(std::move(state.held[h]));
  }
  state.held = std::move(held);
  for (Pinch& pinch : state.pinches) {
    for (std::uint32_t& m : pinch.members)
      if (m >= open) m = open + number[m - open];
    std::sort(pinch.members.begin(), pinch.members.end());
  }
  std::sort(state.pinches.begin(), state.pinches.end(),
            [](const Pinch& a, const Pinch& b) { return a.members < b.members; });
}

}  // namespace

void settle(PartialState& state, const Checkpoint& checkpoint) {
  const auto components = static_cast<std::uint32_t>(state.open.size());
  std::vector<OpenComponent> finished;
  Numbers old_of_finished;
  Numbers number = number_components(state, finished, old_of_finished);
  number_groups(state, finished);
  number_chains(state, number);

  const auto open = static_cast<std::uint32_t>(state.open.size());
  state.counts.solid_components += finished.size();
  for (std::size_t i = 0; i < finished.size(); ++i) {
    if (checkpoint && i % 1024 == 0) checkpoint();
    number[old_of_finished[i]] = open + static_cast<std::uint32_t>(state.held.size());
    state.held.push_back(polygon_of(std::move(finished[i])));
  }
  for (Pinch& pinch : state.pinches)
    for (std::uint32_t& m : pinch.members) m = m < components ? number[m] : open + (m - components);
  settle_pinches(state);
  release_held(state);
}

}  // namespace rbpa
