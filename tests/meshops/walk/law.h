// What: the exception by which walks report a broken law.
#pragma once

#include <stdexcept>

namespace meshops::test {

/// Exception for a broken law; the message names it, and the steps before.
struct LawBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace meshops::test
