// What: splits segments where they cross.
// Law:  afterwards no two segments cross, except in points that are an end of one of them or more. The result depends
//       on the segments as a set. A point where two segments cross is rounded once, to nearest.
// How:  in rounds: all pairs that cross are found, and all their crossings become ends at once; the parts bend by
//       rounding, and may cross others, which the next round splits.
// Why:  the rounds end. A crossing stays in the bounding box of a part when it is rounded, as the sides of the box are
//       doubles. Parts that cross have no end in common, so the rounded crossing is no end of at least one of them. The
//       pieces of this part have smaller boxes, and no box has infinitely many doubles in it.
// Cost: for each round, of which two or three are usual, n log n in the segments and the pairs of boxes that meet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/run/steps.h"

namespace rbpa {

/// A part of a segment, between two places in lexicographic order, and the number of the segment.
struct SegmentPart {
  Point low, high;
  std::uint32_t segment;
};

/// A place at which two segments, by their numbers, are split.
struct SplitPlace {
  Point at;
  std::array<std::uint32_t, 2> segments;
};

/// Splits the parts; returns the places, in lexicographic order, each once. Of equal parts, only that of the lowest
/// segment is kept. Requires: low < high for each part. Throws: Cancelled.
std::vector<SplitPlace> split_crossings(std::vector<SegmentPart>& parts, Steps& step);

}  // namespace rbpa
