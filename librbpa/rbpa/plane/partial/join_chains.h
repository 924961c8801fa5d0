// What: puts chains together where the last edge of one is the first of another.
#pragma once

#include <functional>
#include <vector>

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Returns: the chains that stay open, in any order. Calls closed(chain) for each closed curve: its points once, in order.
/// Throws: InvalidInput when several chains begin, or end, with the same edge. Cost: n log n in the chains, and linear in
///         what is put together, but for the first of each.
std::vector<Chain> join_chains(std::vector<Chain>&& chains, const std::function<void(Chain&&)>& closed);

}  // namespace rbpa
