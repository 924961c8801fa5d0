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

namespace detail {

/// Out of line, so that a check costs no more than a comparison.
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* what) { throw ContractViolation(what); }

}  // namespace detail

/// Throws ContractViolation with `what` unless `holds`.
inline void require(bool holds, const char* what) {
  if (!holds) [[unlikely]]
    detail::violate(what);
}

}  // namespace meshops
