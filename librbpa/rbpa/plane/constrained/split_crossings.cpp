#include "rbpa/plane/constrained/split_crossings.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>

#include "rbpa/plane/grid/plane_box_tree.h"
#include "rbpa/plane/predicate/constructions.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

bool cross(const SegmentPart& a, const SegmentPart& b) {
  return plane_orientation(a.low, a.high, b.low) * plane_orientation(a.low, a.high, b.high) < 0 &&
         plane_orientation(b.low, b.high, a.low) * plane_orientation(b.low, b.high, a.high) < 0;
}

std::vector<Box> boxes_of(std::span<const SegmentPart> parts) {
  std::vector<Box> boxes;
  for (const auto& [low, high, segment] : parts) boxes.push_back(common_box({low, low}, {high, high}));
  return boxes;
}

/// A place on a part.
struct PartCut {
  std::uint32_t part;
  Point at;
};

/// Returns the pieces of parts that are cut.
std::vector<SegmentPart> pieces_of(std::span<const SegmentPart> parts, std::vector<PartCut>& cuts, Steps& step) {
  // Rounding keeps the order of points along a part in each coordinate, but not the lexicographic order.
  sort(cuts, step, [&](const PartCut& a, const PartCut& b) {
    if (a.part != b.part) return a.part < b.part;
    if (a.at.x != b.at.x) return a.at.x < b.at.x;
    return parts[a.part].low.y <= parts[a.part].high.y ? a.at.y < b.at.y : a.at.y > b.at.y;
  });
  std::vector<SegmentPart> pieces;
  auto cut = cuts.begin();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    step();
    Point from = parts[i].low;
    const auto end_at = [&](const Point& to) {
      if (from != to) pieces.push_back({std::min(from, to), std::max(from, to), parts[i].segment});
      from = to;
    };
    for (; cut != cuts.end() && cut->part == i; ++cut) end_at(cut->at);
    end_at(parts[i].high);
  }
  return pieces;
}

void keep_one_of_equal(std::vector<SegmentPart>& parts, Steps& step) {
  sort(parts, step, [](const SegmentPart& a, const SegmentPart& b) {
    return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
  });
  const auto are_equal = [](const SegmentPart& a, const SegmentPart& b) { return a.low == b.low && a.high == b.high; };
  parts.erase(std::unique(parts.begin(), parts.end(), are_equal), parts.end());
}

}  // namespace

std::vector<SplitPlace> split_crossings(std::vector<SegmentPart>& parts, Steps& step) {
  std::vector<SplitPlace> places;
  for (;;) {
    keep_one_of_equal(parts, step);
    std::vector<PartCut> cuts;
    PlaneBoxTree(boxes_of(parts), step).visit_pairs([&](std::uint32_t i, std::uint32_t j) {
      const SegmentPart &a = parts[i], &b = parts[j];
      if (!cross(a, b)) return;
      const Point at = crossing({a.low, a.high}, {b.low, b.high});
      cuts.push_back({i, at});
      cuts.push_back({j, at});
      places.push_back({at, {std::min(a.segment, b.segment), std::max(a.segment, b.segment)}});
    });
    if (cuts.empty()) break;
    parts = pieces_of(parts, cuts, step);
  }
  sort(places, step, [](const SplitPlace& a, const SplitPlace& b) {
    return std::tie(a.at, a.segments) < std::tie(b.at, b.segments);
  });
  const auto are_equal = [](const SplitPlace& a, const SplitPlace& b) { return a.at == b.at; };
  places.erase(std::unique(places.begin(), places.end(), are_equal), places.end());
  return places;
}

}  // namespace rbpa
