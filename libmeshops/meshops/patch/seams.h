// What: a table of sides of triangles. Each side waits at a site for the side of another triangle on the same edge.
// Cost: a search takes time linear in the number of sides that wait at the site.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/patch/patch.h"

namespace meshops {

/// Table of waiting sides. `Side` is the type of the data that is stored for a side.
template <typename Side>
class Seams {
 public:
  /// Begins a table for the sites below `sites`.
  /// Requires: the table is new, or end() was called after the last begin(). Not checked.
  /// Cost:     linear in `sites`.
  void begin(std::size_t sites) { first_.assign(sites, none); }
  /// Returns whether a table of at least one site was begun and has not been ended.
  bool has_begun() const { return !first_.empty(); }

  /// Adds a side that waits at the site `at`, which the caller chooses: for example, an end of the side.
  /// Requires: `at` is below the number of sites, as in prepare() and take(); at most 2³¹ − 1 sides are added between
  ///           begin() and end(), including sides that were taken. Not checked.
  void add(Site at, const Side& side) {
    int& first = first_[at];
    seams_.push_back({side, first});
    first = static_cast<int>(seams_.size()) - 1;
  }

  /// Prefetches the memory of a site, for a later take() or add() at this site.
  void prepare(Site at) const { __builtin_prefetch(&first_[at]); }

  /// Removes and returns a side that waits at the site `at` and for which matches(side) is true; among several, the
  /// side added last. Returns nothing if there is no such side.
  template <typename Matches>
  std::optional<Side> take(Site at, Matches matches) {
    for (int* link = &first_[at]; *link != none;) {
      Seam& seam = seams_[static_cast<std::size_t>(*link)];
      if (matches(seam.side)) {
        *link = seam.next;
        return seam.side;
      }
      link = &seam.next;
    }
    return std::nullopt;
  }

  /// Calls visit(side) for every side added since begin(), including sides that were taken, in the order of adding.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const Seam& seam : seams_) visit(seam.side);
  }

  /// Frees the memory. Afterwards, has_begun() returns false.
  void end() {
    // An assignment of {} would keep the memory.
    seams_ = std::vector<Seam>();
    first_ = FreshVector<int>();
  }

 private:
  static constexpr int none = -1;
  struct Seam {
    Side side;
    int next;
  };
  std::vector<Seam> seams_;
  FreshVector<int> first_;  // for each site, the position in seams_ of the side added last that still waits, or none
};

}  // namespace meshops
