// What: checks lists of duplicates, and visits the points that repeat no point before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "meshops/core/contract.h"
#include "rbpa/base/duplicate.h"

namespace rbpa {

/// Checks that `duplicates` strictly ascends by index, that all indices are below `points`, and that each duplicate
/// stands for a point of lower index. Throws: ContractViolation that names `function`. Cost: linear.
inline void require_duplicates(const char* function, std::span<const Duplicate> duplicates, std::size_t points) {
  for (std::size_t i = 0; i < duplicates.size(); ++i) {
    const auto [index, stands_for] = duplicates[i];
    if (index >= points || stands_for >= index || (i > 0 && index <= duplicates[i - 1].index))
      throw meshops::ContractViolation(std::string(function) + ": found duplicate " + std::to_string(index) +
                                       " of point " + std::to_string(stands_for) +
                                       ", expected ascending duplicates of earlier points");
  }
}

/// Calls visit(index), with a std::uint32_t, for each index below `points` that is not of a duplicate, ascending.
/// Requires: fewer than 2^32 points; require_duplicates() accepts `duplicates`. Not checked.
/// Cost:     linear.
template <typename Visit>
void for_each_distinct(std::size_t points, std::span<const Duplicate> duplicates, Visit visit) {
  std::uint32_t i = 0;
  for (const Duplicate& duplicate : duplicates) {
    for (; i < duplicate.index; ++i) visit(i);
    ++i;
  }
  for (; i < points; ++i) visit(i);
}

}  // namespace rbpa
