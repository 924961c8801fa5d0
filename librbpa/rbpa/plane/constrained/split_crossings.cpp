#include "rbpa/plane/constrained/split_crossings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "rbpa/base/error.h"
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
  for (const SegmentPart& part : parts) boxes.push_back(common_box({part.low, part.low}, {part.high, part.high}));
  return boxes;
}

/// A place at which a part is cut.
struct PartCut {
  std::uint32_t part;
  Point at;
};

double largest_coordinate(const SegmentPart& part) {
  return std::max({std::abs(part.low.x), std::abs(part.low.y), std::abs(part.high.x), std::abs(part.high.y)});
}

/// Returns whether `p`, no end of the part, is beside it, and at most `distance` away from it.
bool is_close(const Point& p, const SegmentPart& part, double distance) {
  const Point &a = part.low, &b = part.high;
  if (p == a || p == b) return false;
  const double x = b.x - a.x, y = b.y - a.y, to_x = p.x - a.x, to_y = p.y - a.y;
  const double length = std::max(std::abs(x), std::abs(y));
  const double along = std::abs(x) == length ? to_x / x : to_y / y;
  return along > 0 && along < 1 && std::abs(to_x * (y / length) - to_y * (x / length)) <= distance;
}

/// Returns the pieces of parts that are cut.
std::vector<SegmentPart> pieces_of(std::span<const SegmentPart> parts, std::vector<PartCut>& cuts, Steps& step) {
  sort(cuts, step, [&](const PartCut& a, const PartCut& b) {
    if (a.part != b.part) return a.part < b.part;
    const Point &low = parts[a.part].low, &high = parts[a.part].high;
    const bool rises = low.y <= high.y;
    const double x = a.at.x - b.at.x, y = rises ? a.at.y - b.at.y : b.at.y - a.at.y;
    const bool is_flat = std::abs(high.x / 2 - low.x / 2) >= std::abs(high.y / 2 - low.y / 2);
    return is_flat ? std::pair(x, y) < std::pair(0.0, 0.0) : std::pair(y, x) < std::pair(0.0, 0.0);
  });
  std::vector<SegmentPart> pieces;
  auto cut = cuts.begin();
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    step();
    Point from = parts[i].low;
    const auto end_at = [&](const Point& to) {
      if (from != to) pieces.push_back({std::min(from, to), std::max(from, to), parts[i].segment, parts[i].is_odd});
      from = to;
    };
    for (; cut != cuts.end() && cut->part == i; ++cut) end_at(cut->at);
    end_at(parts[i].high);
  }
  return pieces;
}

void join_equal(std::vector<SegmentPart>& parts, Steps& step) {
  sort(parts, step, [](const SegmentPart& a, const SegmentPart& b) {
    return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
  });
  std::size_t kept = 0;
  for (const SegmentPart& part : parts) {
    if (kept > 0 && parts[kept - 1].low == part.low && parts[kept - 1].high == part.high)
      parts[kept - 1].is_odd ^= part.is_odd;
    else
      parts[kept++] = SegmentPart(part);
  }
  parts.resize(kept);
}

}  // namespace

std::vector<SplitPlace> split_crossings(std::vector<SegmentPart>& parts, Steps& step) {
  constexpr int rounds_by_part = 8, rounds_with_ends = 40, most_rounds = 100;
  double largest = 0;
  for (const SegmentPart& part : parts) largest = std::max(largest, largest_coordinate(part));
  std::vector<SplitPlace> places;
  for (int round = 0;; ++round) {
    join_equal(parts, step);
    std::vector<PartCut> cuts;
    const double share = std::ldexp(std::numeric_limits<double>::epsilon(), 2 + round / 4);
    PlaneBoxTree(boxes_of(parts), step).visit_pairs([&](std::uint32_t i, std::uint32_t j) {
      const SegmentPart &a = parts[i], &b = parts[j];
      if (!cross(a, b)) return;
      const Point at = crossing({a.low, a.high}, {b.low, b.high});
      const bool is_exact = plane_orientation(a.low, a.high, at) == 0 && plane_orientation(b.low, b.high, at) == 0;
      const std::size_t before = cuts.size();
      const auto cut_at_ends = [&](std::uint32_t cut, const SegmentPart& other) {
        const double distance = share * (round < rounds_by_part ? largest_coordinate(parts[cut]) : largest);
        for (const Point& end : {other.low, other.high})
          if (is_close(end, parts[cut], distance)) cuts.push_back({cut, end});
      };
      if (round < rounds_with_ends && !is_exact) {
        cut_at_ends(i, b);
        cut_at_ends(j, a);
      }
      if (cuts.size() > before) return;
      cuts.push_back({i, at});
      cuts.push_back({j, at});
      places.push_back({at, {std::min(a.segment, b.segment), std::max(a.segment, b.segment)}});
    });
    if (cuts.empty()) break;
    if (round == most_rounds)
      throw InvalidInput("segments: found parts that still cross when they are split for the " +
                         std::to_string(most_rounds) + "th time, as they are nearly one line, expected lines apart");
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
