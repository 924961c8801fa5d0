#include "plane/partial/cuts.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/partial_bytes.h"
#include "rbpa/plane/polygon_of_points.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"
#include "support/infinity.h"
#include "support/order.h"

namespace rbpa_test {
namespace {

using rbpa::Region;

/// Returns a coordinate of one of the points, or one between two of them.
double place(const Points& points, bool is_x, Random& random) {
  const auto any = [&] {
    const rbpa::Point& p = points[random.below(points.size())];
    return is_x ? p.x : p.y;
  };
  const double a = any();
  return random.chance(0.6) ? a : a / 2 + any() / 2;
}

std::vector<double> lines(const Points& points, bool is_x, std::size_t count, Random& random) {
  std::vector<double> at{-infinity, infinity};
  for (; count > 0 && !points.empty(); --count) at.push_back(place(points, is_x, random));
  sort_distinct(at);
  return at;
}

void quarter(const Region& region, const Region& box, const Points& points, std::size_t most, int depth,
             Regions& regions) {
  const auto inside = static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const auto& p) { return region.contains(p); }));
  const double x = box.x0 / 2 + box.x1 / 2, y = box.y0 / 2 + box.y1 / 2;
  if (inside <= most || depth == 0 || !(box.x0 < x && x < box.x1 && box.y0 < y && y < box.y1)) {
    regions.push_back(region);
    return;
  }
  quarter({region.x0, region.y0, x, y}, {box.x0, box.y0, x, y}, points, most, depth - 1, regions);
  quarter({x, region.y0, region.x1, y}, {x, box.y0, box.x1, y}, points, most, depth - 1, regions);
  quarter({region.x0, y, x, region.y1}, {box.x0, y, x, box.y1}, points, most, depth - 1, regions);
  quarter({x, y, region.x1, region.y1}, {x, y, box.x1, box.y1}, points, most, depth - 1, regions);
}

}  // namespace

Regions grid_cut(const Points& points, std::size_t count, Random& random) {
  const std::vector<double> xs = lines(points, true, random.below(count + 1), random);
  const std::vector<double> ys = lines(points, false, random.below(count + 1), random);
  Regions regions;
  for (std::size_t i = 1; i < xs.size(); ++i)
    for (std::size_t j = 1; j < ys.size(); ++j) regions.push_back({xs[i - 1], ys[j - 1], xs[i], ys[j]});
  return regions;
}

Regions halving_cut(const Points& points, std::size_t cuts, Random& random) {
  Regions regions{Region{}};
  for (; cuts > 0 && !points.empty(); --cuts) {
    Region& cut = regions[random.below(regions.size())];
    Region rest = cut;
    const bool is_x = random.chance(0.5);
    const double at = place(points, is_x, random);
    if (is_x ? at < cut.x0 || at > cut.x1 : at < cut.y0 || at > cut.y1) continue;
    // On the border of the region, one of the two parts is empty.
    (is_x ? cut.x1 : cut.y1) = at;
    (is_x ? rest.x0 : rest.y0) = at;
    regions.push_back(rest);
  }
  return regions;
}

Regions quartering_cut(const Points& points, std::size_t most) {
  Region box{infinity, infinity, -infinity, -infinity};
  for (const auto& p : points)
    box = {std::min(box.x0, p.x), std::min(box.y0, p.y), std::max(box.x1, p.x), std::max(box.y1, p.y)};
  Regions regions;
  quarter(Region{}, box, points, most, 12, regions);
  return regions;
}

Regions any_cut(const Points& points, std::size_t regions, Random& random) {
  switch (random.below(3)) {
    case 0:
      return grid_cut(points, std::bit_width(regions) + 1, random);
    case 1:
      return halving_cut(points, regions, random);
    default:
      return quartering_cut(points, points.size() / regions + 1);
  }
}

Given given(const Region& region, const Points& points, double alpha, Random* shuffled) {
  const Region wide = rbpa::halo(region, alpha);
  Given result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (wide.contains(points[i])) result.indices.push_back(i);
  if (shuffled != nullptr) shuffled->shuffle(result.indices);
  for (const std::uint64_t i : result.indices) result.points.push_back(points[i]);
  return result;
}

