// Compares the filtration with GUDHI's persistence and CGAL's optimal alpha.
//   --largest=N   only sets with at most that many points
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "oracle/cgal_alpha.h"
#include "oracle/delaunay.h"
#include "oracle/gudhi_persistence.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/read_points.h"
#include "support/sets.h"

namespace rbpa_test {
namespace {

struct Set {
  std::string name;
  Points points;
};

/// Returns generated, bundled and random sets of the given size whose squared radii are far from the ends of double.
std::vector<Set> sets() {
  std::vector<Set> all;
  const auto add = [&](std::string name, Points points) {
    if (points.size() <= argument("largest", 4000) && fitting_kernel(points) == Kernel::filtered)
      all.push_back({std::move(name), std::move(points)});
  };
  for (const NamedSet& set : generated_sets()) add(std::string(set.name), set.make());
  for (const PointFile& file : point_files(bundled_data())) add(file.name, read_points(file));
  for (unsigned seed = 0; seed < 100; ++seed) {
    add("uniform " + std::to_string(seed), uniform(5 + seed, 500 + seed));
    add("grid " + std::to_string(seed), random_grid(6 + static_cast<int>(seed) / 10, 5 + seed, seed % 2 == 0, seed));
    add("tiny components " + std::to_string(seed), tiny_components(3 + static_cast<int>(seed) / 4, seed));
  }
  return all;
}

const double infinity = std::numeric_limits<double>::infinity();

using Ranked = std::tuple<int, std::size_t, std::size_t>;

/// Pairs with every squared radius replaced by its rank; values that rounding can confuse have one rank.
class Ranks {
 public:
  explicit Ranks(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    for (const double value : values)
      if (starts_.empty() || value > last_ * (1 + 1e-12)) {
        starts_.push_back(value);
        last_ = value;
      } else {
        last_ = value;
      }
  }
  std::size_t of(double value) const {
    return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), value) - starts_.begin());
  }
  std::size_t size() const { return starts_.size(); }
  std::vector<Ranked> operator()(const std::vector<SquaredPair>& pairs) const {
    std::vector<Ranked> ranked;
    for (const SquaredPair& p : pairs)
      if (of(p.birth) != of(p.death)) ranked.emplace_back(p.dimension, of(p.birth), of(p.death));
    std::sort(ranked.begin(), ranked.end());
    return ranked;
  }

 private:
  std::vector<double> starts_;
  double last_ = 0;
};

std::vector<SquaredPair> squared(const std::vector<rbpa::PersistencePair>& pairs) {
  std::vector<SquaredPair> result;
  for (const rbpa::PersistencePair& p : pairs) {
    const double death = p.death.value_or(infinity);
    result.push_back({p.dimension, p.birth * p.birth, death * death});
  }
  return result;
}

TEST_CASE("the persistence of the full alpha complex is GUDHI's") {
  std::size_t compared = 0, holes = 0;
  for (const Set& set : sets()) {
    const Points& points = set.points;
    if (points.empty()) continue;  // GUDHI refuses empty sets
    INFO(set.name, ", ", points.size(), " points");
    const auto delaunay = delaunay_arrays(points);
    const auto ours =
        squared(rbpa::persistence(delaunay, points, rbpa::filtration(delaunay, points), rbpa::ComplexKind::full));
    const auto theirs = gudhi_persistence(points);
    std::vector<double> values;
    for (const auto* pairs : {&ours, &theirs})
      for (const SquaredPair& p : *pairs) values.insert(values.end(), {p.birth, p.death});
    const Ranks ranks(std::move(values));
    const auto expected = ranks(theirs), actual = ranks(ours);
    CHECK(expected.size() == actual.size());
    CHECK(expected == actual);
    ++compared;
    holes += static_cast<std::size_t>(
        std::count_if(actual.begin(), actual.end(), [](const Ranked& p) { return std::get<0>(p) == 1; }));
  }
  CHECK(compared > 200);
  CHECK(holes > 1000);
}

TEST_CASE("smallest_covering is CGAL's optimal alpha, or a smaller one that its bisection has missed") {
  constexpr std::array<std::size_t, 4> bounds = {1, 2, 3, 5};
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-12 * a; };
  std::size_t equal = 0, smaller = 0;
  for (const Set& set : sets()) {
    const Points& points = set.points;
    INFO(set.name, ", ", points.size(), " points");
    const auto delaunay = delaunay_arrays(points);
    if (delaunay.triangles.empty()) continue;
    const rbpa::Filtration all = rbpa::filtration(delaunay, points);
    const ProposedAlphas cgal = cgal_alphas(points, bounds);
    REQUIRE(rbpa::smallest_covering(all));
    CHECK(same(*rbpa::smallest_covering(all), cgal.covering));
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      CAPTURE(bounds[i]);
      const std::optional<double> ours = rbpa::smallest_covering(all, bounds[i]);
      REQUIRE(ours);
      if (same(*ours, cgal.optimal[i])) {
        ++equal;
        continue;
      }
      ++smaller;
      CHECK(*ours < cgal.optimal[i]);
      // Our value is a solution, and no smaller radius at which the complex changes is one.
      const auto solves = [&](double alpha) {
        const auto complex = rbpa::rbpa(points, alpha);
        return complex.isolated.empty() && rbpa::count(complex).solid_components <= bounds[i];
      };
      CHECK(solves(*ours));
      for (const rbpa::FiltrationStep& step : all.steps) {
        if (step.alpha >= *ours) break;
        CHECK_FALSE(solves(step.alpha));
      }
    }
  }
  MESSAGE(equal, " equal, ", smaller, " smaller than CGAL's");
  CHECK(equal > 500);
}

}  // namespace
}  // namespace rbpa_test
