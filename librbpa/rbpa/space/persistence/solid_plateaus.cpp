#include "rbpa/space/persistence/solid_plateaus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/radii/cube_root.h"
#include "rbpa/base/radii/plateau_rules.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
#include "rbpa/base/radii/still_ranges.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/side_by_side.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/boundary/check_triangulation.h"

namespace rbpa {
namespace {

using Wide = long double;  // products of three coordinates may exceed double
constexpr double settles = 2;

/// Returns a ratio that noise does not reach (docs/explanation/filtration_and_persistence.md, section 8).
double noise_ratio(std::size_t distinct) { return 1.5 + 10 / std::sqrt(static_cast<double>(distinct)); }

/// Returns half the diagonal of the points' bounding box.
double reach_of(std::span<const Point3> points) {
  const auto [low, high] = space::box_of(points);
  const auto diagonal = space::from<Wide>(low, high);
  return static_cast<double>(std::sqrt(dot(diagonal, diagonal)) / 2);
}

/// The complex as alpha grows: element i of each list belongs to the radius alpha[i].
struct Growth {
  std::vector<double> alpha;
  std::vector<Wide> change;             // P · H · E^(1/12) of solid_plateaus.h, up to a constant factor
  meshops::FreshVector<double> volume;  // of the complex
  std::vector<Wide> filled;             // the volume of the complex divided by that of complex and voids
  std::size_t begin = 0;                // index of the first radius from which on enough points are covered
};

/// The components, connected through points, of all tetrahedra added, with their numbers of points.
class Parts {
 public:
  explicit Parts(std::size_t of_all) : sets_(of_all), size_(of_all, 0) {}

  /// Returns whether all points are in one component. No further tetrahedron then changes the components.
  bool is_whole(std::size_t distinct) const { return components == 1 && points == distinct; }
  double effective() const {
    const auto of_all = static_cast<double>(points);
    return of_all * of_all / static_cast<double>(squares);
  }
  void add(const std::array<std::uint32_t, 4>& corners) {
    for (const std::uint32_t corner : corners)
      if (size_[sets_.find(corner)] == 0) {
        size_[corner] = 1;
        count(1, 1);
      }
    for (std::size_t k = 1; k < 4; ++k) {
      const std::uint32_t a = sets_.find(corners[0]), b = sets_.find(corners[k]);
      if (a == b) continue;
      const std::uint32_t both = size_[a] + size_[b];
      count(size_[a], -1);
      count(size_[b], -1);
      count(both, 1);
      size_[sets_.link(a, b)] = both;
    }
  }

  std::size_t components = 0, points = 0;
  std::uint64_t squares = 0;

 private:
  void count(std::uint64_t size, int by) {
    const auto times = static_cast<std::uint64_t>(by);  // −1 wraps modulo 2⁶⁴; so do the sums, correctly
    components += times;
    points += times * size;
    squares += times * size * size;
  }

  meshops::DisjointSets sets_;
  std::vector<std::uint32_t> size_;  // size_[i]: number of points in the set with least index i
};

constexpr std::size_t ahead = 16;            // the orders jump about in memory, so data is prefetched
constexpr std::size_t at_a_time = 1u << 13;  // the number of steps or tetrahedra that a thread takes

/// Each tetrahedron's radius from which on it is in the complex or in a void of the complex, and its volume; ascending.
struct Enclosed {
  meshops::FreshVector<double> from;
  meshops::FreshVector<Wide> volume;
};

/// Removes tetrahedra in descending order from the complex. They join the outside or their neighbors that have left
/// before.
Enclosed enclosed(const Solid& delaunay, std::span<const double> alpha, std::span<const std::uint32_t> order,
                  const std::vector<Wide>& volumes, Threads& threads, Steps& step) {
  std::size_t left = alpha.size();  // number of tetrahedra that are not outside yet
  Enclosed result{meshops::FreshVector<double>(left), meshops::FreshVector<Wide>(left)};
  meshops::FreshVector<std::uint32_t> joined(left);  // the tetrahedra in the order of the result
  enum class Place : std::uint8_t { complex, hollow, outside };
  std::vector<Place> place(left, Place::complex);
  const auto place_of = [&](std::uint32_t t) { return t == Solid::none ? Place::outside : place[t]; };
  meshops::DisjointSets voids(left);
  meshops::MemberRings rings(left);
  for (std::size_t i = order.size(); i-- > 0;) {
    step(4);
    if (i >= ahead) __builtin_prefetch(&delaunay.neighbors[order[i - ahead]]);
    const std::uint32_t t = order[i];
    place[t] = Place::hollow;
    for (const std::uint32_t n : delaunay.neighbors[t]) {
      meshops::require(n == Solid::none || n < alpha.size(), "solid_plateaus: a neighbor is no tetrahedron");
      if (place_of(n) == Place::complex || (place_of(n) == Place::outside && place[t] == Place::outside)) continue;
      if (place_of(n) == Place::outside || place[t] == Place::outside) {
        rings.for_each(place[t] == Place::outside ? n : t, [&](std::uint32_t one) {
          place[one] = Place::outside;
          joined[--left] = one;
          result.from[left] = alpha[t];
        });
      } else if (voids.join(t, n)) {
        rings.join(t, n);
      }
    }
  }
  meshops::require(left == 0, "solid_plateaus: expected neighbors as solid() returns them");
  for_each_part(threads, joined.size(), at_a_time, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      __builtin_prefetch(&volumes[joined[std::min(i + ahead, joined.size() - 1)]]);
      result.volume[i] = volumes[joined[i]];
    }
  });
  // Sort the volumes of each radius, in the part where they begin: sums do not depend on the numbering.
  for_each_part(threads, joined.size(), at_a_time, [&](std::size_t first, std::size_t end) {
    while (first > 0 && first < end && result.from[first] == result.from[first - 1]) ++first;
    for (std::size_t last = first; first < end; first = last) {
      while (last < joined.size() && result.from[last] == result.from[first]) ++last;
      if (last - first > 1) std::sort(&result.volume[first], &result.volume[0] + last);
    }
  });
  return result;
}

