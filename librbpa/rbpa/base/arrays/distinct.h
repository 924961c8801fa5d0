// What: visits the points that repeat no point before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/base/duplicate.h"

namespace rbpa {

/// Calls visit(index) for each of the indices below `points` that is not a duplicate, ascending.
/// Requires: `duplicates` ascends by index, and all its indices are below `points`.
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
