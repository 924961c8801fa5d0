// What: an input point that repeats one before it.
#pragma once

#include <cstdint>

namespace rbpa {

/// A point equal to one given before it.
struct Duplicate {
  std::uint32_t index;       ///< the input index of the repetition
  std::uint32_t stands_for;  ///< the lowest input index with the same coordinates
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

}  // namespace rbpa
