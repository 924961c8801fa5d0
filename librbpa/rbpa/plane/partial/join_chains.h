// What: joins chains where the last edge of one is the first of another.
#pragma once

#include <functional>
#include <vector>

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Joins chains and calls closed(chain) for each closed curve, with each of its points once, in order.
/// Returns: the chains that stay open, in any order.
/// Throws:  InvalidInput when several chains begin, or end, with the same edge.
/// Cost:    O(n log n) for n chains, plus linear in the points of the chains that are appended to another one; points
///          of the first chain of each result are only moved with their chain.
std::vector<Chain> join_chains(std::vector<Chain>&& chains, const std::function<void(Chain&&)>& closed);

}  // namespace rbpa