std::vector<rbpa::Partial> partials(const Regions& regions, const Points& points, double alpha) {
  std::vector<rbpa::Partial> result;
  for (const Region& region : regions)
    result.push_back(rbpa::partial(region, given(region, points, alpha), alpha, {.threads = 1}));
  return result;
}

rbpa::Partial merged(std::vector<rbpa::Partial> parts, Random& random) {
  // Some trees are nearly lists, others nearly balanced.
  const bool is_list = random.chance(0.3);
  random.shuffle(parts);
  while (parts.size() > 1) {
    rbpa::Partial a = std::move(parts.back());
    parts.pop_back();
    const std::size_t other = is_list ? parts.size() - 1 : random.below(parts.size());
    if (random.chance(0.1)) a = rbpa::partial_from_bytes(rbpa::to_bytes(a));
    rbpa::Partial& b = parts[other];
    b = random.chance(0.5) ? rbpa::merge(std::move(a), std::move(b)) : rbpa::merge(std::move(b), std::move(a));
  }
  return parts.empty() ? rbpa::Partial() : std::move(parts[0]);
}

rbpa::WholeComplex whole(const Points& points, double alpha) {
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
  const rbpa::ComplexCounts counts = rbpa::count(complex);
  rbpa::WholeComplex result{.counts = {.points = points.size(),
                                       .duplicates = complex.duplicates.size(),
                                       .isolated = complex.isolated.size(),
                                       .vertices = counts.points_covered,
                                       .edges = counts.edges,
                                       .triangles = counts.triangles,
                                       .solid_components = counts.solid_components,
                                       .components = counts.components,
                                       .boundary_curves = counts.boundary_curves},
                            .polygons = {}};
  const std::vector<rbpa::Polygon> polygons = rbpa::outline_polygons(complex);
  const auto corners = [&](const rbpa::Ring& ring) {
    rbpa::CornerRing made;
    for (const std::uint32_t i : ring.points) made.push_back({i, points[i]});
    return made;
  };
  for (const rbpa::Polygon& polygon : polygons) {
    rbpa::CornerPolygon& made = result.polygons.emplace_back(
        rbpa::CornerPolygon{.shell = corners(polygon.shell), .area = polygon.area, .perimeter = polygon.perimeter});
    for (const rbpa::Ring& hole : polygon.holes) made.holes.push_back(corners(hole));
  }
  for (const auto& number : rbpa::polygon_of_points(complex, polygons, {}, points))
    if (number) ++result.polygons[*number].points;
  return result;
}

std::string difference(const rbpa::WholeComplex& found, const rbpa::WholeComplex& expected) {
  std::string text;
  const auto compare = [&](const char* name, std::uint64_t a, std::uint64_t b) {
    if (a != b) text += std::string(name) + " " + std::to_string(a) + ", expected " + std::to_string(b) + "; ";
  };
  const rbpa::PartialCounts &a = found.counts, &b = expected.counts;
  compare("points", a.points, b.points);
  compare("duplicates", a.duplicates, b.duplicates);
  compare("isolated", a.isolated, b.isolated);
  compare("vertices", a.vertices, b.vertices);
  compare("edges", a.edges, b.edges);
  compare("triangles", a.triangles, b.triangles);
  compare("solid components", a.solid_components, b.solid_components);
  compare("components", a.components, b.components);
  compare("boundary curves", a.boundary_curves, b.boundary_curves);
  compare("polygons", found.polygons.size(), expected.polygons.size());
  if (!text.empty()) return text;
  for (std::size_t i = 0; i < found.polygons.size(); ++i) {
    const rbpa::CornerPolygon &p = found.polygons[i], &q = expected.polygons[i];
    if (p.shell != q.shell) text += "shell ";
    if (p.holes != q.holes) text += "holes ";
    if (p.area != q.area) text += "area ";
    if (p.perimeter != q.perimeter) text += "perimeter ";
    compare("points in it", p.points, q.points);
    if (!text.empty()) return text + "of polygon " + std::to_string(i);
  }
  return text;
}

}  // namespace rbpa_test