/// Steps of the solid complex: for each of its radii, the volume and the most Σ nᵢ² up to there.
struct SolidSteps {
  std::vector<double> alpha;
  std::vector<Wide> volume;
  std::vector<std::uint64_t> most_squares;
  std::size_t begin = 0;  // index of the first radius from which on enough points are covered
};

SolidSteps steps_of(const Solid& delaunay, std::size_t points, std::span<const double> alpha,
                    std::span<const std::uint32_t> order, const std::vector<Wide>& volumes, Steps& step) {
  SolidSteps steps;
  steps.alpha.reserve(order.size());
  steps.volume.reserve(order.size());
  steps.most_squares.reserve(order.size());
  Parts parts(points);
  std::uint64_t most_squares = 0;
  Wide solid = 0;
  for (std::size_t i = 0; i < order.size();) {
    const double now = alpha[order[i]];
    for (; i < order.size() && alpha[order[i]] == now; ++i) {
      step(2);
      if (i + ahead < order.size()) {
        __builtin_prefetch(&volumes[order[i + ahead]]);
        __builtin_prefetch(&alpha[order[i + ahead]]);
        __builtin_prefetch(&delaunay.simplices[order[i + ahead]]);
      }
      solid += volumes[order[i]];
      if (!parts.is_whole(delaunay.distinct)) parts.add(delaunay.simplices[order[i]]);
    }
    most_squares = std::max(most_squares, parts.squares);
    if (static_cast<double>(parts.points) / static_cast<double>(delaunay.distinct) < plateau_rules::least_share)
      steps.begin = steps.alpha.size() + 1;
    steps.alpha.push_back(now);
    steps.volume.push_back(solid);
    steps.most_squares.push_back(most_squares);
  }
  return steps;
}

Growth growth_of(std::span<const Point3> points, const Solid& delaunay, std::span<const double> alpha, Threads& threads,
                 const GoOn& go_on) {
  Steps step(go_on);
  std::vector<Wide> volumes(alpha.size());
  meshops::FreshVector<std::uint32_t> order;
  side_by_side(
      threads, go_on, [&](Steps& of_task, const GoOn&) { order = sorted_by_alpha(alpha, of_task); },
      [&](Steps&, const GoOn&) {
        for_each_part(threads, volumes.size(), at_a_time, [&](std::size_t first, std::size_t last) {
          for (std::size_t t = first; t < last; ++t) volumes[t] = space::volume<Wide>(points, delaunay.simplices[t]);
        });
      });
  sort_equal_by_volume<Wide>(order, alpha, volumes, step);
  SolidSteps steps;
  Enclosed inner;
  side_by_side(
      threads, go_on,
      [&](Steps& of_task, const GoOn&) { inner = enclosed(delaunay, alpha, order, volumes, threads, of_task); },
      [&](Steps& of_task, const GoOn&) { steps = steps_of(delaunay, points.size(), alpha, order, volumes, of_task); });
  Growth growth;
  growth.begin = steps.begin;
  growth.change.resize(steps.alpha.size());
  growth.volume.resize(steps.alpha.size());
  Wide volume = 0;
  for (std::size_t i = 0, next = 0; i < steps.alpha.size(); ++i) {
    step();
    for (; next < inner.from.size() && inner.from[next] <= steps.alpha[i]; ++next) volume += inner.volume[next];
    growth.change[i] = volume;  // for now, the enclosed volume
  }
  // The volume of a flat tetrahedron may round to 0.
  const auto positive = [](Wide v) { return std::max(v, std::numeric_limits<Wide>::min()); };
  for_each_part(threads, steps.alpha.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Wide filled = std::min(Wide(1), positive(steps.volume[i]) / positive(growth.change[i]));
      growth.volume[i] = static_cast<double>(steps.volume[i]);
      steps.volume[i] = filled;  // replaces the volume, which has been used
      if (i >= growth.begin)     // no plateau reaches an earlier step; now the twelfth root of the enclosed share
        growth.change[i] = std::sqrt(std::sqrt(cube_root(positive(growth.change[i]) / positive(volume))));
    }
  });
  Wide turns = 1, filled_before = 1;
  for (std::size_t i = 0; i < steps.alpha.size(); ++i) {
    step();
    const auto [lesser, greater] = std::minmax(filled_before, steps.volume[i]);
    turns *= greater / lesser;
    growth.change[i] *= static_cast<Wide>(steps.most_squares[i]) * turns;
    filled_before = steps.volume[i];
  }
  growth.alpha = std::move(steps.alpha);
  growth.filled = std::move(steps.volume);
  return growth;
}

