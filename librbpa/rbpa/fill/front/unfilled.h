// What:   a triangulation of the region that a front has not filled yet: its corners are the points of the front, and
//         its border consists of the edges of the front.
// Law:    after every change the triangulation is the constrained Delaunay triangulation of the unfilled region, unique
//         up to points on one circle. All decisions are exact.
// Why:    a walk through the triangulation from an edge finds the corners visible from the edge. Long edges that lie
//         close together hide most near points from each other, and a search by boxes would visit all near points
//         (docs/explanation/plane.md, section 26).
// Cost:   n log n to build, for a front of n edges. Filling or emptying a triangle costs the number of triangles that
//         it crosses, and flips; removing a corner costs k log k for k triangles around the corner. A search costs the
//         number of triangles that it visits.
// Source: Chew, Constrained Delaunay triangulations (1989); Lee, Preparata, Euclidean shortest paths in the presence of
//         rectilinear barriers (1984), for the funnel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/grid/box.h"

namespace rbpa {

/// An edge of a front, as the sites at its ends; the unfilled region lies on the left of the edge.
struct FrontEdge {
  meshops::Site from, to;
  friend bool operator==(const FrontEdge&, const FrontEdge&) = default;
};

class Unfilled {
 public:
  using Site = meshops::Site;
  static constexpr std::size_t unlimited = ~std::size_t{0};

  /// Triangulates the region left of the rings of a front; a ring is a list of sites. Keeps a reference to `places`, to
  /// which the caller may append places. Throws: Cancelled. Members that take a FrontEdge throw ContractViolation if
  /// the front does not have the edge.
  Unfilled(const std::vector<Point>& places, std::span<const std::vector<Site>> rings, const GoOn& go_on);

  /// Begins a search from an edge of the front, for free_sites(). The search passes at most `most` triangles, in
  /// addition to the triangle beside the edge, whose corner it always sees.
  void look_from(const FrontEdge& edge, std::size_t most = unlimited) const;
  /// Returns the sites in `box` that form an empty triangle with the edge of look_from(), in any order, except sites
  /// that an earlier call returned. Once the search has passed `most` triangles, returns all other sites that it has
  /// seen, even outside of the box. The span is valid until the next call.
  /// Requires: `box` contains the edge and the boxes of earlier calls; no fill() or empty() since look_from().
  std::span<const Site> free_sites(const Box& box) const;
  /// Returns whether an edge of the front and a site of the front form an empty triangle.
  bool is_free(const FrontEdge& edge, Site site) const;
  /// Returns whether an edge of the front and the new point `apex` form an empty triangle, and every edge of the front
  /// is at least `clearance` from `apex`. Returns false if the way to `apex` passes more than `most` triangles.
  bool is_free(const FrontEdge& edge, const Point& apex, double clearance, std::size_t most = unlimited) const;

  /// Fills the triangle of an edge of the front and `apex`. An apex that is a new site becomes a site of the front.
  /// Throws: ContractViolation when the triangle is not empty.
  void fill(const FrontEdge& edge, Site apex);
  /// Makes a filled triangle unfilled again. is_front[i] is whether side i, from corner i to corner i + 1, becomes an
  /// edge of the front; if false, the region beyond side i is unfilled.
  void empty(const std::array<Site, 3>& corners, const std::array<bool, 3>& is_front);

  /// Returns the number of triangles that all searches and walks have passed, plus the numbers of added triangles and
  /// of flips: a measure of the work.
  std::size_t passed() const { return passed_; }
  /// Returns the triangles of the unfilled region, counter-clockwise, in any order.
  std::vector<std::array<Site, 3>> triangles() const;

 private:
  /// The number of a side. Side k of triangle t has the number 3 t + k, lies across from corner k, and runs from corner
  /// k + 1 to corner k + 2 (modulo 3).
  using Side = std::uint32_t;
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static Side after(Side side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Side before(Side side) { return side % 3 == 0 ? side + 2 : side - 1; }
  static std::uint64_t key_of(Site from, Site to) { return std::uint64_t{from} << 32U | to; }
  Site from(Side side) const { return corner_[after(side)]; }
  Site to(Side side) const { return corner_[before(side)]; }

  /// A corner of the rim of a cavity, and the side beyond the rim's edge that leads to the corner. The cavity consists
  /// of the triangles that a filled triangle crosses.
  struct Rim {
    Site site;
    Side beyond;
    bool is_new = false;  // whether the triangle of `beyond` was made for this rim
  };
  /// An edge from a corner that is being removed to a corner of the rim around it: this corner of the rim, the
  /// positions in star_ of the corners of the rim before and after, and how many times this corner was offered as an
  /// ear.
  struct Ray {
    Rim rim;
    std::uint32_t last, next;
    std::uint32_t offers = 0;
  };
  /// An offer to cut the ear at position `at` of star_. Only the last offer for a corner counts. The top of a heap has
  /// the least rise.
  struct Ear {
    double rise;
    std::uint32_t at, offer;
    friend bool operator<(const Ear& one, const Ear& other) {
      return std::pair(other.rise, other.at) < std::pair(one.rise, one.at);
    }
  };
  /// A side through which a search looks, as a side of the triangle already seen. The visible region beyond lies right
  /// of the line from the begin of the edge to site `left`, and left of the line from its end to site `right`.
  struct Gate {
    Side side;
    Site left, right;
  };

  int turn(Site a, Site b, Site c) const;
  int turn(Site a, Site b, const Point& p) const;
  Side at(const FrontEdge& edge) const;
  std::optional<Side> around(const FrontEdge& edge, const Point& apex, std::size_t most) const;
  bool is_clear(Side around, const Point& p, double clearance) const;

  void link(Side side, Side beyond);
  std::uint32_t add(Site a, Site b, Site c);
  void remove(std::uint32_t triangle);
  void forget_removed();
  void split(const FrontEdge& edge, Site site);
  void cross(Side side, Site apex);
  Side cut_ears(std::vector<Rim>& rim, bool is_right);
  void close(Site from, const Rim& to, Side inner, bool is_right);
  void bound(Side beyond, Site from, Site to);
  void flip_all();
  void flip(Side side);
  bool is_inner(Side at) const;
  void take_out(Side at);
  void offer_ear(std::uint32_t i, Site inner);
  std::uint32_t first_ear();
  Side cut_ear(std::uint32_t i);

  const std::vector<Point>& places_;
  std::vector<Site> corner_;           // the corner across from side 3 t + k
  std::vector<Side> across_;           // for each side, the side of the triangle beyond, or none at the front
  std::vector<std::uint32_t> unused_;  // numbers of removed triangles, to be used again
  std::unordered_map<std::uint64_t, Side> border_;  // edges of the front as sides
  Site next_ = 0;                                   // sites from this number on are not yet in the triangulation
  // State while a triangle is filled:
  std::vector<Rim> left_, right_;
  std::vector<std::uint32_t> crossed_;
  std::vector<std::array<std::uint32_t, 3>> waiting_;
  std::vector<Side> queue_;
  // State while a corner is removed:
  std::vector<Ray> star_;
  std::vector<Ear> ears_;  // a heap
  // State of a search:
  mutable FrontEdge eye_ = {};
  mutable std::vector<Site> found_, seen_;    // free sites in the last box; seen free sites outside of the box
  mutable std::vector<Gate> gates_, closed_;  // gates to look through; gates outside of the box
  mutable std::vector<Side> stack_;
  mutable std::vector<std::size_t> stamp_;  // for each triangle, the last search that passed it
  mutable std::size_t most_ = 0, of_look_ = 0, looks_ = 0, passed_ = 0;
};

}  // namespace rbpa
