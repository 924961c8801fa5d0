// What: joins chains where the last edge of one is the first of another.
#pragma once

#include <functional>
#include <vector>

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Joins chains and calls closed(chain) for each closed curve, with each of its points once, in order.
/// Returns: the chains that stay open, in any order.
/// Throws:  InvalidInput when several chains begin, or end, with the same edge.
/// Cost:    n log n in the chains, and linear in the joined points, except those of the first chain of each result.
std::vector<Chain> join_chains(std::vector<Chain>&& chains, const std::function<void(Chain&&)>& closed);

}  // namespace rbpa
