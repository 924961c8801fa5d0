// What:   the paper's search: a uniform grid with cells of side 2α, the nine cells around the middle of an edge scanned
//         for each pivot. Kept for comparison.
// Law:    finds what Pivot finds.
// Cost:   a pivot costs as many points as nine cells hold, which grows with α².
// Source: Restricted BPA, sections 3.1 (V_p) and 3.2.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "rbpa/pivot/candidate.h"
#include "rbpa/predicate/radius.h"

namespace rbpa {

template <typename Real>
class PaperPivot {
 public:
  using Site = std::uint32_t;

  /// Refers to the points, which must be padded as Candidates asks for. `extent` bounds their distances; `grid_unit` as
  /// for Candidates.
  PaperPivot(std::span<const Point> points, Real extent, Radius radius, Real grid_unit)
      : points_(points), radius_(radius), grid_unit_(grid_unit) {
    // Cells far smaller than any coordinate could tell are of no use, and one larger than everything is enough.
    const Real reach = radius.is_infinite() ? extent : 2 * Real(radius.value()) * inflated;
    reach_ = std::clamp(reach, extent * Real(0x1p-30), extent);
    for (const Point& p : points)
      slack_ = std::max(slack_, 16 * Predicates<Real>::unit * std::max(std::abs(Real(p.x)), std::abs(Real(p.y))));
    for (Site s = 0; s < points.size(); ++s) cells_[cell(Real(points[s].x), Real(points[s].y))].push_back(s);
  }

  std::optional<Site> operator()(Site a, Site b, std::initializer_list<Site> = {}) const {
    Candidates<Real> candidates(points_.data(), a, b, grid_unit_);
    const Real x = (Real(points_[a].x) + Real(points_[b].x)) / 2, y = (Real(points_[a].y) + Real(points_[b].y)) / 2;
    const Cell low = cell(x - reach_ - slack_, y - reach_ - slack_),
               high = cell(x + reach_ + slack_, y + reach_ + slack_);
    for (std::int64_t row = low.row; row <= high.row; ++row)
      for (std::int64_t column = low.column; column <= high.column; ++column)
        if (const auto found = cells_.find({column, row}); found != cells_.end())
          for (const Site s : found->second) candidates.consider(s, s + 1);
    const auto apex = candidates.best();
    if (!apex || !radius_.admits<Real>(points_[a], points_[b], points_[*apex])) return std::nullopt;
    return apex;
  }

 private:
  static constexpr Real inflated = 1 + 64 * Predicates<Real>::unit;

  struct Cell {
    std::int64_t column, row;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      return static_cast<std::size_t>(c.column) * 0x9e3779b97f4a7c15u ^ static_cast<std::size_t>(c.row);
    }
  };

  // Counted from a corner of the box, so that the numbers stay small whatever the coordinates.
  Cell cell(Real x, Real y) const {
    const auto index = [&](Real at, double origin) {
      return static_cast<std::int64_t>(std::floor((at - Real(origin)) / reach_));
    };
    return {index(x, points_[0].x), index(y, points_[0].y)};
  }

  std::span<const Point> points_;
  Radius radius_;
  Real grid_unit_;
  Real reach_;
  Real slack_ = 0;  // of the middle of an edge and of the differences that count the cells
  std::unordered_map<Cell, std::vector<Site>, Hash> cells_;
};

}  // namespace rbpa
