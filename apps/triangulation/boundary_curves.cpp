#include "triangulation/boundary_curves.h"

#include <algorithm>
#include <cstddef>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

/// The side of a triangle across from a corner.
struct Side {
  std::uint32_t triangle;
  std::size_t across;
};

/// Walks along boundary sides, against the direction in which they run around their triangles.
class Walk {
 public:
  explicit Walk(const Triangulation& of) : of_(of), seen_(of.triangles.size(), 0) {}

  bool is_new(const Side& side) const {
    return of_.neighbors[side.triangle][side.across] == Triangulation::none &&
           (seen_[side.triangle] >> side.across & 1U) == 0;
  }

  /// The whole curve of a side that is new; none of its sides is new any more.
  std::vector<std::uint32_t> curve_from(Side side) {
    std::vector<std::uint32_t> points;
    for (; is_new(side); side = side_before(side)) {
      seen_[side.triangle] = static_cast<std::uint8_t>(seen_[side.triangle] | 1U << side.across);
      points.push_back(of_.triangles[side.triangle][(side.across + 2) % 3]);
    }
    return points;
  }

 private:
  /// The boundary side that ends where this one begins, at the other end of the fan around that point.
  Side side_before(const Side& side) const {
    const std::uint32_t pivot = of_.triangles[side.triangle][(side.across + 1) % 3];
    Side at{side.triangle, (side.across + 2) % 3};
    for (std::uint32_t next = neighbor(at); next != Triangulation::none; next = neighbor(at)) {
      const auto& corners = of_.triangles[next];
      const auto corner = std::find(corners.begin(), corners.end(), pivot) - corners.begin();
      at = {next, (static_cast<std::size_t>(corner) + 1) % 3};
    }
    return at;
  }
  std::uint32_t neighbor(const Side& side) const { return of_.neighbors[side.triangle][side.across]; }

  const Triangulation& of_;
  std::vector<std::uint8_t> seen_;  // of each triangle, a bit for each side
};

}  // namespace

std::vector<std::vector<std::uint32_t>> boundary_curves(const Triangulation& of) {
  Walk walk(of);
  std::vector<std::vector<std::uint32_t>> curves;
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
    if (t % 16384 == 0) stop_if_interrupted();
    for (std::size_t across = 0; across < 3; ++across)
      if (walk.is_new({t, across})) curves.push_back(walk.curve_from({t, across}));
  }
  return curves;
}

}  // namespace rbpa::app
