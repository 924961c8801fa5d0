// What: the exception for a broken requirement, and the check that throws it. An expected refusal is a value instead:
//       see the …_blocker() functions.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "meshops/core/api.h"

namespace meshops {

/// Exception for a requirement that the caller of a function did not meet, thrown before anything is changed.
class MESHOPS_API ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {

/// Throws ContractViolation. Out of line, so that a check costs only a comparison.
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* what) { throw ContractViolation(what); }
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* before, long long number, const char* after) {
  throw ContractViolation(before + std::to_string(number) + after);
}
[[noreturn, gnu::cold, gnu::noinline]] inline void violate(const char* operation, const char* refusal) {
  throw ContractViolation(std::string(operation) + ": " + refusal);
}

/// Throws ContractViolation with the message "operation: refusal", unless `refusal` is null.
inline void enforce(const char* operation, const char* refusal) {
  if (refusal) [[unlikely]]
    violate(operation, refusal);
}
/// Returns `refusal` as a string; nothing when it is null.
inline std::optional<std::string> as_blocker(const char* refusal) {
  return refusal ? std::optional<std::string>(refusal) : std::nullopt;
}

}  // namespace detail

/// Throws ContractViolation with the message `what`, unless `holds`.
inline void require(bool holds, const char* what) {
  if (!holds) [[unlikely]]
    detail::violate(what);
}
/// Throws ContractViolation with a message that names a number, unless `holds`: "level: face 7 does not exist".
inline void require(bool holds, const char* before, long long number, const char* after) {
  if (!holds) [[unlikely]]
    detail::violate(before, number, after);
}

/// Throws ContractViolation unless there are as many values as items: "report: found 3 points for 5 vertices, expected
/// one for each".
inline void require_one_each(std::string_view name, std::size_t found, std::string_view values, std::size_t expected,
                             std::string_view items) {
  if (found != expected) [[unlikely]]
    throw ContractViolation(std::string(name) + ": found " + std::to_string(found) + " " + std::string(values) +
                            " for " + std::to_string(expected) + " " + std::string(items) + ", expected one for each");
}

}  // namespace meshops
