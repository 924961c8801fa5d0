// What: which holes of a surface are filled: --fill-holes.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "rbpa/curve_kinds.h"
#include "rbpa/holes.h"

namespace rbpa::app {

/// All curves of kind `hole`, by default.
struct HoleChoice {
  std::size_t most_edges = std::numeric_limits<std::size_t>::max();
  double most_length = std::numeric_limits<double>::infinity();
  bool rims = false;  ///< curves of every kind

  bool has(const Hole& curve, CurveKind kind) const {
    return (rims || kind == CurveKind::hole) && curve.edges.size() <= most_edges && curve.length <= most_length;
  }
};

/// "all"; "rims": those and the rims of sheets and islands; "30": of at most so many edges; "length=2.5": at most so
/// long. Throws WrongUsage that names the option.
HoleChoice parse_fill_holes(const std::string& text);

}  // namespace rbpa::app
