// What: how walks report that something is wrong.
#pragma once

#include <stdexcept>

namespace meshops::test {

/// A law does not hold; the message names it, and the steps before.
struct LawBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace meshops::test
