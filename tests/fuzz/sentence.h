// What: checks the form of a refusal, whatever the bytes.
#pragma once

#include <string>

#include "fuzz/target.h"
#include "io/failure.h"

namespace fuzz {

/// Checks a message. The file is called FILE; a refusal may also concern an option.
inline void is_a_sentence(const std::string& message) {
  require(message.starts_with("FILE") || message.starts_with("--"), "a message names the place");
  require(message.find(": found ") != std::string::npos, "a message states the finding");
  require(message.find(", expected ") != std::string::npos, "a message states the expectation");
  require(rbpa::app::printable(message) == message, "a message is one line of visible characters");
}

}  // namespace fuzz
