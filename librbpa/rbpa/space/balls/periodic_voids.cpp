#include "rbpa/space/balls/periodic_voids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/hollows.h"
#include "rbpa/space/balls/periodic/cell_axes.h"
#include "rbpa/space/balls/periodic/periodic_regular.h"
#include "rbpa/space/cells/check_input.h"

namespace rbpa {
namespace {

using space::Boxes;
using space::PeriodicRegular;

/// The parts of the tetrahedra outside of the dual complex, connected across triangles that are not in it.
struct VoidParts {
  std::vector<BallVoid> all;           // with their tetrahedra, as tetrahedra of PeriodicRegular::cells
  std::vector<std::uint32_t> part_of;  // of each kept tetrahedron

  VoidParts(const PeriodicRegular& regular, const space::FacesWithin& faces)
      : part_of(regular.kept.size(), PeriodicRegular::none) {
    const space::Parts parts(
        regular.kept.size(), [&](std::uint32_t i, std::size_t k) { return regular.neighbors[i][k]; },
        [&](std::uint32_t i, std::size_t k) { return !faces.has_triangle(regular.kept[i], k); },
        [](std::uint32_t) { return true; });
    for (std::size_t part = 0; part < parts.size(); ++part) {
      if (faces.has_tetrahedron(regular.kept[parts.tetrahedra(part).front()])) continue;
      for (const std::uint32_t i : parts.tetrahedra(part)) part_of[i] = static_cast<std::uint32_t>(all.size());
      BallVoid& of = all.emplace_back();
      of.dimension = parts.directions(part).value();
      for (const std::uint32_t i : parts.tetrahedra(part)) of.tetrahedra.push_back(regular.kept[i]);
      std::sort(of.tetrahedra.begin(), of.tetrahedra.end());
    }
  }
};

/// Returns a margin within which are all images that meet the largest balls with centers in these parts.
double required_margin(const PeriodicRegular& regular, const VoidParts& parts) {
  if (parts.all.empty()) return 0;
  double diameter = 0;
  for (const BallVoid& of : parts.all)
    for (const std::uint32_t t : of.tetrahedra)
      for (const std::uint32_t a : regular.cells.simplices[t])
        for (const std::uint32_t b : regular.cells.simplices[t])
          diameter = std::max(diameter, space::distance(regular.centers[a], regular.centers[b]));
  return 2 * diameter + *std::max_element(regular.radii.begin(), regular.radii.end());
}

/// Returns an image of p in the cell, up to rounding.
Point3 moved_into(Point3 p, const RepeatingCell& cell) {
  const std::array<double, 3> along = space::CellAxes(cell).along(p);
  for (const auto c : {&Point3::x, &Point3::y, &Point3::z})
    for (std::size_t k = 0; k < 3; ++k) p.*c -= std::floor(along[k]) * (cell.edges[k].*c);
  return p;
}

class VoidMeasurer {
 public:
  VoidMeasurer(const PeriodicRegular& regular, const space::Hollows& hollows, VoidParts parts, Threads& threads,
               const GoOn& go_on)
      : regular_(regular), hollows_(hollows), parts_(std::move(parts)), threads_(threads), go_on_(go_on) {}

  std::vector<BallVoid> all() {
    std::vector<BallVoid>& all = parts_.all;
    measure(all);
    // Each place has an image in a kept tetrahedron: the largest ball is looked for only there.
    std::vector<std::uint32_t> region(regular_.cells.simplices.size(), PeriodicRegular::none);
    for (std::uint32_t i = 0; i < all.size(); ++i)
      for (const std::uint32_t t : all[i].tetrahedra) region[t] = i;
    const space::Grouped images(regular_.ball.size(), regular_.ball.size(),
                                [&](std::uint32_t image) { return regular_.ball[image]; });
    CheckpointOfThreads checkpoint(go_on_);
    for_each_index(threads_, all.size(), [&](std::size_t i) {
      checkpoint();
      std::vector<std::uint32_t> around;
      for (const std::uint32_t t : all[i].tetrahedra)
        for (const std::uint32_t corner : regular_.cells.simplices[t]) around.push_back(images.number()[corner]);
      sort_unique(around);
      std::vector<std::uint32_t> copies;
      for (const std::uint32_t group : around)
        copies.insert(copies.end(), images.items(group).begin(), images.items(group).end());
      std::sort(copies.begin(), copies.end());
      hollows_.find_largest_ball(all[i], copies, region);
    });
    return std::move(all);
  }

 private:
  /// Fills in volumes, areas and lining balls: the shares of balls in the cell, whose tetrahedra are all right.
  void measure(std::vector<BallVoid>& all) {
    std::vector<std::uint32_t> region(regular_.kept_as);
    for (std::uint32_t& of : region)
      if (of != PeriodicRegular::none) of = parts_.part_of[of];
    std::vector<ExactSum> tetrahedra(all.size()), outside(all.size()), area(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const std::uint32_t t : all[i].tetrahedra)
        tetrahedra[i].add(hollows_.unscaled(hollows_.scaled_volume(t), 3));
    outside = tetrahedra;
    for (const space::RegionShare& share : hollows_.measure(region, all.size(), threads_, go_on_).shares) {
      if (regular_.offsets[share.ball] != Boxes{0, 0, 0}) continue;
      outside[share.region].add(-share.volume);
      area[share.region].add(share.area);
      all[share.region].balls.push_back({regular_.ball[share.ball], std::max(share.area, 0.0)});
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].volume_of_tetrahedra = tetrahedra[i].rounded();
      all[i].volume = std::max(outside[i].rounded(), 0.0);
      all[i].area = area[i].rounded();
      std::sort(all[i].balls.begin(), all[i].balls.end(),
                [](const LiningBall& a, const LiningBall& b) { return a.ball < b.ball; });
    }
  }

  const PeriodicRegular& regular_;
  const space::Hollows& hollows_;
  VoidParts parts_;
  Threads& threads_;
  const GoOn& go_on_;
};

}  // namespace

BallVoids periodic_ball_voids(std::span<const Point3> centers, std::span<const double> radii, const RepeatingCell& cell,
                              const SolidOptions& options) {
  space::check_balls(centers, radii);
  if (cell.repeats != std::array{true, true, true})
    throw InvalidInput("the cell does not repeat along all edges, expected three edges along which it repeats");
  BallVoids result;
  if (centers.empty()) return result;
  Threads threads = threads_for(centers.size(), options.threads);
  const GoOn go_on = go_on_of(options.progress, centers.size());
  for (double margin = 0;;) {
    const PeriodicRegular regular = space::periodic_regular(centers, radii, cell, margin, options);
    const space::Hollows hollows(regular.centers, regular.radii, regular.cells, threads, go_on);
    VoidParts parts(regular, hollows.faces());
    margin = required_margin(regular, parts);
    if (margin > regular.margin) continue;
    result.voids = VoidMeasurer(regular, hollows, std::move(parts), threads, go_on).all();
    break;
  }
  for (BallVoid& of : result.voids) {
    of.tetrahedra.clear();
    of.center = moved_into(of.center, cell);
    result.volume += of.volume;
    result.area += of.area;
  }
  std::stable_sort(result.voids.begin(), result.voids.end(), [](const BallVoid& a, const BallVoid& b) {
    return a.volume_of_tetrahedra > b.volume_of_tetrahedra;
  });
  return result;
}

}  // namespace rbpa
