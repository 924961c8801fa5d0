#include <algorithm>
#include <array>
#include <limits>

#include "drawings/drawn_complex.h"
#include "drawings/figures.h"
#include "drawings/random.h"
#include "picture/filtration_plot.h"
#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/plateaus.h"

namespace figures {
namespace {

/// Points around an empty disc, none nearer to another than `apart`.
struct Ring {
  Place middle;
  double inside, outside, apart;
};

Points sampled(const Ring& ring, Random& random) {
  constexpr int tries = 6000;
  Points points;
  for (int i = 0; i < tries; ++i) {
    const double x = 2 * random() - 1;
    const Place p = ring.middle + ring.outside * Place{x, 2 * random() - 1};
    const double out = length(p - ring.middle);
    const bool crowded = std::any_of(points.begin(), points.end(),
                                     [&](const rbpa::Point& q) { return length(place_of(q) - p) < ring.apart; });
    if (out > ring.inside && out < ring.outside && !crowded) points.push_back({p.x, p.y});
  }
  return points;
}

/// What `rbpa alpha -o` draws of three rings, the larger the sparser.
std::string filtration_plot() {
  Random random(5);
  Points points;
  for (const Ring& ring : {Ring{{0, 0}, 0.4, 0.8, 0.05}, {{6, 0}, 1.2, 2.2, 0.2}, {{2, 8}, 3, 5, 0.7}}) {
    const Points some = sampled(ring, random);
    points.insert(points.end(), some.begin(), some.end());
  }
  const rbpa::Triangulation delaunay =
      rbpa::triangulate(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  const rbpa::Filtration filtration = rbpa::filtration(delaunay, points);
  const auto pairs = rbpa::persistence(delaunay, points, filtration);
  return rbpa::app::svg_of({filtration.steps, pairs, rbpa::smallest_covering(filtration),
                            rbpa::smallest_covering(filtration, 1),
                            rbpa::plateaus(delaunay, points, filtration).front()});
}

}  // namespace

std::span<const Figure> filtration_figures() {
  static constexpr std::array figures = {Figure{"filtration_plot", filtration_plot}};
  return figures;
}

}  // namespace figures