/// Returns the plateau without the fields that count() fills in.
SolidPlateau plateau_of(const StepRange& range, const Growth& growth, double ratio, std::size_t distinct) {
  SolidPlateau plateau{.from = growth.alpha[range.first], .ratio = ratio};
  if (range.last < growth.alpha.size()) plateau.to = growth.alpha[range.last];
  plateau.alpha = plateau.from * std::min(std::sqrt(ratio), settles);
  const auto after = std::upper_bound(growth.alpha.begin(), growth.alpha.end(), plateau.alpha);
  const auto there = static_cast<std::size_t>(after - growth.alpha.begin()) - 1;
  plateau.volume = growth.volume[there];
  plateau.void_share = static_cast<double>(1 - growth.filled[there]);
  plateau.is_long = ratio >= noise_ratio(distinct);
  return plateau;
}

/// Fills in the counts of plateaus that ascend by alpha.
void count(std::size_t points, const Solid& delaunay, std::span<const double> radii, Threads& threads, Steps& step,
           std::vector<SolidPlateau>& plateaus) {
  meshops::FreshVector<std::uint8_t> first(radii.size());  // for each tetrahedron: the first plateau that has it
  for_each_part(threads, radii.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    std::fill(&first[begin], &first[0] + end, std::uint8_t{0});
    for (const SolidPlateau& plateau : plateaus)
      for (std::size_t t = begin; t < end; ++t)
        first[t] = static_cast<std::uint8_t>(first[t] + (radii[t] > plateau.alpha ? 1 : 0));
  });
  Parts parts(points);
  std::size_t tetrahedra = 0;
  for (std::uint8_t i = 0; i < plateaus.size(); ++i) {
    SolidPlateau& plateau = plateaus[i];
    tetrahedra += static_cast<std::size_t>(std::count(first.begin(), first.end(), i));
    for (std::size_t t = 0; t < first.size() && !parts.is_whole(delaunay.distinct); ++t) {
      if (first[t] != i) continue;
      step();
      parts.add(delaunay.simplices[t]);
    }
    plateau.tetrahedra = tetrahedra;
    plateau.components = parts.components;
    plateau.covered = parts.points;
    plateau.effective_parts = parts.effective();
    plateau.is_structured = plateau_rules::is_structured(plateau.effective_parts, plateau.void_share);
  }
}

std::vector<SolidPlateau> find_plateaus(std::span<const Point3> points, const Solid& delaunay,
                                        std::span<const double> radii, Threads& threads, Steps& step,
                                        const GoOn& go_on) {
  if (radii.empty()) return {};
  const std::size_t distinct = delaunay.distinct;
  Growth growth = growth_of(points, delaunay, radii, threads, go_on);
  const StillRanges ranges(growth.alpha, std::move(growth.change), reach_of(points));
  std::vector<SolidPlateau> found;
  for (const StepRange& range :
       ranges.longest({growth.begin, growth.alpha.size()}, plateau_rules::most_plateaus, plateau_rules::least_ratio))
    found.push_back(plateau_of(range, growth, ranges.ratio_of(range), distinct));
  std::sort(found.begin(), found.end(), [](const SolidPlateau& a, const SolidPlateau& b) { return a.alpha < b.alpha; });
  count(points.size(), delaunay, radii, threads, step, found);
  plateau_rules::rank(found, [&](const SolidPlateau& p) {
    return plateau_rules::Weight{p.is_structured, static_cast<double>(p.covered) / static_cast<double>(distinct)};
  });
  return found;
}

}  // namespace

std::vector<SolidPlateau> solid_plateaus(std::span<const Point3> points, const Solid& delaunay,
                                         std::span<const double> radii, const GoOn& go_on, unsigned wanted,
                                         const std::function<void(const GoOn&)>& beside) {
  space::check_triangulation("solid_plateaus", points, delaunay, radii);
  Threads threads = threads_for(points.size(), wanted);
  std::vector<SolidPlateau> found;
  side_by_side(
      threads, go_on,
      [&](Steps& step, const GoOn& goes_on) { found = find_plateaus(points, delaunay, radii, threads, step, goes_on); },
      [&](Steps&, const GoOn& goes_on) {
        if (beside) beside(goes_on);
      });
  return found;
}

}  // namespace rbpa
