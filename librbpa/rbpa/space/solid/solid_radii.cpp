#include "rbpa/space/solid/solid_radii.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/circumradius.h"
#include "rbpa/space/solid/boundary/solid_part.h"

namespace rbpa {
namespace {

using Row = std::array<std::uint32_t, 4>;
constexpr double infinity = std::numeric_limits<double>::infinity();

void require_radii(const Solid& solid, std::span<const double> radii) {
  meshops::require_one_each("radii", radii.size(), "values", solid.simplices.size(), "tetrahedra");
}

void require_share(double share) {
  if (!(share > 0 && share <= 1))
    throw meshops::ContractViolation("share is " + text(share) + ", expected a number above 0 and at most 1");
}

/// Returns the least count ≥ 1 with count / all ≥ share, divided in double.
std::size_t share_of(std::size_t all, double share) {
  const auto whole = static_cast<double>(all);
  auto count = static_cast<std::size_t>(std::max(1.0, std::floor(share * whole) - 1));
  while (static_cast<double>(count) / whole < share) ++count;
  return count;
}

/// A test whether one solid component of the complex of alpha has at least a given share of all corners, for several
/// alphas that are all at least `least`.
class GrowingPieces {
 public:
  /// Keeps references to all arguments.
  GrowingPieces(const Solid& delaunay, std::span<const double> radii, double least, double share, Steps& step)
      : delaunay_(delaunay),
        radii_(radii),
        step_(step),
        seen_(corner_bound<4>(delaunay.simplices), none),
        at_least_(radii.size()) {
    std::size_t corners = 0;
    for (std::uint32_t t = 0; t < radii.size(); ++t) {
      step(2);
      for (const std::uint32_t corner : delaunay.simplices[t]) corners += std::exchange(seen_[corner], unseen) == none;
      if (radii[t] <= least)
        join_neighbors(t, least, at_least_);
      else
        later_.push_back(t);
    }
    wanted_ = share_of(corners, share);
  }

  bool is_whole(double alpha) {
    Pieces pieces = at_least_;
    for (const std::uint32_t t : later_) {
      step_();
      if (radii_[t] <= alpha) join_neighbors(t, alpha, pieces);
    }
    // A component of n tetrahedra has at most 4 n corners. Most components are thus too small to be counted.
    for (std::uint32_t root = 0; root < pieces.size.size(); ++root)
      if (4 * std::size_t{pieces.size[root]} >= wanted_ && pieces.sets.is_least(root) && radii_[root] <= alpha &&
          count_corners(root, alpha, pieces.sets) >= wanted_)
        return true;
    return false;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff, unseen = 0xfffffffe;  // marks: no corner; not seen yet

  /// Sets of tetrahedra. `size` has the number of tetrahedra of each set at the least number of the set.
  struct Pieces {
    explicit Pieces(std::size_t tetrahedra) : sets(tetrahedra), size(tetrahedra, 1) {}
    meshops::DisjointSets sets;
    std::vector<std::uint32_t> size;
  };

  void join_neighbors(std::uint32_t t, double alpha, Pieces& pieces) const {
    for (const std::uint32_t n : delaunay_.neighbors[t]) {
      if (n == Solid::none || !(radii_[n] <= alpha)) continue;
      const std::uint32_t a = pieces.sets.find(t), b = pieces.sets.find(n);
      if (a == b) continue;
      const std::uint32_t both = pieces.size[a] + pieces.size[b];
      pieces.size[pieces.sets.link(a, b)] = both;
    }
  }

  std::size_t count_corners(std::uint32_t root, double alpha, meshops::DisjointSets& sets) {
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < delaunay_.simplices.size(); ++t) {
      step_();
      if (!(radii_[t] <= alpha) || sets.find(t) != root) continue;
      for (const std::uint32_t corner : delaunay_.simplices[t]) count += std::exchange(seen_[corner], root) != root;
    }
    std::fill(seen_.begin(), seen_.end(), unseen);
    return count;
  }

  const Solid& delaunay_;
  std::span<const double> radii_;
  Steps& step_;
  std::vector<std::uint32_t> seen_;   // for each point: the root of its component, or a mark
  Pieces at_least_;                   // components at the least alpha
  std::vector<std::uint32_t> later_;  // tetrahedra of greater radius
  std::size_t wanted_ = 0;
};

}  // namespace

std::vector<double> circumradii(std::span<const Point3> points, std::span<const Row> simplices, unsigned threads,
                                const GoOn& go_on) {
  space::check_points(points);
  for (std::size_t t = 0; t < simplices.size(); ++t)
    for (const std::uint32_t corner : simplices[t])
      if (corner >= points.size())
        throw InvalidInput("simplex " + std::to_string(t) + " has corner " + std::to_string(corner) +
                           ", expected one below " + std::to_string(points.size()));
  std::vector<double> radii(simplices.size());
  Threads some = threads_for(simplices.size(), threads);
  constexpr std::size_t at_a_time = 1u << 12;
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(some, radii.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    space::circumradii_rounded_up(points, simplices.subspan(begin, end - begin),
                                  std::span(radii).subspan(begin, end - begin));
  });
  return radii;
}

double min_alpha(const Solid& delaunay, std::span<const double> radii, double share, const GoOn& go_on) {
  require_radii(delaunay, radii);
  require_share(share);
  if (delaunay.simplices.empty()) return infinity;
  constexpr double never = -1;  // mark of a point that is no corner
  std::vector<double> least(corner_bound<4>(delaunay.simplices), never);
  Steps step(go_on);
  for (std::size_t t = 0; t < radii.size(); ++t) {
    step();
    for (const std::uint32_t corner : delaunay.simplices[t])
      least[corner] = least[corner] < 0 ? radii[t] : std::min(least[corner], radii[t]);
  }
  std::erase(least, never);
  const auto last = least.begin() + static_cast<std::ptrdiff_t>(share_of(least.size(), share) - 1);
  std::nth_element(least.begin(), last, least.end());
  return *last;
}

double auto_alpha(const Solid& delaunay, std::span<const double> radii, double share, const GoOn& go_on) {
  require_radii(delaunay, radii);
  require_share(share);
  meshops::require(delaunay.neighbors.size() == radii.size(),
                   "auto_alpha: the triangulation has no neighbors, expected solid() with the option neighbors");
  if (delaunay.simplices.empty()) return infinity;
  // A component keeps its points as alpha grows, so the least alpha is found by bisection over the radii.
  const double least = min_alpha(delaunay, radii, share, go_on);
  std::vector<double> sorted;
  std::copy_if(radii.begin(), radii.end(), std::back_inserter(sorted), [&](double radius) { return radius >= least; });
  Steps asked(go_on);
  sort(sorted, asked, std::less<>());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  GrowingPieces connection(delaunay, radii, least, share, asked);
  std::size_t first = 0;  // the least candidate
  std::size_t last = first;
  for (std::size_t step = 1; !connection.is_whole(sorted[last]); step *= 2) {
    first = last + 1;
    if (first == sorted.size()) return infinity;
    last = std::min(last + step, sorted.size() - 1);
  }
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    if (connection.is_whole(sorted[middle]))
      last = middle;
    else
      first = middle + 1;
  }
  return sorted[last];
}

Solid within(const Solid& solid, std::span<const double> radii, double alpha) {
  require_radii(solid, radii);
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < radii.size(); ++t)
    if (radii[t] <= alpha) kept.push_back(t);
  return space::part_of(solid, kept, [](std::uint32_t, std::size_t) { return true; });
}

}  // namespace rbpa
