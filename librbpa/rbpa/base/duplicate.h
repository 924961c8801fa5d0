// What: an input point that repeats an earlier one.
#pragma once

#include <cstdint>

namespace rbpa {

/// An input point whose coordinates equal those of an earlier input point.
struct Duplicate {
  std::uint32_t index;       ///< the input index of the repetition
  std::uint32_t stands_for;  ///< the lowest input index of a point with these coordinates
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

}  // namespace rbpa
