#include "rbpa/space/balls/periodic/parts.h"

#include <algorithm>

#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {

Boxes step_across(const PeriodicSolid& solid, std::uint32_t t, std::size_t k) {
  const std::uint32_t common = solid.simplices[t][outer_faces[k][0]];
  const auto& beyond = solid.simplices[solid.neighbors[t][k]];
  if (std::find(beyond.begin(), beyond.end(), common) != beyond.end()) return {0, 0, 0};  // nearly always
  const PeriodicVertex& here = solid.vertices[common];
  for (const std::uint32_t corner : beyond) {
    const PeriodicVertex& there = solid.vertices[corner];
    if (there.point == here.point)
      return {here.offset[0] - there.offset[0], here.offset[1] - there.offset[1], here.offset[2] - there.offset[2]};
  }
  return {0, 0, 0};
}

Parts::Parts(const PeriodicSolid& solid, const std::vector<bool>& is_inside, const FacesWithin* walls) {
  const std::size_t count = solid.simplices.size();
  std::vector<Boxes> place(count);
  std::vector<bool> is_placed(count, false);
  order_.reserve(count);
  for (std::uint32_t first = 0; first < count; ++first) {
    if (is_placed[first]) continue;
    place[first] = {0, 0, 0};
    is_placed[first] = true;
    order_.push_back(first);
    Rank& directions = directions_.emplace_back();
    for (std::size_t at = begin_.back(); at < order_.size(); ++at) {
      const std::uint32_t t = order_[at];
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t n = solid.neighbors[t][k];
        if (is_inside[n] != is_inside[t] || (walls != nullptr && !is_inside[t] && walls->has_triangle(t, k))) continue;
        const Boxes step = step_across(solid, t, k);
        const Boxes there = {place[t][0] + step[0], place[t][1] + step[1], place[t][2] + step[2]};
        if (!is_placed[n]) {
          is_placed[n] = true;
          place[n] = there;
          order_.push_back(n);
          continue;
        }
        const Boxes around = {there[0] - place[n][0], there[1] - place[n][1], there[2] - place[n][2]};
        directions.add(around);
        if (!is_inside[t]) directions_outside_.add(around);
      }
    }
    begin_.push_back(order_.size());
  }
}

}  // namespace rbpa::space
