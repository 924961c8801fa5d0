#include "stream/tile_tree.h"

#include <algorithm>
#include <utility>

namespace rbpa::app {
namespace {

/// Returns the two boxes into which `part` cuts `box`.
std::pair<Region, Region> halves(const Region& box, const TileTree::Part& part) {
  std::pair<Region, Region> both{box, box};
  const bool x = part.kind == TileTree::Part::Kind::cut_x;
  (x ? both.first.x1 : both.first.y1) = part.line;
  (x ? both.second.x0 : both.second.y0) = part.line;
  return both;
}

}  // namespace

TileTree::TileTree(std::vector<Part> parts) : parts_(std::move(parts)) {
  const auto is_tile = [](const Part& part) { return part.kind == Part::Kind::tile; };
  const auto count = static_cast<std::size_t>(std::count_if(parts_.begin(), parts_.end(), is_tile));
  boxes_.resize(count);
  part_of_.resize(count);
  std::vector<std::pair<std::uint32_t, Region>> waiting = {{0, Region{}}};
  while (!waiting.empty()) {
    const auto [at, box] = waiting.back();
    waiting.pop_back();
    const Part& part = parts_[at];
    if (is_tile(part)) {
      boxes_.at(part.first) = box;
      part_of_[part.first] = at;
      continue;
    }
    const auto [first, second] = halves(box, part);
    waiting.emplace_back(part.second, second);
    waiting.emplace_back(part.first, first);
  }
}

std::uint32_t TileTree::cut(std::uint32_t tile, Part::Kind kind, double line) {
  const auto added = static_cast<std::uint32_t>(boxes_.size()), at = part_of_[tile];
  const auto first = static_cast<std::uint32_t>(parts_.size());
  parts_.push_back({.first = tile});
  parts_.push_back({.first = added});
  parts_[at] = {kind, line, first, first + 1};
  const auto [low, high] = halves(boxes_[tile], parts_[at]);
  boxes_[tile] = low;
  boxes_.push_back(high);
  part_of_[tile] = first;
  part_of_.push_back(first + 1);
  return added;
}

std::vector<std::uint32_t> TileTree::order() const {
  std::vector<std::uint32_t> tiles, waiting = {0};
  while (!waiting.empty()) {
    const Part& part = parts_[waiting.back()];
    waiting.pop_back();
    if (part.kind == Part::Kind::tile) {
      tiles.push_back(part.first);
    } else {
      waiting.push_back(part.second);
      waiting.push_back(part.first);
    }
  }
  return tiles;
}

}  // namespace rbpa::app
