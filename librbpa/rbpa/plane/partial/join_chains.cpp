#include "rbpa/plane/partial/join_chains.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/triangle.h"

namespace rbpa {
namespace {

using Edge = std::pair<std::uint64_t, std::uint64_t>;

Edge first_edge(const Chain& chain) { return {chain.path[0].index, chain.path[1].index}; }
Edge last_edge(const Chain& chain) { return {chain.path.end()[-2].index, chain.path.end()[-1].index}; }

struct End {
  Edge edge;
  std::uint32_t chain;
};

/// Returns the chains sorted by one of their ends.
std::vector<End> sorted_by(const std::vector<Chain>& chains, Edge (*edge_of)(const Chain&)) {
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

/// Returns for each chain the one that continues where it ends.
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

}  // namespace

std::vector<Chain> join_chains(std::vector<Chain>&& chains, const std::function<void(Chain&&)>& closed) {
  const std::vector<std::uint32_t> next = followers(chains);
  std::vector<bool> follows(chains.size(), false), done(chains.size(), false);
  for (const std::uint32_t c : next)
    if (c != no_index) follows[c] = true;

  // Two chains that meet have the same edge, which is kept once.
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
    curve.path.resize(curve.path.size() - 2);  // they repeat the first two points
    closed(std::move(curve));
  }
  return open;
}

}  // namespace rbpa
