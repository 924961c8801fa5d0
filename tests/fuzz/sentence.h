// What: how a refusal has to look, whatever the bytes.
#pragma once

#include <string>

#include "fuzz/target.h"
#include "io/failure.h"

namespace fuzz {

/// The file is called FILE; a refusal may be of an option as well.
inline void is_a_sentence(const std::string& message) {
  require(message.starts_with("FILE") || message.starts_with("--"), "a message says where");
  require(message.find(": found ") != std::string::npos, "a message says what was found");
  require(message.find(", expected ") != std::string::npos, "a message says what was expected");
  require(rbpa::app::printable(message) == message, "a message is one line of visible characters");
}

}  // namespace fuzz
