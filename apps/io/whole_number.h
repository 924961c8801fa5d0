// What: whole numbers on a command line.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace rbpa::app {

struct WholeNumbers {
  std::size_t least = 0;
  std::size_t greatest = std::numeric_limits<std::size_t>::max();
};

/// What `option` was given: decimal digits and nothing else, of a number among `allowed`. Throws WrongUsage naming text
/// and bounds, of so many `things` ("points").
std::size_t parse_whole(const std::string& option, const std::string& text, WholeNumbers allowed,
                        const std::string& things = "");

}  // namespace rbpa::app
