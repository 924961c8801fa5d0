// What: how walks say that something is wrong.
#pragma once

#include <stdexcept>

namespace meshops::test {

/// A law does not hold; the message says which, and after which steps.
struct LawBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace meshops::test
