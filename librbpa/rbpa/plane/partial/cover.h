// What: the part of the plane that regions cover together.
// How:  the sum of the indicator functions of the regions is a sum of quadrants, one at each corner of each region,
//       with a sign. Where regions lie side by side, quadrants cancel; those at the corners of the covered part remain.
// Law:  the quadrants are a function of the covered part, not of its division into regions.
// Cost: as many corners as the covered part has; n log n to check the corners.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/plane/region.h"

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
  /// Constructs a cover from quadrants. Requires: corners strictly ascend; no weight is 0.
  explicit Cover(std::vector<Quadrant> quadrants) : quadrants_(std::move(quadrants)) {}

  /// Returns the sum of two covers.
  friend Cover operator+(const Cover& a, const Cover& b);

  std::span<const Quadrant> quadrants() const { return quadrants_; }
  bool is_whole() const;
  /// Returns the lower left corner of an area that is covered more than once or a negative number of times, if any.
  std::optional<Point> wrong() const;
  /// Returns the lower left corner of an area that is not covered; nothing if the whole plane is covered.
  std::optional<Point> missing() const;

 private:
  std::vector<Quadrant> quadrants_;  // by corner
};

}  // namespace rbpa
