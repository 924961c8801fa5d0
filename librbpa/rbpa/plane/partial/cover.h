// What: which part of the plane regions cover together.
// How:  the sum of their indicator functions is a sum of quadrants, one at each corner of each region, with a sign. Where
//       regions lie side by side, corners cancel: what is left are the corners of the part covered.
// Law:  a function of the part covered, not of how it was cut.
// Cost: as many corners as that part has; n log n to check them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/region.h"

namespace rbpa {

/// Adds `weight` to the cover of every point (x, y) with x ≥ at.x and y ≥ at.y. Coordinates may be −∞.
struct Quadrant {
  Point at;
  int weight;
  friend bool operator==(const Quadrant&, const Quadrant&) = default;
};

class Cover {
 public:
  Cover() = default;
  explicit Cover(const Region& region);
  /// Requires: ascending by corner, none twice, no weight 0.
  explicit Cover(std::vector<Quadrant> quadrants) : quadrants_(std::move(quadrants)) {}

  /// The sum of both.
  friend Cover operator+(const Cover& a, const Cover& b);

  std::span<const Quadrant> quadrants() const { return quadrants_; }
  bool is_whole() const;
  /// The corner of a place that is covered more than once, or less than not at all.
  std::optional<Point> wrong() const;
  /// The corner of a place that is not covered.
  std::optional<Point> missing() const;

 private:
  std::vector<Quadrant> quadrants_;  // by corner
};

}  // namespace rbpa
