// What: the holes of a surface to fill: --fill-holes.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"

namespace rbpa::app {

/// The curves to fill; by default all of kind `hole`.
struct HoleChoice {
  std::size_t most_edges = std::numeric_limits<std::size_t>::max();
  double most_length = std::numeric_limits<double>::infinity();
  bool rims = false;  ///< true: curves of every kind

  bool has(const Hole& curve, CurveKind kind) const {
    return (rims || kind == CurveKind::hole) && curve.edges.size() <= most_edges && curve.length <= most_length;
  }
};

/// Parses "all"; "rims", which adds the rims of sheets and of islands; "30", curves of at most 30 edges; "length=2.5",
/// curves of at most this length. Throws WrongUsage that names the option.
HoleChoice parse_fill_holes(const std::string& text);

}  // namespace rbpa::app
