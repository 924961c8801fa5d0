#include "rbpa/space/solid/triples/find_by_triples.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "rbpa/space/solid/triples/apex_by_predicates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/space/solid/triples/find_by_triples.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h: the code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/space/solid/triples/apex-inl.h"
#include "rbpa/space/solid/triples/clip_triples-inl.h"
#include "rbpa/space/solid/triples/near_points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

class TripleSearch {
 public:
  TripleSearch(const Cells& cells, double alpha, std::size_t most_exact, Triples& found)
      : cells_(cells),
        alpha_(alpha),
        most_exact_(most_exact),
        block_(alpha),
        near_(alpha),
        apex_(alpha),
        found_(found) {}

  /// Maximum number of points in the cells around a cell, so that a pair of positions fits 31 bits.
  static constexpr std::size_t most_around = 1u << 12;

  bool run(std::size_t first_cell, std::size_t end_cell) {
    Cells::Around around(cells_);
    for (std::size_t cell = first_cell; cell < end_cell; ++cell) {
      block_.gather(cells_, around, cell);
      if (block_.size() > most_around) return false;
      const std::size_t sites = cells_.first_in(cell + 1) - cells_.first_in(cell);
      for (std::size_t i = 0; i < sites; ++i) {
        find_at(block_.own() + i);
        if (found_.exact > most_exact_) return false;
      }
    }
    return true;
  }

 private:
  void find_at(std::size_t at) {
    near_.gather(block_, at, cells_.sites());
    if (near_.after() < 3) return;
    pairs_.list(near_);
    is_listed_ = false;
    v_ = block_.sites[at];
    if (near_.after() <= single_lanes)
      clip<1>();
    else if (near_.after() <= 2 * single_lanes)
      clip<2>();
    else
      clip<3>();
  }

  template <int kRegisters>
  void clip() {
    open_.clear();
    for (std::size_t i = 0; i < pairs_.size(); i += single_lanes)
      open_.append<kRegisters>(near_, pairs_[i], std::min(pairs_.size() - i, single_lanes));
    for (std::size_t i = 0; i < open_.size(); i += single_lanes) {
      const Sides sides = open_.sides<kRegisters>(near_, i);
      for (std::uint64_t tried = sides.positive | sides.negative; tried != 0; tried &= tried - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(tried));
        look_at(i + lane, sides.positive >> lane & 1, sides.negative >> lane & 1);
      }
    }
  }

  /// Adds the tetrahedra on the sides of an open triangle that are to be tried.
  void look_at(std::size_t triangle, bool positive, bool negative) {
    const std::size_t q = open_.q(triangle), r = open_.r(triangle);
    apex_.set_triangle(near_, q, r);
    if (positive) add(q, r, true);
    if (negative) add(q, r, false);
  }

  void add(std::size_t q, std::size_t r, bool is_positive) {
    const Site b = site(q), c = site(r);
    switch (apex_.look(is_positive)) {
      case Side::none:
        return;
      case Side::found:
        return add({v_, b, c, site(apex_.apex())}, is_positive);
      case Side::open:
        if (++found_.exact > most_exact_) return;  // run() then gives up
        if (!is_listed_) {
          is_listed_ = true;
          around_.assign(near_.sites.begin(), near_.sites.begin() + static_cast<std::ptrdiff_t>(near_.size()));
        }
        const auto apex = is_positive ? exact_apex(cells_.sites(), around_, alpha_, v_, b, c)
                                      : exact_apex(cells_.sites(), around_, alpha_, v_, c, b);
        if (apex && *apex > c) add({v_, b, c, *apex}, is_positive);
    }
  }

  void add(std::array<Site, 4> corners, bool is_positive) {
    if (!is_positive) std::swap(corners[2], corners[3]);
    found_.tetrahedra.push_back(corners);
  }

  Site site(std::size_t near) const { return near_.sites[near]; }

  const Cells& cells_;
  double alpha_;
  std::size_t most_exact_;
  Block block_;
  NearPoints near_;
  Pairs pairs_;
  OpenTriangles open_;
  ApexSearch apex_;
  Site v_ = 0;
  bool is_listed_ = false;
  std::vector<Site> around_;  // the near points of v_, for exact_apex()
  Triples& found_;
};

bool find_triples(const Cells& cells, double alpha, std::size_t first_cell, std::size_t end_cell,
                  std::size_t most_exact, Triples& found) {
  return TripleSearch(cells, alpha, most_exact, found).run(first_cell, end_cell);
}

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa::space {
namespace {
HWY_EXPORT(find_triples);
}  // namespace

bool find_by_triples(const Cells& cells, double alpha, std::size_t first_cell, std::size_t end_cell,
                     std::size_t most_exact, Triples& found) {
  found.tetrahedra.clear();
  found.exact = 0;
  return HWY_DYNAMIC_DISPATCH(find_triples)(cells, alpha, first_cell, end_cell, most_exact, found);
}

namespace {

/// Returns the fraction of the points in the cells around a point that are within cells.radius() of the point, by a
/// sample of cells. The fraction depends on whether points fill a volume or lie on a surface.
double share_of_near(const Cells& cells) {
  constexpr std::size_t samples = 512;
  const std::size_t stride = cells.size() / samples + 1;
  Cells::Around around(cells);
  const double square = cells.radius() * cells.radius();
  double near = 0, all = 0;
  for (std::size_t cell = 0; cell < cells.size(); cell += stride) {
    const Point3& p = cells.sites()[cells.first_in(cell)];
    around.for_each_run<1>(cell, [&](Site first, Site last) {
      all += last - first;
      for (Site q = first; q < last; ++q) {
        const double x = cells.sites()[q].x - p.x, y = cells.sites()[q].y - p.y, z = cells.sites()[q].z - p.z;
        near += x * x + y * y + z * z <= square ? 1 : 0;
      }
    });
  }
  return near / all;
}

}  // namespace

double triples_cost(const Cells& cells) {
  // Fitted to uniform points: a point with m near points costs about 100 + 4 m + 0.68 m² units.
  const double share = share_of_near(cells);
  Cells::Around around(cells);
  double cost = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    double points = 0;
    around.for_each_run<1>(cell, [&](Site first, Site last) { points += last - first; });
    const double near = share * points;
    cost += (cells.first_in(cell + 1) - cells.first_in(cell)) * (100 + near * (4 + 0.68 * near));
  }
  return cost;
}

}  // namespace rbpa::space
#endif
