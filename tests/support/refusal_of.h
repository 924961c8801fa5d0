// What: the message with which a function refuses its arguments.
#pragma once

#include <string>

namespace rbpa_test {

/// Returns the message of the error of one of these types that `run` throws; "" if it throws none.
template <typename Error, typename... OtherErrors, typename Run>
std::string refusal_of(const Run& run) {
  try {
    if constexpr (sizeof...(OtherErrors) > 0) return refusal_of<OtherErrors...>(run);
    run();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace rbpa_test
