#include "meshops/topology/merge_points.h"

#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/topology/soup_sides.h"

namespace meshops {
namespace {

/// Returns the soup with the new numbers of its points, without corners that equal the corner before.
PolygonSoup renumbered(const PolygonSoup& soup, const std::vector<std::uint32_t>& number, std::size_t points,
                       Steps& step) {
  PolygonSoup result;
  result.points = points;
  result.corners.reserve(soup.corners.size());
  result.begin.reserve(soup.begin.size());
  std::vector<std::uint32_t> cycle;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step(1 + soup.face(f).size());
    cycle.clear();
    for (const std::uint32_t corner : soup.face(f)) {
      if (corner >= soup.points)
        throw ContractViolation("merge_points: a corner of face " + std::to_string(f) + " is not a point");
      if (cycle.empty() || cycle.back() != number[corner]) cycle.push_back(number[corner]);
    }
    while (cycle.size() > 1 && cycle.front() == cycle.back()) cycle.pop_back();
    result.add_face(cycle);
  }
  return result;
}

}  // namespace

MergedPoints merge_points(const PolygonSoup& soup, std::span<const std::uint32_t> least, const GoOn& go_on) {
  require_parted(soup);
  require_one_each("merge_points", least.size(), "values", soup.points, "points");
  Steps step(go_on);
  MergedPoints result;
  std::vector<std::uint32_t> number(soup.points);
  for (std::uint32_t p = 0; p < soup.points; ++p) {
    step();
    if (least[p] > p || least[least[p]] != least[p])
      throw ContractViolation("merge_points: least[" + std::to_string(p) + "] is " + std::to_string(least[p]) +
                              ", expected the lowest index of the points that are merged with point " +
                              std::to_string(p));
    if (least[p] == p) {
      number[p] = static_cast<std::uint32_t>(result.point_was.size());
      result.point_was.push_back(p);
    } else {
      number[p] = number[least[p]];
    }
  }
  result.merged = soup.points - result.point_was.size();

  const PolygonSoup merged = renumbered(soup, number, result.point_was.size(), step);
  detail::FaceFaults faults = detail::find_face_faults(merged, go_on);
  detail::keep_walls(merged, faults, go_on);
  result.soup.points = merged.points;
  for (std::size_t f = 0; f < merged.faces(); ++f) {
    step();
    result.degenerate += faults.of[f] == detail::FaceFault::degenerate;
    result.duplicate += faults.of[f] == detail::FaceFault::duplicate;
    if (faults.of[f] != detail::FaceFault::none) continue;
    result.corners += soup.face(f).size() - merged.face(f).size();
    result.soup.add_face(merged.face(f));
    result.face_was.push_back(f);
  }
  return result;
}

}  // namespace meshops
