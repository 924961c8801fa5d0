// What: splits segments where they cross.
// Law:  afterwards no two segments cross, except in points that are an end of one of them or more. The result depends
//       on the segments as a set. Parts usually lie within a few units in the last place from their segments.
// How:  in rounds: all pairs that cross are found, and all crossings become ends at once. A crossing that doubles
//       represent is taken as it is. Otherwise an end of one part is taken if it is close to the other, or else the
//       crossing, rounded to nearest. The parts bend by that, and may cross others, which the next round splits.
// Why:  without the ends, the crossings of nearly parallel lines would be rounded ever anew, a last place farther each
//       time. With them, lines between places that are all that close might bend to and fro. So an end is close within
//       2⁻⁵⁰ of the largest coordinate of the part in the first rounds, of all parts from the ninth on; the distance is
//       doubled after each four rounds; and from the 41st on ends are not taken. A rounded crossing stays in the
//       bounding box of its part, whose pieces have smaller boxes, so that the last rounds are few in small boxes.
// Cost: for each round, of which two or three are usual and 100 the limit, n log n in the segments and the pairs of
//       boxes that meet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/run/steps.h"

namespace rbpa {

/// A part of one or several segments, between two places in lexicographic order.
struct SegmentPart {
  Point low, high;
  std::uint32_t segment;  ///< the least number of these segments
  bool is_odd = true;     ///< whether their number is odd
};

/// A place at which two segments, by their numbers, are split.
struct SplitPlace {
  Point at;
  std::array<std::uint32_t, 2> segments;
};

/// Splits the parts; returns the places, in lexicographic order, each once. Equal parts become one.
/// Requires: low < high for each part. Throws: InvalidInput at the limit of rounds; Cancelled.
std::vector<SplitPlace> split_crossings(std::vector<SegmentPart>& parts, Steps& step);

}  // namespace rbpa
