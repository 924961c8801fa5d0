// What: the exception for a broken requirement, and the checks that throw it.
// Law:  an expected refusal is a value instead of an exception: see core/blocker.h.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "meshops/core/api.h"

namespace meshops {

/// Exception for a requirement that the caller of a function did not meet. A function throws this exception before it
/// changes anything, unless its comment says otherwise.
class MESHOPS_API ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {

/// Throws ContractViolation. The functions are not inlined, so that a check costs its caller only a comparison.
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* what) { throw ContractViolation(what); }
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* before, long long number, const char* after) {
  throw ContractViolation(before + std::to_string(number) + after);
}
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* operation, const std::string& refusal) {
  throw ContractViolation(std::string(operation) + ": " + refusal);
}

}  // namespace detail

/// Throws ContractViolation with the message `what` unless `holds` is true.
inline void require(bool holds, const char* what) {
  if (!holds) [[unlikely]]
    detail::violate(what);
}
/// Throws ContractViolation unless `holds` is true. The message is `before`, `number` and `after`, without spaces
/// between them, for example "level: face 7 does not exist".
inline void require(bool holds, const char* before, long long number, const char* after) {
  if (!holds) [[unlikely]]
    detail::violate(before, number, after);
}

/// Throws ContractViolation unless the number of values, `found`, equals the number of items, `expected`. An example of
/// the message, where `name` is "report": "report: found 3 points for 5 vertices, expected one for each".
inline void require_one_each(std::string_view name, std::size_t found, std::string_view values, std::size_t expected,
                             std::string_view items) {
  if (found != expected) [[unlikely]]
    throw ContractViolation(std::string(name) + ": found " + std::to_string(found) + " " + std::string(values) +
                            " for " + std::to_string(expected) + " " + std::string(items) + ", expected one for each");
}

}  // namespace meshops
