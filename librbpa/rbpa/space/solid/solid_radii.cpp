#include "rbpa/space/solid/solid_radii.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
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

/// The solid components of a complex to which tetrahedra are added, and a test whether one of them has enough corners.
class GrowingPieces {
 public:
  /// Keeps a reference to the triangulation. Enough is at least `share` of all corners.
  GrowingPieces(const Solid& delaunay, double share)
      : delaunay_(delaunay),
        bound_(corner_bound<4>(delaunay.simplices)),
        sets_(delaunay.simplices.size()),
        size_(delaunay.simplices.size(), 0),
        next_(delaunay.simplices.size()) {
    Corners all(bound_, bound_);
    for (const Row& row : delaunay.simplices) all.add(row);
    wanted_ = share_of(all.size(), share);
  }

  void add(std::uint32_t t) {
    size_[t] = 1;
    next_[t] = t;
    is_enough_ = is_enough_ || delaunay_.simplices[t].size() >= wanted_;
    for (const std::uint32_t n : delaunay_.neighbors[t])
      if (n != Solid::none && size_[n] > 0) join(sets_.find(t), sets_.find(n));
  }
  /// Returns whether a component has enough corners.
  bool is_enough() const { return is_enough_; }

 private:
  /// A set of corners: a bit for each point, or a table of its members where these are few.
  class Corners {
   public:
    Corners(std::size_t bound, std::size_t most) : has_(64 * most < bound ? 0 : bound, false) {}
    void add(const Row& row) {
      for (const std::uint32_t corner : row)
        if (has_.empty())
          few_.insert(corner);
        else if (!has_[corner]) {
          has_[corner] = true;
          ++count_;
        }
    }
    std::size_t size() const { return has_.empty() ? few_.size() : count_; }

   private:
    std::vector<bool> has_;
    std::unordered_set<std::uint32_t> few_ = {};
    std::size_t count_ = 0;
  };

  /// Returns whether a component of so many tetrahedra may have enough corners. A tetrahedron that is joined at a face
  /// adds one corner at most.
  bool may_have_enough(std::uint32_t tetrahedra) const { return std::size_t{tetrahedra} + 3 >= wanted_; }

  void join(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    if (size_[a] < size_[b]) std::swap(a, b);
    const std::uint32_t both = size_[a] + size_[b];
    const bool is_counted = may_have_enough(both);
    if (is_counted) {
      Corners& corners = corners_.try_emplace(a, bound_, wanted_).first->second;
      if (corners.size() == 0) add_all(a, corners);
      add_all(b, corners);
      corners_.erase(b);
      is_enough_ = is_enough_ || corners.size() >= wanted_;
    }
    std::swap(next_[a], next_[b]);
    const std::uint32_t root = sets_.link(a, b);
    size_[root] = both;
    if (!is_counted || root == a) return;
    auto node = corners_.extract(a);
    node.key() = root;
    corners_.insert(std::move(node));
  }

  void add_all(std::uint32_t root, Corners& corners) const {
    std::uint32_t t = root;
    do corners.add(delaunay_.simplices[t]);
    while ((t = next_[t]) != root);
  }

  const Solid& delaunay_;
  std::size_t bound_, wanted_ = 0;
  meshops::DisjointSets sets_;
  std::vector<std::uint32_t> size_;  // at each root, its number of tetrahedra; 0 for a tetrahedron that is not added
  std::vector<std::uint32_t> next_;  // the tetrahedra of a component in a circle
  std::unordered_map<std::uint32_t, Corners> corners_;  // by root, where may_have_enough()
  bool is_enough_ = false;
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
  Steps step(go_on);
  GrowingPieces pieces(delaunay, share);
  // Up to the least radius at which enough points are covered, the order does not matter.
  const double least = min_alpha(delaunay, radii, share, go_on);
  for (std::uint32_t t = 0; t < radii.size(); ++t) {
    step();
    if (radii[t] <= least) pieces.add(t);
  }
  if (pieces.is_enough()) return least;
  const auto order = sorted_by_alpha(radii, step);
  constexpr std::size_t ahead = 16;  // the order jumps about in memory
  for (std::size_t i = 0; i < order.size(); ++i) {
    step(4);
    if (i + ahead < order.size()) __builtin_prefetch(&delaunay.neighbors[order[i + ahead]]);
    if (radii[order[i]] <= least) continue;
    pieces.add(order[i]);
    if (pieces.is_enough()) return radii[order[i]];
  }
  return infinity;
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
