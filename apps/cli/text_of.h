// What: a number in the digits that the verbs say it in.
#pragma once

#include <optional>
#include <string>

#include "io/bytes/number.h"

namespace rbpa::app {

/// The shortest digits that read back to the number; "none" where there is none.
inline std::string text_of(const std::optional<double>& value) {
  return value ? std::string(ShortestText(*value)) : "none";
}

}  // namespace rbpa::app
