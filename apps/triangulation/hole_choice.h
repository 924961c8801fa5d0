// What: which holes of a surface are filled: --fill-holes.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "rbpa/holes.h"

namespace rbpa::app {

/// All of them, by default.
struct HoleChoice {
  std::size_t most_edges = std::numeric_limits<std::size_t>::max();
  double most_length = std::numeric_limits<double>::infinity();

  bool has(const Hole& hole) const { return hole.edges.size() <= most_edges && hole.length <= most_length; }
};

/// "all"; "30": of at most so many edges; "length=2.5": at most so long. Throws WrongUsage that names the option.
HoleChoice parse_fill_holes(const std::string& text);

}  // namespace rbpa::app
