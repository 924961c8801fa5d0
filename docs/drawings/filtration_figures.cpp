#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drawings/drawn_complex.h"
#include "drawings/figures.h"
#include "drawings/random.h"
#include "picture/filtration_plot.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"

namespace figures {
namespace {

/// Ring of points around an empty disc, no two nearer than `apart`.
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

/// Returns the plot that `rbpa alpha -o` draws for three rings; the larger a ring, the sparser.
std::string filtration_plot() {
  Random random(5);
  Points points;
  for (const Ring& ring : {Ring{{0, 0}, 0.4, 0.8, 0.05}, {{6, 0}, 1.2, 2.2, 0.2}, {{2, 8}, 3, 5, 0.7}}) {
    const Points some = sampled(ring, random);
    points.insert(points.end(), some.begin(), some.end());
  }
  const rbpa::AlphaComplex delaunay =
      rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  const rbpa::Filtration filtration = rbpa::filtration(delaunay, points);
  const auto pairs = rbpa::persistence(delaunay, points, filtration);
  rbpa::app::FiltrationPlot plot = rbpa::app::plot_of(filtration.steps, pairs);
  plot.least_covering = rbpa::smallest_covering(filtration);
  plot.least_connected = rbpa::smallest_covering(filtration, 1);
  plot.plateau = rbpa::plateaus(delaunay, points, filtration).front();
  return rbpa::app::svg_of(plot);
}

/// Returns the persistence diagram of 96 by 24 points of a torus.
std::string persistence_of_torus() {
  constexpr int around_hole = 96, around_tube = 24;
  constexpr double turn = 6.283185307179586;
  std::vector<rbpa::Point3> points;
  for (int i = 0; i < around_hole; ++i)
    for (int j = 0; j < around_tube; ++j) {
      const double along = turn * i / around_hole, around = turn * j / around_tube, out = 1 + std::cos(around) / 4;
      points.push_back({out * std::cos(along), out * std::sin(along), std::sin(around) / 4});
    }
  return rbpa::app::svg_of(rbpa::app::plot_of(rbpa::solid_persistence(rbpa::solid_filtration(points))));
}

}  // namespace

std::span<const Figure> filtration_figures() {
  static constexpr std::array figures = {Figure{"filtration_plot", filtration_plot},
                                         Figure{"persistence_torus", persistence_of_torus}};
  return figures;
}

}  // namespace figures
