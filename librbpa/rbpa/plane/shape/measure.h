// What: computes areas, exactly summed and rounded once, and lengths of rings.
// Law:  sums are a function of the set of edges, not of the order of edges.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// A sum of numbers that are not negative and may be infinite.
class LengthSum {
 public:
  void add(double value) {
    if (std::isinf(value))
      infinite_ = true;
    else
      sum_.add(value);
  }
  double rounded() const { return infinite_ ? std::numeric_limits<double>::infinity() : sum_.rounded(); }
  LengthSum& operator+=(const LengthSum& other) {
    sum_ += other.sum_;
    infinite_ = infinite_ || other.infinite_;
    return *this;
  }

  bool is_infinite() const { return infinite_; }
  const ExactSum& finite() const { return sum_; }  ///< sum of the finite numbers
  static LengthSum of(const ExactSum& finite, bool infinite) {
    LengthSum sum;
    sum.sum_ = finite;
    sum.infinite_ = infinite;
    return sum;
  }

 private:
  ExactSum sum_;
  bool infinite_ = false;
};

/// The area that the edges of a polygon's rings enclose, and their total length. Edges have the polygon on the left.
class BoundaryMeasure {
 public:
  BoundaryMeasure() = default;
  BoundaryMeasure(const ExactSum& twice_area, const LengthSum& lengths) : twice_(twice_area), lengths_(lengths) {}

  void add_edge(const Point& from, const Point& to);
  BoundaryMeasure& operator+=(const BoundaryMeasure& other) {
    twice_ += other.twice_;
    lengths_ += other.lengths_;
    return *this;
  }

  const ExactSum& twice_area() const { return twice_; }
  const LengthSum& lengths() const { return lengths_; }
  double area() const { return twice_.rounded(-1); }  ///< rounded once
  double perimeter() const { return lengths_.rounded(); }

 private:
  ExactSum twice_;
  LengthSum lengths_;
};

/// Adds twice the area that the ring encloses, exactly: positive when the ring is counter-clockwise.
void add_twice_area(ExactSum& sum, const Ring& ring, std::span<const Point> points);

/// Returns the area that the ring encloses, in either orientation, rounded once.
double enclosed_area(const Ring& ring, std::span<const Point> points);

/// Fills in area and perimeter of `polygon`, whose rings are indices into `points`.
void measure(Polygon& polygon, std::span<const Point> points);

}  // namespace rbpa
