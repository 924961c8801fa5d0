// What: the disc in which the plane cuts a ball of radius alpha that turns over an edge.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "drawings/canvas.h"
#include "meshops/patch/site.h"

namespace figures {

/// Section of a ball by the plane.
struct Disc {
  Place center;
  double radius;
};

inline Place left_of(Place d) { return {-d.y, d.x}; }
inline double dot(Place a, Place b) { return a.x * b.x + a.y * b.y; }
inline double cross(Place a, Place b) { return a.x * b.y - a.y * b.x; }

class BallInPlane {
 public:
  using Site = meshops::Site;

  BallInPlane(std::vector<Place> places, double alpha) : places_(std::move(places)), alpha_(alpha) {}

  /// Returns the distance of the center from the edge ab, in half-chords to the left, when the ball also touches c.
  double half_chords(Site a, Site b, Site c) const {
    const Place e = at(c) - at(a), f = at(c) - at(b), d = at(b) - at(a);
    return dot(e, f) / cross(d, e);
  }
  /// Returns the disc of a ball on a and b whose center is this many half-chords left of the edge.
  Disc on_edge(Site a, Site b, double half_chords) const {
    const Place d = at(b) - at(a);
    return {middle(a, b) + (half_chords / 2) * left_of(d), length(d) / 2 * std::sqrt(1 + half_chords * half_chords)};
  }
  /// Returns the disc of a ball at rest on three points.
  Disc on(Site a, Site b, Site c) const { return on_edge(a, b, half_chords(a, b, c)); }
  /// Returns the disc of a ball that touches two points at its equator, after it turned to the left of the edge without
  /// touching a third point.
  Disc largest_left_of(Site a, Site b) const {
    const Place d = at(b) - at(a);
    return {middle(a, b) + std::sqrt(alpha_ * alpha_ - dot(d, d) / 4) * direction(left_of(d)), alpha_};
  }

 private:
  Place at(Site s) const { return places_[static_cast<std::size_t>(s)]; }
  Place middle(Site a, Site b) const { return 0.5 * (at(a) + at(b)); }

  std::vector<Place> places_;
  double alpha_;
};

}  // namespace figures
