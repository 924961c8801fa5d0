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
#include "rbpa/space/cells/circumradii.h"
#include "rbpa/space/solid/boundary/solid_part.h"

namespace rbpa {
namespace {

using Row = std::array<std::uint32_t, 4>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t at_a_time = 1u << 12;

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

/// The corners of a triangulation.
struct Covered {
  std::size_t bound = 0;   ///< the greatest corner plus one
  std::size_t wanted = 0;  ///< the number of corners in the wanted share of all corners
  double alpha = 0;        ///< the least alpha at which the wanted number of corners are in tetrahedra
};

/// Returns the corners that the share wants, and where they are covered. Requires: there is a tetrahedron.
Covered covered(const Solid& delaunay, std::span<const double> radii, double share, Steps& step) {
  constexpr double never = -1;  // mark of a point that is no corner
  Covered found{.bound = corner_bound<4>(delaunay.simplices)};
  std::vector<double> least(found.bound, never);
  for (std::size_t t = 0; t < radii.size(); ++t) {
    step();
    for (const std::uint32_t corner : delaunay.simplices[t])
      least[corner] = least[corner] < 0 ? radii[t] : std::min(least[corner], radii[t]);
  }
  std::erase(least, never);
  found.wanted = share_of(least.size(), share);
  const auto last = least.begin() + static_cast<std::ptrdiff_t>(found.wanted - 1);
  std::nth_element(least.begin(), last, least.end());
  found.alpha = *last;
  return found;
}

/// The solid components of a complex to which tetrahedra are added, and a test whether one of them has enough corners.
class GrowingPieces {
 public:
  /// Begins with the tetrahedra of the complex at covered.alpha. Keeps a reference to the triangulation.
  GrowingPieces(const Solid& delaunay, std::span<const double> radii, const Covered& covered, Threads& threads,
                const GoOn& go_on)
      : delaunay_(delaunay),
        bound_(covered.bound),
        wanted_(covered.wanted),
        sets_(radii.size()),
        rings_(radii.size()),
        size_(radii.size(), 0) {
    CheckpointOfThreads checkpoint(go_on);
    for_each_part(threads, radii.size(), at_a_time, [&](std::size_t first, std::size_t last) {
      checkpoint();
      for (auto t = static_cast<std::uint32_t>(first); t < last; ++t)
        for (const std::uint32_t n : delaunay.neighbors[t])
          if (n < t && std::max(radii[t], radii[n]) <= covered.alpha) sets_.join_among_threads(t, n);
    });
    Steps step(go_on);
    for (std::uint32_t t = 0; t < radii.size(); ++t) {
      step();
      if (radii[t] > covered.alpha) continue;
      const std::uint32_t root = sets_.find(t);
      size_[t] = 1;
      if (root == t) continue;
      ++size_[root];
      rings_.join(root, t);
    }
    is_enough_ = delaunay.simplices.front().size() >= wanted_;
    for (std::uint32_t t = 0; t < radii.size() && !is_enough_; ++t)
      if (size_[t] > 1 && sets_.is_least(t) && may_have_enough(size_[t])) count(t);
  }

  void add(std::uint32_t t) {
    size_[t] = 1;
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
      if (!corners_.contains(a)) count(a);
      add_all(b, corners_.at(a));
      corners_.erase(b);
      is_enough_ = is_enough_ || corners_.at(a).size() >= wanted_;
    }
    rings_.join(a, b);
    const std::uint32_t root = sets_.link(a, b);
    size_[root] = both;
    if (!is_counted || root == a) return;
    auto node = corners_.extract(a);
    node.key() = root;
    corners_.insert(std::move(node));
  }

  void count(std::uint32_t root) {
    Corners& corners = corners_.try_emplace(root, bound_, wanted_).first->second;
    add_all(root, corners);
    is_enough_ = is_enough_ || corners.size() >= wanted_;
  }
  void add_all(std::uint32_t root, Corners& corners) const {
    rings_.for_each(root, [&](std::uint32_t t) { corners.add(delaunay_.simplices[t]); });
  }

  const Solid& delaunay_;
  std::size_t bound_, wanted_;
  meshops::DisjointSets sets_;
  meshops::MemberRings rings_;       // the tetrahedra of each component
  std::vector<std::uint32_t> size_;  // at each root, its number of tetrahedra; 0 for a tetrahedron that is not added
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
  Threads some = threads_for(simplices.size(), threads);
  return space::circumradii_of(points, simplices, some, go_on);
}

double min_alpha(const Solid& delaunay, std::span<const double> radii, double share, const GoOn& go_on) {
  require_radii(delaunay, radii);
  require_share(share);
  if (delaunay.simplices.empty()) return infinity;
  Steps step(go_on);
  return covered(delaunay, radii, share, step).alpha;
}

double auto_alpha(const Solid& delaunay, std::span<const double> radii, double share, const GoOn& go_on,
                  unsigned wanted) {
  require_radii(delaunay, radii);
  require_share(share);
  meshops::require(delaunay.neighbors.size() == radii.size(),
                   "auto_alpha: the triangulation has no neighbors, expected solid() with the option neighbors");
  if (delaunay.simplices.empty()) return infinity;
  Steps step(go_on);
  Threads threads = threads_for(radii.size(), wanted);
  // Up to the least radius at which enough points are covered, the order does not matter.
  const Covered least = covered(delaunay, radii, share, step);
  GrowingPieces pieces(delaunay, radii, least, threads, go_on);
  if (pieces.is_enough()) return least.alpha;
  const auto order = sorted_by_alpha(radii, step);
  constexpr std::size_t ahead = 16;  // the order jumps about in memory
  for (std::size_t i = 0; i < order.size(); ++i) {
    step(4);
    if (i + ahead < order.size()) __builtin_prefetch(&delaunay.neighbors[order[i + ahead]]);
    if (radii[order[i]] <= least.alpha) continue;
    pieces.add(order[i]);
    if (pieces.is_enough()) return radii[order[i]];
  }
  return infinity;
}

Solid within(const Solid& solid, std::span<const double> radii, double alpha, unsigned wanted) {
  require_radii(solid, radii);
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < radii.size(); ++t)
    if (radii[t] <= alpha) kept.push_back(t);
  Threads threads = threads_for(radii.size(), wanted);
  return space::part_of(solid, kept, threads, [](std::uint32_t, std::size_t) { return true; });
}

}  // namespace rbpa
