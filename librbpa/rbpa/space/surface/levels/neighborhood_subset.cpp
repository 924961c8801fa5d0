#include "rbpa/space/surface/levels/neighborhood_subset.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/arrays/sort_unique.h"

namespace rbpa::space {
namespace {

Cells cells_of(std::span<const Point3> points, double radius) {
  Threads threads;
  return Cells(points, radius, threads);
}

}  // namespace

NeighborhoodFinder::NeighborhoodFinder(std::span<const Point3> points, double radius)
    : cells_(cells_of(points, radius)), site_(points.size()) {
  for (Site site = 0; site < cells_.sites().size(); ++site) site_[cells_.input_index()[site]] = site;
  for (const auto& [site, index] : cells_.equals()) site_[index] = site;
}

std::vector<std::uint32_t> NeighborhoodFinder::around(std::span<const std::uint32_t> wanted) const {
  std::vector<std::size_t> cells;
  for (const std::uint32_t i : wanted) cells.push_back(cells_.cell_of(site_[i]));
  sort_unique(cells);
  std::vector<std::pair<Site, Site>> runs;
  Cells::Around around(cells_);
  for (const std::size_t cell : cells)
    around.for_each_run(cell, [&](Site first, Site last) { runs.emplace_back(first, last); });
  std::sort(runs.begin(), runs.end());

  std::vector<std::uint32_t> near;
  const std::span<const Cells::Equal> equals = cells_.equals();
  Site end = 0;
  for (auto [first, last] : runs) {
    first = std::max(first, end);
    for (Site site = first; site < last; ++site) near.push_back(cells_.input_index()[site]);
    auto equal = std::lower_bound(equals.begin(), equals.end(), first,
                                  [](const Cells::Equal& e, Site site) { return e.site < site; });
    for (; equal != equals.end() && equal->site < last; ++equal) near.push_back(equal->index);
    end = std::max(end, last);
  }
  std::sort(near.begin(), near.end());
  return near;
}

NeighborhoodSubset neighborhood_subset(std::span<const Point3> points, std::span<const Point3> normals,
                                       std::span<const Duplicate> duplicates, const std::vector<std::uint8_t>& wanted,
                                       double radius) {
  std::vector<std::uint32_t> list;
  for_each_distinct(points.size(), duplicates, [&](std::uint32_t i) {
    if (wanted[i] != 0) list.push_back(i);
  });
  NeighborhoodSubset result{.input = NeighborhoodFinder(points, radius).around(list), .points = {}, .normals = {}};
  for (const std::uint32_t i : result.input) {
    result.points.push_back(points[i]);
    if (!normals.empty()) result.normals.push_back(normals[i]);
  }
  return result;
}

}  // namespace rbpa::space
