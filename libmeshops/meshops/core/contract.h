// What: the exception for a broken requirement, and the check that throws it. An expected refusal is a value instead:
//       see the …_blocker() functions.
#pragma once

#include <stdexcept>
#include <string>

#include "meshops/core/api.h"

namespace meshops {

/// Exception for a requirement of a function that the caller did not meet. It is thrown before anything is changed.
class MESHOPS_API ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {

/// Throws ContractViolation. Out of line, so that a check costs only a comparison.
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* what) { throw ContractViolation(what); }

}  // namespace detail

/// Throws ContractViolation with the message `what`, unless `holds`.
inline void require(bool holds, const char* what) {
  if (!holds) [[unlikely]]
    detail::violate(what);
}

}  // namespace meshops
