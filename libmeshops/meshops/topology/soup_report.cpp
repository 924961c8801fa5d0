#include <algorithm>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <vector>

#include "meshops/core/progress.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_anatomy.h"

namespace meshops {
namespace {

using detail::SoupAnatomy;
using detail::SoupSide;
using SoupEdge = std::span<const SoupSide>;

/// Rank of a system of equations over Z/2 that are added one by one. Each equation is reduced by Gaussian elimination;
/// an equation in one unknown costs next to nothing.
class Z2Rank {
 public:
  /// Adds the equation that the sum of these unknowns is 0. An unknown that is listed twice cancels. Throws Cancelled.
  void add(std::vector<std::size_t> unknowns, Steps& step) {
    std::sort(unknowns.begin(), unknowns.end());
    std::vector<std::size_t> row, sum;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (!row.empty() && row.back() == unknowns[i])
        row.pop_back();
      else
        row.push_back(unknowns[i]);
    while (!row.empty()) {
      step(row.size());
      const auto [slot, is_new] = rows_.try_emplace(row.front());
      if (is_new) {
        slot->second = std::move(row);
        return;
      }
      sum.clear();
      std::set_symmetric_difference(row.begin(), row.end(), slot->second.begin(), slot->second.end(),
                                    std::back_inserter(sum));
      row.swap(sum);
    }
  }
  std::size_t rank() const { return rows_.size(); }

 private:
  std::unordered_map<std::size_t, std::vector<std::size_t>> rows_;  // the rows, by their first unknown
};

class SoupReporter {
 public:
  SoupReporter(SoupAnatomy& anatomy, const GoOn& go_on)
      : anatomy_(anatomy), soup_(anatomy.soup), sides_(anatomy.sides), go_on_(go_on), step_(go_on) {}

  TopologyReport operator()() {
    find_pieces();
    if (anatomy_.has_non_manifold_edge) {
      // Pieces end at edges with more than two faces.
      DisjointSets fans = detail::fans_of(
          soup_, sides_, [](SoupEdge edge) { return edge.size() == 2; }, go_on_);
      count_fans(fans);
    } else {
      count_fans(anatomy_.fans);
    }
    count_edges();
    count_points();
    total_.genus = 0;
    for (const ComponentReport& piece : total_.per_component) {
      total_.boundary_curves += piece.boundary_curves;
      if (total_.genus && piece.orientable && !anatomy_.has_non_manifold_edge)
        *total_.genus += *piece.genus();
      else
        total_.genus.reset();
    }
    total_.solid_components = total_.per_component.size();
    const long b0 = static_cast<long>(total_.components), b2 = cycles_of_faces();
    total_.betti = {b0, b0 + b2 - total_.euler(), b2};
    return std::move(total_);
  }

 private:
  /// Finds the pieces of surface, in the order of their first faces.
  void find_pieces() {
    piece_of_.resize(soup_.faces());
    std::size_t pieces = 0;
    for (std::uint32_t f = 0; f < soup_.faces(); ++f)
      if (anatomy_.is_sound(f) && anatomy_.pieces.is_least(f)) ++pieces;
    total_.per_component.reserve(pieces);
    for (std::uint32_t f = 0; f < soup_.faces(); ++f) {
      step_();
      if (!anatomy_.is_sound(f)) continue;
      const std::uint32_t root = anatomy_.pieces.find(f);
      if (root == f) {
        piece_of_[f] = static_cast<std::uint32_t>(total_.per_component.size());
        total_.per_component.push_back({.first_face = f});
      }
      piece_of_[f] = piece_of_[root];
      ++total_.per_component[piece_of_[f]].faces;
      ++total_.faces;
    }
    for (const SoupEdge edge : anatomy_.disagreeing) piece_at(edge[0]).orientable = false;
  }

  ComponentReport& piece_at(const SoupSide& side) { return total_.per_component[piece_of_[side.face()]]; }

  /// Counts the vertices and curves of each piece. `fans` are joined only at edges of two faces.
  void count_fans(DisjointSets& fans) {
    // Every open side joins the fans at its ends, and two open sides meet in a fan, so that the sets are the curves.
    DisjointSets curves(soup_.corners.size());
    std::vector<bool> is_open(soup_.corners.size(), false);
    for_each_edge([&](SoupEdge edge) {
      if (edge.size() == 2) return;
      for (const SoupSide& side : edge) {
        step_();
        const std::uint32_t low = fans.find(side.corner_at_low()), high = fans.find(side.corner_at_high());
        curves.unite(low, high);
        is_open[low] = is_open[high] = true;
      }
    });
    for_each_corner([&](std::uint32_t c, std::size_t f) {
      if (!fans.is_least(c)) return;
      ComponentReport& piece = total_.per_component[piece_of_[f]];
      ++piece.vertices;
      if (is_open[c] && curves.is_least(c)) ++piece.boundary_curves;
    });
  }

