// What: walks along the boundary sides of a region's triangles, as far as the region determines their continuation.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/partial/region_complex.h"

namespace rbpa {

/// The side of a triangle across from a corner, without a neighbor.
struct OpenSide {
  std::uint32_t triangle;
  std::uint32_t across;
};

class RimWalk {
 public:
  explicit RimWalk(const RegionComplex& of) : of_(of), seen_(of.triangulation().triangles.size(), 0) {}

  std::uint32_t from(const OpenSide& side) const { return corner(side.triangle, side.across + 1); }
  std::uint32_t to(const OpenSide& side) const { return corner(side.triangle, side.across + 2); }

  bool is_new(const OpenSide& side) const { return (unsigned{seen_[side.triangle]} >> side.across & 1U) == 0; }

  /// Returns the points from the beginning of a new side on, triangles on the left: up to the first point that the
  /// region does not own, or each point of a closed curve once.
  std::vector<Corner> path_from(OpenSide side) {
    std::vector<Corner> path{of_.corner(from(side))};
    const OpenSide first = side;
    do {
      seen_[side.triangle] = static_cast<std::uint8_t>(seen_[side.triangle] | 1U << side.across);
      path.push_back(of_.corner(to(side)));
      if (!of_.owns(to(side))) return path;
      side = side_after(side);
    } while (side.triangle != first.triangle || side.across != first.across);
    path.pop_back();  // it repeats the first point
    return path;
  }

 private:
  std::uint32_t corner(std::uint32_t t, std::uint32_t k) const { return of_.triangulation().triangles[t][k % 3]; }

  /// Returns the side that begins where this one ends, at the other end of the fan around that point.
  OpenSide side_after(const OpenSide& side) const {
    const std::uint32_t pivot = to(side);
    OpenSide at{side.triangle, (side.across + 1) % 3};
    for (std::uint32_t next = across(at); next != AlphaComplex::none; next = across(at)) {
      const auto& corners = of_.triangulation().triangles[next];
      const std::uint32_t place = corners[0] == pivot ? 0 : corners[1] == pivot ? 1 : 2;
      at = {next, (place + 2) % 3};
    }
    return at;
  }
  std::uint32_t across(const OpenSide& side) const { return of_.triangulation().neighbors[side.triangle][side.across]; }

  const RegionComplex& of_;
  std::vector<std::uint8_t> seen_;  // for each triangle, a bit for each side
};

}  // namespace rbpa
