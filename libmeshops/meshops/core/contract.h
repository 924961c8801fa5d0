// What: what a caller's bug raises. An expected refusal is a value instead: see the …_blocker() functions.
#pragma once

#include <stdexcept>
#include <string>

#include "meshops/core/api.h"

namespace meshops {

/// A requirement of a function was not met. Thrown before anything is changed.
class MESHOPS_API ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws ContractViolation with `what` unless `holds`.
inline void require(bool holds, const char* what) {
  if (!holds) throw ContractViolation(what);
}

}  // namespace meshops