  /// Counts the edges of each piece. An edge with two faces is two sides of the piece, an open edge is one side.
  void count_edges() {
    std::vector<std::size_t> sides(total_.per_component.size(), 0);
    for (std::size_t f = 0; f < soup_.faces(); ++f)
      if (anatomy_.is_sound(f)) sides[piece_of_[f]] += soup_.face(f).size();
    total_.edges = sides_.edges();
    for_each_edge([&](SoupEdge edge) {
      if (edge.size() == 2) return;
      for (const SoupSide& side : edge) ++sides[piece_of_[side.face()]];
    });
    for (std::size_t i = 0; i < sides.size(); ++i) total_.per_component[i].edges = sides[i] / 2;
  }

  /// Counts the points on which several fans stand, and the components that are connected through points.
  void count_points() {
    const auto count = [&](auto is_such) {
      return static_cast<std::size_t>(std::count_if(anatomy_.fans_at.begin(), anatomy_.fans_at.end(), is_such));
    };
    total_.vertices = soup_.points;
    total_.isolated = count([](std::uint32_t fans) { return fans == 0; });
    total_.pinches = count([](std::uint32_t fans) { return fans > 1; });
    total_.components = total_.isolated + joined_pieces();
  }

  /// Returns the number of sets to which the pieces are joined by common points.
  std::size_t joined_pieces() {
    const std::size_t pieces = total_.per_component.size();
    if (total_.pinches == 0 && !anatomy_.has_non_manifold_edge) return pieces;
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> piece_at_point(soup_.points, none);
    DisjointSets connected(pieces);
    for_each_corner([&](std::uint32_t c, std::size_t f) {
      std::uint32_t& at = piece_at_point[soup_.corners[c]];
      if (at == none) at = piece_of_[f];
      if (at != piece_of_[f]) connected.unite(at, piece_of_[f]);
    });
    std::size_t sets = 0;
    for (std::uint32_t i = 0; i < pieces; ++i) sets += connected.is_least(i) ? 1U : 0U;
    return sets;
  }

  /// Returns the dimension of the space of 2-cycles over Z/2. A 2-cycle is a set of faces of which an even number meets
  /// at every edge. It has both faces of an edge of two faces or neither, and so is a set of pieces. A piece with an
  /// edge of one face is in no cycle. Every other edge gives an equation about the other pieces.
  long cycles_of_faces() {
    std::vector<bool> is_in_none(total_.per_component.size(), false);
    for_each_edge([&](SoupEdge edge) {
      if (edge.size() == 1) is_in_none[piece_of_[edge[0].face()]] = true;
    });
    Z2Rank equations;
    std::vector<std::size_t> unknowns;
    if (anatomy_.has_non_manifold_edge)
      for_each_edge([&](SoupEdge edge) {
        if (edge.size() <= 2) return;
        unknowns.clear();
        for (const SoupSide& side : edge)
          if (const std::uint32_t piece = piece_of_[side.face()]; !is_in_none[piece]) unknowns.push_back(piece);
        equations.add(unknowns, step_);
      });
    return std::count(is_in_none.begin(), is_in_none.end(), false) - static_cast<long>(equations.rank());
  }

  template <typename Visit>
  void for_each_edge(Visit visit) {
    for (std::size_t e = 0; e < sides_.edges(); ++e) {
      step_();
      visit(sides_.edge(e));
    }
  }

  template <typename Visit>
  void for_each_corner(Visit visit) {
    for (std::size_t f = 0; f < soup_.faces(); ++f) {
      if (!anatomy_.is_sound(f)) continue;
      for (std::size_t c = soup_.begin[f]; c < soup_.begin[f + 1]; ++c) {
        step_();
        visit(static_cast<std::uint32_t>(c), f);
      }
    }
  }

  SoupAnatomy& anatomy_;
  const PolygonSoup& soup_;
  const detail::SoupSides& sides_;
  const GoOn& go_on_;
  Steps step_;
  std::vector<std::uint32_t> piece_of_;
  TopologyReport total_;
};

}  // namespace

namespace detail {
TopologyReport report_of(SoupAnatomy& anatomy, const GoOn& go_on) { return SoupReporter(anatomy, go_on)(); }
}  // namespace detail

TopologyReport report(const PolygonSoup& soup, const GoOn& go_on) {
  detail::SoupAnatomy anatomy(soup, go_on);
  return detail::report_of(anatomy, go_on);
}

}  // namespace meshops
